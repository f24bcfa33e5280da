// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_grid_model_h
#define fuga_tests_stress_grid_model_h

#include "stress/scene_data.h"

#include <array>

namespace fuga::stress
{
  /**
   * Bodies cut out of one tensor product grid, mapped into the plane, as text of a mesh and of a
   * parameter file. Faces at the outside of a body belong to the group BODY_bottom, BODY_right,
   * BODY_top or BODY_left; where two bodies meet is the line BODY-BODY, lower number first, along
   * which the normal points into the second one.
   */
  class GridModel : public SceneData
  {
  public:
    /** Coordinates of the grid lines, increasing. */
    Vector x, y;
    /** Which body a cell belongs to: index into bodies, or none. */
    static constexpr int none = -1;
    std::function<int(std::size_t i, std::size_t j)> body_of_cell;
    std::function<std::array<double, 2>(double, double)> map;
    bool triangles    = false;
    bool plane_stress = false;
    /** Named points: grid indices. */
    std::map<std::string, std::array<std::size_t, 2>> points;

    unsigned int
    dimension() const override
    {
      return 2;
    }

    std::string
    cells() const override
    {
      return triangles ? "triangles" : "quadrilaterals";
    }

    std::string
    mesh_text() const override;
    double
    width() const override;
    double
    largest_aspect() const override;
    double
    size_ratio() const override;
    double
    offset() const override;

    /** Number of faces along all joints. */
    std::size_t
    n_joint_faces() const;

    /** Where a vertex of the grid is. */
    std::array<double, 2>
    place(const std::size_t i, const std::size_t j) const;

  private:
    FaceGroups
    faces() const override;
    std::string
    mesh_entries() const override
    {
      return plane_stress ? "set Assumption = plane stress\n" : "";
    }
    int
    body(const std::size_t i, const std::size_t j) const;
  };
} // namespace fuga::stress

#endif
