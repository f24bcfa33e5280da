// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_families_h
#define fuga_tests_stress_families_h

#include "stress/cut_polygon.h"
#include "stress/draws.h"

/** One function per family of scenes; what each is good for: the table in scene_kinds.cc. */
namespace fuga::stress::families
{
  GridModel
  single(Random &random);
  GridModel
  stack(Random &random);
  GridModel
  tower(Random &random);
  GridModel
  cross(Random &random);
  GridModel
  masonry(Random &random);
  GridModel
  arch(Random &random);
  GridModel
  wedge(Random &random);
  GridModel
  virgin(Random &random);
  GridModel
  reversal(Random &random);
  GridModel
  symmetric(Random &random);
  GridModel
  graded(Random &random);
  GridModel
  slender(Random &random);
  GridModel
  offset(Random &random);
  GridModel
  stiff(Random &random);
  GridModel
  soft(Random &random);
  GridModel
  contrast(Random &random);
  GridModel
  rigid_bodies(Random &random);
  GridModel
  gap(Random &random);
  GridModel
  settlement(Random &random);
  GridModel
  stages(Random &random);
  GridModel
  many_elements(Random &random);
  GridModel
  high_friction(Random &random);
  GridModel
  limit(Random &random);
  GridModel
  cohesion(Random &random);
  GridModel
  cubic_root(Random &random);
  GridModel
  cubic_root_crossing(Random &random);
  GridModel
  residual(Random &random);
  GridModel
  bonds(Random &random);
  GridModel
  dilatancy(Random &random);
  GridModel
  curved_laws(Random &random);
  GridModel
  coupled_shear(Random &random);
  GridModel
  envelopes(Random &random);
  GridModel
  envelopes_with_laws(Random &random);
  GridModel
  lift_off(Random &random);
  GridModel
  all_laws(Random &random);
  GridModel
  all_laws_crossing(Random &random);
  CutPolygon
  polygons(Random &random);
  CutPolygon
  polygons_with_laws(Random &random);
  GridModel
  motion(Random &random);
  GridModel
  motion_with_laws(Random &random);

  /** Any of the layouts with any layers. */
  GridModel
  draw_anything(Random &random);

  GridModel
  with_stages(Random &random, GridModel model, const unsigned int n_stages);

  void
  set_layers(SceneData &model, const std::function<Layer()> &draw);
} // namespace fuga::stress::families

#endif
