// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/change_of_state.h>
#include <fuga/contact/cone_path.h>
#include <fuga/contact/joint_water.h>
#include <fuga/contact/layer_response.h>
#include <fuga/contact/virgin_state.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** Steps shorter than this share of the load time do not count as progress. */
    constexpr double shortest_step = 1e-13;
    /** A jump below this share of the largest is none. */
    constexpr double no_jump = 1e-6;

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
    : elements(contact_elements)
    , system(layered_system)
    , history(load_history)
    , boundary(elements, system)
    , released(system)
    , rate_problem(elements, system)
    , ever_active(system.n_bars(), false)
  {
    check_path(history, options);
    for (const ContactElement &element : elements)
      if (const std::string what = unavailable_in_cone_path(element); !what.empty())
        throw InputError("Not available for friction with two directions of slip: " + what + ".");
  }

  PathResult
  ConePath::resume(const PathCut &from, const std::vector<double> &levels, PathObserver &observer)
  {
    cut             = from;
    next_level      = cut.next_level;
    resticking      = cut.resticking;
    iteration_count = cut.iterations;
    standstill      = Standstill();
    ReportCounter reports(observer, cut.n_reports);
    return follow(levels, reports);
  }

  PathResult
  ConePath::go_on(const PathCut &end, const std::vector<double> &levels, PathObserver &observer)
  {
    PathCut start    = end;
    start.resticking = {};
    start.n_reports  = 0;
    return resume(start, levels, observer);
  }

  void
  ConePath::make_cut(const JointState &state, const PathResult &result, ReportCounter &observer)
  {
    if (standstill.n_steps() > 0)
      return; // what is known at this load is not kept
    observer.start();
    if (!observer.wants_cuts())
      return;
    cut.state      = state;
    cut.result     = result;
    cut.iterations = iteration_count;
    cut.next_level = next_level;
    cut.resticking = resticking;
  }

  PathResult
  ConePath::run(const std::vector<double> &levels, PathObserver &observer)
  {
    PathCut start;
    start.state = virgin_state(elements, system.n_bars(), !system.opening_water().empty());
    return resume(start, levels, observer);
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
        const auto states                   = state.states;
        const ConeContinuation continuation = decide(state, course, observer, result);
        if (!continuation.exists)
          {
            lose_equilibrium(state, continuation, observer, result);
            return result;
          }
        if (water_has_changed(elements, system, states, state))
          {
            note_zero_step(state, result);
            continue; // water comes in or is squeezed out before the load goes on
          }

        ConeSegment segment({elements, system, boundary, released},
                            course,
                            {state, continuation.rates},
                            directions,
                            iteration_count);
        double length = 0.;
        try
          {
            length = segment.find_end();
          }
        catch (const NumericalFailure &)
          {
            report_piecewise(segment, course, levels, next_level, observer);
            throw;
          }
        state      = report_piecewise(segment, course, levels, next_level, observer);
        resticking = segment.resticking();
        result.t   = state.t;
        ++result.n_steps;
        if (length > shortest_step * std::max(1., course.t))
          standstill.forget();
        else
          note_zero_step(state, result);
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

  double
  ConePath::widening_of_tolerances() const
  {
    const std::size_t n = standstill.n_steps() / 4 + standstill.n_repetitions();
    return std::pow(10., static_cast<double>(std::min<std::size_t>(3, n)));
  }

  void
  ConePath::note_zero_step(const JointState &state, PathResult &result)
  {
    ++result.n_zero_steps;
    standstill.note(state.states);
    if (standstill.n_steps() > 20 + 4 * elements.size())
      throw NumericalFailure(
        fmt::format("The contact goes on changing at load time {} without any load being added ({} "
                    "changes). The forces there are too small against their rounding errors to "
                    "decide.",
                    state.t,
                    standstill.n_steps()));
  }

  Course
  ConePath::next_course(const JointState &state) const
  {
    Course course;
    course.t       = state.t;
    course.t_end   = state.t;
    course.factors = history.factors(state.t);
    if (state.is_unsettled())
      {
        course.kind                = Course::Kind::release;
        course.factor_rates        = Vector(course.factors.size(), 0.);
        course.drive.missing_water = state.missing_water;
        for (double &rate : course.drive.missing_water)
          rate = -rate;
        course.length = 1.;
      }
    else
      {
        course.factor_rates = history.rates(state.t);
        course.t_end        = history.next_corner(state.t);
        course.length       = course.t_end - state.t;
      }
    course.drive.reactions = multiply(system.reactions(), course.factor_rates);
    add_water_rates(elements, system, state, course.factor_rates, course.drive);
    return course;
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
        if (state.states[k] == states[i])
          continue;
        events.push_back({state.t, k, state.states[k], states[i]});
        const double no_force = boundary.force_tolerance(elements[k].normal_bar);
        change_state(elements[k], k, states[i], no_force, state);
        keep_water(elements[k], k, system, history.factors(state.t), no_force, state);
      }
    result.n_events += events.size();
    if (!events.empty())
      observer.changed(events, state);
  }

  void
  ConePath::take_limit(const JointState &state, const JointRates &motion, PathResult &result) const
  {
    result.t               = state.t;
    result.verdict         = Verdict::limit_load;
    result.mechanism_jumps = mechanism_jumps(motion, system);
    result.mechanism       = classify_mechanism(result.mechanism_jumps, elements);
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
        result.verdict    = Verdict::no_continuation;
        result.critical.t = state.t;
        for (const BoundaryElement &candidate : boundary.elements_on_boundary(state))
          if (candidate.shear == ShearPosition::at_strength)
            result.critical.elements.push_back(candidate.element);
        return;
      }
    take_limit(state, continuation.mechanism, result);
    const std::vector<BoundaryElement> set = boundary.elements_on_boundary(state);
    std::vector<ContactState> states;
    for (const BoundaryElement &candidate : set)
      {
        const ContactElement &element = elements[candidate.element];
        ContactState next             = state.states[candidate.element];
        if (next != ContactState::open && candidate.grazing &&
            result.mechanism_jumps[element.normal_bar] > no_jump)
          next = ContactState::open;
        else if (next == ContactState::stick && candidate.shear == ShearPosition::at_strength &&
                 dot(tangential(element, state.forces),
                     tangential(element, result.mechanism_jumps)) >
                   no_jump * length(tangential(element, state.forces)))
          next = element.has_second_tangential_bar() || state.forces[element.tangential_bar] > 0.
                   ? ContactState::slip_forward
                   : ContactState::slip_backward;
        states.push_back(next);
      }
    adopt(state, set, states, observer, result);
  }
} // namespace fuga
