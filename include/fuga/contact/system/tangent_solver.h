// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_system_tangent_solver_h
#define fuga_contact_system_tangent_solver_h

#include <fuga/base/numerics/dense_matrix.h>

#include <array>

namespace fuga
{
  /** Stiffness of the bars of one element, in the order normal, first tangent, second tangent; it
   * need not be symmetric [MN/m]. */
  using ElementStiffness = std::array<std::array<double, 3>, 3>;

  /** Solves for the bodies together with linear bars where the stiffness S of the bodies is not
   * known as a matrix. */
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

    /** Return for every bar the stiffness of the bodies against its jump if nothing but its lips
     * moved [MN/m]. */
    virtual Vector
    stiffness_of_lips() const = 0;

    /**
     * Solve (S + Bᵀ C B) x = r with C of @p bars, one per contact element, to the relative residual
     * @p tolerance. What the solution @p so_far, to which this one is to be added, has left inside
     * the bodies is solved for as well.
     * @throws NumericalFailure
     */
    virtual Solution
    solve_with_bars(const std::vector<ElementStiffness> &bars,
                    const Vector &r,
                    const Solution &so_far,
                    const double tolerance) const = 0;

    /** Make the resistance to x exact: for a sum of solutions with little effort, for x alone from
     * the beginning. */
    virtual void
    refine(Solution &solution) const = 0;
  };
} // namespace fuga

#endif
