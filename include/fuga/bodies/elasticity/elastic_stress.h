// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_elasticity_elastic_stress_h
#define fuga_bodies_elasticity_elastic_stress_h

#include <deal.II/base/symmetric_tensor.h>

#include <fuga/bodies/model_definition.h>

namespace fuga
{
  /** Stress at a point [stress], tension positive. */
  template <int dim>
  struct StressState
  {
    /** Components in the plane; in space, all components. */
    dealii::SymmetricTensor<2, dim> in_plane;
    /** Stress across the plane; in axisymmetry, the hoop stress. */
    double across = 0.;
  };

  /**
   * Evaluate Hooke's law for the strain minus the thermal strain αΔT. @p gradient is ∂u_i/∂x_j;
   * @p hoop_strain is u_r/r in axisymmetry, otherwise 0.
   */
  template <int dim>
  StressState<dim>
  elastic_stress(const Material &material,
                 const PlaneAssumption assumption,
                 const dealii::Tensor<2, dim> &gradient,
                 const double hoop_strain,
                 const double thermal_strain);
} // namespace fuga

#endif
