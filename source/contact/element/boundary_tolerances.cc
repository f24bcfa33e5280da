// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/contact_boundary.h>

#include <algorithm>
#include <cmath>
#include <limits>

// The values of forces, gaps and their rates that count as zero.
namespace fuga
{
  namespace
  {
    /** Share of the terms whose difference they are, below which forces and gaps count as zero. */
    constexpr double value_tolerance = 1e-12;
    /** Share of this tolerance that is sufficient where forces are small differences of their
     * terms, so that it is their last digit: elements that begin to slip must not begin off their
     * cones. */
    constexpr double of_small_differences = 1e-4;
    /** The corresponding share in space, relative to the forces that act: with a smaller one slips
     * begin and rest again and again where rigid joints cross, with a larger one elements begin to
     * slip off their cones. */
    constexpr double of_small_differences_in_space = 1e-2;
    /** Share of the terms of a force that is their rounding where as many of them are added as
     * there are bars. */
    constexpr double few_last_digits = 4. * std::numeric_limits<double>::epsilon();
    /** Share of the reactions to all loads that counts as a force in a time step, whose loads hold
     * bodies at their present places and may be far above every force. */
    constexpr double of_reactions_in_motion = 1e-2;
    /** Share of the forces that drive a motion above which no rate is noise: where bodies move far
     * compared with their deformation, refinement gives their forces more accurately than their
     * terms indicate. */
    constexpr double largest_force_noise = 1e-9;
    /** Share below which every rate is noise: a few times the rounding of the largest of these
     * forces. */
    constexpr double least_force_noise = 1e-13;
    /** Shares of d and D p that count for a nonlinear bar, whose jump d + D p may be much smaller
     * than either: its noise is given by their rounding errors, not by the size of the jump. */
    constexpr double value_rounding = 1e-2, rate_rounding = 1e-3;
    /** Share of the largest force tolerance below which no force tolerance lies in space: a few
     * times the rounding of the largest forces. */
    constexpr double smallest_share = 1e-3;
    /** Share of the acting forces beyond which the tolerance does not grow in space, however many
     * steps of zero length there are: an element that opens with a force, or slips off its cone, is
     * not in equilibrium. */
    constexpr double largest_share = 1e-10;
  } // namespace

  // A force is the sum of the reactions of the stuck joint to all loads and of the effects of the
  // dislocations; the size of these terms, not of their sum, determines its rounding error. Where
  // terms far above all forces cancel, their last digit counts, and more digits only as steps of
  // zero length show that they are unknown.
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
    const double least_share = in_space ? of_small_differences_in_space
                                        : std::min(1., of_small_differences * widening * widening);
    const bool in_motion     = system.contact_system().force_scale() > 0.;
    const double of_given    = in_motion ? of_reactions_in_motion : 1.;
    const double largest_force =
      std::max(in_space ? 0. : of_given * max_abs(given), max_abs(state.forces));
    double largest_jump = 0.;
    last_digits         = 0.;
    for (std::size_t i = 0; i < force_tolerances.size(); ++i)
      {
        const double terms = given[i] + system.scale(i) * scaled_dislocation;
        const double size  = std::min(terms, std::max(least_share * terms, largest_force));
        last_digits        = std::max(last_digits, few_last_digits * terms);
        force_tolerances[i] =
          in_space ? std::min(relative * size,
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
    // A soft layer turns a force that is only rounding into a closure that does not exist: where it
    // opens, a force that counts as zero must not leave a gap either.
    for (std::size_t i = 0; i < force_tolerances.size(); ++i)
      if (system.is_curved(i))
        force_tolerances[i] =
          std::max(value_rounding * force_tolerances[i],
                   std::min(force_tolerances[i], zero_gap / system.compliance(i)));
    if (!in_space)
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
    jump_noise                    = share * size;
    const double largest_reaction = max_abs(drive.reactions);
    least_noise                   = least_force_noise * largest_reaction;
    if (largest_reaction > 0.)
      largest_noise = largest_force_noise * std::max(largest_reaction, max_abs(rates.forces));
  }

  double
  ContactBoundary::RateNoise::force(const std::size_t bar) const
  {
    const double strength = drive.strength.empty() ? 0. : std::abs(drive.strength[bar]);
    const double terms =
      std::abs(drive.reactions[bar]) + system.scale(bar) * scaled_dislocation + strength;
    return std::clamp(share * terms, least_noise, largest_noise);
  }
} // namespace fuga
