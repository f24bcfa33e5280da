// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_law_draws_h
#define fuga_tests_stress_law_draws_h

#include "stress/draws.h"

namespace fuga::stress
{
  /** What the numbers of a layer are drawn in proportion to. */
  struct Scales
  {
    /** Pressure [MPa]. */
    double pressure = 0.;
    /** Compliance of the stiffest body [m/MPa], and how much a body deforms [m]. */
    double compliance = 0.;
    double length     = 0.;
    /** Young's modulus of the softest body [MPa]. */
    double softest = 0.;
  };

  Scales
  scales_of(const SceneData &model, const double pressure);

  /** With a pressure that is drawn. */
  Scales
  scales_of(Random &random, const SceneData &model);

  /** Rigid or linear bars with friction, 1e-4 to 1e3 as soft as the stiffest body. */
  Layer
  straight_layer(Random &random, const Scales &scales);

  /** Gives the layer a nonlinear normal law of any kind, and now and then such a shear law. */
  void
  make_curved(Random &random, Layer &layer, const Scales &scales);

  /** Residual friction; what is left of the coefficient. */
  double
  lose_friction(Random &random, Layer &layer);

  /** Cohesion, mostly with tensile strength, brittle or not. */
  void
  bond(Random &random, Layer &layer, const Scales &scales);

  void
  dilate(Random &random, Layer &layer, const Scales &scales, const double least_friction);

  /** Strength along a curve over the pressure, if no rise could gain energy by it. */
  void
  bend(Random &random, Layer &layer, const Scales &scales);

  /** Shear stiffness that grows with closure or pressure. */
  void
  couple(Random &random, Layer &layer, const Scales &scales);

  /** Any strength on any layer, of what fits together. */
  Layer
  any_layer(Random &random, const Scales &scales);

  /** The same, or one whose bond may carry tension; now and then with an initial gap. */
  Layer
  any_layer_or_bond(Random &random, const Scales &scales);
} // namespace fuga::stress

#endif
