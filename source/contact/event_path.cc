// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/change_of_state.h>
#include <fuga/contact/curved_segment.h>
#include <fuga/contact/event_path.h>
#include <fuga/contact/implicit_step.h>
#include <fuga/contact/layer_response.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** Steps shorter than this share of the load time do not count as progress. */
    constexpr double shortest_step = 1e-13;

    Vector
    negative(const Vector &x)
    {
      Vector result(x.size());
      std::transform(x.begin(), x.end(), result.begin(), std::negate<>());
      return result;
    }
  } // namespace

  EventPath::EventPath(const std::vector<ContactElement> &contact_elements,
                       const LayeredSystem &layered_system,
                       const LoadHistory &load_history,
                       const PathOptions &path_options)
    : elements(contact_elements)
    , system(layered_system)
    , history(load_history)
    , options(path_options)
    , boundary(elements, system)
    , scheme(elements, system)
    , rate_problem(elements, system, scheme)
  {
  }

  PathResult
  EventPath::run(const std::vector<double> &levels, PathObserver &observer)
  {
    PathCut start;
    start.state  = virgin_state();
    start.scheme = scheme.memory();
    return resume(start, levels, observer);
  }

  PathResult
  EventPath::follow(const std::vector<double> &levels, ReportCounter &observer)
  {
    JointState state  = cut.state;
    PathResult result = cut.result;
    standstill        = Standstill();
    while (state.t < history.end() || max_abs(state.unreleased) > 0.)
      {
        make_cut(state, result, observer);
        if (jump_to_corner(state, levels, observer, result))
          continue;
        const Course course = next_course(state);

        // How does the contact go on from here? The rates of all elements on a boundary decide
        // together.
        boundary.set_scales(state, course.factors, widening_of_tolerances());
        const Vector unreleased         = state.unreleased;
        const Continuation continuation = decide(state, course, observer, result);
        if (!continuation.exists)
          {
            if (result.verdict != Verdict::non_unique_continuation &&
                break_exhausted_bonds(state, observer, result))
              {
                standstill.forget();
                continue;
              }
            lose_equilibrium(state, continuation, observer, result);
            if (options.beyond_limit && result.verdict != Verdict::non_unique_continuation)
              go_beyond_limit(state, observer, result);
            return result;
          }
        if (state.unreleased != unreleased)
          {
            standstill.forget();
            continue; // a bond broke: its forces are given up before the load goes on
          }

        // At which load does the next event occur? Advance to it.
        const std::unique_ptr<PathSegment> segment =
          make_segment(course, {state, continuation.rates});
        const double length = find_end(*segment, course, levels, observer);
        state               = report_piecewise(*segment, course, levels, observer);

        resticking = segment->resticking();
        result.t   = state.t;
        ++result.n_steps;
        if (length > shortest_step * std::max(1., course.t))
          standstill.forget();
        else
          {
            ++result.n_zero_steps;
            standstill.note(scheme.all_states());
            check_standstill(state);
          }
      }
    standstill.forget();
    make_cut(state, result, observer);
    return result;
  }

  // Steps without length come from elements that reach their boundary together but for rounding:
  // what counts as being on it is widened step by step, at once where a scheme comes back.
  double
  EventPath::widening_of_tolerances() const
  {
    const std::size_t n = standstill.n_steps() / 4 + standstill.n_repetitions();
    return std::pow(10., static_cast<double>(std::min<std::size_t>(3, n)));
  }

  void
  EventPath::check_standstill(const JointState &state) const
  {
    if (standstill.n_steps() <= 20 + 4 * elements.size())
      return;
    throw NumericalFailure(fmt::format(
      "The contact goes on changing at load time {} without any load being added ({} "
      "changes, {} of them to a scheme that was there before). The forces there are too "
      "small against their rounding errors to decide.",
      state.t,
      standstill.n_steps(),
      standstill.n_repetitions()));
  }

  JointState
  EventPath::virgin_state() const
  {
    JointState state;
    state.states.assign(elements.size(), ContactState::stick);
    state.forces.assign(system.n_bars(), 0.);
    state.dislocations.assign(system.n_bars(), 0.);
    state.slips.assign(elements.size(), 0.);
    state.dilations.assign(elements.size(), 0.);
    state.unreleased.assign(system.n_bars(), 0.);
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        state.strengths.push_back(virgin_strength(elements[k].friction, elements[k].area));
        if (elements[k].initial_gap > 0.)
          {
            // Lips that never touched have no bond.
            state.states[k]             = ContactState::open;
            state.strengths[k].cohesion = state.strengths[k].tension = 0.;
          }
      }
    return state;
  }

  Course
  EventPath::next_course(const JointState &state) const
  {
    Course course;
    course.t       = state.t;
    course.t_end   = state.t;
    course.factors = history.factors(state.t);
    if (max_abs(state.unreleased) > 0.)
      {
        course.kind          = Course::Kind::release;
        course.factor_rates  = Vector(course.factors.size(), 0.);
        course.drive.release = negative(state.unreleased);
        course.length        = 1.;
      }
    else
      {
        course.factor_rates = history.rates(state.t);
        course.t_end        = history.next_corner(state.t);
        course.length       = course.t_end - state.t;
      }
    course.drive.reactions = multiply(system.reactions(), course.factor_rates);
    return course;
  }

  // Only on request, and only where nothing between matters to the end: a straight path without
  // strength that could be lost. Whatever the step cannot solve is left to the events.
  bool
  EventPath::jump_to_corner(JointState &state,
                            const std::vector<double> &levels,
                            PathObserver &observer,
                            PathResult &result)
  {
    if (options.follow == PathOptions::Follow::events || scheme.is_nonlinear() ||
        max_abs(state.unreleased) > 0.)
      return false;
    for (const ContactElement &element : elements)
      if (!element.friction.is_plain())
        return false;
    const double corner = history.next_corner(state.t);
    if (next_level < levels.size() && levels[next_level] < corner)
      return false;
    ImplicitStep step(elements, system, scheme);
    const std::optional<JointState> end = step.solve(state, corner, history.factors(corner));
    result.n_schemes += static_cast<unsigned int>(step.n_schemes);
    if (!end)
      return false;
    state = *end;
    observer.jumped(state);
    result.t = state.t;
    ++result.n_jumps;
    for (; next_level < levels.size() && levels[next_level] <= corner; ++next_level)
      observer.reached(next_level, state);
    return true;
  }

  Continuation
  EventPath::decide(JointState &state,
                    const Course &course,
                    PathObserver &observer,
                    PathResult &result)
  {
    take_scheme(state);
    for (const std::size_t k : resticking)
      scheme.set_state(k, ContactState::stick);
    scheme.linearise(state);

    const std::vector<BoundaryElement> set = standstill.unite(boundary.elements_on_boundary(state));
    Continuation continuation              = rate_problem.solve(state, set, course.drive);
    result.n_schemes += continuation.n_schemes;
    if (continuation.exists)
      choose_branch(state, set, course.drive, continuation, result);
    if (!continuation.exists)
      return continuation;
    ++result.n_decided_by[static_cast<std::size_t>(continuation.method)];

    result.n_events += adopt_scheme(state, set, continuation.n_branches, observer);
    return continuation;
  }

  void
  EventPath::take_scheme(JointState &state)
  {
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        if (state.dilations[k] >= elements[k].friction.dilation_limit - boundary.gap_tolerance())
          state.strengths[k].dilatancy = 0.;
        scheme.set_state(k, state.states[k]);
        scheme.set_strength(k, state.strengths[k]);
      }
  }

  // Gives the boundary elements the states of the working scheme. Returns the number of changes.
  std::size_t
  EventPath::adopt_scheme(JointState &state,
                          const std::vector<BoundaryElement> &set,
                          const std::size_t n_branches,
                          PathObserver &observer) const
  {
    std::vector<ContactEvent> events;
    for (const BoundaryElement &candidate : set)
      {
        const std::size_t k = candidate.element;
        if (state.states[k] == scheme.state(k))
          continue;
        events.push_back({state.t, k, state.states[k], scheme.state(k), n_branches});
        change_state(
          elements[k], k, scheme.state(k), boundary.force_tolerance(elements[k].normal_bar), state);
        events.back().to = state.states[k];
      }
    if (!events.empty())
      observer.changed(events, state);
    return events.size();
  }

  // A bond at the end of its strength that allows no continuation, neither kept nor lost by
  // opening, breaks.
  bool
  EventPath::break_exhausted_bonds(JointState &state,
                                   PathObserver &observer,
                                   PathResult &result) const
  {
    bool any = false;
    std::vector<ContactEvent> events;
    for (const BoundaryElement &candidate : boundary.elements_on_boundary(state))
      {
        const std::size_t k = candidate.element;
        if (!candidate.grazing || !state.strengths[k].has_bond())
          continue;
        any                     = true;
        const ContactState from = state.states[k];
        break_bond(elements[k], k, boundary.force_tolerance(elements[k].normal_bar), state);
        if (state.states[k] != from)
          events.push_back({state.t, k, from, state.states[k]});
      }
    result.n_events += events.size();
    if (!events.empty())
      observer.changed(events, state);
    return any;
  }

  std::unique_ptr<PathSegment>
  EventPath::make_segment(const Course &course, const PathPoint &start)
  {
    const PathContext context{elements, system, boundary, scheme};
    if (scheme.is_nonlinear())
      return std::make_unique<CurvedSegment>(context, course, start, options, iteration_count);
    return std::make_unique<StraightSegment>(context, course, start);
  }

  // A failure on the way must not take along what was reached before it.
  double
  EventPath::find_end(PathSegment &segment,
                      const Course &course,
                      const std::vector<double> &levels,
                      PathObserver &observer)
  {
    try
      {
        return segment.find_end();
      }
    catch (const NumericalFailure &)
      {
        report_piecewise(segment, course, levels, observer);
        throw;
      }
  }

  // Walks from station to station, with a stop at every requested load time. Returns the state at
  // the end.
  JointState
  EventPath::report_piecewise(PathSegment &segment,
                              const Course &course,
                              const std::vector<double> &levels,
                              PathObserver &observer)
  {
    std::vector<double> stations = segment.stations();
    const double rounding =
      4. * std::numeric_limits<double>::epsilon() * std::max(1., course.t_end);
    PathPoint from = segment.at(stations.front());
    for (std::size_t i = 1; i < stations.size(); ++i)
      {
        const double next   = course.kind == Course::Kind::loading && next_level < levels.size()
                                ? levels[next_level] - course.t
                                : std::numeric_limits<double>::infinity();
        const bool is_level = next <= stations[i] + rounding;
        if (is_level && next < stations[i] - rounding)
          stations.insert(stations.begin() + static_cast<std::ptrdiff_t>(i), next);
        PathPoint to = segment.at(stations[i]);
        observer.advanced(from, to, stations[i] - stations[i - 1]);
        if (is_level)
          observer.reached(next_level++, to.state);
        from = std::move(to);
      }
    return from.state;
  }

  IterationCount
  EventPath::iterations() const
  {
    return iteration_count;
  }
} // namespace fuga
