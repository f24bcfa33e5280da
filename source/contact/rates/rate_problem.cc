// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/element/mechanism.h>
#include <fuga/contact/rates/rate_problem.h>
#include <fuga/contact/scheme/combinations.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace fuga
{
  namespace
  {
    /** Number of mechanisms that one attempt to switch states one by one may pass through. */
    constexpr std::size_t most_mechanisms = 12;
    /** Number of combinations of states that are tried where the only alternative is not to
     * know. */
    constexpr double most_combinations_at_last = 1e5;
  } // namespace

  RateProblem::RateProblem(const std::vector<ContactElement> &contact_elements,
                           const LayeredSystem &layered_system,
                           WorkingScheme &working_scheme)
    : elements(contact_elements)
    , system(layered_system)
    , scheme(working_scheme)
    , off_boundary(contact_elements, layered_system)
    , has_cones(have_two_tangents(contact_elements))
    , cones(contact_elements, layered_system)
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

  namespace
  {
    std::vector<std::vector<ContactState>>
    admissible_states(const std::vector<BoundaryElement> &set)
    {
      std::vector<std::vector<ContactState>> states;
      for (const BoundaryElement &candidate : set)
        states.push_back(fuga::admissible_states(candidate));
      return states;
    }
  } // namespace

  Continuation
  RateProblem::solve(const JointState &state,
                     const std::vector<BoundaryElement> &set,
                     const Drive &drive,
                     const std::vector<std::size_t> &resticking,
                     const double widening)
  {
    if (has_cones)
      return solve_cones(state, set, drive, resticking, widening);
    Continuation result;
    if (switch_states(state, set, drive, Stride::all_at_once, result))
      return result;
    result.method = RateMethod::single_switching;
    if (switch_states(state, set, drive, Stride::one_at_a_time, result))
      return result;
    if (set.size() <= max_enumerated)
      {
        result.method = RateMethod::enumeration;
        if (enumerate(state, set, drive, result, [] { return true; }))
          return result;
      }
    result.method = RateMethod::lemke;
    if (complementarity(state, set, drive, result) || set.size() <= max_enumerated)
      return result;
    // A free motion proves that there is no continuation, unless elements at the apex of the cone
    // are free to choose their direction: then, as where nothing moves freely and friction is
    // beyond its critical value, the only option is to try.
    const bool any_apex = std::any_of(set.begin(), set.end(), [](const BoundaryElement &candidate) {
      return candidate.shear == ShearPosition::at_apex;
    });
    if (!any_apex && result.has_mechanism && is_free_motion(result.mechanism, system))
      return result;
    result.method = RateMethod::search;
    if (can_be_enumerated(set))
      {
        enumerate(state, set, drive, result, [] { return true; });
        return result;
      }
    const std::vector<Branch> found = search_branches(state, set, drive, {}, 1);
    if (!found.empty())
      {
        take(set, found.front());
        result.exists = true;
        result.rates  = found.front().rates;
      }
    else
      search_all(state, set, drive, resticking, result);
    // An exhaustive search decides where nothing else does.
    if (!result.exists && !result.is_ruled_out &&
        n_combinations(admissible_states(set)) <= most_combinations_at_last)
      result.is_ruled_out = !enumerate(state, set, drive, result, [] { return true; });
    return result;
  }

  // An element that the rates drive shut will first slip if it moves along more than across, where
  // both are measured by the stiffness of the bars; this is the guess of Newton's method for the
  // augmented Lagrangian.
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
            if (lip_opening_rate(element, state, rates) < -noise.jump())
              switches.push_back({k, state_on_closing(state, candidate, rates)});
            continue;
          }
        if (candidate.grazing && dN - tensile_strength_rate(element, drive) > N_noise)
          {
            switches.push_back({k, ContactState::open});
            continue;
          }
        if (candidate.shear == ShearPosition::inside)
          continue;
        if (is_slipping(now))
          {
            if (dot(scheme.slip_direction_of(k), slip_rate(element, state, k, rates)) <
                -noise.jump())
              switches.push_back({k, ContactState::stick});
            continue;
          }
        const double f  = state.strengths[k].friction;
        const double dT = rates.forces[element.tangential_bar];
        const double sign =
          candidate.shear == ShearPosition::at_apex ? std::copysign(1., dT) : candidate.sign;
        const double shear_noise = noise.force(element.tangential_bar) + f * N_noise;
        if (sign * dT + f * dN - shear_strength_rate(element, f, drive) > shear_noise)
          switches.push_back(
            {k, sign > 0. ? ContactState::slip_forward : ContactState::slip_backward});
      }
    return switches;
  }

  std::optional<WorkingScheme::FreeMotion>
  RateProblem::rates_of_scheme(const Drive &drive, const bool last_resort)
  {
    std::optional<WorkingScheme::FreeMotion> motion = scheme.motion(drive);
    if (!motion)
      return motion;
    motion->rests &= scheme.is_nonlinear(); // beside linear layers nothing has to hold it
    motion->is_driven |= motion->rests && !last_resort;
    return motion;
  }

  // Violating elements are switched until none is left. A scheme that comes back, or a mechanism
  // that violates nothing as it moves, ends the attempt; the next method then has to decide.
  bool
  RateProblem::switch_states(const JointState &state,
                             const std::vector<BoundaryElement> &set,
                             const Drive &drive,
                             const Stride stride,
                             Continuation &result)
  {
    std::set<std::vector<ContactState>> visited;
    const std::size_t max_schemes = stride == Stride::all_at_once ? 60 : 20 + 4 * set.size();
    std::size_t n_mechanisms      = 0;
    for (std::size_t count = 0; count < max_schemes; ++count)
      {
        ++result.n_schemes;
        if (!visited.insert(states_of(set)).second)
          return false;
        const std::optional<WorkingScheme::FreeMotion> motion =
          rates_of_scheme(drive, stride == Stride::last_resort);
        if (!motion || (motion->is_driven &&
                        (stride == Stride::all_at_once || n_mechanisms++ == most_mechanisms)))
          return false;
        result.met_negative_determinant |= !motion->is_driven && scheme.determinant_sign() < 0;
        const std::vector<Switch> switches = violations(state, set, drive, motion->rates);
        if (switches.empty() && motion->is_driven)
          return false;
        if (switches.empty())
          {
            result.exists = true;
            result.rates  = motion->rates;
            result.rests  = motion->rests;
            return true;
          }
        const std::size_t n = stride == Stride::all_at_once ? switches.size() : 1;
        for (std::size_t i = 0; i < n; ++i)
          scheme.set_state(switches[i].element, switches[i].to);
      }
    return false;
  }

  template <typename Found>
  bool
  RateProblem::enumerate(const JointState &state,
                         const std::vector<BoundaryElement> &set,
                         const Drive &drive,
                         Continuation &result,
                         const Found &found)
  {
    const std::vector<std::vector<ContactState>> choices = admissible_states(set);
    std::vector<ContactState> last_resort;
    const bool any = any_combination(choices, [&](const std::vector<std::size_t> &chosen) {
      ++result.n_schemes;
      for (std::size_t i = 0; i < set.size(); ++i)
        scheme.set_state(set[i].element, choices[i][chosen[i]]);
      const std::optional<WorkingScheme::FreeMotion> motion = rates_of_scheme(drive, true);
      if (!motion || motion->is_driven || !violations(state, set, drive, motion->rates).empty())
        return false;
      if (motion->rests)
        {
          last_resort = states_of(set);
          return false;
        }
      result.exists = true;
      result.rates  = motion->rates;
      return found();
    });
    if (result.exists || last_resort.empty())
      return any;
    set_states(set, last_resort);
    return switch_states(state, set, drive, Stride::last_resort, result);
  }

  bool
  RateProblem::can_be_enumerated(const std::vector<BoundaryElement> &set) const
  {
    if (has_cones)
      return cones.can_be_enumerated();
    return n_combinations(admissible_states(set)) <= most_combinations;
  }

  std::vector<ContactState>
  RateProblem::states_of(const std::vector<BoundaryElement> &set) const
  {
    std::vector<ContactState> states;
    for (const BoundaryElement &candidate : set)
      states.push_back(scheme.state(candidate.element));
    return states;
  }

  void
  RateProblem::set_states(const std::vector<BoundaryElement> &set,
                          const std::vector<ContactState> &states)
  {
    for (std::size_t i = 0; i < set.size(); ++i)
      scheme.set_state(set[i].element, states[i]);
  }

  std::vector<Branch>
  RateProblem::branches(const JointState &state,
                        const std::vector<BoundaryElement> &set,
                        const Drive &drive)
  {
    if (has_cones)
      return branches_of_cones(state, set, drive);
    const std::vector<ContactState> present = states_of(set);
    std::vector<Branch> found;
    const std::optional<WorkingScheme::FreeMotion> motion = rates_of_scheme(drive);
    if (motion && !motion->is_driven && violations(state, set, drive, motion->rates).empty())
      found.push_back(present_branch(state, set, motion->rates));
    Continuation result;
    if (can_be_enumerated(set))
      enumerate(state, set, drive, result, [&] {
        if (is_new(found, result.rates, drive))
          found.push_back(present_branch(state, set, result.rates));
        return false;
      });
    else
      found = search_branches(state, set, drive, found, std::numeric_limits<std::size_t>::max());
    set_states(set, present);
    return found;
  }
} // namespace fuga
