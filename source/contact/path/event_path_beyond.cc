// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/path/event_path.h>
#include <fuga/contact/segments/curved_segment.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    /** Return whether load times are equal to the accuracy with which a curved path can meet
     * one. */
    bool
    is_at(const double expected, const double t)
    {
      constexpr double rounding = 2e-14;
      return std::abs(t - expected) <= rounding * std::max(1., expected);
    }
  } // namespace

  // From the limit load on, the motion is given and the load follows from it: doc/theory.md,
  // section 7. The verdict and its load time remain those of the limit.
  void
  EventPath::go_beyond_limit(JointState &state,
                             const double ahead,
                             PathObserver &observer,
                             PathResult &result)
  {
    using End = BeyondLimit::End;
    if (!options.beyond_limit || scheme.is_nonlinear())
      return;
    const double last_t      = result.t + ahead * std::max(1., result.t);
    BeyondLimit &beyond      = result.beyond;
    const double last_corner = history.last_corner(state.t);
    const double furthest =
      options.beyond_jump > 0.
        ? options.beyond_jump
        : 10. * largest_jump(elements, system.jumps(state.dislocations, state.forces));
    beyond.t = state.t;
    standstill.forget();
    observer.went_beyond(0., state);
    while (beyond.end == End::none)
      {
        boundary.set_scales(state, history.factors(state.t), widening_of_tolerances());
        take_scheme(state);
        const std::vector<BoundaryElement> set =
          standstill.unite(boundary.elements_on_boundary(state));
        ControlledStep step = step_beyond(state, set, furthest - beyond.length);
        if (!step.motion.exists)
          {
            beyond.end = End::no_continuation;
            return;
          }
        if (adopt_scheme(state, set, 1, observer, result))
          continue;
        if (let_water_follow(boundary.all_force_tolerances(), state, observer, result))
          continue;

        const std::unique_ptr<PathSegment> segment =
          segment_beyond(step, state, last_corner, last_t);
        const double length = find_end(*segment, step.course, {}, observer, state);
        const Vector before = system.jumps(state.dislocations, state.forces);
        state               = report_piecewise(*segment, step.course, {}, next_level, observer);
        resticking          = segment->resticking();
        Vector growth       = system.jumps(state.dislocations, state.forces);
        for (std::size_t i = 0; i < growth.size(); ++i)
          growth[i] -= before[i];
        beyond.length += largest_jump(elements, growth);
        beyond.t = state.t;
        ++beyond.n_steps;
        if (length > 0.)
          {
            standstill.forget();
            observer.went_beyond(beyond.length, state);
          }
        else
          note_zero_step(state, result);
        const double load_rate = segment->at(length).load_rate.value_or(step.motion.load_rate);
        if (length < step.course.length && !step.course.yielding)
          continue;
        if (is_at(last_corner, state.t) && load_rate < 0.)
          beyond.end = End::load_removed;
        else if (is_at(last_t, state.t) && load_rate > 0.)
          beyond.end = End::limit_regained;
        else if (length == step.course.length && step.course.kind == Course::Kind::beyond_limit)
          beyond.end = End::largest_jump;
      }
  }

  // The next piece: lost strength is given up first, at constant load if that is possible; then the
  // largest jump grows by @p left at most.
  EventPath::ControlledStep
  EventPath::step_beyond(const JointState &state,
                         const std::vector<BoundaryElement> &set,
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
    return step;
  }

  // The load time stays between the last corner and the limit. Where directions of slip turn, its
  // rate is not known beforehand; lost strength is given up there as the load falls at the rate at
  // which it begins to.
  std::unique_ptr<PathSegment>
  EventPath::segment_beyond(ControlledStep &step,
                            const JointState &state,
                            const double first_t,
                            const double last_t)
  {
    Course &course  = step.course;
    PathPoint start = {state, step.motion.rates};
    if (course.kind == Course::Kind::beyond_limit &&
        turns(start, false, system.largest_stiffness()))
      {
        course.yielding = yielding_load(step, state);
        if (course.yielding->stiffness > 0.)
          {
            course.yielding->first_t = first_t;
            course.yielding->last_t  = last_t;
            start.load_rate          = step.motion.load_rate;
            return make_segment(course, start);
          }
        course.yielding.reset();
      }
    if (course.t_end < first_t || course.t_end > last_t)
      {
        course.t_end  = step.motion.load_rate < 0. ? first_t : last_t;
        course.length = (course.t_end - state.t) / step.motion.load_rate;
      }
    return make_segment(course, start);
  }

  // The motion is measured by its component along the slips with which it begins, of those that may
  // turn. The load gives way by as much as the bars are stiff, and by more than it falls.
  YieldingLoad
  EventPath::yielding_load(const ControlledStep &step, const JointState &state) const
  {
    YieldingLoad load;
    load.factor_rates = history.rates(state.t);
    set_reactions(state, load.factor_rates, load.drive);
    load.dislocations = state.dislocations;
    load.weights.assign(system.n_bars(), 0.);
    double square = 0., softness = 0.;
    for (std::size_t k = 0; k < elements.size(); ++k)
      if (may_turn(elements[k], state, k))
        for (std::size_t a = 1; a < 3; ++a)
          {
            const std::size_t bar = elements[k].bar(a);
            load.weights[bar]     = step.motion.rates.dislocations[bar];
            square += load.weights[bar] * load.weights[bar];
          }
    constexpr double no_motion = 1e-6; // of the largest jump
    if (square <= no_motion * no_motion)
      return load;
    for (std::size_t bar = 0; bar < system.n_bars(); ++bar)
      {
        load.weights[bar] /= square;
        softness = std::max(softness, std::abs(load.weights[bar] * load.drive.reactions[bar]));
      }
    load.stiffness = std::max(softness > 0. ? system.largest_stiffness() / softness : 0.,
                              4. * std::abs(step.motion.load_rate));
    return load;
  }
} // namespace fuga
