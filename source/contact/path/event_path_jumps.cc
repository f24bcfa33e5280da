// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/path/event_path.h>
#include <fuga/contact/path/implicit_step.h>

#include <algorithm>

// Steps that do not follow the path: to the end of a stage on request, and from a state without
// continuation to an equilibrium near by.
namespace fuga
{
  namespace
  {
    /** Share of a stage by which the load grows in a jump. */
    constexpr double shortest_jump = 1e-6, longest_jump = 1e-2;

    /** Return the length of a jump. It is twice that of the last one where the path has gone on
     * after it by less than that one was long: lips that alternately stick and snap would otherwise
     * be followed through millions of jumps. */
    double
    length_of_jump(const double t, const Jump &last)
    {
      return last.length > 0. && t - last.t < 2. * last.length
               ? std::min(2. * last.length, longest_jump)
               : shortest_jump;
    }
  } // namespace

  // This is done only on request, and neither where water could come in nor before lost strength
  // has been given up. Whatever the step cannot solve is left to the events.
  bool
  EventPath::jump_to_corner(JointState &state,
                            const std::vector<double> &levels,
                            PathObserver &observer,
                            PathResult &result)
  {
    if (options.follow == PathOptions::Follow::events || system.water_in_joints() != nullptr ||
        state.is_unsettled() ||
        (scheme.is_nonlinear() && options.iteration == PathOptions::Iteration::constant_stiffness))
      return false;
    const Course course = next_course(state);
    if (next_level < levels.size() && levels[next_level] < course.t_end)
      return false;
    ImplicitStep step({elements, system, boundary, scheme}, course);
    const std::optional<JointState> end = step.solve(state);
    result.n_schemes += static_cast<unsigned int>(step.n_schemes());
    if (!end)
      return false;
    state = *end;
    observer.jumped(state);
    result.t = state.t;
    ++result.n_jumps;
    reach_levels(levels, state, observer);
    return true;
  }

  // An equilibrium at the same load could be the present one itself, so the load is slightly
  // larger.
  std::optional<JumpEnd>
  EventPath::equilibrium_ahead(const JointState &state,
                               const double ahead,
                               const std::vector<double> &levels)
  {
    Course course = next_course(state);
    if (course.kind == Course::Kind::loading)
      {
        const bool has_level = next_level < levels.size() && levels[next_level] > state.t;
        course.t_end =
          std::min({course.t_end, state.t + ahead, has_level ? levels[next_level] : course.t_end});
        course.length = course.t_end - state.t;
      }
    try
      {
        return find_equilibrium_nearby(elements, system, course, state);
      }
    catch (const NumericalFailure &)
      {
        return {}; // no equilibrium was found
      }
  }

  bool
  EventPath::jump_to_equilibrium(JointState &state,
                                 const std::vector<double> &levels,
                                 PathObserver &observer,
                                 PathResult &result)
  {
    const double ahead         = length_of_jump(state.t, result.jump);
    std::optional<JumpEnd> end = equilibrium_ahead(state, ahead, levels);
    if (!end && ahead > shortest_jump)
      end = equilibrium_ahead(state, shortest_jump, levels);
    result.jump = end ? end->jump : Jump();
    if (!end)
      return false;
    if (!options.follow_jumps)
      {
        constexpr double nearer = 0.01;
        if (!result.tried.empty() || result.mechanism != MechanismKind::none)
          if (const auto same = equilibrium_ahead(state, nearer * end->jump.length, levels))
            result.jump.size_nearer = same->jump.size;
        return false;
      }
    jump_to(end->state, state, observer, result);
    reach_levels(levels, state, observer);
    return true;
  }

  // A motion without bound is a limit load. One that closes lips may come to rest on them.
  bool
  EventPath::jump_or_go_beyond(JointState &state,
                               const double ahead,
                               const std::vector<double> &levels,
                               PathObserver &observer,
                               PathResult &result)
  {
    if (result.verdict == Verdict::non_unique_continuation)
      return false;
    if (result.verdict == Verdict::no_continuation ||
        closes_lips(result.mechanism_jumps, elements, state))
      {
        if (jump_to_equilibrium(state, levels, observer, result))
          return true;
        if (result.jump.found)
          result.verdict = Verdict::no_continuation;
      }
    go_beyond_limit(state, ahead, observer, result);
    return false;
  }

  // The path ends where it fails again and again.
  bool
  EventPath::jump_over_failure(JointState &state,
                               const std::vector<double> &levels,
                               PathObserver &observer,
                               PathResult &result)
  {
    constexpr std::size_t most_failures = 12;
    if (result.verdict != Verdict::done || result.n_failures == most_failures)
      return false;
    if (!jump_to_equilibrium(state, levels, observer, result))
      return false;
    ++result.n_failures;
    return true;
  }

  void
  EventPath::jump_to(const JointState &end,
                     JointState &state,
                     PathObserver &observer,
                     PathResult &result)
  {
    std::vector<ContactEvent> events;
    for (std::size_t k = 0; k < elements.size(); ++k)
      if (state.states[k] != end.states[k])
        events.push_back({end.t, k, state.states[k], end.states[k]});
    state            = end;
    result.verdict   = Verdict::done;
    result.critical  = {};
    result.mechanism = MechanismKind::none;
    result.mechanism_jumps.clear();
    result.tried.clear();
    result.barrier = {};
    result.t       = state.t;
    ++result.n_followed_jumps;
    standstill.forget();
    resticking.clear();
    observer.jumped(state);
    report(events, state, observer, result);
  }

  bool
  EventPath::jump_over_course(const JointState &from, PathObserver &observer, PathResult &result)
  {
    const Course course = next_course(from);
    std::optional<JointState> end;
    try
      {
        end = ImplicitStep({elements, system, boundary, scheme}, course).solve(from);
        if (!end)
          if (std::optional<JumpEnd> far = find_equilibrium_nearby(elements, system, course, from))
            end = std::move(far->state);
      }
    catch (const NumericalFailure &)
      {
        // no equilibrium was found
      }
    if (!end)
      return false;
    JointState state = from;
    jump_to(*end, state, observer, result);
    return true;
  }
} // namespace fuga
