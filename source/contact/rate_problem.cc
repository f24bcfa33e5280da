// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/layer_response.h>
#include <fuga/contact/lemke.h>
#include <fuga/contact/rate_problem.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace fuga
{
  RateProblem::RateProblem(const std::vector<ContactElement> &contact_elements,
                           const LayeredSystem &layered_system,
                           WorkingScheme &working_scheme)
    : elements(contact_elements), system(layered_system), scheme(working_scheme)
  {
  }

  std::vector<ContactState>
  admissible_states(const BoundaryElement &element)
  {
    std::vector<ContactState> states = {ContactState::stick};
    if (element.shear == ShearPosition::at_apex ||
        (element.shear == ShearPosition::at_strength && element.sign > 0.))
      states.push_back(ContactState::slip_forward);
    if (element.shear == ShearPosition::at_apex ||
        (element.shear == ShearPosition::at_strength && element.sign < 0.))
      states.push_back(ContactState::slip_backward);
    if (element.grazing)
      states.push_back(ContactState::open);
    return states;
  }

  Continuation
  RateProblem::solve(const JointState &state,
                     const std::vector<BoundaryElement> &set,
                     const Drive &drive)
  {
    Continuation result;
    if (switch_states(state, set, drive, Stride::all_at_once, result))
      return result;
    result.method = RateMethod::single_switching;
    if (switch_states(state, set, drive, Stride::one_at_a_time, result))
      return result;
    if (set.size() <= max_enumerated)
      {
        result.method = RateMethod::enumeration;
        if (enumerate(state, set, drive, true, result) > 0)
          return result;
      }
    result.method = RateMethod::lemke;
    complementarity(state, set, drive, result);
    return result;
  }

  // An element that the rates drive shut will first slip if it moves along more than across, both
  // measured by the stiffness of the bars: the guess of Newton's method for the augmented
  // Lagrangian.
  ContactState
  RateProblem::state_on_closing(const JointState &state,
                                const BoundaryElement &candidate,
                                const JointRates &rates) const
  {
    const ContactElement &element = elements[candidate.element];
    if (candidate.shear != ShearPosition::at_apex)
      return ContactState::stick;
    const std::size_t n = element.normal_bar, t = element.tangential_bar;
    const double pressing = -system.stiffness()(n, n) * rates.dislocations[n];
    const double shearing = system.stiffness()(t, t) * rates.dislocations[t];
    if (std::abs(shearing) <= state.strengths[candidate.element].friction * pressing)
      return ContactState::stick;
    return shearing > 0. ? ContactState::slip_forward : ContactState::slip_backward;
  }

  std::vector<RateProblem::Switch>
  RateProblem::violations(const JointState &state,
                          const std::vector<BoundaryElement> &set,
                          const Drive &drive,
                          const JointRates &rates) const
  {
    std::vector<Switch> switches;
    const ContactBoundary::RateNoise noise(system, rates, drive);
    for (const BoundaryElement &candidate : set)
      {
        const std::size_t k           = candidate.element;
        const ContactElement &element = elements[k];
        const ContactState now        = scheme.state(k);
        const double dN               = rates.forces[element.normal_bar];
        const double N_noise          = noise.force(element.normal_bar);
        if (now == ContactState::open)
          {
            if (rates.dislocations[element.normal_bar] < -noise.jump())
              switches.push_back({k, state_on_closing(state, candidate, rates)});
            continue;
          }
        if (candidate.grazing && dN > N_noise)
          {
            switches.push_back({k, ContactState::open});
            continue;
          }
        if (candidate.shear == ShearPosition::inside)
          continue;
        if (is_slipping(now))
          {
            if (slip_sign(now) * slip_rate(element, state, k, rates) < -noise.jump())
              switches.push_back({k, ContactState::stick});
            continue;
          }
        const double f  = state.strengths[k].friction;
        const double dT = rates.forces[element.tangential_bar];
        const double sign =
          candidate.shear == ShearPosition::at_apex ? std::copysign(1., dT) : candidate.sign;
        const double shear_noise = noise.force(element.tangential_bar) + f * N_noise;
        if (sign * dT + f * dN - cohesive_strength_rate(element, drive) > shear_noise)
          switches.push_back(
            {k, sign > 0. ? ContactState::slip_forward : ContactState::slip_backward});
      }
    return switches;
  }

  // Switches violating elements until none is left. A scheme that comes back, or one that is a
  // mechanism, ends the attempt: then the next method has to decide.
  bool
  RateProblem::switch_states(const JointState &state,
                             const std::vector<BoundaryElement> &set,
                             const Drive &drive,
                             const Stride stride,
                             Continuation &result)
  {
    std::set<std::vector<ContactState>> visited;
    const std::size_t max_schemes = stride == Stride::all_at_once ? 60 : 20 + 4 * set.size();
    for (std::size_t count = 0; count < max_schemes; ++count)
      {
        ++result.n_schemes;
        std::vector<ContactState> present;
        for (const BoundaryElement &candidate : set)
          present.push_back(scheme.state(candidate.element));
        if (!visited.insert(std::move(present)).second)
          return false;
        const std::optional<JointRates> rates = scheme.rates(drive);
        if (!rates)
          return false;
        const std::vector<Switch> switches = violations(state, set, drive, *rates);
        if (switches.empty())
          {
            result.exists = true;
            result.rates  = *rates;
            return true;
          }
        const std::size_t n = stride == Stride::all_at_once ? switches.size() : 1;
        for (std::size_t i = 0; i < n; ++i)
          scheme.set_state(switches[i].element, switches[i].to);
      }
    return false;
  }

  unsigned int
  RateProblem::enumerate(const JointState &state,
                         const std::vector<BoundaryElement> &set,
                         const Drive &drive,
                         const bool stop_at_first,
                         Continuation &result)
  {
    std::vector<std::vector<ContactState>> choices;
    for (const BoundaryElement &candidate : set)
      choices.push_back(admissible_states(candidate));
    std::vector<std::size_t> choice(set.size(), 0);
    unsigned int n_found = 0;
    while (true)
      {
        ++result.n_schemes;
        for (std::size_t i = 0; i < set.size(); ++i)
          scheme.set_state(set[i].element, choices[i][choice[i]]);
        const std::optional<JointRates> rates = scheme.rates(drive);
        if (rates && violations(state, set, drive, *rates).empty())
          {
            ++n_found;
            result.exists = true;
            result.rates  = *rates;
            if (stop_at_first)
              return n_found;
          }
        std::size_t digit = 0;
        while (digit < set.size() && ++choice[digit] == choices[digit].size())
          choice[digit++] = 0;
        if (digit == set.size())
          return n_found;
      }
  }

  unsigned int
  RateProblem::count_continuations(const JointState &state,
                                   const std::vector<BoundaryElement> &set,
                                   const Drive &drive)
  {
    Continuation unused;
    return enumerate(state, set, drive, false, unused);
  }
} // namespace fuga
