// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/judge/judge.h>

#include <cmath>

// The judge's own laws of the layer, from forces to deformations; the solver goes the other way.
namespace fuga
{
  namespace
  {
    /** Return the deformation of a bar's layer under a stress ≥ 0, from the law itself. */
    double
    deformation(const ComplianceLaw &law, const double stress)
    {
      return law.kind() == ComplianceKind::rigid ? 0. : law.deformation(stress);
    }

    /** Return the closure. A layer under tension (a bond) keeps its first stiffness. */
    double
    closure(const ComplianceLaw &law, const double pressure)
    {
      return pressure < 0. ? law.initial_compliance() * pressure : deformation(law, pressure);
    }

    double
    energy_of(const ComplianceLaw &law, const double stress, const bool tension)
    {
      if (law.kind() == ComplianceKind::rigid)
        return 0.;
      if (tension)
        return 0.5 * law.initial_compliance() * stress * stress;
      return law.energy(law.deformation(std::abs(stress)));
    }

    /** Return the rate of the deformation @p w ≥ 0 of a bar's layer. */
    double
    deformation_rate(const ComplianceLaw &law, const double w, const double stress_rate)
    {
      const bool curved = law.kind() == ComplianceKind::nonlinear && w > 0.;
      return stress_rate * (curved ? 1. / law.tangent(w) : law.initial_compliance());
    }
  } // namespace

  // The layer is isotropic in its plane: it deforms along the force, by the amount that the size of
  // the force demands.
  Judge::Layer
  Judge::layer(const std::size_t k, const JointState &state) const
  {
    const ContactElement &element = elements[k];
    const double pressure         = -state.forces[element.normal_bar] / element.area;
    const TangentVector T         = shear_part(element, state.forces);
    const double tau              = length(T) / element.area;
    double w = 0., e = 0.;
    if (element.coupling != nullptr)
      {
        const ShearCoupling::Deformation of_both = element.coupling->deformation(pressure, tau);
        w                                        = of_both.closure;
        e                                        = of_both.shear;
      }
    else
      {
        w = closure(*element.normal_law, pressure);
        e = element.has_tangential_bar() ? deformation(*element.shear_law, tau) : 0.;
      }
    return {-w, sum({{0., 0.}}, e, direction(T))};
  }

  double
  Judge::stored_energy(const std::size_t k, const JointState &state) const
  {
    const ContactElement &element = elements[k];
    const double pressure         = -state.forces[element.normal_bar] / element.area;
    const double shear            = length(shear_part(element, state.forces)) / element.area;
    if (element.coupling != nullptr)
      {
        const auto [w, e] = element.coupling->deformation(pressure, shear);
        return element.area * element.coupling->energy(w, e);
      }
    double energy = energy_of(*element.normal_law, pressure, pressure < 0.);
    if (element.has_tangential_bar())
      energy += energy_of(*element.shear_law, shear, false);
    return element.area * energy;
  }

  // Let u be the direction of the force. The deformation e(N, |T|) u changes along u by the tangent
  // of the law at the present stresses, and across u as u turns: by e/|T| times the component of
  // the force's rate across u.
  Judge::Layer
  Judge::layer_rates(const std::size_t k, const PathPoint &point) const
  {
    const ContactElement &element = elements[k];
    const double A                = element.area;
    const double N_rate           = point.rates.forces[element.normal_bar] / A;
    const Layer now               = layer(k, point.state);
    const TangentVector T         = shear_part(element, point.state.forces);
    const double e                = length(now.shear);
    const TangentVector T_rate    = shear_part(element, point.rates.forces);
    // A force that is just beginning has no direction yet, and the layer has the same compliance in
    // all directions.
    const bool begins          = length(T) == 0.;
    const TangentVector u      = begins ? TangentVector{{1., 0.}} : direction(T);
    const TangentVector across = normal_to(u);
    const double tau_rate      = dot(u, T_rate) / A;
    const double across_rate   = dot(across, T_rate) / A;
    Layer result;
    double shear_rate = 0., first_compliance = 0.;
    if (element.coupling != nullptr)
      {
        const ShearCoupling::Response r = element.coupling->response(-now.normal, e);
        const double determinant        = r.dsigma_dw * r.dtau_de - r.dsigma_de * r.dsigma_de;
        result.normal    = (r.dtau_de * N_rate + r.dsigma_de * tau_rate) / determinant;
        shear_rate       = (r.dsigma_de * N_rate + r.dsigma_dw * tau_rate) / determinant;
        first_compliance = 1. / r.dtau_de;
      }
    else
      {
        result.normal = deformation_rate(*element.normal_law, -now.normal, N_rate);
        if (element.has_tangential_bar())
          {
            shear_rate       = deformation_rate(*element.shear_law, e, tau_rate);
            first_compliance = element.shear_law->initial_compliance();
          }
      }
    const double secant_compliance = begins ? first_compliance : e / (length(T) / A);
    result.shear = sum(sum({{0., 0.}}, shear_rate, u), secant_compliance * across_rate, across);
    return result;
  }
} // namespace fuga
