// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/blas.h>
#include <fuga/contact/cones/cone_rate_problem.h>

#include <cmath>

namespace fuga
{
  namespace
  {
    /** Compliances of the springs that are put in series with the bars, times the stiffness of the
     * bars: the first one, the factor between successive ones, and the last one above zero. */
    constexpr double softest = 1e4, first_factor = 0.1, hardest = 1e-4;
    /** Largest factor between successive softnesses for which another trial is worthwhile. */
    constexpr double largest_factor = 0.9;
  } // namespace

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
          blas::axpy(n, softness / stiff.diagonal[j], W.column(j), series.column(j));
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
    std::vector<Candidate> solved;
    double softness = softest, last = 0., factor = first_factor;
    Outcome outcome = Outcome::cycled;
    while (true)
      {
        take_softened(stiff, softness);
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
    refresh_forces();
    return outcome;
  }
} // namespace fuga
