// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/cone_projection.h>

#include <Eigen/QR>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace fuga
{
  RightSingularVectors::RightSingularVectors(const DenseMatrix &A)
    : values(A.cols()), V(A.cols(), A.cols())
  {
    if (A.cols() == 0)
      return;
    DenseMatrix padded(std::max(A.rows(), A.cols()), A.cols());
    padded.topRows(A.rows()) = A;
    const Eigen::BDCSVD<DenseMatrix> svd(padded, Eigen::ComputeFullV);
    values = to_vector(svd.singularValues());
    V      = svd.matrixV();
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
      return svd.V.rightCols(E.cols() - rank);
    }

    /** Return the rows of C, scaled to size one and without those that are zero, as columns. */
    DenseMatrix
    unit_normals(const DenseMatrix &C)
    {
      std::vector<Vector> normals;
      for (Eigen::Index i = 0; i < C.rows(); ++i)
        {
          const double size = C.row(i).norm();
          if (size > negligible)
            normals.push_back(to_vector(C.row(i).transpose() / size));
        }
      DenseMatrix result(C.cols(), normals.size());
      for (std::size_t j = 0; j < normals.size(); ++j)
        result.col(j) = view(normals[j]);
      return result;
    }

    /** Return the multipliers s of the given normals that minimise |q + N s|. */
    Vector
    least_squares(const DenseMatrix &normals,
                  const std::vector<std::size_t> &active,
                  const Vector &q)
    {
      Eigen::CompleteOrthogonalDecomposition<DenseMatrix> factors;
      factors.setThreshold(1e-12);
      factors.compute(normals(Eigen::all, active));
      return to_vector(factors.solve(-view(q)));
    }

    /** Project q by Lawson and Hanson's method for the multipliers of the faces of the cone: μ ≥ 0,
     * |q + N μ| smallest. The remainder of q is its projection. */
    Vector
    project(const DenseMatrix &normals, const Vector &q)
    {
      const double none = 1e-12 * std::sqrt(dot(q, q));
      std::vector<std::size_t> active;
      Vector multipliers, x = q;
      for (Eigen::Index count = 0; count < 10 * (normals.cols() + 1); ++count)
        {
          const Vector distances = normals.size() == 0 ? Vector() : multiply_transposed(normals, x);
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
            view(x) += multipliers[i] * normals.col(active[i]);
        }
      return x;
    }
  } // namespace

  Vector
  nearest_in_cone(const DenseMatrix &E, const DenseMatrix &C, const Vector &q)
  {
    const DenseMatrix Z = null_space(E);
    if (Z.size() == 0)
      return Vector(q.size(), 0.);
    const Vector in_null_space = multiply_transposed(Z, q);
    return multiply(
      Z, C.size() == 0 ? in_null_space : project(unit_normals(multiply(C, Z)), in_null_space));
  }
} // namespace fuga
