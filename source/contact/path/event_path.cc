// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/element/mechanism.h>
#include <fuga/contact/path/event_path.h>
#include <fuga/contact/path/implicit_step.h>
#include <fuga/contact/segments/course.h>
#include <fuga/contact/segments/curved_segment.h>
#include <fuga/contact/segments/layer_work.h>

#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Return the number of states that the elements of @p set may take, all together. */
    std::size_t
    n_choices(const std::vector<BoundaryElement> &set)
    {
      std::size_t n = 0;
      for (const BoundaryElement &candidate : set)
        n += n_states(candidate);
      return n;
    }
  } // namespace

  EventPath::EventPath(const std::vector<ContactElement> &contact_elements,
                       const LayeredSystem &layered_system,
                       const LoadHistory &load_history,
                       const PathOptions &path_options)
    : ContactPath(contact_elements, layered_system, load_history)
    , options(path_options)
    , in_space(have_two_tangents(elements))
    , boundary(elements, system)
    , scheme(elements, system)
    , rate_problem(elements, system, scheme)
  {
  }

  SchemeWork
  EventPath::work() const
  {
    SchemeWork work = scheme.work();
    work.n_factorisations += rate_problem.background().work().n_factorisations;
    work.n_updates += rate_problem.background().work().n_updates;
    return work;
  }

  PathMemory
  EventPath::memory() const
  {
    return {iteration_count, scheme.memory(), rate_problem.background().memory()};
  }

  void
  EventPath::restore(const PathMemory &memory)
  {
    iteration_count = memory.iterations;
    scheme.restore(memory.scheme);
    rate_problem.background().restore(memory.background);
  }

  PathResult
  EventPath::follow(const std::vector<double> &levels, ReportCounter &observer)
  {
    JointState state  = cut.state;
    PathResult result = cut.result;
    standstill        = Standstill();
    while ((state.t < history.end() || state.is_unsettled()) && observer.wants_more())
      {
        make_cut(state, result, observer);
        try
          {
            if (!advance(state, levels, observer, result))
              return result;
          }
        catch (const PathFailure &failure)
          {
            if (!options.follow_jumps && dynamic_cast<const LawExhausted *>(&failure) == nullptr)
              throw NumericalFailure(
                failure.what() +
                std::string(" Solver/No continuation = jump may continue from there."));
            if (!options.follow_jumps || !jump_over_failure(state, levels, observer, result))
              throw;
          }
      }
    standstill.forget();
    make_cut(state, result, observer);
    return result;
  }

  bool
  EventPath::advance(JointState &state,
                     const std::vector<double> &levels,
                     PathObserver &observer,
                     PathResult &result)
  {
    if (jump_to_corner(state, levels, observer, result))
      return true;
    const Course course = next_course(state);

    // How does the contact go on from here? This is decided by the rates of all elements on a
    // boundary together.
    set_boundary(state, course, widening_of_tolerances());
    Continuation continuation = decide(state, course, observer, result);
    // A motion is not a limit if it closes what a rounding error has left open.
    while (
      !continuation.exists && continuation.has_mechanism &&
      boundary.take_for_closed(widest_gap_closed(continuation.mechanism, elements, system, state)))
      continuation = decide(state, course, observer, result);
    if (!continuation.exists && result.verdict != Verdict::non_unique_continuation)
      decide_on_wider_boundary(state, course, observer, continuation, result);
    if (!continuation.exists)
      return leave_path(state, continuation, levels, observer, result);
    if (continuation.costs_strength)
      {
        standstill.forget();
        return true; // what was lost is given up, and the rates are decided again, at this load
      }
    if (let_water_follow(boundary.all_force_tolerances(), state, observer, result))
      return true; // water comes in or is squeezed out before the load goes on

    // At which load does the next event occur? Advance to it.
    const std::unique_ptr<PathSegment> segment = make_segment(course, {state, continuation.rates});
    const double length = find_end(*segment, course, levels, observer, state);
    if (scheme.is_nonlinear())
      note_segment({elements, system, boundary, scheme}, course, *segment, iteration_count);
    state = report_piecewise(*segment, course, levels, next_level, observer);
    note_step(*segment, course, length, state, result);
    last_rates = continuation.rates;
    if (segment->ends_at_turning_point())
      {
        result.verdict = Verdict::no_continuation;
        find_critical_elements(state, result);
      }
    else if (segment->ends_at_limit())
      take_limit(state, segment->motion_at_limit(), result);
    else
      return true;
    // Share of a stage by which the path ends before the limit where directions of slip turn.
    constexpr double near_limit = 2e-6;
    return jump_or_go_beyond(state, near_limit, levels, observer, result);
  }

  bool
  EventPath::leave_path(JointState &state,
                        const Continuation &continuation,
                        const std::vector<double> &levels,
                        PathObserver &observer,
                        PathResult &result)
  {
    if (result.verdict != Verdict::non_unique_continuation &&
        break_exhausted_bonds(state, observer, result))
      {
        standstill.forget();
        return true;
      }
    lose_equilibrium(state, continuation, observer, result);
    return jump_or_go_beyond(state, 0., levels, observer, result);
  }

  // A step of zero length may end at a boundary that it does not reach: where all forces and jumps
  // vanish together, the effect of the last digit of the load time exceeds their rounding.
  void
  EventPath::set_boundary(const JointState &state, const Course &course, const double widening)
  {
    boundary.set_scales(state, course.factors, widening);
    if (standstill.n_steps() == 0)
      last_rates = {};
    else
      boundary.take_unresolved(last_rates,
                               std::numeric_limits<double>::epsilon() * state.t * widening);
  }

  // Where the forces of several elements vanish together, as when a block comes free, rounding may
  // leave some of them off the boundary by slightly more than what counts as zero, so that no
  // states of the others go on. No verdict may be based on that.
  void
  EventPath::decide_on_wider_boundary(JointState &state,
                                      const Course &course,
                                      PathObserver &observer,
                                      Continuation &continuation,
                                      PathResult &result)
  {
    constexpr double widening = 10.;
    if (continuation.has_mechanism && is_free_motion(continuation.mechanism, system))
      return;
    const std::size_t n_known = n_choices(boundary.elements_on_boundary(state));
    set_boundary(state, course, widening * widening_of_tolerances());
    if (n_choices(boundary.elements_on_boundary(state)) > n_known)
      {
        Continuation wider = decide(state, course, observer, result);
        if (wider.exists)
          {
            continuation = std::move(wider);
            return;
          }
      }
    set_boundary(state, course, widening_of_tolerances());
  }

  std::unique_ptr<PathSegment>
  EventPath::make_segment(const Course &course, const PathPoint &start)
  {
    const bool is_curved =
      scheme.is_nonlinear() || is_bent_by_reduction(elements, course, start.state);
    const bool is_turning =
      course.yielding || (course.kind != Course::Kind::beyond_limit && turns(start, is_curved));
    const PathContext context{
      elements, system, boundary, is_turning ? rate_problem.background() : scheme};
    if (!is_turning && !is_curved)
      return std::make_unique<StraightSegment>(context, course, start);
    std::vector<TangentVector> directions;
    for (std::size_t k = 0; k < elements.size() && is_turning; ++k)
      directions.push_back(scheme.slip_direction_of(k));
    return std::make_unique<CurvedSegment>(
      context, course, start, directions, options, iteration_count);
  }

  // The force of an element that slips moves across its slip, now or, along a curve, perhaps later.
  bool
  EventPath::turns(const PathPoint &start, const bool is_curved, double size) const
  {
    constexpr double no_turn = 1e-11; // of the largest force rate
    size                     = std::max(size, max_abs(start.rates.forces));
    for (std::size_t k = 0; k < elements.size() && in_space; ++k)
      if (may_turn(elements[k], start.state, k))
        if (const TangentVector across = normal_to(scheme.slip_direction_of(k));
            is_curved ||
            std::abs(dot(across, tangential(elements[k], start.rates.forces))) > no_turn * size)
          return true;
    return false;
  }
} // namespace fuga
