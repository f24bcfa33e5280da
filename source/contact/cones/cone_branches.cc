// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/cones/cone_rate_problem.h>
#include <fuga/contact/scheme/combinations.h>

#include <algorithm>
#include <cmath>
#include <random>

// Determines whether the solution of the rate problem is the only one, and which others exist.
namespace fuga
{
  namespace
  {
    /** Largest number of combinations of states that are tried where directions of slip have to be
     * solved for. */
    constexpr double most_with_directions = 512.;
    /** Number of directions in which Newton's method begins at the apex. */
    constexpr int n_directions = 8;
    /** Number of random first guesses; few where each of them is expensive. */
    constexpr unsigned int n_random_guesses = 64, n_costly_guesses = 6;
    constexpr std::size_t costly_rows = 100;
  } // namespace

  bool
  ConeRateProblem::has_free_directions() const
  {
    return std::any_of(candidates.begin(), candidates.end(), [](const Candidate &candidate) {
      return candidate.at_apex && candidate.n_tangents == 2;
    });
  }

  std::vector<ConeRateProblem::Choice>
  ConeRateProblem::choices(const Candidate &candidate) const
  {
    std::vector<Choice> result = {{ContactState::stick, candidate.direction}};
    if (candidate.grazing)
      result.push_back({ContactState::open, candidate.direction});
    if (candidate.n_tangents == 0)
      return result;
    if (!candidate.at_apex)
      result.push_back({ContactState::slip_forward, candidate.direction});
    else if (candidate.n_tangents == 1)
      for (const double sign : {1., -1.})
        result.push_back({ContactState::slip_forward, {{sign, 0.}}});
    else
      {
        const TangentVector first = direction_of(tangential_rows(candidate, r));
        for (int i = 0; i < n_directions; ++i)
          {
            const double angle = 2. * std::acos(-1.) * i / n_directions;
            result.push_back({ContactState::slip_forward,
                              sum({{std::cos(angle) * first[0], std::cos(angle) * first[1]}},
                                  std::sin(angle),
                                  normal_to(first))});
          }
      }
    return result;
  }

  std::vector<std::vector<ConeRateProblem::Choice>>
  ConeRateProblem::choices() const
  {
    std::vector<std::vector<Choice>> result;
    for (const Candidate &candidate : candidates)
      result.push_back(choices(candidate));
    return result;
  }

  bool
  ConeRateProblem::is_small() const
  {
    return n_combinations(choices()) <=
           (has_free_directions() ? most_with_directions : most_combinations);
  }

  // On its cone an element slips along its force, whatever state was tried before.
  void
  ConeRateProblem::take(const Choice &choice, Candidate &candidate)
  {
    candidate.state     = choice.state;
    candidate.direction = candidate.at_apex ? choice.direction : candidate.shear_direction;
    candidate.slip = candidate.strength = 0.;
  }

  // The present states are tested, with directions of slip at the apex solved for.
  bool
  ConeRateProblem::is_solution(ConeContinuation &result)
  {
    constexpr int max_turns = 30;
    for (int i = 0; i < max_turns; ++i)
      {
        ++result.n_schemes;
        if (!solve_scheme())
          return false;
        if (is_settled())
          return std::all_of(candidates.begin(), candidates.end(), [this](const Candidate &own) {
            return demand(own).state == own.state;
          });
      }
    return false;
  }

  // Call note() at every solution until it returns true. Where there is no reduced system, only
  // accept() can tell which states are one.
  void
  ConeRateProblem::try_all(ConeContinuation &result, const std::function<bool()> &note)
  {
    const std::vector<std::vector<Choice>> all = choices();
    any_combination(all, [&](const std::vector<std::size_t> &chosen) {
      for (std::size_t i = 0; i < all.size(); ++i)
        take(all[i][chosen[i]], candidates[i]);
      const bool is_right = has_system ? is_solution(result) && is_accepted() : is_accepted(true);
      return is_right && note();
    });
  }

  // Newton's method begins from all stuck, from all slipping, and from random states.
  void
  ConeRateProblem::try_guesses(ConeContinuation &result, const std::function<bool()> &note)
  {
    const std::vector<std::vector<Choice>> all = choices();
    std::mt19937 random; // its numbers are the same everywhere
    const unsigned int n = bars.size() > costly_rows ? n_costly_guesses : n_random_guesses;
    for (unsigned int guess = 0; guess < 2 + n; ++guess)
      {
        for (std::size_t i = 0; i < all.size(); ++i)
          {
            const std::size_t slipping =
              std::min<std::size_t>(all[i].size() - 1, candidates[i].grazing ? 2 : 1);
            const std::size_t choice = guess == 0   ? 0
                                       : guess == 1 ? slipping
                                                    : random() % all[i].size();
            take(all[i][choice], candidates[i]);
          }
        if (settles(result) && note())
          return;
      }
  }

  bool
  ConeRateProblem::search(ConeContinuation &result,
                          const std::function<bool()> &note,
                          const double most_combinations_tried)
  {
    const std::vector<Candidate> before = candidates;
    const Vector v_before = v, q_before = q, motion_before = free_motion;
    bool found            = false;
    const auto until_done = [&] { return found = note(); };
    if (is_small() ||
        (!has_free_directions() && n_combinations(choices()) <= most_combinations_tried))
      {
        try_all(result, until_done);
        result.is_ruled_out = !found && !has_free_directions();
      }
    else
      try_guesses(result, until_done);
    free_motion = motion_before;
    if (found)
      return true;
    candidates = before;
    v          = v_before;
    q          = q_before;
    return false;
  }

  std::vector<ConeContinuation>
  ConeRateProblem::all_solutions(const JointState &state,
                                 const std::vector<BoundaryElement> &set,
                                 WorkingScheme &background,
                                 const Drive &drive,
                                 const std::vector<ContactState> &states,
                                 const std::vector<TangentVector> &directions,
                                 const Accept &accepts)
  {
    std::vector<ConeContinuation> result;
    ConeContinuation counted;
    take_set(state, set, background, drive, {}, counted);
    if (!has_system && !accepts)
      return result;
    accept = accepts;
    for (std::size_t i = 0; i < candidates.size(); ++i)
      take({is_slipping(states[i]) ? ContactState::slip_forward : states[i],
            is_slipping(states[i]) ? directions[i] : candidates[i].direction},
           candidates[i]);
    const auto note = [&] {
      if (accept)
        return false; // which has noted it
      ConeContinuation solution;
      take_solution(solution);
      solution.rates = full_rates(background, drive, v);
      result.push_back(std::move(solution));
      return false;
    };
    if (accept ? is_accepted() : is_solution(counted)) // the present one
      note();
    if (accept && !is_small() && has_system)
      pivot_from_many(counted, note);
    search(counted, note);
    accept = {};
    return result;
  }
} // namespace fuga
