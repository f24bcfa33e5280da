// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/blas.h>
#include <fuga/contact/released_system.h>

#include <cmath>
#include <lapacke.h>

namespace fuga
{
  namespace
  {
    /** Pivot of W_oo, scaled to a unit diagonal, that counts as zero. */
    constexpr double smallest_pivot = 1e-13;
  } // namespace

  ReleasedSystem::ReleasedSystem(const LayeredSystem &layered_system) : system(layered_system)
  {
  }

  bool
  ReleasedSystem::release(const std::vector<std::size_t> &new_bars)
  {
    bars                 = new_bars;
    const std::size_t n  = bars.size();
    const DenseMatrix &W = system.stiffness();
    roots.assign(n, 0.);
    factor = DenseMatrix(n, n);
    for (std::size_t j = 0; j < n; ++j)
      {
        if (W(bars[j], bars[j]) <= 0.)
          return false;
        roots[j] = std::sqrt(W(bars[j], bars[j]));
      }
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
        factor(i, j) = W(bars[i], bars[j]) / (roots[i] * roots[j]);
    if (n == 0)
      return true;
    const int size = blas::to_int(n);
    ++work::now().dense_factorisations;
    work::now().dense_operations += factor.n_rows() * factor.n_rows() * factor.n_rows() / 6;
    if (LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'L', size, factor.data(), size) != 0)
      return false;
    for (std::size_t i = 0; i < n; ++i)
      if (factor(i, i) * factor(i, i) < smallest_pivot)
        return false;
    return true;
  }

  Vector
  ReleasedSystem::solve(Vector x) const
  {
    const int n = blas::to_int(bars.size());
    for (std::size_t i = 0; i < bars.size(); ++i)
      x[i] /= roots[i];
    ++work::now().dense_solutions;
    work::now().dense_operations += bars.size() * bars.size();
    if (n > 0)
      LAPACKE_dpotrs_work(LAPACK_COL_MAJOR, 'L', n, 1, factor.data(), n, x.data(), n);
    for (std::size_t i = 0; i < bars.size(); ++i)
      x[i] /= roots[i];
    return x;
  }

  // With L the factor, W_co W_oo⁻¹ W_oc = ZᵀZ, Z = L⁻¹ W_oc.
  DenseMatrix
  ReleasedSystem::stiffness(const std::vector<std::size_t> &of_bars) const
  {
    const DenseMatrix &W = system.stiffness();
    DenseMatrix result(of_bars.size(), of_bars.size());
    for (std::size_t j = 0; j < of_bars.size(); ++j)
      for (std::size_t i = 0; i < of_bars.size(); ++i)
        result(i, j) = W(of_bars[i], of_bars[j]);
    if (bars.empty() || of_bars.empty())
      return result;
    DenseMatrix Z(bars.size(), of_bars.size());
    for (std::size_t j = 0; j < of_bars.size(); ++j)
      for (std::size_t i = 0; i < bars.size(); ++i)
        Z(i, j) = W(bars[i], of_bars[j]) / roots[i];
    const int n = blas::to_int(bars.size()), m = blas::to_int(of_bars.size());
    work::now().dense_solutions += of_bars.size();
    work::now().dense_operations += bars.size() * bars.size() * of_bars.size() / 2;
    LAPACKE_dtrtrs_work(LAPACK_COL_MAJOR, 'L', 'N', 'N', n, m, factor.data(), n, Z.data(), n);
    const DenseMatrix change = multiply_transposed(Z, Z);
    for (std::size_t j = 0; j < of_bars.size(); ++j)
      for (std::size_t i = 0; i < of_bars.size(); ++i)
        result(i, j) -= change(i, j);
    return result;
  }

  Vector
  ReleasedSystem::reactions(const Vector &all, const std::vector<std::size_t> &of_bars) const
  {
    const DenseMatrix &W = system.stiffness();
    Vector released(bars.size()), result(of_bars.size());
    for (std::size_t i = 0; i < bars.size(); ++i)
      released[i] = all[bars[i]];
    released = solve(released);
    for (std::size_t i = 0; i < of_bars.size(); ++i)
      {
        result[i] = all[of_bars[i]];
        for (std::size_t j = 0; j < bars.size(); ++j)
          result[i] -= W(bars[j], of_bars[i]) * released[j];
      }
    return result;
  }

  void
  ReleasedSystem::complete(const Vector &reactions, Vector &dislocations) const
  {
    const DenseMatrix &W = system.stiffness();
    for (const std::size_t bar : bars)
      dislocations[bar] = 0.;
    Vector forces = reactions;
    system.subtract_response(dislocations, forces);
    // The second sweep refines: forces of open elements are differences of large terms.
    for (int sweep = 0; sweep < 2; ++sweep)
      {
        Vector change(bars.size());
        for (std::size_t i = 0; i < bars.size(); ++i)
          change[i] = forces[bars[i]];
        change = solve(change);
        for (std::size_t i = 0; i < bars.size(); ++i)
          {
            dislocations[bars[i]] += change[i];
            blas::axpy(forces.size(), -change[i], W.column(bars[i]), forces.data());
          }
      }
  }

  JointRates
  ReleasedSystem::mechanism() const
  {
    constexpr double epsilon = 1e-14;
    const DenseMatrix &W     = system.stiffness();
    DenseMatrix M(bars.size(), bars.size());
    for (std::size_t j = 0; j < bars.size(); ++j)
      for (std::size_t i = 0; i < bars.size(); ++i)
        M(i, j) = W(bars[i], bars[j]) + (i == j ? epsilon * system.largest_stiffness() : 0.);
    const Vector x = null_vector(std::move(M));
    JointRates result;
    result.dislocations.assign(system.n_bars(), 0.);
    result.forces.assign(system.n_bars(), 0.);
    for (std::size_t i = 0; i < bars.size(); ++i)
      {
        result.dislocations[bars[i]] = x[i];
        blas::axpy(result.forces.size(), -x[i], W.column(bars[i]), result.forces.data());
      }
    return result;
  }
} // namespace fuga
