// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/cones/cone_program.h>
#include <fuga/contact/cones/cone_rate_problem.h>

#include <cmath>

namespace fuga
{
  namespace
  {
    /** Number of programs before the search is given up; Newton's method is tried after 1, 2, 4, 8
     * ... of them. */
    constexpr unsigned int n_programs = 256;

    bool
    is_power_of_two(const unsigned int i)
    {
      return (i & (i - 1)) == 0;
    }
  } // namespace

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
    if (candidate.at_apex && place == ConeProgram::Place::unloaded)
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
