// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/elasticity/elastic_stress.h>
#include <fuga/bodies/elasticity/lame_constants.h>

namespace fuga
{
  template <int dim>
  StressState<dim>
  elastic_stress(const Material &material,
                 const PlaneAssumption assumption,
                 const dealii::Tensor<2, dim> &gradient,
                 const double hoop_strain,
                 const double thermal_strain)
  {
    const LameConstants lame                     = lame_constants(material, assumption);
    const dealii::SymmetricTensor<2, dim> strain = symmetrize(gradient);
    const double isotropic                       = lame.lambda * (trace(strain) + hoop_strain) -
                             thermal_modulus(material, assumption) * thermal_strain;
    StressState<dim> stress;
    stress.in_plane = isotropic * dealii::unit_symmetric_tensor<dim>() + 2. * lame.mu * strain;
    if constexpr (dim == 3) // there is no direction across
      return stress;
    switch (assumption)
      {
        case PlaneAssumption::plane_strain:
          stress.across = material.poisson_ratio * trace(stress.in_plane) -
                          material.young_modulus * thermal_strain;
          break;
        case PlaneAssumption::plane_stress:
          break;
        case PlaneAssumption::axisymmetric:
          stress.across = isotropic + 2. * lame.mu * hoop_strain;
          break;
      }
    return stress;
  }

  template StressState<2>
  elastic_stress(const Material &,
                 const PlaneAssumption,
                 const dealii::Tensor<2, 2> &,
                 const double,
                 const double);
  template StressState<3>
  elastic_stress(const Material &,
                 const PlaneAssumption,
                 const dealii::Tensor<2, 3> &,
                 const double,
                 const double);
} // namespace fuga
