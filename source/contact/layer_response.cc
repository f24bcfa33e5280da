// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/layer_response.h>
#include <fuga/contact/layered_system.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    bool
    widens(const ContactElement &element, const JointState &at)
    {
      return element.coupling != nullptr && at.unreleased[element.tangential_bar] != 0.;
    }

    double
    first_stiffness(const ComplianceLaw &law, const double area)
    {
      return area / law.initial_compliance();
    }
  } // namespace

  bool
  has_nonlinear_closure(const ContactElement &element)
  {
    return element.coupling != nullptr || element.normal_law->kind() == ComplianceKind::nonlinear;
  }

  bool
  has_nonlinear_shear(const ContactElement &element)
  {
    return element.has_tangential_bar() &&
           (element.coupling != nullptr || element.shear_law->kind() == ComplianceKind::nonlinear);
  }

  double
  closure_limit(const ContactElement &element)
  {
    return element.coupling != nullptr ? element.coupling->closure_limit()
                                       : element.normal_law->deformation_limit();
  }

  double
  gap(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const std::size_t n = element.normal_bar;
    return element.initial_gap - at.dilations[k] + at.dislocations[n] +
           bar_compliance(*element.normal_law, element.area) * at.forces[n];
  }

  // Under tension a layer keeps its first stiffness, so that g - D N = g0 - ω + d.
  double
  lip_opening(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const std::size_t n = element.normal_bar;
    if (!widens(element, at))
      return element.initial_gap - at.dilations[k] + at.dislocations[n];
    const double A = element.area;
    return gap(element, at, k) +
           element.coupling->deformation(-at.forces[n] / A, at.forces[element.tangential_bar] / A)
             .closure;
  }

  double
  lip_opening_rate(const ContactElement &element, const JointState &at, const JointRates &rates)
  {
    const std::size_t n = element.normal_bar, t = element.tangential_bar;
    if (!widens(element, at))
      return rates.dislocations[n];
    const double A      = element.area;
    const auto [w, e]   = element.coupling->deformation(-at.forces[n] / A, at.forces[t] / A);
    const auto response = element.coupling->response(w, e);
    const double determinant =
      response.dsigma_dw * response.dtau_de - response.dsigma_de * response.dsigma_de;
    return rates.dislocations[n] + bar_compliance(*element.normal_law, A) * rates.forces[n] -
           (response.dtau_de * rates.forces[n] + response.dsigma_de * rates.forces[t]) /
             (A * determinant);
  }

  double
  elastic_shear(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const std::size_t t = element.tangential_bar;
    return at.dislocations[t] + bar_compliance(*element.shear_law, element.area) * at.forces[t] -
           at.slips[k];
  }

  // While the lips are apart the gap does not tell the closure; the force of a bond that is being
  // unloaded does.
  double
  shear_deformation(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const double A = element.area;
    const double T = at.forces[element.tangential_bar];
    if (!has_nonlinear_shear(element))
      return bar_compliance(*element.shear_law, A) * T;
    if (element.coupling != nullptr)
      return at.states[k] == ContactState::open
               ? element.coupling->deformation(-at.forces[element.normal_bar] / A, T / A).shear
               : element.coupling->shear_deformation(-gap(element, at, k), T / A);
    return std::copysign(element.shear_law->deformation(std::abs(T) / element.area), T);
  }

  LayerForces
  layer_forces(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const double A = element.area;
    if (element.coupling != nullptr)
      {
        const double e = at.states[k] == ContactState::stick ? elastic_shear(element, at, k)
                                                             : shear_deformation(element, at, k);
        const ShearCoupling::Response r = element.coupling->response(-gap(element, at, k), e);
        return {-A * r.sigma, A * r.tau};
      }
    LayerForces forces;
    if (has_nonlinear_closure(element))
      {
        const double g = gap(element, at, k);
        forces.normal  = g < 0. ? -A * element.normal_law->stress(-g)
                                : g * first_stiffness(*element.normal_law, A);
      }
    if (has_nonlinear_shear(element))
      {
        const double e = elastic_shear(element, at, k);
        forces.shear   = std::copysign(A * element.shear_law->stress(std::abs(e)), e);
      }
    return forces;
  }

  double
  nonlinear_energy(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const double A = element.area, g = gap(element, at, k);
    if (element.coupling != nullptr)
      return A * element.coupling->energy(-g, elastic_shear(element, at, k));
    double energy = 0.;
    if (has_nonlinear_closure(element))
      energy += g < 0. ? A * element.normal_law->energy(-g)
                       : 0.5 * g * g * first_stiffness(*element.normal_law, A);
    if (has_nonlinear_shear(element))
      energy += A * element.shear_law->energy(std::abs(elastic_shear(element, at, k)));
    return energy;
  }

  LayerTangent
  layer_tangent(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const double A = element.area;
    if (element.coupling != nullptr)
      {
        const double e = at.states[k] == ContactState::stick ? elastic_shear(element, at, k)
                                                             : shear_deformation(element, at, k);
        const ShearCoupling::Response r = element.coupling->response(-gap(element, at, k), e);
        return {A * r.dsigma_dw, -A * r.dsigma_de, A * r.dtau_de};
      }
    LayerTangent tangent;
    if (has_nonlinear_closure(element))
      {
        const double g = gap(element, at, k);
        tangent.normal =
          g < 0. ? A * element.normal_law->tangent(-g) : first_stiffness(*element.normal_law, A);
      }
    if (has_nonlinear_shear(element))
      tangent.shear = A * element.shear_law->tangent(std::abs(elastic_shear(element, at, k)));
    return tangent;
  }

  LayerTangent
  initial_layer_tangent(const ContactElement &element)
  {
    LayerTangent tangent;
    if (has_nonlinear_closure(element))
      tangent.normal = first_stiffness(*element.normal_law, element.area);
    if (has_nonlinear_shear(element))
      tangent.shear = first_stiffness(*element.shear_law, element.area);
    return tangent;
  }

  // s = jump - e, so ṡ = ḋ + D Ṫ - ė, with ė from the inverse of the layer's tangent.
  double
  slip_rate(const ContactElement &element,
            const JointState &at,
            const std::size_t k,
            const JointRates &rates)
  {
    const std::size_t n = element.normal_bar, t = element.tangential_bar;
    if (!has_nonlinear_shear(element))
      return rates.dislocations[t];
    const double A      = element.area;
    const double T_rate = rates.forces[t];
    double elastic_rate = 0.;
    if (element.coupling == nullptr)
      elastic_rate = T_rate / layer_tangent(element, at, k).shear;
    else
      {
        const auto [w, e] = element.coupling->deformation(-at.forces[n] / A, at.forces[t] / A);
        const ShearCoupling::Response r = element.coupling->response(w, e);
        elastic_rate                    = (r.dsigma_de * rates.forces[n] + r.dsigma_dw * T_rate) /
                       (A * (r.dsigma_dw * r.dtau_de - r.dsigma_de * r.dsigma_de));
      }
    return rates.dislocations[t] + bar_compliance(*element.shear_law, A) * T_rate - elastic_rate;
  }

  double
  cohesive_strength(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const double unreleased =
      element.has_tangential_bar() ? std::abs(at.unreleased[element.tangential_bar]) : 0.;
    return at.strengths[k].cohesion + unreleased;
  }

  // Under tension a bond has less strength; without a bond a tension is rounding.
  double
  shear_strength(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const double N        = at.forces[element.normal_bar];
    const double pressing = at.strengths[k].tension > 0. ? -N : std::max(-N, 0.);
    return std::max(0., at.strengths[k].friction * pressing + cohesive_strength(element, at, k));
  }

  double
  tensile_strength(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    return at.strengths[k].tension + std::max(at.unreleased[element.normal_bar], 0.);
  }

  double
  tensile_strength_rate(const ContactElement &element, const Drive &drive)
  {
    double rate = drive.release.empty() ? 0. : std::min(drive.release[element.normal_bar], 0.);
    if (!drive.strength.empty())
      rate += drive.strength[element.normal_bar];
    return rate;
  }

  double
  shear_strength_rate(const ContactElement &element, const Drive &drive)
  {
    double rate = drive.release.empty() ? 0. : -std::abs(drive.release[element.tangential_bar]);
    if (!drive.strength.empty())
      rate += drive.strength[element.tangential_bar];
    return rate;
  }
} // namespace fuga
