// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/contact_boundary.h>
#include <fuga/contact/layer_response.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Forces and gaps below this share of the terms they are the difference of are zero. */
    constexpr double value_tolerance = 1e-12;
    /** The same for rates, which come out of a linear solution. */
    constexpr double rate_tolerance = 1e-10;
    /** Share of the forces that drive a motion above which no rate is noise: where bodies move far
     * beside what they deform, refinement keeps their forces better than their terms tell. */
    constexpr double largest_force_noise = 1e-9;
    /** Shares of d and D p that count for a nonlinear bar, whose jump d + D p may be much smaller
     * than either: their rounding errors, not the size of the jump. */
    constexpr double value_rounding = 1e-2, rate_rounding = 1e-3;
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
    , force_tolerances(layered_system.n_bars(), 0.)
  {
  }

  // A force is the sum of the reactions of the stuck joint to all loads and of the effects of the
  // dislocations; the size of these terms, not of their sum, tells its rounding error.
  void
  ContactBoundary::set_scales(const JointState &state, const Vector &factors, const double widening)
  {
    const DenseMatrix &R            = system.reactions();
    const double scaled_dislocation = system.scaled_size(state.dislocations);
    const double relative           = value_tolerance * widening;
    const Vector jumps              = system.jumps(state.dislocations, state.forces);
    double largest_jump             = 0.;
    for (std::size_t i = 0; i < force_tolerances.size(); ++i)
      {
        double terms = system.scale(i) * scaled_dislocation;
        for (std::size_t j = 0; j < factors.size(); ++j)
          terms += std::abs(R(i, j) * factors[j]);
        if (!state.water.empty())
          terms += std::abs(state.water[i]);
        force_tolerances[i] = relative * terms;
        const double parts  = std::max(std::abs(state.dislocations[i]),
                                      system.compliance(i) * std::abs(state.forces[i]));
        largest_jump        = std::max(
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

  void
  ContactBoundary::place_shear(const JointState &state, BoundaryElement &candidate) const
  {
    const std::size_t k           = candidate.element;
    const ContactElement &element = elements[k];
    const double T                = state.forces[element.tangential_bar];
    const double strength         = shear_strength(element, state, k);
    const double tolerance        = force_tolerances[element.tangential_bar] +
                             state.strengths[k].friction * force_tolerances[element.normal_bar];
    const bool slipping = is_slipping(state.states[k]);
    if (strength <= tolerance)
      candidate.shear = ShearPosition::at_apex;
    else if (slipping || std::abs(T) >= strength - tolerance)
      {
        candidate.shear = ShearPosition::at_strength;
        candidate.sign  = slipping ? slip_sign(state.states[k]) : std::copysign(1., T);
      }
  }

  double
  ContactBoundary::distance_of(const std::size_t k,
                               const JointState &state,
                               const JointRates &rates,
                               const Drive &drive,
                               const RateNoise &noise) const
  {
    const ContactElement &element = elements[k];
    const std::size_t n = element.normal_bar, t = element.tangential_bar;
    const double force_rate_noise = rate_tolerance * std::abs(rates.forces[n]);
    if (state.states[k] == ContactState::open)
      return used_up_after(
        {lip_opening(element, state, k), lip_opening_rate(element, state, rates), zero_gap},
        noise.jump());

    const Strength &strength_left = state.strengths[k];
    double nearest = used_up_after({tensile_strength(element, state, k) - state.forces[n],
                                    tensile_strength_rate(element, drive) - rates.forces[n],
                                    force_tolerances[n]},
                                   noise.force(n));
    if (is_slipping(state.states[k]) && strength_left.dilatancy > 0.)
      nearest = std::min(
        nearest,
        used_up_after({element.friction.dilation_limit - state.dilations[k],
                       -strength_left.dilatancy * length(slip_rate(element, state, k, rates)),
                       zero_gap},
                      strength_left.dilatancy * noise.jump()));
    if (state.states[k] == ContactState::stick && element.has_tangential_bar())
      for (const double sign : {1., -1.})
        {
          const double f         = strength_left.friction;
          const double strength  = shear_strength(element, state, k);
          const double tolerance = force_tolerances[t] + f * force_tolerances[n] + force_rate_noise;
          nearest =
            std::min(nearest,
                     used_up_after({strength - sign * state.forces[t],
                                    -f * rates.forces[n] + shear_strength_rate(element, drive) -
                                      sign * rates.forces[t],
                                    tolerance},
                                   noise.force(t) + f * noise.force(n)));
        }
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
