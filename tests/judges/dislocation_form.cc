// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "judges/dislocation_form.h"

#include "judges/linear_solve.h"
#include "judges/scheme.h"

#include <algorithm>
#include <cmath>

namespace fuga::judges
{
  DislocationForm
  dislocation_form(const JudgeProblem &problem, const std::vector<Vector> &loads)
  {
    const std::size_t n_x = problem.n_coordinates();
    const std::size_t n_b = problem.n_bars();
    DenseMatrix rhs(n_x + n_b, n_b + loads.size());
    for (std::size_t bar = 0; bar < n_b; ++bar)
      rhs(n_x + bar, bar) = 1.;
    for (std::size_t l = 0; l < loads.size(); ++l)
      rhs.col(n_b + l).head(loads[l].size()) = view(loads[l]);

    const std::vector<ContactState> all_stick(problem.elements.size(), ContactState::stick);
    const LinearSolution linear =
      solve_linear(scheme_matrix(problem, all_stick, normal_compliances(problem)), std::move(rhs));

    DislocationForm form;
    form.regular = linear.regular;
    form.W       = DenseMatrix(n_b, n_b);
    form.X       = DenseMatrix(n_x, n_b);
    for (std::size_t j = 0; j < n_b; ++j)
      {
        for (std::size_t i = 0; i < n_b; ++i)
          form.W(i, j) = -.5 * (linear.X(n_x + i, j) + linear.X(n_x + j, i));
        std::copy_n(linear.X.col(j).data(), n_x, form.X.col(j).data());
      }
    for (std::size_t l = 0; l < loads.size(); ++l)
      {
        const double *const column = linear.X.col(n_b + l).data();
        form.x_R.emplace_back(column, column + n_x);
        form.R.emplace_back(column + n_x, column + n_x + n_b);
      }
    return form;
  }

  std::vector<ContactState>
  name_states(const JudgeProblem &problem,
              const Vector &slip_before,
              const Vector &p,
              const Vector &openings_and_slips,
              const Vector &stiffness)
  {
    std::vector<ContactState> states;
    for (std::size_t k = 0; k < problem.elements.size(); ++k)
      {
        const JudgeElement &element = problem.elements[k];
        const unsigned int n        = element.normal_bar;
        const double pressing       = -p[n];
        ContactState state          = ContactState::stick;
        if (stiffness[n] * openings_and_slips[n] > pressing)
          state = ContactState::open;
        else if (element.has_tangential_bar())
          {
            const unsigned int t   = element.tangential_bar;
            const double increment = openings_and_slips[t] - slip_before[k];
            const double room      = element.strength(pressing) - std::abs(p[t]);
            if (stiffness[t] * std::abs(increment) > room)
              state = increment > 0. || (increment == 0. && p[t] > 0.)
                        ? ContactState::slip_forward
                        : ContactState::slip_backward;
          }
        states.push_back(state);
      }
    return states;
  }

  Vector
  stiffness_scales(const DenseMatrix &W)
  {
    Vector result(W.rows());
    double largest = 0.;
    for (std::size_t i = 0; i < result.size(); ++i)
      {
        result[i] = W(i, i);
        largest   = std::max(largest, W(i, i));
      }
    for (double &entry : result)
      if (!(entry > 1e-12 * largest))
        entry = largest > 0. ? largest : 1.;
    return result;
  }
} // namespace fuga::judges
