// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "judges/enumeration.h"

#include "judges/scheme.h"

#include <stdexcept>

namespace fuga::judges
{
  StepEnumeration
  enumerate_step(const JudgeProblem &problem,
                 const Vector &slip_before,
                 const Vector &load,
                 const double tolerance)
  {
    validate(problem);
    const std::size_t n = problem.elements.size();
    if (n > 9)
      throw std::invalid_argument("enumerate_step: too many elements");

    constexpr ContactState all_states[] = {ContactState::open,
                                           ContactState::stick,
                                           ContactState::slip_forward,
                                           ContactState::slip_backward};

    StepEnumeration result;
    std::vector<unsigned int> digits(n, 0u);
    std::vector<ContactState> states(n, ContactState::open);
    while (true)
      {
        for (std::size_t k = 0; k < n; ++k)
          states[k] = all_states[digits[k]];
        ++result.n_schemes;
        const SchemeSolution scheme = solve_scheme(problem, slip_before, load, states, true);
        if (scheme.singular)
          ++result.n_singular;
        if (scheme.solved && scheme.solution.residual <= tolerance)
          {
            bool is_new = true;
            for (const StepSolution &known : result.solutions)
              is_new = is_new && distance(known, scheme.solution) > 1e-8;
            if (is_new)
              result.solutions.push_back(scheme.solution);
          }

        std::size_t k = 0;
        while (k < n && ++digits[k] == (problem.elements[k].has_tangential_bar() ? 4u : 2u))
          digits[k++] = 0u;
        if (k == n)
          return result;
      }
  }
} // namespace fuga::judges
