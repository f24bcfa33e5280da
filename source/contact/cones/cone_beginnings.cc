// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/cones/cone_program.h>
#include <fuga/contact/cones/cone_rate_problem.h>
#include <fuga/contact/cones/lemke.h>

#include <cmath>
#include <utility>

// Other beginnings for Newton's method where it goes round in circles.
namespace fuga
{
  namespace
  {
    /** Compliances of the springs that are put in series with the bars, times the stiffness of the
     * bars: the first one, the factor between successive ones, and the last one above zero. */
    constexpr double softest = 1e4, first_factor = 0.1, hardest = 1e-4;
    /** Largest factor between successive softnesses for which another trial is worthwhile. */
    constexpr double largest_factor = 0.9;

    /** Number of covering vectors with which Lemke's method begins. */
    constexpr unsigned int n_covering_vectors = 12;
    constexpr double golden_ratio             = 0.6180339887498949;

    /** Number of programs before the search is given up; Newton's method is tried after 1, 2, 4, 8
     * ... of them. */
    constexpr unsigned int n_programs = 256;
    constexpr double unbounded        = 1e12;

    bool
    is_power_of_two(const unsigned int i)
    {
      return (i & (i - 1)) == 0;
    }
  } // namespace

  // Lemke's method ends with a solution, or with a vertex from which Newton's method may begin.
  // Both directions of slip of an element may grow together without moving anything: a meaningless
  // ray. It cannot occur if the artificial variable acts in the friction rows by more than f times
  // what it does in the opening row.
  bool
  ConeRateProblem::pivot(const std::vector<ConeUnknown> &unknowns,
                         const ConeLcp &problem,
                         const Vector &shares,
                         ConeContinuation &result)
  {
    constexpr double nothing = 1e-12;
    Vector covering          = shares;
    for (std::size_t j = 0; j < unknowns.size(); ++j)
      if (const Candidate &candidate = candidates[unknowns[j].candidate]; unknowns[j].slips)
        covering[j] +=
          2. * candidate.friction * unknowns[j].scale * std::sqrt(diagonal[candidate.row]);
    const LcpSolution solution = solve_lcp(problem.M, problem.q, covering);
    if (solution.status == LcpStatus::ray && ray.empty())
      ray = motion_of(unknowns, solution.z);
    const Vector &z = solution.solved() ? solution.z : solution.vertex;
    if (z.size() != unknowns.size())
      return false; // the method was cut short
    take_answers(unknowns, z, nothing, std::vector<bool>(candidates.size(), false));
    return settles(result);
  }

  Vector
  ConeRateProblem::motion_of(const std::vector<ConeUnknown> &unknowns, const Vector &z) const
  {
    Vector motion(bars.size(), 0.);
    for (std::size_t j = 0; j < unknowns.size(); ++j)
      {
        const Candidate &candidate = candidates[unknowns[j].candidate];
        const double rate          = unknowns[j].scale * z[j];
        motion[candidate.row] += rate * (unknowns[j].slips ? candidate.rise : 1.);
        for (std::size_t i = 0; i < candidate.n_tangents && unknowns[j].slips; ++i)
          motion[candidate.row + 1 + i] += rate * unknowns[j].direction[i];
      }
    return motion;
  }

  ConeRateProblem::Outcome
  ConeRateProblem::approach_by_pivoting(ConeContinuation &result)
  {
    if (!accept || has_free_directions())
      return Outcome::cycled; // the other beginnings need no given directions
    const std::vector<bool> none(candidates.size(), false);
    const std::vector<ConeUnknown> unknowns = unknowns_of(none, true);
    return pivot(unknowns, *problem_of(unknowns, {}, none), Vector(unknowns.size(), 1.), result)
             ? Outcome::solved
             : Outcome::cycled;
  }

  // Where all rates are resisted, as by a viscous layer, no motion is free, and Lemke's method
  // finds a solution; the weaker the resistance, the closer it is to one without.
  bool
  ConeRateProblem::pivot_from_many(ConeContinuation &result, const std::function<bool()> &note)
  {
    if (has_free_directions())
      return false;
    const std::vector<bool> none(candidates.size(), false);
    const std::vector<ConeUnknown> unknowns = unknowns_of(none, true);
    const ConeLcp problem                   = *problem_of(unknowns, {}, none);
    const std::size_t n                     = unknowns.size();
    for (unsigned int attempt = 1; attempt < n_covering_vectors; ++attempt)
      {
        Vector shares(n);
        for (std::size_t i = 0; i < n; ++i)
          {
            // Multiples of the golden ratio fill the interval from 0.05 to 1.05 evenly.
            const double position = golden_ratio * static_cast<double>(attempt * n + i);
            shares[i]             = 0.05 + position - std::floor(position);
          }
        if (pivot(unknowns, problem, shares, result) && note())
          return true;
      }
    for (const double resistance : {1e-8, 1e-6, 1e-4, 1e-2, 1.})
      {
        ConeLcp resisted = problem;
        for (std::size_t i = 0; i < n; ++i)
          resisted.M(i, i) += resistance;
        if (pivot(unknowns, resisted, Vector(n, 1.), result) && note())
          return true;
      }
    return false;
  }

  // With the compliances s/W_ii on the diagonal of C the equations are (I + W C) q = r - W v.
  void
  ConeRateProblem::take_softened(const ReducedSystem &stiff, const double softness)
  {
    W        = stiff.W;
    r        = stiff.r;
    diagonal = stiff.diagonal;
    if (softness == 0.)
      return;
    const std::size_t n = r.size();
    DenseMatrix series(n, n);
    for (std::size_t j = 0; j < n; ++j)
      {
        if (stiff.diagonal[j] > 0.) // a bar without stiffness remains without
          series.col(j) += softness / stiff.diagonal[j] * W.col(j);
        series(j, j) += 1.;
      }
    const LuFactors factors(std::move(series));
    factors.solve(r);
    factors.solve(W);
    for (double &stiffness : diagonal)
      stiffness /= 1. + softness;
  }

