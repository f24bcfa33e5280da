// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "judges/lemke_step.h"

#include "judges/dislocation_form.h"
#include "judges/scheme.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace fuga::judges
{
  namespace
  {
    /** One unknown of the LCP: it moves the dislocation of @p bar by @p sign. */
    struct Unknown
    {
      std::size_t element;
      std::size_t bar;
      double sign;
      bool normal;
    };

    std::vector<Unknown>
    list_unknowns(const JudgeProblem &problem)
    {
      std::vector<Unknown> unknowns;
      for (std::size_t k = 0; k < problem.elements.size(); ++k)
        {
          const JudgeElement &element = problem.elements[k];
          unknowns.push_back({k, element.normal_bar, 1., true});
          if (element.has_tangential_bar())
            {
              unknowns.push_back({k, element.tangential_bar, 1., false});
              unknowns.push_back({k, element.tangential_bar, -1., false});
            }
        }
      return unknowns;
    }

    /** M and q, rows and columns scaled by 1/√W_ii of their bars. */
    struct ScaledLcp
    {
      DenseMatrix M;
      Vector q;
      Vector scales;
    };

    ScaledLcp
    build_lcp(const JudgeProblem &problem,
              const std::vector<Unknown> &unknowns,
              const DislocationForm &form,
              const Vector &slip_before,
              const std::vector<bool> &cohesive)
    {
      const Vector stiffness = stiffness_scales(form.W);
      Vector p               = form.R[0]; // forces at a = 0, λ = 0
      for (std::size_t k = 0; k < problem.elements.size(); ++k)
        for (std::size_t i = 0; i < p.size(); ++i)
          {
            const JudgeElement &element = problem.elements[k];
            p[i] += form.W(i, element.normal_bar) * element.initial_gap;
            if (element.has_tangential_bar())
              p[i] -= form.W(i, element.tangential_bar) * slip_before[k];
          }

      const std::size_t n = unknowns.size();
      ScaledLcp lcp{DenseMatrix(n, n), Vector(n), Vector(n)};
      for (std::size_t i = 0; i < n; ++i)
        lcp.scales[i] = 1. / std::sqrt(stiffness[unknowns[i].bar]);
      for (std::size_t i = 0; i < n; ++i)
        {
          // The row's quantity is  on_n N + on_t T + constant.
          const Unknown &row          = unknowns[i];
          const JudgeElement &element = problem.elements[row.element];
          const std::size_t nb        = element.normal_bar;
          const double on_n           = row.normal ? -1. : -element.friction;
          const double on_t           = row.normal ? 0. : -row.sign;
          lcp.q[i]                    = on_n * p[nb] + (row.normal ? 0. : on_t * p[row.bar]);
          if (!row.normal && cohesive[row.element])
            lcp.q[i] += element.cohesion * element.area;
          lcp.q[i] *= lcp.scales[i];
          for (std::size_t j = 0; j < n; ++j)
            {
              const Unknown &column = unknowns[j];
              const double change   = on_n * form.W(nb, column.bar) +
                                    (row.normal ? 0. : on_t * form.W(row.bar, column.bar));
              lcp.M(i, j) = -change * column.sign * lcp.scales[i] * lcp.scales[j];
            }
        }
      return lcp;
    }

    /**
     * The covering vector of one attempt: ones first, then random ones, always the same; raised in
     * the friction rows so that the two faces of a cone stay apart while z0 > 0: with w_n = P + d_n
     * z0 ≥ 0 their distance is 2fP + (d⁺ + d⁻) z0 ≥ (d⁺ + d⁻ - 2f d_n) z0, which must be positive.
     * Otherwise both may vanish at once and λ⁺ = λ⁻ → ∞, which moves nothing, is a ray that proves
     * nothing.
     */
    Vector
    covering_vector(const JudgeProblem &problem,
                    const std::vector<Unknown> &unknowns,
                    const Vector &scales,
                    const std::size_t attempt)
    {
      Vector d(unknowns.size(), 1.);
      std::mt19937 generator(static_cast<unsigned int>(attempt));
      if (attempt > 0)
        for (double &entry : d)
          entry = .05 + static_cast<double>(generator()) / 4294967296.;
      std::size_t normal_row = 0;
      for (std::size_t i = 0; i < d.size(); ++i)
        if (unknowns[i].normal)
          normal_row = i;
        else
          d[i] += problem.elements[unknowns[i].element].friction * d[normal_row] * scales[i] /
                  scales[normal_row];
      return d;
    }
  } // namespace


  LemkeStep
  lemke_step(const JudgeProblem &problem,
             const Vector &slip_before,
             const Vector &load,
             const double tolerance,
             const std::size_t max_attempts)
  {
    validate(problem);
    for (const JudgeElement &element : problem.elements)
      if (element.has_nonlinear_layer())
        throw std::invalid_argument("lemke_step: linear layers only");

    LemkeStep result;
    const DislocationForm form = dislocation_form(problem, {load});
    result.indeterminate       = !form.regular;
    if (result.indeterminate)
      return result;
    const std::vector<Unknown> unknowns = list_unknowns(problem);
    const Vector stiffness              = stiffness_scales(form.W);
    std::vector<bool> cohesive(problem.elements.size(), true);

    for (std::size_t round = 0; round <= problem.elements.size(); ++round)
      {
        ScaledLcp lcp = build_lcp(problem, unknowns, form, slip_before, cohesive);
        double size   = 0.;
        for (const double entry : lcp.q)
          size = std::max(size, std::abs(entry));
        if (size == 0.)
          size = 1.;
        for (double &entry : lcp.q)
          entry /= size;

        for (std::size_t attempt = 0; attempt < max_attempts; ++attempt)
          {
            result.lcp =
              lemke(lcp.M, lcp.q, covering_vector(problem, unknowns, lcp.scales, attempt));
            result.n_pivots += result.lcp.n_pivots;
            ++result.n_attempts;
            if (result.lcp.status == LemkeStatus::solution)
              break;
          }
        if (result.lcp.status != LemkeStatus::solution)
          return result;

        // Back to bars: openings and slips, dislocations, forces, coordinates.
        Vector values(problem.n_bars(), 0.), d(problem.n_bars(), 0.);
        for (std::size_t k = 0; k < problem.elements.size(); ++k)
          if (problem.elements[k].has_tangential_bar())
            values[problem.elements[k].tangential_bar] = slip_before[k];
        for (std::size_t i = 0; i < unknowns.size(); ++i)
          values[unknowns[i].bar] += unknowns[i].sign * result.lcp.z[i] * lcp.scales[i] * size;
        d = values;
        for (const JudgeElement &element : problem.elements)
          d[element.normal_bar] -= element.initial_gap;
        StepSolution &solution = result.solution;
        solution               = StepSolution();
        solution.forces        = form.R[0];
        solution.x             = form.x_R[0];
        for (std::size_t bar = 0; bar < d.size(); ++bar)
          {
            for (std::size_t i = 0; i < d.size(); ++i)
              solution.forces[i] -= form.W(i, bar) * d[bar];
            for (std::size_t i = 0; i < solution.x.size(); ++i)
              solution.x[i] += form.X(i, bar) * d[bar];
          }
        solution.states = name_states(problem, slip_before, solution.forces, values, stiffness);
        for (const JudgeElement &element : problem.elements)
          solution.slip.push_back(element.has_tangential_bar() ? values[element.tangential_bar]
                                                               : 0.);
        complete(problem, slip_before, load, solution);

        // Polish: the scheme's own equations, if they give a smaller residual.
        const SchemeSolution scheme =
          solve_scheme(problem, slip_before, load, solution.states, false);
        if (scheme.solved && scheme.solution.residual < solution.residual)
          solution = scheme.solution;
        result.solved = solution.residual <= tolerance;

        bool changed = false;
        for (std::size_t k = 0; k < problem.elements.size(); ++k)
          if (solution.states[k] == ContactState::open && cohesive[k] &&
              problem.elements[k].cohesion > 0.)
            {
              cohesive[k] = false;
              changed     = true;
            }
        if (!changed || result.solved)
          break;
      }
    return result;
  }
} // namespace fuga::judges
