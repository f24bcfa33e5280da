// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/rate_question.h"

#include "judges/lemke.h"
#include "judges/linear_solve.h"
#include "stress/rate_reduction.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace fuga::stress
{
  using namespace judges;

  namespace
  {
    /** Violations below this share of the largest term are rounding. */
    constexpr double tolerance = 1e-9;

    std::vector<ContactState>
    choices(const Candidate &candidate)
    {
      std::vector<ContactState> result = {ContactState::stick};
      const bool grazing               = candidate.status == RateStatus::grazing;
      if (candidate.has_shear && !(grazing && candidate.cohesive))
        for (const ContactState slip : {ContactState::slip_forward, ContactState::slip_backward})
          if (grazing || slip_sign(slip) == candidate.sign)
            result.push_back(slip);
      if (grazing)
        result.push_back(ContactState::open);
      return result;
    }

    /** Solves one combination; false if it has no solution or violates an inequality. */
    bool
    is_consistent(const ReducedProblem &problem,
                  const std::vector<ContactState> &states,
                  double &largest_rate)
    {
      std::vector<std::size_t> moving;
      std::vector<double> weight; // row: force[i] + weight * force of the normal bar
      std::vector<std::size_t> normal;
      for (std::size_t c = 0; c < states.size(); ++c)
        {
          const Candidate &candidate = problem.candidates[c];
          const auto add             = [&](const std::size_t bar, const double w) {
            moving.push_back(bar);
            weight.push_back(w);
            normal.push_back(candidate.n);
          };
          if (states[c] == ContactState::open)
            add(candidate.n, 0.);
          if (candidate.has_shear && states[c] != ContactState::stick)
            add(candidate.t, slip_sign(states[c]) * friction(problem, candidate));
        }
      const std::size_t m = moving.size(), n = problem.q.size();
      DenseMatrix A(m, m);
      Vector b(m), rates(n, 0.), forces = problem.q;
      for (std::size_t i = 0; i < m; ++i)
        {
          b[i] = problem.q[moving[i]] + weight[i] * problem.q[normal[i]];
          for (std::size_t j = 0; j < m; ++j)
            A(i, j) = problem.M(moving[i], moving[j]) + weight[i] * problem.M(normal[i], moving[j]);
        }
      if (m > 0)
        {
          const LinearSolution solution = solve_linear(std::move(A), b, true);
          if (!solution.regular && !solution.consistent)
            return false;
          for (std::size_t i = 0; i < m; ++i)
            rates[moving[i]] = solution.X(i, 0);
        }
      double size  = problem.size;
      largest_rate = 0.;
      for (std::size_t i = 0; i < n; ++i)
        {
          size         = std::max(size, std::abs(problem.q[i]));
          largest_rate = std::max(largest_rate, std::abs(rates[i]));
          for (std::size_t j = 0; j < n; ++j)
            forces[i] -= problem.M(i, j) * rates[j];
        }
      const double noise = tolerance * std::max(size, largest_rate);
      for (Eigen::Index a = 0; a < problem.follow.rows(); ++a)
        {
          double rate = problem.follow(a, n);
          for (std::size_t j = 0; j < n; ++j)
            rate -= problem.follow(a, j) * rates[j];
          largest_rate = std::max(largest_rate, std::abs(rate));
        }
      largest_rate = size > 0. ? largest_rate / size : largest_rate;
      for (std::size_t c = 0; c < states.size(); ++c)
        {
          const Candidate &candidate = problem.candidates[c];
          const double N             = forces[candidate.n];
          const double T             = candidate.has_shear ? forces[candidate.t] : 0.;
          const double strength      = -friction(problem, candidate) * N;
          if (states[c] == ContactState::open)
            {
              if (rates[candidate.n] < -noise)
                return false;
              continue;
            }
          if (candidate.status == RateStatus::grazing && N > noise)
            return false;
          if (!candidate.has_shear ||
              (candidate.status == RateStatus::grazing && candidate.cohesive))
            continue;
          if (states[c] != ContactState::stick)
            {
              if (slip_sign(states[c]) * rates[candidate.t] < -noise)
                return false;
            }
          else if ((candidate.status == RateStatus::grazing ? std::abs(T) : candidate.sign * T) >
                   strength + noise)
            return false;
        }
      return true;
    }

    /** Whether the path can go on with these states, at a bounded rate. */
    bool
    goes_on(const ReducedProblem &problem,
            const std::vector<ContactState> &states,
            RateSearch &result)
    {
      double rate = 0.;
      if (!is_consistent(problem, states, rate))
        return false;
      if (rate < problem.unbounded_rate)
        rate = exact_rate(problem, states);
      if (rate < problem.unbounded_rate)
        {
          result.answer = RateAnswer::continuation;
          return true;
        }
      result.unbounded = std::max(result.unbounded, rate);
      return false;
    }

    void
    enumerate(const ReducedProblem &problem,
              const std::vector<std::vector<ContactState>> &options,
              RateSearch &result)
    {
      std::vector<std::size_t> digits(options.size(), 0);
      std::vector<ContactState> states(options.size());
      result.answer = RateAnswer::none;
      while (true)
        {
          for (std::size_t c = 0; c < options.size(); ++c)
            states[c] = options[c][digits[c]];
          ++result.n_schemes;
          if (goes_on(problem, states, result))
            return;
          std::size_t c = 0;
          while (c < options.size() && ++digits[c] == options[c].size())
            digits[c++] = 0;
          if (c == options.size())
            return;
        }
    }

    void
    pivot(const ReducedProblem &problem, RateSearch &result)
    {
      struct Unknown
      {
        std::size_t bar, candidate;
        double sign; // 0: opening
      };
      std::vector<Unknown> unknowns;
      for (std::size_t c = 0; c < problem.candidates.size(); ++c)
        for (const ContactState state : choices(problem.candidates[c]))
          if (state == ContactState::open)
            unknowns.push_back({problem.candidates[c].n, c, 0.});
          else if (state != ContactState::stick)
            unknowns.push_back({problem.candidates[c].t, c, slip_sign(state)});
      const std::size_t m = unknowns.size();
      DenseMatrix M(m, m);
      Vector q(m), covering(m, 1.);
      const auto reserve = [&](const Unknown &row, const double N, const double T) {
        return row.sign == 0.
                 ? -N
                 : -friction(problem, problem.candidates[row.candidate]) * N - row.sign * T;
      };
      for (std::size_t i = 0; i < m; ++i)
        {
          const Candidate &own = problem.candidates[unknowns[i].candidate];
          q[i] = reserve(unknowns[i], problem.q[own.n], own.has_shear ? problem.q[own.t] : 0.);
          for (std::size_t j = 0; j < m; ++j)
            {
              const double direction = unknowns[j].sign == 0. ? 1. : unknowns[j].sign;
              const std::size_t bar  = unknowns[j].bar;
              M(i, j)                = -direction * reserve(unknowns[i],
                                             problem.M(own.n, bar),
                                             own.has_shear ? problem.M(own.t, bar) : 0.);
            }
        }
      std::mt19937 generator(7);
      result.answer = RateAnswer::ray;
      for (unsigned int attempt = 0; attempt < 12; ++attempt)
        {
          for (std::size_t i = 0; i < m; ++i)
            {
              covering[i] =
                attempt == 0 ? 1. : .05 + static_cast<double>(generator()) / 4294967296.;
              // See judges/lemke_step.cc: keeps the two faces of a cone apart.
              if (unknowns[i].sign != 0.)
                covering[i] += 2. * friction(problem, problem.candidates[unknowns[i].candidate]);
            }
          const LemkeResult lemke_result = lemke(M, q, covering);
          if (lemke_result.status != LemkeStatus::solution)
            continue;
          // The states of the solution are checked like all others.
          std::vector<ContactState> states(problem.candidates.size(), ContactState::stick);
          for (std::size_t i = 0; i < m; ++i)
            if (lemke_result.z[i] > lemke_result.w[i] &&
                states[unknowns[i].candidate] != ContactState::open)
              states[unknowns[i].candidate] = unknowns[i].sign == 0.  ? ContactState::open
                                              : unknowns[i].sign > 0. ? ContactState::slip_forward
                                                                      : ContactState::slip_backward;
          if (goes_on(problem, states, result))
            return;
        }
    }
  } // namespace

  RateSearch
  search_continuation(const JudgeProblem &problem,
                      const std::vector<RateElement> &elements,
                      const Vector &load_rate,
                      const double stiffness_error,
                      const std::size_t max_schemes)
  {
    RateSearch result;
    const ReducedProblem reduced = reduce(problem, elements, load_rate, stiffness_error);
    result.n_boundary            = reduced.candidates.size();
    if (!reduced.regular)
      return result;
    std::vector<std::vector<ContactState>> options;
    double n_schemes = 1.;
    for (const Candidate &candidate : reduced.candidates)
      {
        options.push_back(choices(candidate));
        n_schemes *= static_cast<double>(options.back().size());
      }
    // The pivots find a continuation faster than enumeration, but cannot exclude one.
    pivot(reduced, result);
    if (result.answer != RateAnswer::continuation && n_schemes <= static_cast<double>(max_schemes))
      enumerate(reduced, options, result);
    return result;
  }
} // namespace fuga::stress
