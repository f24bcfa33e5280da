// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_scenes_grid_mesh_h
#define fuga_tests_scenes_grid_mesh_h

#include <fuga/mesh/gmsh_mesh.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace fuga::tests
{
  /** Coordinates of grid lines, increasing. */
  using Axis = std::vector<double>;

  /** n equal intervals. */
  Axis
  uniform(const double begin, const double end, const std::size_t n);

  /** From @p begin on, the first interval about h, every next one @p growth times as long. */
  Axis
  growing(const double begin, const double end, const double h, const double growth);

  /** @p first, and @p second after its end. */
  Axis
  joined(Axis first, const Axis &second);

  /** x → -x in front of x. */
  Axis
  both_sides(const Axis &axis);

  /**
   * The rectangle @p xs, @p ys of one body `block`; its bottom is `contact` up to @p contact_end
   * and `bottom_free` behind; `left`, `right`, `top`; the point `corner` at the right of the
   * bottom.
   */
  GmshMesh
  block_mesh(const Axis &xs, const Axis &ys, const double contact_end);

  /** Bodies `lower`, `upper` on both sides of the line `joint` at y = 0; `bottom`, `top`, `left`,
   * `right`. @p ys: of the upper body, from 0; the lower one is its mirror image. */
  GmshMesh
  two_blocks_mesh(const Axis &xs, const Axis &ys);

  /**
   * A plane mesh of quadrilaterals as the section through bodies in space, with grid lines @p zs
   * across it: lines become surfaces with their names, and `front` (smallest z) and `back` are the
   * ends. Points are left out.
   */
  GmshMesh
  extruded(const GmshMesh &plane, const Axis &zs);

  /** Writes a parameter file (.json, entries as in doc/input.md) with this mesh. Returns its name.
   */
  std::string
  write_scene(const GmshMesh &mesh, nlohmann::ordered_json parameters);
} // namespace fuga::tests

#endif
