// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_families_in_space_h
#define fuga_tests_stress_families_in_space_h

#include "stress/cut_polyhedron.h"
#include "stress/draws.h"
#include "stress/spatial_grid.h"

/** One function per family of scenes in space; what each is good for: the table in scene_kinds.cc.
 */
namespace fuga::stress::families
{
  SpatialGrid
  extruded(Random &random);
  SpatialGrid
  extruded_reversal(Random &random);
  SpatialGrid
  blocks_in_space(Random &random);
  SpatialGrid
  pair_in_space(Random &random);
  SpatialGrid
  wedge_in_space(Random &random);
  SpatialGrid
  motion_in_space(Random &random);
  CutPolyhedron
  polyhedra(Random &random);
  SpatialGrid
  extruded_with_laws(Random &random);
  SpatialGrid
  blocks_with_laws(Random &random);
  SpatialGrid
  envelopes_in_space(Random &random);
  CutPolyhedron
  polyhedra_with_laws(Random &random);
  SpatialGrid
  motion_in_space_with_laws(Random &random);

  /** Layers with which a joint in space can be followed, stiffness from 1e-1 to 1e6 of a body's. */
  Layer
  draw_layer_in_space(Random &random);
} // namespace fuga::stress::families

#endif
