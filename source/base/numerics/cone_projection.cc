// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/numerics/blas.h>
#include <fuga/base/numerics/cone_projection.h>

#include <algorithm>
#include <cmath>
#include <lapacke.h>

namespace fuga
{
  RightSingularVectors::RightSingularVectors(const DenseMatrix &A)
    : values(A.n_columns()), V(A.n_columns(), A.n_columns())
  {
    const std::size_t n = A.n_columns(), m = std::max(A.n_rows(), n);
    if (n == 0)
      return;
    DenseMatrix padded(m, n), transposed(n, n);
    for (std::size_t j = 0; j < n; ++j)
      std::copy_n(A.column(j), A.n_rows(), padded.column(j));
    Vector unconverged(n);
    double no_left_vectors = 0.;
    if (LAPACKE_dgesvd(LAPACK_COL_MAJOR,
                       'N',
                       'A',
                       blas::to_int(m),
                       blas::to_int(n),
                       padded.data(),
                       blas::to_int(m),
                       values.data(),
                       &no_left_vectors,
                       1,
                       transposed.data(),
                       blas::to_int(n),
                       unconverged.data()) != 0)
      throw NumericalFailure("The singular values of a matrix were not found.");
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
        V(i, j) = transposed(j, i);
  }

  namespace
  {
    /** Singular values and rows below this value count as zero. */
    constexpr double negligible = 1e-7;

    DenseMatrix
    null_space(const DenseMatrix &E)
    {
      const RightSingularVectors svd(E);
      const std::size_t rank = std::count_if(svd.values.begin(),
                                             svd.values.end(),
                                             [](const double value) { return value > negligible; });
      DenseMatrix result(E.n_columns(), E.n_columns() - rank);
      for (std::size_t j = 0; j < result.n_columns(); ++j)
        std::copy_n(svd.V.column(rank + j), result.n_rows(), result.column(j));
      return result;
    }

    /** Return the rows of C, scaled to size one and without those that are zero, as columns. */
    DenseMatrix
    unit_normals(const DenseMatrix &C)
    {
      std::vector<Vector> normals;
      for (std::size_t i = 0; i < C.n_rows(); ++i)
        {
          Vector row(C.n_columns());
          for (std::size_t j = 0; j < row.size(); ++j)
            row[j] = C(i, j);
          const double size = std::sqrt(dot(row, row));
          if (size <= negligible)
            continue;
          for (double &value : row)
            value /= size;
          normals.push_back(row);
        }
      DenseMatrix result(C.n_columns(), normals.size());
      for (std::size_t j = 0; j < normals.size(); ++j)
        std::copy(normals[j].begin(), normals[j].end(), result.column(j));
      return result;
    }

    /** Return the multipliers s of the given normals that minimise |q + N s|. */
    Vector
    least_squares(const DenseMatrix &normals,
                  const std::vector<std::size_t> &active,
                  const Vector &q)
    {
      const std::size_t n = q.size(), m = active.size(), n_rhs = std::max(n, m);
      DenseMatrix A(n, m);
      for (std::size_t j = 0; j < m; ++j)
        std::copy_n(normals.column(active[j]), n, A.column(j));
      Vector s(n_rhs, 0.);
      for (std::size_t i = 0; i < n; ++i)
        s[i] = -q[i];
      std::vector<int> pivots(m, 0);
      int rank = 0;
      LAPACKE_dgelsy(LAPACK_COL_MAJOR,
                     blas::to_int(n),
                     blas::to_int(m),
                     1,
                     A.data(),
                     blas::to_int(n),
                     s.data(),
                     blas::to_int(n_rhs),
                     pivots.data(),
                     1e-12,
                     &rank);
      s.resize(m);
      return s;
    }

    /** Project q by Lawson and Hanson's method for the multipliers of the faces of the cone: μ ≥ 0,
     * |q + N μ| smallest. The remainder of q is its projection. */
    Vector
    project(const DenseMatrix &normals, const Vector &q)
    {
      const double none = 1e-12 * std::sqrt(dot(q, q));
      std::vector<std::size_t> active;
      Vector multipliers, x = q;
      for (std::size_t count = 0; count < 10 * (normals.n_columns() + 1); ++count)
        {
          const Vector distances = normals.empty() ? Vector() : multiply_transposed(normals, x);
          const auto worst       = std::min_element(distances.begin(), distances.end());
          if (worst == distances.end() || *worst >= -none)
            break;
          active.push_back(static_cast<std::size_t>(worst - distances.begin()));
          multipliers.push_back(0.);
          Vector wanted = least_squares(normals, active, q);
          while (std::any_of(wanted.begin(), wanted.end(), [](const double s) { return s <= 0.; }))
            {
              double step = 1.;
              for (std::size_t i = 0; i < wanted.size(); ++i)
                if (wanted[i] <= 0.)
                  step = std::min(step, multipliers[i] / (multipliers[i] - wanted[i]));
              std::vector<std::size_t> kept;
              Vector kept_multipliers;
              for (std::size_t i = 0; i < wanted.size(); ++i)
                {
                  const double value = multipliers[i] + step * (wanted[i] - multipliers[i]);
                  if (wanted[i] <= 0. && value <= 1e-14 * max_abs(multipliers))
                    continue;
                  kept.push_back(active[i]);
                  kept_multipliers.push_back(value);
                }
              active      = kept;
              multipliers = kept_multipliers;
              if (active.empty())
                break;
              wanted = least_squares(normals, active, q);
            }
          multipliers = active.empty() ? Vector() : wanted;
          x           = q;
          for (std::size_t i = 0; i < active.size(); ++i)
            blas::axpy(x.size(), multipliers[i], normals.column(active[i]), x.data());
        }
      return x;
    }
  } // namespace

  Vector
  nearest_in_cone(const DenseMatrix &E, const DenseMatrix &C, const Vector &q)
  {
    const DenseMatrix Z = null_space(E);
    if (Z.empty())
      return Vector(q.size(), 0.);
    const Vector in_null_space = multiply_transposed(Z, q);
    return multiply(
      Z, C.empty() ? in_null_space : project(unit_normals(multiply(C, Z)), in_null_space));
  }
} // namespace fuga
