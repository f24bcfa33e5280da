// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/numerics/blas_threads.h>
#include <fuga/base/work_counter.h>
#include <fuga/contact/element/change_of_state.h>
#include <fuga/contact/element/joint_water.h>
#include <fuga/contact/path/contact_path.h>
#include <fuga/contact/segments/course.h>
#include <fuga/contact/virgin_state.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Number of times that contact configurations may come back at one load before water that
     * leaves waits. */
    constexpr std::size_t returns_before_water_waits = 3;
    /** Number of times that they may come back before an element that has come to rest is held. */
    constexpr std::size_t returns_before_rest_is_held = 3;

    Vector
    negative(const Vector &x)
    {
      Vector result(x.size());
      std::transform(x.begin(), x.end(), result.begin(), std::negate<>());
      return result;
    }
  } // namespace

  ContactPath::ContactPath(const std::vector<ContactElement> &contact_elements,
                           const LayeredSystem &layered_system,
                           const LoadHistory &load_history)
    : elements(contact_elements), system(layered_system), history(load_history)
  {
  }

  PathResult
  ContactPath::run(const std::vector<double> &levels, PathObserver &observer)
  {
    PathCut start;
    start.state  = virgin_state(elements, system.n_bars(), system.water_in_joints() != nullptr);
    start.memory = memory();
    return resume(start, levels, observer);
  }

  PathResult
  ContactPath::resume(const PathCut &from,
                      const std::vector<double> &levels,
                      PathObserver &observer)
  {
    const work::Scope phase(work::Phase::path);
    cut = from;
    restore(cut.memory);
    return follow_from_cut(levels, observer);
  }

  PathResult
  ContactPath::follow_from_cut(const std::vector<double> &levels, PathObserver &observer)
  {
    // With this many rows a product takes as long as threads need to start and to meet.
    constexpr std::size_t few_bars = 2500;
    const blas::OneThread of_small_systems(system.n_bars() <= few_bars);
    next_level  = cut.next_level;
    resticking  = cut.resticking;
    last_states = cut.last_states;
    standstill  = Standstill();
    ReportCounter reports(observer, cut.n_reports);
    return follow(levels, reports);
  }

  PathResult
  ContactPath::go_on(const PathCut &end, const std::vector<double> &levels, PathObserver &observer)
  {
    PathCut start           = end;
    start.memory            = memory();
    start.memory.iterations = end.memory.iterations;
    start.resticking        = {};
    start.last_states       = {};
    start.n_reports         = 0;
    return resume(start, levels, observer);
  }

  PathResult
  ContactPath::follow_step(const JointState &state,
                           const PathResult &so_far,
                           PathObserver &observer)
  {
    cut        = PathCut();
    cut.state  = state;
    cut.result = so_far;
    // Events that follow a jump of an earlier step are in another time.
    cut.result.jump.length = 0.;
    return follow_from_cut({}, observer);
  }

  void
  ContactPath::make_cut(const JointState &state, const PathResult &result, ReportCounter &observer)
  {
    if (standstill.n_steps() > 0)
      return; // what is known at this load is not kept
    observer.start();
    if (!observer.wants_cuts())
      return;
    cut.state       = state;
    cut.result      = result;
    cut.memory      = memory();
    cut.next_level  = next_level;
    cut.resticking  = resticking;
    cut.last_states = last_states;
  }

  Course
  ContactPath::next_course(const JointState &state) const
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
  ContactPath::set_reactions(const JointState &state,
                             const Vector &factor_rates,
                             Drive &drive) const
  {
    drive.reactions = multiply(system.reactions(), factor_rates);
    add_water_rates(system, state, factor_rates, drive);
  }

  // Steps of zero length are due to elements that reach their boundary together up to rounding: the
  // tolerance for being on it is widened step by step, and at once where a scheme comes back.
  double
  ContactPath::widening_of_tolerances() const
  {
    const std::size_t n = standstill.n_steps() / 4 + standstill.n_repetitions();
    return std::pow(10., static_cast<double>(std::min<std::size_t>(3, n)));
  }

  // Just before a maximum of the load the rounding of forces on their cones may exceed a small rate
  // of slip: an element slips according to the rates, and loses its slip in the next step, however
  // short. Where nothing else has ended this it rests, whatever its rates are; should it leave its
  // cone, the next segment ends where it does.
  double
  ContactPath::widening_at_rest() const
  {
    return standstill.n_repetitions() > returns_before_rest_is_held
             ? std::numeric_limits<double>::max()
             : widening_of_tolerances();
  }

  // A failure on the way must not discard what was reached before it.
  double
  ContactPath::find_end(PathSegment &segment,
                        const Course &course,
                        const std::vector<double> &levels,
                        PathObserver &observer,
                        JointState &state)
  {
    try
      {
        return segment.find_end();
      }
    catch (const NumericalFailure &)
      {
        state = report_piecewise(segment, course, levels, next_level, observer);
        throw;
      }
  }

  void
  ContactPath::note_step(const PathSegment &segment,
                         const Course &course,
                         const double length,
                         const JointState &state,
                         PathResult &result)
  {
    resticking = segment.resticking();
    result.t   = state.t;
    ++result.n_steps;
    // Share of the load time below which a step is no progress, and share of a release for one that
    // leaves the scheme as it is.
    constexpr double shortest_step = 1e-13, shortest_release = 1e-6;
    const bool is_repeated = course.kind == Course::Kind::release && state.states == last_states;
    last_states            = state.states;
    if (length > (is_repeated ? shortest_release : shortest_step * std::max(1., course.t)))
      standstill.forget();
    else
      note_zero_step(state, result);
  }

  void
  ContactPath::note_zero_step(const JointState &state, PathResult &result)
  {
    ++result.n_zero_steps;
    standstill.note(state.states);
    if (standstill.n_steps() > 20 + 4 * elements.size())
      throw PathFailure(fmt::format(
        "The contact goes on changing at load time {} without any load being added ({} "
        "changes, {} of them to a scheme that was there before). The forces there are too "
        "small against their rounding errors to decide.",
        state.t,
        standstill.n_steps(),
        standstill.n_repetitions()));
  }

  ContactEvent
  ContactPath::change_element(const std::size_t k,
                              const ContactState to,
                              const TangentVector &direction,
                              const double no_force,
                              JointState &state) const
  {
    const ContactState from = state.states[k];
    change_state(elements[k], k, to, direction, no_force, state);
    return {state.t, k, from, state.states[k]};
  }

  // A connection that appears or disappears without any element changing its state is an event as
  // well. Where water that leaves a crack closes it, and the water of the closed crack opens it
  // again, no state of both is consistent: such a change waits until the load has gone on. Water of
  // the reservoir never waits.
  bool
  ContactPath::let_water_follow(const Vector &no_force,
                                JointState &state,
                                PathObserver &observer,
                                PathResult &result)
  {
    if (system.water_in_joints() == nullptr || history.water_stands_still(state.t))
      return false;
    const auto relief =
      standstill.n_repetitions() == 0 ? WaterRelief::allowed : WaterRelief::refused;
    const std::vector<WaterAccess> before = state.access;
    JointState next                       = state;
    const std::vector<std::size_t> changed =
      renew_water(elements, system, history.factors(state.t), no_force, relief, next);
    const auto is_filled = [&next](const std::size_t k) {
      return next.access[k] == WaterAccess::upstream;
    };
    if (changed.empty() || (standstill.n_repetitions() > returns_before_water_waits &&
                            std::none_of(changed.begin(), changed.end(), is_filled)))
      return false;
    state = std::move(next);
    std::vector<ContactEvent> events;
    for (const std::size_t k : changed)
      if (before[k] != WaterAccess::seepage && state.access[k] != WaterAccess::seepage)
        events.push_back(
          {state.t, k, state.states[k], state.states[k], 1, {{before[k], state.access[k]}}});
    report(events, state, observer, result);
    note_zero_step(state, result);
    return true;
  }

  void
  ContactPath::report(const std::vector<ContactEvent> &events,
                      const JointState &state,
                      PathObserver &observer,
                      PathResult &result)
  {
    result.n_events += events.size();
    if (!events.empty())
      observer.changed(events, state);
  }

  void
  ContactPath::reach_levels(const std::vector<double> &levels,
                            const JointState &state,
                            PathObserver &observer)
  {
    for (; next_level < levels.size() && levels[next_level] <= state.t; ++next_level)
      observer.reached(next_level, state);
  }

  void
  ContactPath::take_limit(const JointState &state,
                          const JointRates &motion,
                          PathResult &result) const
  {
    result.t               = state.t;
    result.verdict         = Verdict::limit_load;
    result.mechanism_jumps = mechanism_jumps(motion, system);
    result.mechanism       = classify_mechanism(result.mechanism_jumps, elements);
  }
} // namespace fuga
