// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_scene_data_h
#define fuga_tests_stress_scene_data_h

#include <fuga/base/numerics/dense_matrix.h>

#include <functional>
#include <map>
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
    /** Expression of the coordinates. */
    std::string initial_gap;
    /** Further entries of the joint, by name. */
    std::vector<std::pair<std::string, std::string>> more;
  };

  /** A mesh in Gmsh's format 2.2, line by line. */
  class MeshText
  {
  public:
    /** A physical group with the tag @p tag. */
    void
    add_name(const unsigned int dimension, const std::size_t tag, const std::string &name);

    /** @p type: Gmsh's number of the kind of element. @p vertices count from 1. */
    void
    add_element(const unsigned int type,
                const std::size_t tag,
                const std::vector<std::size_t> &vertices);

    void
    add_vertex(const std::size_t number, const double x, const double y, const double z);

    std::string
    text() const;

  private:
    std::string names, vertices, elements;
    std::size_t n_names = 0, n_vertices = 0, n_elements = 0;
  };

  /** What a scene is, in the plane or in space: its parameter file, and a mesh that the derived
   * classes make. */
  class SceneData
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

    /** How a stage goes from the factors of the one before to its own. */
    struct Course
    {
      /** Seconds; 0: slowly. */
      double duration = 0.;
      /** Share of its own factors as an expression of t; 1 at its end. */
      std::string share = "t";
    };

    virtual ~SceneData() = default;

    unsigned int degree      = 1;
    double certificate_bound = 1e-9;
    unsigned int load_levels = 1;
    std::vector<Body> bodies;
    std::vector<Joint> joints;
    /** Fixed components by boundary. */
    std::map<std::string, std::string> supports;
    std::vector<Load> loads;
    /** Factors of all loads at the end of every stage. */
    std::vector<Vector> stages;
    /** By stage, if any is not slow. */
    std::vector<Course> courses;
    /** By body, if it is not at rest. */
    std::map<std::string, std::string> initial_velocities;
    /** Entries of the section Dynamics. */
    std::vector<std::pair<std::string, std::string>> dynamics;
    /** True if the path goes on after jumps. */
    bool follows_jumps = false;

    bool
    is_in_motion() const
    {
      return !courses.empty();
    }

    virtual unsigned int
    dimension() const = 0;

    /** What the cells are, in the plural. */
    virtual std::string
    cells() const = 0;

    /** Adds a joint with the layer that @p make_layer gives wherever two bodies meet. */
    void
    join_all(const std::function<Layer()> &make_layer);

    /** Gmsh 2.2. */
    virtual std::string
    mesh_text() const = 0;

    /** @p mesh_file: how the parameter file is to name the mesh. */
    std::string
    parameter_text(const std::string &mesh_file) const;

    /** How far it reaches along x, before mapping. */
    virtual double
    width() const = 0;

    /** Largest ratio of the sides of a cell, before mapping. */
    virtual double
    largest_aspect() const = 0;

    /** Ratio of the longest to the shortest side along any grid direction. */
    virtual double
    size_ratio() const = 0;

    /** Largest coordinate of the first corner. */
    virtual double
    offset() const = 0;

    /** If this is a plane scene extruded: that scene. */
    virtual const SceneData *
    plane_section() const
    {
      return nullptr;
    }

  protected:
    /** Faces of cells by group, each by its vertices, which count from 1. */
    using FaceGroups = std::map<std::string, std::vector<std::vector<std::size_t>>>;

    /** Groups BODY_side at the outside, and BODY-BODY where two bodies meet, lower number first,
     * along which the normal points into the second one. */
    virtual FaceGroups
    faces() const = 0;

    /** The group of the faces at which the bodies of these numbers meet. */
    std::string
    name_of_joint(const std::size_t a, const std::size_t b) const;

    /** Tag of a body's cells. */
    static std::size_t
    tag_of_body(const std::size_t body)
    {
      return body + 1;
    }

    /** A mesh with the names of the bodies and with all faces, whose tags follow on 100. */
    MeshText
    mesh_of_faces() const;

    /** Further entries of the section Mesh. */
    virtual std::string
    mesh_entries() const
    {
      return {};
    }

  private:
    std::vector<std::string>
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

  /** SceneData::largest_aspect() of a cell with these sides. */
  double
  aspect_of(const std::vector<double> &sides);

  /** SceneData::size_ratio() of a grid with these lines. */
  double
  size_ratio_of(const std::vector<Vector> &lines);
} // namespace fuga::stress

#endif
