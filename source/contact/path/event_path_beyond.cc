// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/path/event_path.h>

#include <algorithm>

namespace fuga
{
  // From the limit load on the motion is given and the load follows from it: doc/theory.md, section
  // 7. The verdict and its load time remain those of the limit.
  void
  EventPath::go_beyond_limit(JointState &state, PathObserver &observer, PathResult &result)
  {
    using End = BeyondLimit::End;
    if (scheme.is_nonlinear())
      return;
    BeyondLimit &beyond      = result.beyond;
    const double last_corner = history.last_corner(state.t);
    const double furthest    = options.beyond_jump > 0.
                                 ? options.beyond_jump
                                 : 10. * max_abs(system.jumps(state.dislocations, state.forces));
    beyond.t                 = state.t;
    standstill.forget();
    observer.went_beyond(0., state);
    while (beyond.end == End::none)
      {
        boundary.set_scales(state, history.factors(state.t), widening_of_tolerances());
        take_scheme(state);
        const std::vector<BoundaryElement> set =
          standstill.unite(boundary.elements_on_boundary(state));
        const ControlledStep step =
          step_beyond(state, set, last_corner, result.t, furthest - beyond.length);
        if (!step.motion.exists)
          {
            beyond.end = End::no_continuation;
            return;
          }
        if (adopt_scheme(state, set, 1, observer, result))
          continue;
        if (let_water_follow(boundary.all_force_tolerances(), state, observer, result))
          continue;

        StraightSegment segment(
          {elements, system, boundary, scheme}, step.course, {state, step.motion.rates});
        const double length = segment.find_end();
        const Vector before = system.jumps(state.dislocations, state.forces);
        state               = report_piecewise(segment, step.course, {}, next_level, observer);
        const Vector after  = system.jumps(state.dislocations, state.forces);
        double growth       = 0.;
        for (std::size_t i = 0; i < after.size(); ++i)
          growth = std::max(growth, std::abs(after[i] - before[i]));
        beyond.length += growth;
        beyond.t = state.t;
        ++beyond.n_steps;
        if (length > 0.)
          {
            standstill.forget();
            observer.went_beyond(beyond.length, state);
          }
        else
          note_zero_step(state, result);
        if (length < step.course.length)
          continue;
        if (state.t == last_corner && step.motion.load_rate < 0.)
          beyond.end = End::load_removed;
        else if (state.t == result.t && step.motion.load_rate > 0.)
          beyond.end = End::limit_regained;
        else if (step.course.kind == Course::Kind::beyond_limit)
          beyond.end = End::largest_jump;
      }
  }

  // The next piece: lost strength is given up first, at constant load if that is possible; then the
  // largest jump grows by @p left at most, while the load time stays between the last corner and the
  // limit.
  EventPath::ControlledStep
  EventPath::step_beyond(const JointState &state,
                         const std::vector<BoundaryElement> &set,
                         const double first_t,
                         const double last_t,
                         const double left)
  {
    Drive unit_load;
    set_reactions(state, history.rates(state.t), unit_load);
    ControlledStep step;
    Course &course = step.course;
    if (state.is_unsettled())
      {
        course                          = next_course(state);
        const Continuation continuation = rate_problem.solve(state, set, course.drive);
        if (continuation.exists)
          {
            step.motion.exists = true;
            step.motion.rates  = continuation.rates;
            return step;
          }
        step.motion = rate_problem.solve_release(state, set, course.drive, unit_load);
      }
    else
      {
        step.motion   = rate_problem.solve_controlled(state, set, unit_load);
        course.kind   = Course::Kind::beyond_limit;
        course.length = left;
      }
    const double load_rate = step.motion.load_rate;
    course.t               = state.t;
    course.factors         = history.factors(state.t);
    course.factor_rates    = history.rates(state.t);
    for (double &rate : course.factor_rates)
      rate *= load_rate;
    set_reactions(state, course.factor_rates, course.drive);
    course.t_end = state.t + load_rate * course.length;
    if (course.t_end < first_t || course.t_end > last_t)
      {
        course.t_end  = load_rate < 0. ? first_t : last_t;
        course.length = (course.t_end - state.t) / load_rate;
      }
    return step;
  }
} // namespace fuga
