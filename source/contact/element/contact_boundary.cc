// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/contact_boundary.h>
#include <fuga/contact/element/layer_response.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Forces and gaps below this share of the terms they are the difference of are zero. */
    constexpr double value_tolerance = 1e-12;
    /** Share of it that is enough where forces are small differences of their terms, the last digit
     * of which it is: what begins to slip must not begin off its cone. */
    constexpr double of_small_differences = 1e-4;
    /** The same in space, beside the forces that act: with less of it slips begin and rest again
     * and again where rigid joints cross, with more elements begin to slip off their cones. */
    constexpr double of_small_differences_in_space = 1e-2;
    /** The same for rates, which come out of a linear solution. */
    constexpr double rate_tolerance = 1e-10;
    /** Share of the forces that drive a motion above which no rate is noise: where bodies move far
     * beside what they deform, refinement keeps their forces better than their terms tell. */
    constexpr double largest_force_noise = 1e-9;
    /** Shares of d and D p that count for a nonlinear bar, whose jump d + D p may be much smaller
     * than either: their rounding errors, not the size of the jump. */
    constexpr double value_rounding = 1e-2, rate_rounding = 1e-3;
    /** In space no force tolerance is below this share of the largest: a few times the rounding of
     * the largest forces. */
    constexpr double smallest_share = 1e-3;
    /** Nor does it grow, in space, beyond this share of the forces that act, be steps without
     * length ever so many: an element that opens with a force, or slips off its cone, is no
     * equilibrium. */
    constexpr double largest_share = 1e-10;

    /** The smallest τ > 0 at which c + 2bτ + aτ² goes from positive to negative, if c > 0. */
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
  } // namespace

  double
  used_up_after(const Reserve &reserve, const double noise)
  {
    if (reserve.rate >= 0. ||
        (reserve.value <= reserve.tolerance && reserve.rate >= -std::max(reserve.tolerance, noise)))
      return no_boundary;
    return std::max(0., -reserve.value / reserve.rate);
  }

  ContactBoundary::ContactBoundary(const std::vector<ContactElement> &contact_elements,
                                   const LayeredSystem &layered_system)
    : elements(contact_elements)
    , system(layered_system)
    , has_cones(have_two_tangents(contact_elements))
    , force_tolerances(layered_system.n_bars(), 0.)
  {
  }

  // A force is the sum of the reactions of the stuck joint to all loads and of the effects of the
  // dislocations; the size of these terms, not of their sum, tells its rounding error. Where terms
  // far above all forces cancel, their last digit counts, and more of them only as steps without
  // length show that it is unknown.
  void
  ContactBoundary::set_scales(const JointState &state, const Vector &factors, const double widening)
  {
    const double scaled_dislocation = system.scaled_size(state.dislocations);
    const double relative           = value_tolerance * widening;
    const Vector jumps              = system.jumps(state.dislocations, state.forces);
    const DenseMatrix &R            = system.reactions();
    Vector given(force_tolerances.size(), 0.);
    for (std::size_t j = 0; j < factors.size(); ++j)
      for (std::size_t i = 0; i < given.size(); ++i)
        given[i] += std::abs(R(i, j) * factors[j]);
    for (std::size_t i = 0; i < state.water.size(); ++i)
      given[i] += std::abs(state.water[i]);
    const double least_share   = has_cones ? of_small_differences_in_space
                                           : std::min(1., of_small_differences * widening * widening);
    const double largest_force = std::max(has_cones ? 0. : max_abs(given), max_abs(state.forces));
    double largest_jump        = 0.;
    for (std::size_t i = 0; i < force_tolerances.size(); ++i)
      {
        const double terms = given[i] + system.scale(i) * scaled_dislocation;
        const double size  = std::min(terms, std::max(least_share * terms, largest_force));
        force_tolerances[i] =
          has_cones ? std::min(relative * size,
                               std::max(value_tolerance * size, largest_share * largest_force))
                    : relative * size;
        const double parts = std::max(std::abs(state.dislocations[i]),
                                      system.compliance(i) * std::abs(state.forces[i]));
        largest_jump       = std::max(
          largest_jump,
          system.is_curved(i) ? std::max(std::abs(jumps[i]), value_rounding * parts) : parts);
      }
    for (const ContactElement &element : elements)
      largest_jump = std::max(largest_jump, element.initial_gap);
    zero_gap = relative * largest_jump;
    // A soft layer turns a force of rounding into a closure that is none: where it opens, what is
    // no force must leave no gap either.
    for (std::size_t i = 0; i < force_tolerances.size(); ++i)
      if (system.is_curved(i))
        force_tolerances[i] =
          std::max(value_rounding * force_tolerances[i],
                   std::min(force_tolerances[i], zero_gap / system.compliance(i)));
    if (!has_cones)
      return;
    const double smallest = smallest_share * max_abs(force_tolerances);
    for (double &tolerance : force_tolerances)
      tolerance = std::max(tolerance, smallest);
  }

  void
  ContactBoundary::take_unresolved(const JointRates &rates, const double length)
  {
    for (std::size_t i = 0; i < rates.forces.size(); ++i)
      force_tolerances[i] = std::max(force_tolerances[i], length * std::abs(rates.forces[i]));
    zero_gap = std::max(zero_gap, length * max_abs(rates.dislocations));
  }

  bool
  ContactBoundary::take_for_closed(const double gap)
  {
    const bool is_wider = gap > zero_gap;
    zero_gap            = std::max(zero_gap, gap);
    return is_wider;
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

  double
  ContactBoundary::strength_tolerance(const std::size_t k, const Strength &strength) const
  {
    const ContactElement &element = elements[k];
    const double shear            = force_tolerances[element.tangential_bar];
    return (element.has_second_tangential_bar()
              ? std::max(shear, force_tolerances[element.second_tangential_bar])
              : shear) +
           strength.friction * force_tolerances[element.normal_bar];
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
    if (is_cone && strength <= tolerance && !state.strengths[k].resists_shear())
      return;
    if (strength <= tolerance)
      {
        candidate.shear = ShearPosition::at_apex;
        candidate.grazing |= is_cone && !state.strengths[k].has_bond();
      }
    else if (slipping || size >= strength - tolerance)
      {
        candidate.shear = ShearPosition::at_strength;
        candidate.sign  = is_cone    ? 1.
                          : slipping ? slip_sign(state.states[k])
                                     : std::copysign(1., T[0]);
        if (is_cone)
          candidate.direction = direction_of(T);
      }
  }

  Reserve
  ContactBoundary::gap_reserve(const std::size_t k,
                               const JointState &state,
                               const JointRates &rates) const
  {
    return {
      lip_opening(elements[k], state, k), lip_opening_rate(elements[k], state, rates), zero_gap};
  }

  Reserve
  ContactBoundary::tension_reserve(const std::size_t k,
                                   const JointState &state,
                                   const JointRates &rates,
                                   const Drive &drive) const
  {
    const std::size_t n = elements[k].normal_bar;
    return {tensile_strength(elements[k], state, k) - state.forces[n],
            tensile_strength_rate(elements[k], drive) - rates.forces[n],
            force_tolerances[n]};
  }

  Reserve
  ContactBoundary::dilation_reserve(const std::size_t k,
                                    const JointState &state,
                                    const JointRates &rates) const
  {
    return {elements[k].friction.dilation_limit - state.dilations[k],
            -state.strengths[k].dilatancy * length(slip_rate(elements[k], state, k, rates)),
            zero_gap};
  }

  ContactBoundary::Shear
  ContactBoundary::shear(const std::size_t k,
                         const JointState &state,
                         const JointRates &rates,
                         const Drive &drive) const
  {
    const ContactElement &element = elements[k];
    return {tangential(element, state.forces),
            tangential(element, rates.forces),
            shear_strength(element, state, k),
            -state.strengths[k].friction * rates.forces[element.normal_bar] +
              shear_strength_rate(element, state.strengths[k].friction, drive),
            strength_tolerance(k, state.strengths[k])};
  }

  // Along one tangent both directions, as |T| has a kink.
  void
  ContactBoundary::append_shear_reserves(const std::size_t k,
                                         const JointState &state,
                                         const JointRates &rates,
                                         const Drive &drive,
                                         std::vector<Reserve> &reserves) const
  {
    const auto [T, T_rate, strength, strength_rate, tolerance] = shear(k, state, rates, drive);
    if (elements[k].has_second_tangential_bar())
      {
        const double size   = length(T);
        const double growth = size > 0. ? dot(T, T_rate) / size : length(T_rate);
        reserves.push_back({strength - size, strength_rate - growth, tolerance});
      }
    else
      for (const double sign : {1., -1.})
        reserves.push_back({strength - sign * T[0], strength_rate - sign * T_rate[0], tolerance});
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
        // On the cone. The rate problem has seen to it that the element does not leave it at once.
        return a < 0. && size > tolerance && b > 0. ? -2. * b / a : no_boundary;
      }
    const double noise_of_shear = noise.force(element.tangential_bar) +
                                  state.strengths[k].friction * noise.force(element.normal_bar);
    const double noise_of_value =
      tolerance + rate_tolerance * std::abs(rates.forces[element.normal_bar]);
    double nearest = no_boundary;
    for (const double sign : {1., -1.})
      nearest = std::min(
        nearest,
        used_up_after({strength - sign * T[0], strength_rate - sign * T_rate[0], noise_of_value},
                      noise_of_shear));
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
      return used_up_after(gap_reserve(k, state, rates), noise.jump());
    const Strength &strength = state.strengths[k];
    double nearest =
      used_up_after(tension_reserve(k, state, rates, drive), noise.force(elements[k].normal_bar));
    if (is_slipping(state.states[k]) && strength.dilatancy > 0.)
      nearest = std::min(
        nearest,
        used_up_after(dilation_reserve(k, state, rates), strength.dilatancy * noise.jump()));
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
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        if (state.states[k] == ContactState::open)
          {
            result.push_back(gap_reserve(k, state, rates));
            continue;
          }
        result.push_back(tension_reserve(k, state, rates, drive));
        if (!carries_shear(elements[k], state.strengths[k]))
          continue;
        if (state.states[k] == ContactState::stick)
          append_shear_reserves(k, state, rates, drive, result);
        else if (state.strengths[k].dilatancy > 0.)
          result.push_back(dilation_reserve(k, state, rates));
      }
    return result;
  }

  ContactBoundary::RateNoise::RateNoise(const LayeredSystem &layered_system,
                                        const JointRates &rates,
                                        const Drive &path_drive)
    : system(layered_system)
    , drive(path_drive)
    , scaled_dislocation(system.scaled_size(rates.dislocations))
  {
    const Vector jumps = system.jumps(rates.dislocations, rates.forces);
    double size        = 0.;
    for (std::size_t i = 0; i < jumps.size(); ++i)
      {
        const double parts = std::max(std::abs(rates.dislocations[i]),
                                      system.compliance(i) * std::abs(drive.reactions[i]));
        size               = std::max(
          size, system.is_curved(i) ? std::max(std::abs(jumps[i]), rate_rounding * parts) : parts);
      }
    jump_noise    = rate_tolerance * size;
    largest_noise = largest_force_noise * max_abs(drive.reactions);
  }

  double
  ContactBoundary::RateNoise::force(const std::size_t bar) const
  {
    const double strength = drive.strength.empty() ? 0. : std::abs(drive.strength[bar]);
    const double terms =
      std::abs(drive.reactions[bar]) + system.scale(bar) * scaled_dislocation + strength;
    return largest_noise > 0. ? std::min(rate_tolerance * terms, largest_noise)
                              : rate_tolerance * terms;
  }
} // namespace fuga
