// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_draws_h
#define fuga_tests_stress_draws_h

#include "campaign/random.h"
#include "stress/grid_model.h"

namespace fuga::stress
{
  using campaign::Random;

  /** 0, up to 1, or 1 to 3. */
  double
  draw_friction(Random &random);

  /** Compliances of any size from rigid, 1e-12 to 1e3 m/MPa, in both directions on their own or
   * equal. */
  Layer
  draw_layer(Random &random);

  /** The same with compliances between two powers of ten; @p rigid: probability of a rigid bar. */
  Layer
  draw_layer(Random &random, const double low, const double high, const double rigid);

  /** ν to 0.4999. */
  double
  draw_poisson_ratio(Random &random);

  /** Number of cells along a joint: mostly few. */
  unsigned int
  draw_cells(Random &random);

  /** A block on a foundation ("ground") that is held at its bottom and sides. */
  struct StackShape
  {
    double width = 1., height = 1., depth = 1., margin = 1.;
    unsigned int n_along = 4, n_up = 3, n_down = 2, n_margin = 2;
    /** Ratio of the last to the first cell along the joint. */
    double growth = 1.;
  };

  StackShape
  draw_stack_shape(Random &random);

  GridModel
  make_stack(const StackShape &shape, const double young_modulus, const double ground_modulus);

  GridModel
  draw_stack(Random &random);

  /** Bodies above each other, the lowest on a rigid obstacle or held. */
  GridModel
  draw_tower(Random &random);

  /** Four blocks around a point; the lower two are held. */
  GridModel
  draw_cross(Random &random);

  /** A wall in running bond: joints meet in T. */
  GridModel
  draw_masonry(Random &random);

  /** A half ring of voussoirs between two abutments. */
  GridModel
  draw_arch(Random &random);

  /** A block between two inclined rigid planes. */
  GridModel
  draw_wedge(Random &random);

  /** One cell or a few on a rigid obstacle, with one to five contact elements. */
  GridModel
  draw_single(Random &random);

  /**
   * Adds loads to the body @p name: 0 pressure on its top, 1 shear traction on its top, 2 traction on
   * its left side, 3 a pressure on its top that varies along it; sizes in proportion to @p pressure.
   */
  void
  add_block_loads(GridModel &model,
                  const std::string &name,
                  const double pressure,
                  const double horizontal);

  /** The softest body times 1e-6 to 1e-3. */
  double
  draw_pressure(Random &random, const SceneData &model);

  /** First load from 0.3 to 1.5, the others in ±1.5; some loads rest in some stages. */
  void
  draw_stages(Random &random, SceneData &model, const unsigned int n_stages);

  /** All loads grow together from nothing. */
  void
  draw_proportional_stage(Random &random, SceneData &model);

  /** The first load, then the others to and fro. */
  void
  draw_reversals(Random &random, SceneData &model, const unsigned int n_reversals);

  /** Loads in any of these ways. */
  void
  draw_any_stages(Random &random, SceneData &model);
} // namespace fuga::stress

#endif
