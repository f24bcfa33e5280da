// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/cone_path.h>
#include <fuga/contact/layer_response.h>

#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    void
    check_path(const LoadHistory &history, const PathOptions &options)
    {
      const auto check = [](const bool asked_for, const char *what) {
        if (asked_for)
          throw InputError(std::string(what) +
                           " is not available for friction with two directions of slip.");
      };
      check(options.beyond_limit, "A path beyond the limit load");
      for (double t = 0.; t < history.end(); t = history.next_corner(t))
        check(history.strength_share(t) != 1. || history.strength_share_rate(t) != 0.,
              "A strength reduction");
    }
  } // namespace

  std::string
  unavailable_in_cone_path(const ContactElement &element)
  {
    if (!element.friction.is_plain())
      return "cohesion, tensile strength, residual friction and dilatancy";
    if (element.coupling != nullptr)
      return "a shear stiffness that grows with closure or pressure";
    if (has_nonlinear_closure(element) ||
        (element.has_tangential_bar() && has_nonlinear_shear(element)))
      return "a nonlinear law of the layer";
    return {};
  }

  ConePath::ConePath(const std::vector<ContactElement> &contact_elements,
                     const LayeredSystem &layered_system,
                     const LoadHistory &load_history,
                     const PathOptions &options)
    : ContactPath(contact_elements, layered_system, load_history)
    , boundary(elements, system)
    , released(system)
    , rate_problem(elements, system)
    , ever_active(system.n_bars(), false)
  {
    check_path(history, options);
    require_available(unavailable_in_cone_path, "for friction with two directions of slip");
  }

  PathResult
  ConePath::follow(const std::vector<double> &levels, ReportCounter &observer)
  {
    JointState state  = cut.state;
    PathResult result = cut.result;
    while (state.t < history.end() || state.is_unsettled())
      {
        make_cut(state, result, observer);
        const Course course = next_course(state);
        boundary.set_scales(state, course.factors, widening_of_tolerances());
        const ConeContinuation continuation = decide(state, course, observer, result);
        if (!continuation.exists)
          {
            lose_equilibrium(state, continuation, observer, result);
            return result;
          }
        if (let_water_follow(boundary.all_force_tolerances(), state, observer, result))
          continue; // water comes in or is squeezed out before the load goes on

        ConeSegment segment({elements, system, boundary, released},
                            course,
                            {state, continuation.rates},
                            directions,
                            iteration_count);
        const double length = find_end(segment, course, levels, observer);
        state               = report_piecewise(segment, course, levels, next_level, observer);
        note_step(segment, course, length, state, result);
        if (segment.ends_at_turning_point())
          {
            result.verdict = Verdict::no_continuation;
            take_critical_elements(state, result);
            return result;
          }
        if (segment.ends_at_limit())
          {
            // What closed layers still deform is no part of the mechanism.
            JointRates motion = segment.at(length).rates;
            motion.forces.assign(system.n_bars(), 0.);
            take_limit(state, motion, result);
            return result;
          }
      }
    standstill.forget();
    make_cut(state, result, observer);
    return result;
  }

  // Those of the elements on a boundary are unknowns of the rate problem.
  bool
  ConePath::release_open_elements(const JointState &state, const std::vector<BoundaryElement> &set)
  {
    std::vector<bool> on_boundary(elements.size(), false);
    for (const BoundaryElement &candidate : set)
      on_boundary[candidate.element] = true;
    std::vector<std::size_t> bars;
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        const bool open               = state.states[k] == ContactState::open && !on_boundary[k];
        if (open)
          bars.push_back(element.normal_bar);
        if (element.has_tangential_bar() && (open || !has_friction(element)))
          {
            bars.push_back(element.tangential_bar);
            if (element.has_second_tangential_bar())
              bars.push_back(element.second_tangential_bar);
          }
      }
    if (bars == released.released_bars() && !bars.empty())
      return true;
    ++scheme_work.n_factorisations;
    return released.release(bars);
  }

  ConeContinuation
  ConePath::decide(JointState &state,
                   const Course &course,
                   PathObserver &observer,
                   PathResult &result)
  {
    const std::vector<BoundaryElement> set = standstill.unite(boundary.elements_on_boundary(state));
    ConeContinuation continuation;
    if (!release_open_elements(state, set))
      {
        continuation.has_mechanism = true;
        continuation.mechanism     = released.mechanism();
        return continuation;
      }
    continuation = rate_problem.solve(state, set, released, course.drive.reactions, resticking);
    result.n_schemes += continuation.n_schemes;
    if (!continuation.exists)
      return continuation;
    directions.assign(elements.size(), TangentVector{{1., 0.}});
    for (std::size_t i = 0; i < set.size(); ++i)
      directions[set[i].element] = continuation.directions[i];
    adopt(state, set, continuation.states, observer, result);
    for (std::size_t bar = 0; bar < system.n_bars(); ++bar)
      if (continuation.rates.dislocations[bar] != 0. && !ever_active[bar])
        {
          ever_active[bar] = true;
          ++scheme_work.n_bars_ever_active;
        }
    if (!release_open_elements(state, {}))
      {
        continuation.exists        = false;
        continuation.has_mechanism = true;
        continuation.mechanism     = released.mechanism();
      }
    return continuation;
  }

  void
  ConePath::adopt(JointState &state,
                  const std::vector<BoundaryElement> &set,
                  const std::vector<ContactState> &states,
                  PathObserver &observer,
                  PathResult &result)
  {
    std::vector<ContactEvent> events;
    for (std::size_t i = 0; i < set.size(); ++i)
      {
        const std::size_t k = set[i].element;
        if (state.states[k] != states[i])
          events.push_back(
            change_element(k, states[i], boundary.force_tolerance(elements[k].normal_bar), state));
      }
    report(events, state, observer, result);
  }

  void
  ConePath::take_critical_elements(const JointState &state, PathResult &result) const
  {
    result.t          = state.t;
    result.critical.t = state.t;
    for (std::size_t k = 0; k < elements.size(); ++k)
      if (is_slipping(state.states[k]) && has_friction(elements[k]))
        result.critical.elements.push_back(k);
  }

  // The elements that reach their boundary at the limit take the state in which the mechanism
  // moves.
  void
  ConePath::lose_equilibrium(JointState &state,
                             const ConeContinuation &continuation,
                             PathObserver &observer,
                             PathResult &result)
  {
    result.t = state.t;
    if (!continuation.has_mechanism || !is_free_motion(continuation.mechanism, system))
      {
        result.verdict = Verdict::no_continuation;
        result.tried =
          fmt::format("Newton's method tried {} sets of states of {} elements on the "
                      "boundary of their contact conditions, also from a softer layer, "
                      "from associated friction and with sweeps from element to element",
                      continuation.n_schemes,
                      boundary.elements_on_boundary(state).size());
        take_critical_elements(state, result);
        return;
      }
    take_limit(state, continuation.mechanism, result);
    const std::vector<BoundaryElement> set = boundary.elements_on_boundary(state);
    std::vector<ContactState> states;
    for (const BoundaryElement &candidate : set)
      states.push_back(
        state_in_mechanism(candidate, elements[candidate.element], state, result.mechanism_jumps));
    adopt(state, set, states, observer, result);
  }
} // namespace fuga
