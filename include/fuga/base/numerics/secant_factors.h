// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_numerics_secant_factors_h
#define fuga_base_numerics_secant_factors_h

#include <fuga/base/numerics/dense_matrix.h>

#include <memory>
#include <optional>

namespace fuga
{
  /**
   * Factors of a Jacobian some of whose unknowns, the *weak* ones, hardly enter any equation but
   * their own: LU factors of the rest, from whose solution the weak unknowns follow.
   */
  class NearlyTriangularFactors
  {
  public:
    NearlyTriangularFactors(const DenseMatrix &jacobian, const std::vector<bool> &is_weak);

    double
    reciprocal_condition() const
    {
      return factors->reciprocal_condition();
    }

    bool
    has_weak_unknowns() const
    {
      return !weak.empty();
    }

    Vector
    solve(const Vector &right_hand_side) const;

  private:
    std::vector<std::size_t> strong, weak;
    std::optional<LuFactors> factors;
    /**
     * The entries of the strong unknowns in the equations of the weak ones, and the diagonal
     * entries of the latter.
     */
    DenseMatrix rows;
    Vector diagonal;
  };

  /**
   * Factors of the Jacobian of a system of equations at a point near the present one, corrected by
   * the results of earlier steps (Broyden's good method, as products of rank-one factors: C. T.
   * Kelley, Iterative Methods for Linear and Nonlinear Equations, SIAM 1995, section 7.3). The few
   * directions in which the Jacobian has changed most are learnt first and are remembered for the
   * next right-hand sides.
   */
  class SecantFactors
  {
  public:
    SecantFactors(const DenseMatrix &jacobian, const std::vector<bool> &is_weak)
      : factors(std::make_shared<const NearlyTriangularFactors>(jacobian, is_weak))
    {
    }

    const NearlyTriangularFactors &
    first_factors() const
    {
      return *factors;
    }

    /** Return the same factors without the corrections learnt at later points. */
    SecantFactors
    without_corrections() const
    {
      SecantFactors result = *this;
      result.corrections.clear();
      return result;
    }

    /**
     * Return the step that removes @p residual. The residual is the result of @p last_step, which
     * was computed with these factors; @p last_step is empty if there was none, or if nothing is to
     * be learnt from it.
     */
    Vector
    solve(const Vector &residual, const Vector &last_step);

  private:
    /**
     * H r = z + missed (step·z) / gain, where z results from the factors and the earlier
     * corrections.
     */
    struct Correction
    {
      Vector step, missed;
      double gain;
    };

    std::shared_ptr<const NearlyTriangularFactors> factors;
    std::vector<Correction> corrections;
  };
} // namespace fuga

#endif
