// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_elasticity_lame_constants_h
#define fuga_bodies_elasticity_lame_constants_h

#include <fuga/bodies/model_definition.h>

namespace fuga
{
  /** The two constants of isotropic elasticity, σ = λ tr(ε) 1 + 2μ ε in the plane. */
  struct LameConstants
  {
    double lambda = 0.;
    double mu     = 0.;
  };

  LameConstants
  lame_constants(const Material &material, const PlaneAssumption assumption);

  /**
   * Return the stress per strain that restrains a thermal strain αΔT in the plane: σ = C ε - this ·
   * αΔT.
   */
  double
  thermal_modulus(const Material &material, const PlaneAssumption assumption);
} // namespace fuga

#endif
