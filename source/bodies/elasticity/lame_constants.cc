// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/elasticity/lame_constants.h>

namespace fuga
{
  LameConstants
  lame_constants(const Material &material, const PlaneAssumption assumption)
  {
    const double E = material.young_modulus, nu = material.poisson_ratio;
    LameConstants result;
    result.mu     = E / (2. * (1. + nu));
    result.lambda = assumption == PlaneAssumption::plane_stress
                      ? E * nu / (1. - nu * nu)
                      : E * nu / ((1. + nu) * (1. - 2. * nu));
    return result;
  }


  // A material that is held across the plane presses there as well: 3λ + 2μ as in space. In plane
  // stress only the plane itself counts.
  double
  thermal_modulus(const Material &material, const PlaneAssumption assumption)
  {
    const double nu = material.poisson_ratio;
    return material.young_modulus /
           (assumption == PlaneAssumption::plane_stress ? 1. - nu : 1. - 2. * nu);
  }
} // namespace fuga
