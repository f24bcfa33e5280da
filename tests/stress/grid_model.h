// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_grid_model_h
#define fuga_tests_stress_grid_model_h

#include <fuga/base/dense_matrix.h>

#include <array>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace fuga::stress
{
  /** Numbers of one joint, as the parameter file states them. */
  struct Layer
  {
    std::string normal_law = "linear", shear_law = "linear";
    /** Zero makes a linear law rigid; of a law without such an entry its size, for the report. */
    double normal_compliance = 0., shear_compliance = 0.;
    double thickness = 0.;
    double friction  = 0.;
    double cohesion  = 0.;
    /** Expression of x and y. */
    std::string initial_gap;
    /** Further entries of the joint, by name. */
    std::vector<std::pair<std::string, std::string>> more;
  };

  /**
   * Bodies cut out of one tensor product grid, mapped into the plane, as text of a mesh and of a
   * parameter file. Faces at the outside of a body belong to the group BODY_bottom, BODY_right,
   * BODY_top or BODY_left; where two bodies meet is the line BODY-BODY, lower number first, along
   * which the normal points into the second one.
   */
  class GridModel
  {
  public:
    struct Body
    {
      std::string name;
      double young_modulus = 1.;
      double poisson_ratio = 0.;
      double weight        = 0.;
    };

    struct Joint
    {
      std::string line;
      /** Bodies of a line, or a lip against a rigid obstacle if there is no minus. */
      std::string plus, minus;
      Layer layer;
    };

    struct Load
    {
      /** weight, pressure, traction, displacement. */
      std::string type;
      /** Body of a weight, boundary else. */
      std::string target;
      std::string value;
    };

    /** Coordinates of the grid lines, increasing. */
    Vector x, y;
    /** Which body a cell belongs to: index into bodies, or none. */
    static constexpr int none = -1;
    std::function<int(std::size_t i, std::size_t j)> body_of_cell;
    std::function<std::array<double, 2>(double, double)> map;
    bool triangles           = false;
    unsigned int degree      = 1;
    bool plane_stress        = false;
    double certificate_bound = 1e-8;
    unsigned int load_levels = 1;
    std::vector<Body> bodies;
    std::vector<Joint> joints;
    /** Fixed components by boundary. */
    std::map<std::string, std::string> supports;
    /** Named points: grid indices. */
    std::map<std::string, std::array<std::size_t, 2>> points;
    std::vector<Load> loads;
    /** Factors of all loads at the end of every stage. */
    std::vector<Vector> stages;

    /** Adds a joint with the layer that @p make_layer gives wherever two bodies meet. */
    void
    join_all(const std::function<Layer()> &make_layer);

    /** Gmsh 2.2. */
    std::string
    mesh_text() const;

    /** @p mesh_file: how the parameter file is to name the mesh. */
    std::string
    parameter_text(const std::string &mesh_file) const;

    /** Largest ratio of the sides of a cell, before mapping. */
    double
    largest_aspect() const;

    /** Ratio of the longest to the shortest side along either grid direction. */
    double
    size_ratio() const;

  private:
    int
    body(const std::size_t i, const std::size_t j) const;
    std::map<std::string, std::vector<std::array<std::size_t, 2>>>
    faces() const;
    std::set<std::string>
    free_boundaries() const;
    std::string
    joint_text() const;
    std::string
    load_text() const;
  };

  /** Grid lines through @p breaks with counts[i] cells in interval i, whose sizes grow from one to the next by growth[i] in total. */
  Vector
  grid_lines(const Vector &breaks,
             const std::vector<unsigned int> &counts,
             const Vector &growth = Vector());
} // namespace fuga::stress

#endif
