// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "judges/scheme.h"

#include "judges/linear_solve.h"

#include <stdexcept>

namespace fuga::judges
{
  DenseMatrix
  scheme_matrix(const JudgeProblem &problem,
                const std::vector<ContactState> &states,
                const Vector &normal_compliances)
  {
    const std::size_t n_x = problem.n_coordinates();
    const std::size_t n_b = problem.n_bars();
    DenseMatrix matrix(n_x + n_b, n_x + n_b);
    for (std::size_t j = 0; j < n_x; ++j)
      {
        for (std::size_t i = 0; i < n_x; ++i)
          matrix(i, j) = problem.S(i, j);
        for (std::size_t bar = 0; bar < n_b; ++bar)
          matrix(j, n_x + bar) = problem.jump_operator(bar, j);
      }
    const auto jump_row = [&](const std::size_t bar, const double compliance) {
      for (std::size_t j = 0; j < n_x; ++j)
        matrix(n_x + bar, j) = problem.jump_operator(bar, j);
      matrix(n_x + bar, n_x + bar) = -compliance;
    };
    for (std::size_t k = 0; k < problem.elements.size(); ++k)
      {
        const JudgeElement &element = problem.elements[k];
        const std::size_t n         = element.normal_bar;
        if (states[k] == ContactState::open)
          matrix(n_x + n, n_x + n) = 1.;
        else
          jump_row(n, normal_compliances[k] / element.area);
        if (!element.has_tangential_bar())
          continue;
        const std::size_t t = element.tangential_bar;
        if (states[k] == ContactState::stick)
          jump_row(t, element.shear_compliance / element.area);
        else
          {
            matrix(n_x + t, n_x + t) = 1.;
            matrix(n_x + t, n_x + n) = slip_sign(states[k]) * element.friction;
          }
      }
    return matrix;
  }

  Vector
  normal_compliances(const JudgeProblem &problem)
  {
    Vector result;
    for (const JudgeElement &element : problem.elements)
      result.push_back(element.normal_compliance);
    return result;
  }

  SchemeSolution
  solve_scheme(const JudgeProblem &problem,
               const Vector &slip_before,
               const Vector &load,
               const std::vector<ContactState> &states,
               const bool allow_singular)
  {
    const std::size_t n_x = problem.n_coordinates();
    Vector rhs(load);
    rhs.resize(n_x + problem.n_bars(), 0.);
    for (std::size_t k = 0; k < problem.elements.size(); ++k)
      {
        const JudgeElement &element = problem.elements[k];
        if (element.has_nonlinear_layer())
          throw std::invalid_argument("solve_scheme: linear layers only");
        if (states[k] != ContactState::open)
          rhs[n_x + element.normal_bar] = -element.initial_gap;
        if (element.has_tangential_bar())
          rhs[n_x + element.tangential_bar] =
            states[k] == ContactState::stick
              ? slip_before[k]
              : slip_sign(states[k]) * element.cohesion * element.area;
      }

    SchemeSolution result;
    const LinearSolution linear = solve_linear(
      scheme_matrix(problem, states, normal_compliances(problem)), rhs, allow_singular);
    result.singular = !linear.regular;
    result.solved   = linear.regular || linear.consistent;
    if (!result.solved)
      return result;

    StepSolution &solution     = result.solution;
    const double *const values = linear.X.col(0).data();
    solution.x.assign(values, values + n_x);
    solution.forces.assign(values + n_x, values + rhs.size());
    solution.states     = states;
    solution.family     = result.singular;
    const Vector deltas = problem.jumps(solution.x);
    solution.slip.assign(problem.elements.size(), 0.);
    for (std::size_t k = 0; k < problem.elements.size(); ++k)
      if (problem.elements[k].has_tangential_bar())
        {
          const JudgeElement &element = problem.elements[k];
          const std::size_t t         = element.tangential_bar;
          solution.slip[k] =
            states[k] == ContactState::stick
              ? slip_before[k]
              : deltas[t] - element.shear_compliance / element.area * solution.forces[t];
        }
    complete(problem, slip_before, load, solution);
    return result;
  }
} // namespace fuga::judges
