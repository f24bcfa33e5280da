// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/contact_boundary.h>
#include <fuga/contact/element/joint_strength.h>
#include <fuga/contact/element/layer_response.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Return the smallest τ > 0 at which c + 2bτ + aτ² goes from positive to negative, if c >
     * 0. */
    double
    descending_root(const double a, const double b, const double c)
    {
      const double discriminant = b * b - a * c;
      if (discriminant < 0.)
        return no_boundary;
      const double s = std::sqrt(discriminant);
      if (b < 0.)
        return c / (s - b);
      return a < 0. ? (b + s) / -a : no_boundary;
    }

    /** Return the length τ after which a reserve is used up; `no_boundary` if it never is. */
    double
    used_up_after(const Reserve &reserve)
    {
      return reserve.rate >= 0. || reserve.rests() ? no_boundary
                                                   : std::max(0., -reserve.value / reserve.rate);
    }
  } // namespace

  ContactBoundary::ContactBoundary(const std::vector<ContactElement> &contact_elements,
                                   const LayeredSystem &layered_system)
    : elements(contact_elements)
    , system(layered_system)
    , in_space(have_two_tangents(contact_elements))
    , force_tolerances(layered_system.n_bars(), 0.)
  {
  }

  std::vector<BoundaryElement>
  ContactBoundary::elements_on_boundary(const JointState &state) const
  {
    std::vector<BoundaryElement> result;
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        const bool open               = state.states[k] == ContactState::open;
        BoundaryElement candidate;
        candidate.element   = k;
        const std::size_t n = element.normal_bar;
        candidate.grazing =
          open ? lip_opening(element, state, k) <= zero_gap
               : state.forces[n] >= tensile_strength(element, state, k) - force_tolerances[n];
        if (element.has_tangential_bar() && (candidate.grazing || !open))
          place_shear(state, candidate);
        if (candidate.grazing || candidate.shear != ShearPosition::inside)
          result.push_back(candidate);
      }
    return result;
  }

  bool
  ContactBoundary::is_visibly_closed(const JointState &state, const std::size_t k) const
  {
    constexpr double visible = 1e2;
    return state.states[k] != ContactState::open &&
           system.compliance(elements[k].normal_bar) > 0. &&
           -gap(elements[k], state, k) > visible * zero_gap;
  }

  void
  ContactBoundary::place_shear(const JointState &state, BoundaryElement &candidate) const
  {
    const std::size_t k           = candidate.element;
    const ContactElement &element = elements[k];
    const bool is_cone            = element.has_second_tangential_bar();
    const TangentVector T         = tangential(element, state.forces);
    const double size             = length(T);
    const double strength         = shear_strength(element, state, k);
    const double tolerance        = strength_tolerance(k, state.strengths[k]);
    const bool slipping           = is_slipping(state.states[k]);
    const bool resists            = state.strengths[k].resists_shear();
    if (strength <= tolerance && !(resists && is_visibly_closed(state, k)))
      {
        if (is_cone && !resists)
          return;
        candidate.shear = ShearPosition::at_apex;
        candidate.grazing |= resists && !state.strengths[k].has_bond();
      }
    else if (slipping || size >= strength - tolerance)
      {
        candidate.shear = ShearPosition::at_strength;
        if (is_cone)
          candidate.direction = direction_of(T);
        else
          candidate.direction = {
            {slipping ? slip_sign(state.states[k]) : std::copysign(1., T[0]), 0.}};
      }
  }

  Reserve
  ContactBoundary::gap_reserve(const std::size_t k,
                               const JointState &state,
                               const JointRates &rates,
                               const RateNoise &noise) const
  {
    return {lip_opening(elements[k], state, k),
            lip_opening_rate(elements[k], state, rates),
            zero_gap,
            noise.jump()};
  }

  Reserve
  ContactBoundary::tension_reserve(const std::size_t k,
                                   const JointState &state,
                                   const JointRates &rates,
                                   const Drive &drive,
                                   const RateNoise &noise) const
  {
    const std::size_t n = elements[k].normal_bar;
    return {tensile_strength(elements[k], state, k) - state.forces[n],
            tensile_strength_rate(elements[k], drive) - rates.forces[n],
            force_tolerances[n],
            noise.force(n)};
  }

  Reserve
  ContactBoundary::dilation_reserve(const std::size_t k,
                                    const JointState &state,
                                    const JointRates &rates,
                                    const RateNoise &noise) const
  {
    const double rise = state.strengths[k].dilatancy;
    return {elements[k].friction.dilation_limit - state.dilations[k],
            -rise * length(slip_rate(elements[k], state, k, rates)),
            zero_gap,
            rise * noise.jump()};
  }

  double
  ContactBoundary::noise_of_shear(const std::size_t k,
                                  const JointState &state,
                                  const RateNoise &noise) const
  {
    const ContactElement &element = elements[k];
    double shear                  = 0.;
    for (std::size_t i = 1; i < element.n_bars(); ++i)
      shear = std::max(shear, noise.force(element.bar(i)));
    return shear + state.strengths[k].friction * noise.force(element.normal_bar);
  }

  ContactBoundary::Shear
  ContactBoundary::shear(const std::size_t k,
                         const JointState &state,
                         const JointRates &rates,
                         const Drive &drive) const
  {
    const ContactElement &element = elements[k];
    const double friction         = strength_line(element, state, k).friction;
    return {tangential(element, state.forces),
            tangential(element, rates.forces),
            shear_strength(element, state, k),
            -friction * rates.forces[element.normal_bar] +
              shear_strength_rate(element, friction, drive),
            strength_tolerance(k, state.strengths[k])};
  }

  // Along one tangent both directions are considered, since |T| has a kink.
  void
  ContactBoundary::append_shear_reserves(const std::size_t k,
                                         const JointState &state,
                                         const JointRates &rates,
                                         const Drive &drive,
                                         const RateNoise &noise,
                                         std::vector<Reserve> &reserves) const
  {
    const auto [T, T_rate, strength, strength_rate, tolerance] = shear(k, state, rates, drive);
    const double of_rates                                      = noise_of_shear(k, state, noise);
    if (elements[k].has_second_tangential_bar())
      {
        const double size   = length(T);
        const double growth = size > 0. ? dot(T, T_rate) / size : length(T_rate);
        reserves.push_back({strength - size, strength_rate - growth, tolerance, of_rates});
      }
    else
      for (const double sign : {1., -1.})
        reserves.push_back(
          {strength - sign * T[0], strength_rate - sign * T_rate[0], tolerance, of_rates});
  }

  double
  ContactBoundary::distance_from_cone(const std::size_t k,
                                      const JointState &state,
                                      const JointRates &rates,
                                      const Drive &drive,
                                      const RateNoise &noise) const
  {
    const ContactElement &element                              = elements[k];
    const auto [T, T_rate, strength, strength_rate, tolerance] = shear(k, state, rates, drive);
    if (element.has_second_tangential_bar())
      {
        const double size = strength + length(T);
        const double a    = strength_rate * strength_rate - dot(T_rate, T_rate);
        const double b    = strength * strength_rate - dot(T, T_rate);
        if (strength - length(T) > tolerance)
          return descending_root(a, b, (strength - length(T)) * size);
        // The shear is on the cone. The rate problem has ensured that the element does not leave it
        // at once.
        return a < 0. && size > tolerance && b > 0. ? -2. * b / a : no_boundary;
      }
    const double noise_of_value =
      tolerance + RateNoise::share * std::abs(rates.forces[element.normal_bar]);
    double nearest = no_boundary;
    for (const double sign : {1., -1.})
      nearest = std::min(nearest,
                         used_up_after({strength - sign * T[0],
                                        strength_rate - sign * T_rate[0],
                                        noise_of_value,
                                        noise_of_shear(k, state, noise)}));
    return nearest;
  }

  double
  ContactBoundary::distance_of(const std::size_t k,
                               const JointState &state,
                               const JointRates &rates,
                               const Drive &drive,
                               const RateNoise &noise) const
  {
    if (state.states[k] == ContactState::open)
      return used_up_after(gap_reserve(k, state, rates, noise));
    const Strength &strength = state.strengths[k];
    double nearest           = used_up_after(tension_reserve(k, state, rates, drive, noise));
    if (is_slipping(state.states[k]) && strength.dilatancy > 0.)
      nearest = std::min(nearest, used_up_after(dilation_reserve(k, state, rates, noise)));
    if (state.states[k] == ContactState::stick && carries_shear(elements[k], strength))
      nearest = std::min(nearest, distance_from_cone(k, state, rates, drive, noise));
    return nearest;
  }

  double
  ContactBoundary::distance(const JointState &state,
                            const JointRates &rates,
                            const Drive &drive) const
  {
    double nearest = no_boundary;
    const RateNoise noise(system, rates, drive);
    for (std::size_t k = 0; k < elements.size(); ++k)
      nearest = std::min(nearest, distance_of(k, state, rates, drive, noise));
    return nearest;
  }

  std::vector<Reserve>
  ContactBoundary::reserves(const JointState &state,
                            const JointRates &rates,
                            const Drive &drive) const
  {
    std::vector<Reserve> result;
    const RateNoise noise(system, rates, drive);
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        if (state.states[k] == ContactState::open)
          {
            result.push_back(gap_reserve(k, state, rates, noise));
            continue;
          }
        result.push_back(tension_reserve(k, state, rates, drive, noise));
        if (!carries_shear(elements[k], state.strengths[k]))
          continue;
        if (state.states[k] == ContactState::stick)
          append_shear_reserves(k, state, rates, drive, noise, result);
        else if (state.strengths[k].dilatancy > 0.)
          result.push_back(dilation_reserve(k, state, rates, noise));
      }
    return result;
  }
} // namespace fuga
