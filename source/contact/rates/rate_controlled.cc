// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/rates/boundary_lcp.h>
#include <fuga/contact/rates/lemke.h>
#include <fuga/contact/rates/rate_problem.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace fuga
{
  namespace
  {
    /** Share of the reaction of the stiffness of the bars below which a load rate is zero, judging
     * by its forces. */
    constexpr double no_load_rate = 1e-10;

    /** Share of the terms whose difference they are, below which violations are rounding. */
    constexpr double zero_share = 1e-11;
    /** Number of sets of active unknowns tried by switching, and number of unknowns of which all
     * subsets are tried. */
    constexpr std::size_t max_switches   = 200;
    constexpr std::size_t max_enumerated = 12;

    /** A motion z and the load rate that belongs to it. */
    struct Motion
    {
      Vector z;
      double load_rate = 0.;
    };

    /**
     * Return the motion with the given unknowns active: M z + λ̇ q = 0 in their rows, Σ scale
     * z = 1. Set @p reserves to all other rows, which should be nonnegative. Return nothing if the
     * system is singular.
     */
    std::optional<Motion>
    motion_of(const BoundaryLcp &lcp, const std::vector<bool> &active, Vector &reserves)
    {
      std::vector<std::size_t> indices;
      for (std::size_t i = 0; i < lcp.size(); ++i)
        if (active[i])
          indices.push_back(i);
      const std::size_t n     = indices.size();
      const double load_scale = max_abs(lcp.q), motion_scale = max_abs(lcp.scale);
      DenseMatrix bordered(n + 1, n + 1);
      for (std::size_t j = 0; j < n; ++j)
        {
          for (std::size_t i = 0; i < n; ++i)
            bordered(i, j) = lcp.M(indices[i], indices[j]);
          bordered(j, n) = lcp.q[indices[j]] / load_scale;
          bordered(n, j) = lcp.scale[indices[j]] / motion_scale;
        }
      const LuFactors factors(std::move(bordered));
      if (n == 0 || !(factors.reciprocal_condition() > 1e-14))
        return {};
      Vector x(n + 1, 0.);
      x[n] = 1.;
      factors.solve(x);
      Motion motion;
      motion.z.assign(lcp.size(), 0.);
      motion.load_rate = x[n] / load_scale;
      for (std::size_t i = 0; i < n; ++i)
        motion.z[indices[i]] = x[i];
      reserves = multiply(lcp.M, motion.z);
      for (std::size_t i = 0; i < lcp.size(); ++i)
        {
          const double terms = std::abs(reserves[i]) + std::abs(motion.load_rate * lcp.q[i]);
          reserves[i] += motion.load_rate * lcp.q[i];
          if (active[i] || std::abs(reserves[i]) <= zero_share * std::max(terms, max_abs(motion.z)))
            reserves[i] = 0.;
        }
      for (double &value : motion.z)
        if (std::abs(value) <= zero_share * max_abs(motion.z))
          value = 0.;
      return motion;
    }

    bool
    is_valid(const Motion &motion, const Vector &reserves)
    {
      const auto negative = [](const double value) { return value < 0.; };
      return std::none_of(motion.z.begin(), motion.z.end(), negative) &&
             std::none_of(reserves.begin(), reserves.end(), negative);
    }

    void
    add(const double amount, const JointRates &rates, JointRates &sum)
    {
      for (std::size_t i = 0; i < sum.forces.size(); ++i)
        {
          sum.forces[i] += amount * rates.forces[i];
          sum.dislocations[i] += amount * rates.dislocations[i];
        }
    }

    /** Switch unknowns until none violates; all at once until a set comes back, then one by one. */
    std::optional<Motion>
    switch_unknowns(const BoundaryLcp &lcp, std::vector<bool> active)
    {
      std::set<std::vector<bool>> visited;
      Vector reserves;
      for (std::size_t count = 0; count < max_switches; ++count)
        {
          const bool one_by_one              = !visited.insert(active).second;
          const std::optional<Motion> motion = motion_of(lcp, active, reserves);
          if (!motion)
            return {};
          if (is_valid(*motion, reserves))
            return motion;
          for (std::size_t i = 0; i < lcp.size(); ++i)
            if (motion->z[i] < 0. || reserves[i] < 0.)
              {
                active[i] = !active[i];
                if (one_by_one)
                  break;
              }
        }
      return {};
    }

    std::optional<Motion>
    try_all(const BoundaryLcp &lcp)
    {
      Vector reserves;
      for (std::size_t subset = 1; subset < (std::size_t(1) << lcp.size()); ++subset)
        {
          std::vector<bool> active(lcp.size());
          for (std::size_t i = 0; i < lcp.size(); ++i)
            active[i] = ((subset >> i) & 1) != 0;
          const std::optional<Motion> motion = motion_of(lcp, active, reserves);
          if (motion && is_valid(*motion, reserves))
            return motion;
        }
      return {};
    }

    /** Begin with the motion that the growing load would cause, which meets the least resistance,
     * then with the elements that already move. */
    std::optional<Motion>
    find_motion(const BoundaryLcp &lcp, const std::vector<bool> &moving)
    {
      if (max_abs(lcp.q) == 0.)
        return {};
      std::vector<bool> active(lcp.size());
      const LcpSolution growing = solve_lcp(lcp.M, lcp.q, lcp.covering);
      for (std::size_t i = 0; i < lcp.size(); ++i)
        active[i] = growing.z[i] > 1e-9 * max_abs(growing.z);
      if (const std::optional<Motion> motion = switch_unknowns(lcp, active))
        return motion;
      if (const std::optional<Motion> motion = switch_unknowns(lcp, moving))
        return motion;
      if (lcp.size() <= max_enumerated)
        return try_all(lcp);
      return {};
    }
  } // namespace

  void
  RateProblem::measure_by_largest_jump(const Drive &unit_load, ControlledContinuation &motion) const
  {
    const double size =
      largest_jump(elements, system.jumps(motion.rates.dislocations, motion.rates.forces));
    for (std::size_t i = 0; i < system.n_bars(); ++i)
      {
        motion.rates.forces[i] /= size;
        motion.rates.dislocations[i] /= size;
      }
    motion.load_rate /= size;
    if (std::abs(motion.load_rate) * max_abs(unit_load.reactions) <=
        no_load_rate * system.largest_stiffness())
      motion.load_rate = 0.;
  }

  ControlledContinuation
  RateProblem::solve_controlled(const JointState &state,
                                const std::vector<BoundaryElement> &set,
                                const Drive &unit_load)
  {
    ControlledContinuation result;
    if (has_cones)
      {
        Drive at_rest;
        at_rest.reactions.assign(system.n_bars(), 0.);
        result =
          solve_yielding_cones(state, set, at_rest, unit_load, ConeRateProblem::Control::motion);
        if (result.exists)
          measure_by_largest_jump(unit_load, result);
        return result;
      }
    Continuation unused;
    const std::vector<ContactState> present = states_of(set);
    const std::optional<BoundaryLcp> lcp    = boundary_lcp(state, set, unit_load, unused);
    if (!lcp || lcp->size() == 0)
      return result;
    std::vector<bool> moving(lcp->size());
    for (std::size_t j = 0; j < lcp->size(); ++j)
      for (std::size_t i = 0; i < set.size(); ++i)
        if (lcp->unknowns[j].element == set[i].element)
          moving[j] = lcp->unknowns[j].state == present[i];
    const std::optional<Motion> motion = find_motion(*lcp, moving);
    if (!motion)
      return result;

    result.load_rate = motion->load_rate;
    result.rates     = lcp->motion(motion->z);
    add(result.load_rate, lcp->stuck, result.rates);
    measure_by_largest_jump(unit_load, result);
    take_states(*lcp, set, motion->z);
    Drive drive = unit_load;
    for (double &rate : drive.reactions)
      rate *= result.load_rate;
    result.exists = violations(state, set, drive, result.rates).empty();
    return result;
  }

  // The border is skew: where M is positive semidefinite the whole matrix is, so that Lemke's
  // method ends with a solution if there is one.
  ControlledContinuation
  RateProblem::solve_release(const JointState &state,
                             const std::vector<BoundaryElement> &set,
                             const Drive &release,
                             const Drive &unit_load)
  {
    if (has_cones)
      return solve_yielding_cones(
        state, set, release, unit_load, ConeRateProblem::Control::displacement);
    ControlledContinuation result;
    Continuation unused;
    const std::optional<BoundaryLcp> lost = boundary_lcp(state, set, release, unused);
    const std::optional<BoundaryLcp> load = boundary_lcp(state, set, unit_load, unused);
    if (!lost || !load || max_abs(load->q) == 0.)
      return result;
    const std::size_t n     = lost->size();
    const double load_scale = max_abs(load->q);
    DenseMatrix M(n + 1, n + 1);
    Vector q = lost->q, covering = lost->covering;
    for (std::size_t j = 0; j < n; ++j)
      {
        for (std::size_t i = 0; i < n; ++i)
          M(i, j) = lost->M(i, j);
        M(j, n) = -load->q[j] / load_scale;
        M(n, j) = load->q[j] / load_scale;
      }
    q.push_back(0.);
    covering.push_back(1.);
    const LcpSolution solution = solve_lcp(M, q, covering);
    if (!solution.solved())
      return result;

    const Vector z(solution.z.begin(), solution.z.end() - 1);
    result.load_rate = -solution.z.back() / load_scale;
    result.rates     = lost->motion(z);
    add(1., lost->stuck, result.rates);
    add(result.load_rate, load->stuck, result.rates);
    take_states(*lost, set, z);
    Drive drive = release;
    for (std::size_t i = 0; i < drive.reactions.size(); ++i)
      drive.reactions[i] += result.load_rate * unit_load.reactions[i];
    result.exists = violations(state, set, drive, result.rates).empty();
    return result;
  }
} // namespace fuga