  // The softer the layer, the fewer elements change their states at once when one of them does.
  // States and directions of slip of each solution are the initial guess for the next, stiffer one.
  ConeRateProblem::Outcome
  ConeRateProblem::approach_from_softer_layer(ConeContinuation &result)
  {
    const ReducedSystem stiff = {W, r, diagonal};
    const Accept of_stiff     = std::exchange(accept, {});
    std::vector<Candidate> solved;
    double softness = softest, last = 0., factor = first_factor;
    Outcome outcome = Outcome::cycled;
    while (true)
      {
        take_softened(stiff, softness);
        if (softness == 0.)
          accept = of_stiff;
        v.assign(bars.size(), 0.);
        q       = r;
        outcome = iterate(n_iterations, result);
        if (outcome == Outcome::solved)
          {
            if (softness == 0.)
              break;
            solved = candidates;
            last   = softness;
          }
        else if (solved.empty() || (factor = std::sqrt(factor)) > largest_factor)
          break;
        else
          candidates = solved;
        softness = last * factor < hardest ? 0. : last * factor;
      }
    take_softened(stiff, 0.);
    accept = of_stiff;
    refresh_forces();
    return outcome;
  }

  // v = P z - f s n: at the apex z is a block of rates, elsewhere the slip γ, with v_n = fγ - fs.
  DenseMatrix
  ConeRateProblem::associated_motions(std::vector<ConeBlock> &blocks) const
  {
    std::size_t n = 0;
    for (const Candidate &candidate : candidates)
      {
        blocks.push_back({n, candidate.at_apex ? candidate.n_tangents + 1 : 1, candidate.friction});
        n += blocks.back().size;
      }
    DenseMatrix P(bars.size(), n);
    for (std::size_t k = 0; k < blocks.size(); ++k)
      {
        const Candidate &candidate = candidates[k];
        const std::size_t first    = blocks[k].first;
        for (std::size_t i = 0; i < blocks[k].size; ++i)
          P(candidate.row + i, first + i) = 1.;
        if (candidate.at_apex || candidate.n_tangents == 0)
          continue;
        P(candidate.row, first) = candidate.friction;
        for (std::size_t i = 0; i < candidate.n_tangents; ++i)
          P(candidate.row + 1 + i, first) = candidate.direction[i];
      }
    return P;
  }

  // If faces that slip by γ parted by f γ, friction would be associated and the rates the minimum
  // of a convex program. With De Saxcé's change of variables, z = v + f s n for a given s, friction
  // becomes associated, and the rates satisfy eq. 31 if s = |v_t|. This is a fixed point, which is
  // approached by repetition.
  ConeRateProblem::Outcome
  ConeRateProblem::approach_by_associated_slip(ConeContinuation &result)
  {
    for (const Candidate &candidate : candidates)
      if (candidate.at_apex && candidate.n_tangents > 0 && !(candidate.friction > 0.))
        return Outcome::cycled; // a cone without width
    std::vector<ConeBlock> blocks;
    const DenseMatrix P = associated_motions(blocks);
    const ConeProgram program(multiply_transposed(P, multiply(W, P)), blocks);
    const std::vector<Candidate> at_first = candidates;
    Vector lift(bars.size(), 0.);
    for (unsigned int i = 1; i <= n_programs; ++i)
      {
        Vector load = multiply(W, lift);
        for (std::size_t row = 0; row < load.size(); ++row)
          load[row] += r[row];
        if (!(max_abs(load) <= unbounded * max_abs(r)))
          break; // what rises higher and higher has no fixed point
        const std::optional<ConeProgram::Solution> solution =
          program.solve(multiply_transposed(P, load));
        if (!solution || !solution->is_bounded)
          break;
        Vector rates = multiply(P, solution->z);
        for (std::size_t row = 0; row < rates.size(); ++row)
          rates[row] -= lift[row];
        for (const Candidate &candidate : candidates)
          if (candidate.n_tangents > 0)
            lift[candidate.row] = candidate.friction * length(tangential_rows(candidate, rates));
        if (!is_power_of_two(i))
          continue;
        candidates = at_first;
        for (std::size_t k = 0; k < blocks.size(); ++k)
          take_from_program(solution->places[k],
                            candidates[k].friction * solution->forces[blocks[k].first],
                            rates,
                            candidates[k]);
        if (iterate(n_iterations, result) == Outcome::solved)
          return Outcome::solved;
      }
    return Outcome::cycled;
  }

  void
  ConeRateProblem::take_from_program(const ConeProgram::Place place,
                                     const double strength,
                                     const Vector &rates,
                                     Candidate &candidate)
  {
    candidate.state = ContactState::stick;
    candidate.slip = candidate.strength = 0.;
    if (candidate.grazing && place == ConeProgram::Place::unloaded)
      candidate.state = ContactState::open;
    else if (place != ConeProgram::Place::at_rest && candidate.n_tangents > 0)
      {
        const TangentVector slip = tangential_rows(candidate, rates);
        candidate.state          = ContactState::slip_forward;
        candidate.slip           = length(slip);
        if (!candidate.at_apex || candidate.slip == 0.)
          return;
        candidate.strength  = strength;
        candidate.direction = {{slip[0] / candidate.slip, slip[1] / candidate.slip}};
      }
  }
} // namespace fuga
