// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_system_tangent_solver_h
#define fuga_contact_system_tangent_solver_h

#include <fuga/base/numerics/dense_matrix.h>

#include <array>

namespace fuga
{
  /** Stiffness of one element's bars, in the order normal, first tangent, second tangent; need not
   * be symmetric [MN/m]. */
  using ElementStiffness = std::array<std::array<double, 3>, 3>;

  /** Solves the bodies together with linear bars where the stiffness S of the bodies is not known
   * as a matrix. */
  class TangentSolver
  {
  public:
    struct Solution
    {
      Vector x;
      /** S x, to the accuracy of the solution. */
      Vector resistance;
      /** Displacements inside the bodies, for refine(); empty if they are not known. */
      Vector interior;

      void
      add(const double factor, const Solution &step);
    };

    virtual ~TangentSolver() = default;

    /** For every bar the stiffness of the bodies against its jump if nothing but its lips moved
     * [MN/m]. */
    virtual Vector
    stiffness_of_lips() const = 0;

    /**
     * Solves (S + Bᵀ C B) x = r with C of @p bars, one per contact element, to the relative residual
     * @p tolerance. What the solution @p so_far, which this one is to be added to, has left inside
     * the bodies is solved for with it.
     * @throws NumericalFailure
     */
    virtual Solution
    solve_with_bars(const std::vector<ElementStiffness> &bars,
                    const Vector &r,
                    const Solution &so_far,
                    const double tolerance) const = 0;

    /** Makes the resistance to x exact: of a sum of solutions with little to be done, of x alone
     * from the beginning. */
    virtual void
    refine(Solution &solution) const = 0;
  };
} // namespace fuga

#endif
