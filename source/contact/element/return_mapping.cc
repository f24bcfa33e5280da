// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/change_of_state.h>
#include <fuga/contact/element/joint_strength.h>
#include <fuga/contact/element/return_mapping.h>
#include <fuga/contact/system/layered_system.h>

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Return the slope of the strength where more pressure gives more of it. */
    double
    friction_at(const ContactElement &element,
                const JointState &at,
                const std::size_t k,
                const double N)
    {
      return (N < 0. || at.strengths[k].tension > 0.) && shear_strength(element, at, k, N) > 0.
               ? strength_line(element, at, k, N).friction
               : 0.;
    }
  } // namespace

  ReturnMapping::ReturnMapping(const std::vector<ContactElement> &contact_elements,
                               const JointState &start,
                               const Vector &jumps)
    : elements(contact_elements), from(start), at(start)
  {
    at.states.assign(elements.size(), ContactState::stick);
    at.strengths = strengths_in_step(from);
    at.forces.assign(jumps.size(), 0.);
    at.dislocations = jumps;
  }

  ReturnMapping::Layer
  ReturnMapping::layer(const std::size_t k) const
  {
    const ContactElement &element = elements[k];
    const LayerForces nonlinear   = layer_forces(element, at, k);
    Layer result{nonlinear.normal, length(nonlinear.shear), layer_tangent(element, at, k)};
    if (!has_nonlinear_closure(element))
      {
        result.tangent.normal = 1. / bar_compliance(*element.normal_law, element.area);
        result.normal         = result.tangent.normal * gap(element, at, k);
      }
    if (element.has_tangential_bar() && !has_nonlinear_shear(element))
      {
        const TangentVector e    = elastic_shear(element, at, k);
        result.tangent.direction = direction_of(e);
        result.tangent.shear     = result.tangent.across =
          1. / bar_compliance(*element.shear_law, element.area);
        result.shear = result.tangent.shear * length(e);
      }
    return result;
  }

  bool
  ReturnMapping::may_rise(const std::size_t k) const
  {
    return at.strengths[k].dilatancy > 0. && at.dilations[k] < elements[k].friction.dilation_limit;
  }

  // The slip is measured from the beginning of the step.
  void
  ReturnMapping::slide(const std::size_t k, const TangentVector &by)
  {
    at.slips[k]     = sum(from.slips[k], 1., by);
    at.dilations[k] = std::min(from.dilations[k] + at.strengths[k].dilatancy * length(by),
                               std::max(elements[k].friction.dilation_limit, from.dilations[k]));
  }

  // The excess of the shear over the strength decreases as the lips slip, from above zero to below
  // zero where no shear is left. Both layers stay within their laws.
  double
  ReturnMapping::slip_onto_strength(const std::size_t k, const TangentVector &e)
  {
    constexpr double within       = 1. - 1e-12;
    constexpr int digits          = std::numeric_limits<double>::digits;
    const ContactElement &element = elements[k];
    const TangentVector u         = direction_of(e);
    const double room =
      has_nonlinear_closure(element) ? within * closure_limit(element) + gap(element, at, k) : 0.;
    const double most  = may_rise(k) && has_nonlinear_closure(element)
                           ? std::clamp(room / at.strengths[k].dilatancy, 0., length(e))
                           : length(e);
    const double least = std::max(0., length(e) - within * element.shear_law->deformation_limit());
    const auto excess_and_derivative = [&](const double slip) {
      slide(k, {{slip * u[0], slip * u[1]}});
      const Layer now   = layer(k);
      const double rise = may_rise(k) ? at.strengths[k].dilatancy : 0.;
      const double f    = friction_at(element, at, k, now.normal);
      return std::make_pair(now.shear - shear_strength(element, at, k, now.normal),
                            -(now.tangent.shear + rise * now.tangent.mixed) -
                              f * (now.tangent.mixed + rise * now.tangent.normal));
    };
    boost::uintmax_t n_iterations = 200;
    return boost::math::tools::newton_raphson_iterate(
      excess_and_derivative, least, least, most, digits, n_iterations);
  }

  // The derivatives are those of N by the slip, and of |T| + f N by it; then those of N by the gap
  // and by the shear of the whole step, at which the excess stays zero.
  void
  ReturnMapping::slip(const std::size_t k, const TangentVector &e, StepResponse &result)
  {
    const ContactElement &element = elements[k];
    const std::size_t n_bars      = element.n_bars();
    const TangentVector u         = direction_of(e);
    const double way              = slip_onto_strength(k, e);
    slide(k, {{way * u[0], way * u[1]}});
    const Layer now             = layer(k);
    const double rise           = may_rise(k) ? at.strengths[k].dilatancy : 0.;
    const double strength       = shear_strength(element, at, k, now.normal);
    const double f              = friction_at(element, at, k, now.normal);
    const double by_slip        = -now.tangent.mixed - rise * now.tangent.normal;
    const double excess_by_slip = -(now.tangent.shear + rise * now.tangent.mixed) + f * by_slip;
    const double share          = by_slip / excess_by_slip;
    const double by_gap = now.tangent.normal - share * (now.tangent.mixed + f * now.tangent.normal);
    const double by_shear = now.tangent.mixed - share * (now.tangent.shear + f * now.tangent.mixed);
    result.forces[0]      = now.normal;
    result.tangent[0]     = {{by_gap, by_shear * u[0], by_shear * u[1]}};
    for (std::size_t i = 1; i < n_bars; ++i)
      {
        result.forces[i] = strength * u[i - 1];
        for (std::size_t j = 0; j < n_bars; ++j)
          result.tangent[i][j] =
            -f * u[i - 1] * result.tangent[0][j] +
            (j == 0 ? 0. : strength / length(e) * ((i == j ? 1. : 0.) - u[i - 1] * u[j - 1]));
      }
    // With two tangents the direction is that of T, and the sign means nothing; where no strength
    // is left, neither does the state.
    result.state    = !carries_shear(element, at.strengths[k]) ? ContactState::stick
                      : n_bars == 2 && u[0] < 0.               ? ContactState::slip_backward
                                                               : ContactState::slip_forward;
    result.slip     = at.slips[k];
    result.dilation = at.dilations[k];
  }

  StepResponse
  ReturnMapping::respond(const std::size_t k)
  {
    const ContactElement &element = elements[k];
    const bool is_bonded = from.strengths[k].has_bond() && from.states[k] != ContactState::open;
    StepResponse result;
    result.dilation = from.dilations[k];
    if (element.has_tangential_bar())
      result.slip = tangential(element, at.dislocations);
    const TangentVector e =
      element.has_tangential_bar() ? elastic_shear(element, at, k) : TangentVector{};
    // Lips that slide rise after each other.
    const double highest = may_rise(k)
                             ? std::min(at.strengths[k].dilatancy * length(e),
                                        element.friction.dilation_limit - from.dilations[k])
                             : 0.;
    if (gap(element, at, k) > highest && !is_bonded)
      return result;

    result.state             = ContactState::stick;
    result.slip              = from.slips[k];
    const Layer now          = layer(k);
    result.forces[0]         = now.normal;
    const std::size_t n_bars = element.n_bars();
    const TangentVector u    = direction_of(e);
    for (std::size_t i = 1; i < n_bars; ++i)
      result.forces[i] = now.shear * u[i - 1];
    for (std::size_t i = 0; i < n_bars; ++i)
      for (std::size_t j = 0; j < n_bars; ++j)
        result.tangent[i][j] = now.tangent(i, j);
    if (!element.has_tangential_bar() || (length(e) < element.shear_law->deformation_limit() &&
                                          now.shear <= shear_strength(element, at, k, now.normal)))
      return result;

    slip(k, e, result);
    return result;
  }
} // namespace fuga
