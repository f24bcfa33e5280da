// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_spatial_grid_h
#define fuga_tests_stress_spatial_grid_h

#include "stress/grid_model.h"

#include <optional>

namespace fuga::stress
{
  /**
   * Bodies cut out of one tensor product grid, mapped into space, of hexahedra or of tetrahedra
   * (six in each cell). Faces at the outside of a body belong to BODY_left or BODY_right (across
   * x), BODY_front or BODY_back (y), BODY_bottom or BODY_top (z).
   */
  class SpatialGrid : public SceneData
  {
  public:
    using Index = std::array<std::size_t, 3>;

    /** Coordinates of the grid lines along x, y and z, increasing. */
    std::array<Vector, 3> lines;
    /** Which body a cell belongs to: index into bodies, or none. */
    static constexpr int none = -1;
    std::function<int(const Index &)> body_of_cell;
    std::function<std::array<double, 3>(const std::array<double, 3> &)> map;
    bool tetrahedra = false;
    /** If this is a plane scene extruded along y: that scene. */
    std::optional<GridModel> section;

    unsigned int
    dimension() const override
    {
      return 3;
    }

    std::string
    cells() const override
    {
      return tetrahedra ? "tetrahedra" : "hexahedra";
    }

    const SceneData *
    plane_section() const override
    {
      return section ? &*section : nullptr;
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

  private:
    FaceGroups
    faces() const override;
    int
    body(const Index &cell) const;
    void
    add_faces(const unsigned int across, FaceGroups &result) const;
    /** Calls @p action(index) for every point of the grid. */
    void
    for_each_index(const std::function<void(const Index &)> &action) const;
    std::size_t
    vertex(const Index &index) const;
    std::array<double, 3>
    place(const Index &index) const;
    bool
    is_used(const Index &index) const;
    void
    add_cell(const Index &cell, MeshText &mesh) const;
  };

  /**
   * The plane scene @p section, x and y of which become x and z, between faces at the lines @p y that
   * move in their own planes only. The loads of the section must be tractions, pressures and
   * displacements without y. In plane strain its stresses and jumps are those of the section,
   * whatever the lines @p y are.
   */
  SpatialGrid
  extrude(const GridModel &section, const Vector &y);
} // namespace fuga::stress

#endif
