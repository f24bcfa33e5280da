// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/curved_segment.h>
#include <fuga/contact/event_path.h>
#include <fuga/contact/implicit_step.h>
#include <fuga/contact/joint_water.h>
#include <fuga/contact/layer_response.h>
#include <fuga/contact/strength_reduction.h>
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
    start.state  = virgin_state(elements, system.n_bars(), !system.opening_water().empty());
    start.scheme = scheme.memory();
    return resume(start, levels, observer);
  }

  PathResult
  EventPath::follow(const std::vector<double> &levels, ReportCounter &observer)
  {
    JointState state  = cut.state;
    PathResult result = cut.result;
    standstill        = Standstill();
    while (state.t < history.end() || state.is_unsettled())
      {
        make_cut(state, result, observer);
        if (jump_to_corner(state, levels, observer, result))
          continue;
        const Course course = next_course(state);

        // How does the contact go on from here? The rates of all elements on a boundary decide
        // together.
        boundary.set_scales(state, course.factors, widening_of_tolerances());
        const Vector unreleased         = state.unreleased;
        const auto states               = state.states;
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
        if (water_has_changed(elements, system, states, state))
          {
            note_zero_step(state, result);
            continue; // water comes in or is squeezed out before the load goes on
          }

        // At which load does the next event occur? Advance to it.
        const std::unique_ptr<PathSegment> segment =
          make_segment(course, {state, continuation.rates});
        const double length = find_end(*segment, course, levels, observer);
        state               = report_piecewise(*segment, course, levels, next_level, observer);

        resticking = segment->resticking();
        result.t   = state.t;
        ++result.n_steps;
        if (length > shortest_step * std::max(1., course.t))
          standstill.forget();
        else
          note_zero_step(state, result);
        if (segment->ends_at_limit())
          {
            take_limit(state, segment->at(length).rates, result);
            return result;
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
  EventPath::note_zero_step(const JointState &state, PathResult &result)
  {
    ++result.n_zero_steps;
    standstill.note(scheme.all_states());
    check_standstill(state);
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

  Course
  EventPath::next_course(const JointState &state) const
  {
    Course course;
    course.t       = state.t;
    course.t_end   = state.t;
    course.factors = history.factors(state.t);
    if (state.is_unsettled())
      {
        course.kind                = Course::Kind::release;
        course.factor_rates        = Vector(course.factors.size(), 0.);
        course.drive.release       = negative(state.unreleased);
        course.drive.missing_water = negative(state.missing_water);
        course.length              = 1.;
      }
    else
      {
        course.factor_rates = history.rates(state.t);
        course.t_end        = history.next_corner(state.t);
        course.length       = course.t_end - state.t;
        course.share        = history.strength_share(state.t);
        course.share_rate   = history.strength_share_rate(state.t);
      }
    set_reactions(state, course.factor_rates, course.drive);
    course.drive = drive_at(elements, course, state);
    return course;
  }

  void
  EventPath::set_reactions(const JointState &state, const Vector &factor_rates, Drive &drive) const
  {
    drive.reactions = multiply(system.reactions(), factor_rates);
    add_water_rates(elements, system, state, factor_rates, drive);
  }

  // Only on request, and only where nothing between matters to the end: a straight path without
  // strength that could be lost, or water that could come in. Whatever the step cannot solve is
  // left to the events.
  bool
  EventPath::jump_to_corner(JointState &state,
                            const std::vector<double> &levels,
                            PathObserver &observer,
                            PathResult &result)
  {
    if (options.follow == PathOptions::Follow::events || scheme.is_nonlinear() ||
        !system.opening_water().empty() || state.is_unsettled() ||
        history.strength_share_rate(state.t) != 0.)
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

  std::unique_ptr<PathSegment>
  EventPath::make_segment(const Course &course, const PathPoint &start)
  {
    const PathContext context{elements, system, boundary, scheme};
    if (scheme.is_nonlinear() || is_bent_by_reduction(elements, course, start.state))
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
        report_piecewise(segment, course, levels, next_level, observer);
        throw;
      }
  }

  IterationCount
  EventPath::iterations() const
  {
    return iteration_count;
  }
} // namespace fuga
