// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/dynamics/step_system.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Column numbers of the patterns, and their number. */
    constexpr std::size_t at_begin = 0, at_end = 1, of_jumps = 2, n_patterns = 3;

    std::size_t
    number_of_bars(const std::vector<ContactElement> &elements)
    {
      std::size_t result = 0;
      for (const ContactElement &element : elements)
        result += element.n_bars();
      return result;
    }

    DenseMatrix
    identity(const std::size_t n)
    {
      DenseMatrix result(n, n);
      for (std::size_t i = 0; i < n; ++i)
        result(i, i) = 1.;
      return result;
    }
  } // namespace

  StepSystem::StepSystem(DenseMatrix &&stiffness,
                         const unsigned int rung_of_stiffness,
                         const SparseOperator &jump_operator,
                         const std::vector<ContactElement> &elements)
    : S(std::move(stiffness))
    , rung(rung_of_stiffness)
    , B(jump_operator)
    , dual(dual_of(B))
    , no_motions(number_of_bars(elements), 0)
    , no_loads(0, n_patterns)
    , F(identity(S.rows()))
  {
    layered_system.emplace(*this, elements);
    reactions_to_units = layered_system->reactions();
    F                  = DenseMatrix(S.rows(), n_patterns);
    E                  = DenseMatrix(layered_system->n_bars(), n_patterns);
  }

  void
  StepSystem::begin(const JointState &state,
                    const MovingBodies::Step &step,
                    const double largest_energy)
  {
    energy              = largest_energy;
    pushed              = std::ldexp(max_abs(whole_push(step)), static_cast<int>(rung));
    const Vector before = multiply_transposed(B, state.forces);
    const Vector jumps  = layered_system->jumps(state.dislocations, state.forces);
    for (std::size_t i = 0; i < before.size(); ++i)
      {
        F(i, at_begin) = before[i];
        F(i, at_end)   = before[i] + step.push[i];
      }
    E.col(of_jumps) = view(jumps);
    E.col(at_end)   = view(step.jumps);

    DenseMatrix reactions(layered_system->n_bars(), n_patterns);
    for (const std::size_t column : {at_begin, at_end})
      {
        const Vector of_load  = multiply(reactions_to_units, to_vector(F.col(column)));
        reactions.col(column) = view(of_load);
      }
    layered_system->take_loads(std::move(reactions));
  }

  // The jumps are compatible: B x = jumps has a solution.
  Vector
  StepSystem::whole_push(const MovingBodies::Step &step) const
  {
    Vector result = multiply(S, multiply_transposed(dual, step.jumps));
    add_multiple(1., step.push, result);
    return result;
  }

  LoadHistory
  StepSystem::history()
  {
    return LoadHistory({0., 1.}, {{1., 0., 1.}, {0., 1., 1.}});
  }

  // Where joints have opened far, the rounding error of a jump is more than one digit of the change
  // within the step; the balance of forces, which does not depend on how far they have opened,
  // gives x to all digits.
  Vector
  StepSystem::coordinates(const Vector &jumps, const Vector &forces)
  {
    Vector result(S.rows());
    if (B.is_identity())
      {
        constexpr double wanted_digits = 1e-12;
        for (std::size_t i = 0; i < result.size(); ++i)
          result[i] = jumps[i] - E(i, of_jumps) - E(i, at_end);
        if (std::numeric_limits<double>::epsilon() * max_abs(jumps) <=
            wanted_digits * max_abs(result))
          return result;
      }
    if (!factors)
      factors.emplace(DenseMatrix(S));
    const Vector carried = multiply_transposed(B, forces);
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = F(i, at_end) - carried[i];
    factors->solve(result);
    return result;
  }
} // namespace fuga
