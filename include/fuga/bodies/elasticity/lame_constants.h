// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_elasticity_lame_constants_h
#define fuga_bodies_elasticity_lame_constants_h

#include <fuga/bodies/model_definition.h>

namespace fuga
{
  /** The two numbers of isotropic elasticity, σ = λ tr(ε) 1 + 2μ ε in the plane. */
  struct LameConstants
  {
    double lambda = 0.;
    double mu     = 0.;
  };

  LameConstants
  lame_constants(const Material &material, const PlaneAssumption assumption);

  /** Stress that holds back a thermal strain αΔT in the plane, per strain: σ = C ε - this · αΔT. */
  double
  thermal_modulus(const Material &material, const PlaneAssumption assumption);
} // namespace fuga

#endif
