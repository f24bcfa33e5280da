// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/joint_strength.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/system/layered_system.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    bool
    widens(const ContactElement &element, const JointState &at)
    {
      return element.coupling != nullptr && unreleased_shear(element, at) != 0.;
    }

    double
    shear_force(const ContactElement &element, const JointState &at)
    {
      return length(tangential(element, at.forces));
    }

    TangentVector
    scaled(const double size, const TangentVector &direction)
    {
      return {{size * direction[0], size * direction[1]}};
    }

    /** Return the deformation of the layer in its plane, as far as its forces depend on it. */
    TangentVector
    layer_shear(const ContactElement &element, const JointState &at, const std::size_t k)
    {
      return at.states[k] == ContactState::stick ? elastic_shear(element, at, k)
                                                 : shear_deformation(element, at, k);
    }

    /** Return the difference between the first compliance of a normal bar, which a layer keeps
     * under tension, and its D. */
    double
    lack_of_compliance(const ContactElement &element)
    {
      const ComplianceLaw &law = *element.normal_law;
      return law.initial_compliance() / element.area - bar_compliance(law, element.area);
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

  bool
  is_at_closure_limit(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    constexpr double nearest = 1e-8;
    return has_nonlinear_closure(element) && at.states[k] != ContactState::open &&
           -gap(element, at, k) >= (1. - nearest) * closure_limit(element);
  }

  double
  gap(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const std::size_t n = element.normal_bar;
    return element.initial_gap - at.dilations[k] + at.dislocations[n] +
           bar_compliance(*element.normal_law, element.area) * at.forces[n];
  }

  double
  lip_opening(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const std::size_t n = element.normal_bar;
    if (!widens(element, at))
      return element.initial_gap - at.dilations[k] + at.dislocations[n] -
             lack_of_compliance(element) * at.forces[n];
    const double A = element.area;
    return gap(element, at, k) +
           element.coupling->deformation(-at.forces[n] / A, shear_force(element, at) / A).closure;
  }

  double
  lip_opening_rate(const ContactElement &element, const JointState &at, const JointRates &rates)
  {
    const std::size_t n = element.normal_bar;
    if (!widens(element, at))
      return rates.dislocations[n] - lack_of_compliance(element) * rates.forces[n];
    const double A          = element.area;
    const TangentVector T   = tangential(element, at.forces);
    const auto [w, e]       = element.coupling->deformation(-at.forces[n] / A, length(T) / A);
    const auto response     = element.coupling->response(w, e);
    const double shear_rate = dot(direction_of(T), tangential(element, rates.forces));
    const double determinant =
      response.dsigma_dw * response.dtau_de - response.dsigma_de * response.dsigma_de;
    return rates.dislocations[n] + bar_compliance(*element.normal_law, A) * rates.forces[n] -
           (response.dtau_de * rates.forces[n] + response.dsigma_de * shear_rate) /
             (A * determinant);
  }

  TangentVector
  elastic_shear(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const TangentVector jump = sum(tangential(element, at.dislocations),
                                   bar_compliance(*element.shear_law, element.area),
                                   tangential(element, at.forces));
    return sum(jump, -1., at.slips[k]);
  }

  // While the lips are apart, the gap does not determine the closure; the force of a bond that is
  // being unloaded does.
  TangentVector
  shear_deformation(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const double A        = element.area;
    const TangentVector T = tangential(element, at.forces);
    if (!has_nonlinear_shear(element))
      return scaled(bar_compliance(*element.shear_law, A), T);
    const double stress = length(T) / A;
    if (element.coupling == nullptr)
      return scaled(element.shear_law->deformation(stress), direction_of(T));
    return scaled(
      at.states[k] == ContactState::open
        ? element.coupling->deformation(-at.forces[element.normal_bar] / A, stress).shear
        : element.coupling->shear_deformation(-gap(element, at, k), stress),
      direction_of(T));
  }

  // A linear layer deforms by D T, which is not part of the dislocations; other layers deform less,
  // or more.
  TangentVector
  present_slip(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const TangentVector d = tangential(element, at.dislocations);
    if (!has_nonlinear_shear(element))
      return d;
    return sum(
      sum(d, bar_compliance(*element.shear_law, element.area), tangential(element, at.forces)),
      -1.,
      shear_deformation(element, at, k));
  }

  LayerForces
  layer_forces(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const double A = element.area;
    if (element.coupling != nullptr)
      {
        const TangentVector e = layer_shear(element, at, k);
        const ShearCoupling::Response r =
          element.coupling->response(-gap(element, at, k), length(e));
        return {-A * r.sigma, scaled(A * r.tau, direction_of(e))};
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
        const TangentVector e = elastic_shear(element, at, k);
        forces.shear          = scaled(A * element.shear_law->stress(length(e)), direction_of(e));
      }
    return forces;
  }

  double
  nonlinear_energy(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const double A = element.area, g = gap(element, at, k);
    if (element.coupling != nullptr)
      return A * element.coupling->energy(-g, length(elastic_shear(element, at, k)));
    double energy = 0.;
    if (has_nonlinear_closure(element) && at.states[k] != ContactState::open)
      energy += g < 0. ? A * element.normal_law->energy(-g)
                       : 0.5 * g * g * first_stiffness(*element.normal_law, A);
    if (has_nonlinear_shear(element))
      energy += A * element.shear_law->energy(length(elastic_shear(element, at, k)));
    return energy;
  }

  LayerTangent
  layer_tangent(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    const double A = element.area;
    LayerTangent tangent;
    if (element.coupling != nullptr)
      {
        const TangentVector e           = layer_shear(element, at, k);
        const double size               = length(e);
        const ShearCoupling::Response r = element.coupling->response(-gap(element, at, k), size);
        tangent.normal                  = A * r.dsigma_dw;
        tangent.mixed                   = -A * r.dsigma_de;
        tangent.shear                   = A * r.dtau_de;
        tangent.across                  = A * (size > 0. ? r.tau / size : r.dtau_de);
        tangent.direction               = direction_of(e);
        return tangent;
      }
    if (has_nonlinear_closure(element))
      {
        const double g = gap(element, at, k);
        tangent.normal =
          g < 0. ? A * element.normal_law->tangent(-g) : first_stiffness(*element.normal_law, A);
      }
    if (has_nonlinear_shear(element))
      {
        const TangentVector e = elastic_shear(element, at, k);
        tangent.shear         = A * element.shear_law->tangent(length(e));
        tangent.across        = A * element.shear_law->secant(length(e));
        tangent.direction     = direction_of(e);
      }
    return tangent;
  }

  LayerTangent
  initial_layer_tangent(const ContactElement &element)
  {
    LayerTangent tangent;
    if (has_nonlinear_closure(element))
      tangent.normal = first_stiffness(*element.normal_law, element.area);
    if (has_nonlinear_shear(element))
      tangent.shear = tangent.across = first_stiffness(*element.shear_law, element.area);
    return tangent;
  }

  // s = jump - e, so ṡ = ḋ + D Ṫ - ė, with ė from the inverse of the layer's tangent.
  TangentVector
  slip_rate(const ContactElement &element,
            const JointState &at,
            const std::size_t k,
            const JointRates &rates)
  {
    const TangentVector dislocation_rate = tangential(element, rates.dislocations);
    if (!has_nonlinear_shear(element))
      return dislocation_rate;
    const double A           = element.area;
    const TangentVector T    = tangential(element, at.forces);
    const TangentVector rate = tangential(element, rates.forces);
    LayerTangent tangent     = layer_tangent(element, at, k);
    TangentVector u          = tangent.direction;
    double along             = 0.;
    if (element.coupling == nullptr)
      along = dot(u, rate) / tangent.shear;
    else
      {
        u = direction_of(T);
        const auto [w, e] =
          element.coupling->deformation(-at.forces[element.normal_bar] / A, length(T) / A);
        const ShearCoupling::Response r = element.coupling->response(w, e);
        tangent.across                  = A * (e > 0. ? r.tau / e : r.dtau_de);
        along = (r.dsigma_de * rates.forces[element.normal_bar] + r.dsigma_dw * dot(u, rate)) /
                (A * (r.dsigma_dw * r.dtau_de - r.dsigma_de * r.dsigma_de));
      }
    TangentVector elastic = scaled(along, u);
    if (element.has_second_tangential_bar())
      elastic = sum(elastic, dot(normal_to(u), rate) / tangent.across, normal_to(u));
    const TangentVector jump = sum(dislocation_rate, bar_compliance(*element.shear_law, A), rate);
    return sum(jump, -1., elastic);
  }
} // namespace fuga
