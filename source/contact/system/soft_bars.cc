// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/numerics/blas.h>
#include <fuga/contact/system/soft_bars.h>

#include <algorithm>
#include <cmath>
#include <lapacke.h>

namespace fuga
{
  namespace
  {
    using Indices = std::vector<std::size_t>;

    /** Compute A += factor B. */
    void
    add(DenseMatrix &A, const double factor, const DenseMatrix &B)
    {
      if (!A.empty())
        blas::axpy(A.n_rows() * A.n_columns(), factor, B.data(), A.data());
    }

    /** Return combinations N of the columns of A (k x k_null) with A N = 0 to rounding. */
    DenseMatrix
    null_combinations(const DenseMatrix &A, const std::size_t k)
    {
      DenseMatrix gram = A.n_rows() > 0 ? multiply_transposed(A, A) : DenseMatrix(k, k);
      Vector eigenvalues(k, 0.);
      if (k == 0)
        return {};
      const int n = static_cast<int>(k);
      if (LAPACKE_dsyev(LAPACK_COL_MAJOR, 'V', 'U', n, gram.data(), n, eigenvalues.data()) != 0)
        throw NumericalFailure("The rigid motions of the bodies cannot be told apart.");
      // The columns of A have entries of at most one: a motion that some bar resists is far above
      // this.
      const double threshold = 1e-14;
      std::size_t n_null     = 0;
      while (n_null < k && eigenvalues[n_null] <= threshold)
        ++n_null;
      DenseMatrix N(k, n_null);
      std::copy_n(gram.data(), k * n_null, N.data());
      return N;
    }

    struct SoftMotions
    {
      RigidMotions motions;
      /** Largest jump of another bar in one of these motions. */
      double jump_of_others = 0.;
    };

    /** Return the motions that only soft bars resist: orthonormal jumps of the soft bars, and the
     * work of the loads. */
    SoftMotions
    motions_of_soft_bars(const RigidMotions &motions, const Indices &soft, const Indices &others)
    {
      const std::size_t k = motions.jumps.n_columns();
      RigidMotions scaled{motions.jumps, motions.load_work};
      for (std::size_t j = 0; j < k; ++j)
        {
          double size = 0.;
          for (std::size_t i = 0; i < scaled.jumps.n_rows(); ++i)
            size = std::max(size, std::abs(scaled.jumps(i, j)));
          for (std::size_t i = 0; i < scaled.jumps.n_rows() && size > 0.; ++i)
            scaled.jumps(i, j) /= size;
          for (std::size_t i = 0; i < scaled.load_work.n_columns() && size > 0.; ++i)
            scaled.load_work(j, i) /= size;
        }
      const Indices columns       = all_columns(scaled.jumps);
      const DenseMatrix of_others = submatrix(scaled.jumps, others, columns);
      const DenseMatrix N         = null_combinations(of_others, k);
      RigidMotions result{multiply(submatrix(scaled.jumps, soft, columns), N),
                          multiply_transposed(N, scaled.load_work)};
      const DenseMatrix left = multiply(of_others, N);
      const double jump_of_others =
        max_abs(Vector(left.data(), left.data() + left.n_rows() * left.n_columns()));

      // The Gram-Schmidt method is applied twice; the work follows the motions.
      for (int sweep = 0; sweep < 2; ++sweep)
        for (std::size_t j = 0; j < result.jumps.n_columns(); ++j)
          {
            const std::size_t n = result.jumps.n_rows();
            double *v           = result.jumps.column(j);
            for (std::size_t i = 0; i < j; ++i)
              {
                const double share = blas::dot(n, result.jumps.column(i), v);
                blas::axpy(n, -share, result.jumps.column(i), v);
                for (std::size_t l = 0; l < result.load_work.n_columns(); ++l)
                  result.load_work(j, l) -= share * result.load_work(i, l);
              }
            const double length = std::sqrt(blas::dot(n, v, v));
            if (!(length > 0.))
              throw_unheld();
            for (std::size_t i = 0; i < n; ++i)
              v[i] /= length;
            for (std::size_t l = 0; l < result.load_work.n_columns(); ++l)
              result.load_work(j, l) /= length;
          }
      return {result, jump_of_others};
    }

    /** Compute A ← (I - G Gᵀ) A for orthonormal G. */
    void
    remove_motions(DenseMatrix &A, const DenseMatrix &G)
    {
      if (G.n_columns() > 0)
        add(A, -1., multiply(G, multiply_transposed(G, A)));
    }

    /** Return P (S + C) P + σ G Gᵀ: the stiffness against deformation, made definite by the
     * motions. */
    DenseMatrix
    deformation_stiffness(const DenseMatrix &S, const Vector &C, const DenseMatrix &G)
    {
      DenseMatrix H = S;
      double sigma  = 0.;
      for (std::size_t i = 0; i < C.size(); ++i)
        {
          H(i, i) += C[i];
          sigma = std::max(sigma, H(i, i));
        }
      if (G.n_columns() == 0)
        return H;
      remove_motions(H, G);
      H = transposed(H);
      remove_motions(H, G);
      add(H, sigma, multiply(G, transposed(G)));
      return H;
    }

    /** Add the small compliances D to the stiff bars: W ← (W⁻¹ + D)⁻¹ without inverting W. */
    void
    insert_stiff_bars(DenseMatrix &W, DenseMatrix &R, const Indices &stiff, const Vector &D)
    {
      Vector roots(D.size());
      std::transform(
        D.begin(), D.end(), roots.begin(), [](const double d) { return std::sqrt(d); });

      DenseMatrix E_W = submatrix(W, stiff, all_columns(W));
      DenseMatrix E_R = submatrix(R, stiff, all_columns(R));
      scale_rows(E_W, roots);
      scale_rows(E_R, roots);
      DenseMatrix H(stiff.size(), stiff.size());
      for (std::size_t j = 0; j < stiff.size(); ++j)
        for (std::size_t i = 0; i < stiff.size(); ++i)
          H(i, j) = E_W(i, stiff[j]) * roots[j] + (i == j ? 1. : 0.);

      DenseMatrix Z(stiff.size(), W.n_columns() + R.n_columns());
      std::copy_n(E_W.data(), E_W.n_rows() * E_W.n_columns(), Z.data());
      std::copy_n(E_R.data(), E_R.n_rows() * E_R.n_columns(), Z.column(W.n_columns()));
      if (!solve_positive_definite(H, Z))
        throw_unheld();

      const DenseMatrix change = multiply_transposed(E_W, Z);
      for (std::size_t j = 0; j < W.n_columns(); ++j)
        for (std::size_t i = 0; i < W.n_rows(); ++i)
          W(i, j) -= change(i, j);
      for (std::size_t j = 0; j < R.n_columns(); ++j)
        for (std::size_t i = 0; i < R.n_rows(); ++i)
          R(i, j) -= change(i, W.n_columns() + j);
    }
  } // namespace

  DenseMatrix
  transposed(const DenseMatrix &A)
  {
    DenseMatrix result(A.n_columns(), A.n_rows());
    for (std::size_t j = 0; j < A.n_columns(); ++j)
      for (std::size_t i = 0; i < A.n_rows(); ++i)
        result(j, i) = A(i, j);
    return result;
  }

  DenseMatrix
  submatrix(const DenseMatrix &A, const Indices &rows, const Indices &columns)
  {
    DenseMatrix result(rows.size(), columns.size());
    for (std::size_t j = 0; j < columns.size(); ++j)
      for (std::size_t i = 0; i < rows.size(); ++i)
        result(i, j) = A(rows[i], columns[j]);
    return result;
  }

  Indices
  all_columns(const DenseMatrix &A)
  {
    Indices indices(A.n_columns());
    for (std::size_t j = 0; j < indices.size(); ++j)
      indices[j] = j;
    return indices;
  }

  void
  scale_rows(DenseMatrix &A, const Vector &factors)
  {
    for (std::size_t j = 0; j < A.n_columns(); ++j)
      for (std::size_t i = 0; i < A.n_rows(); ++i)
        A(i, j) *= factors[i];
  }

  void
  throw_unheld()
  {
    throw NumericalFailure(
      "The small system of the joints is not positive definite even with "
      "every bar closed and sticking: the bodies are not held. Check the supports.");
  }

  // With Z = P H⁻¹ P, W0 = C - C Z C, V = C Z S_cr, U = C Z F_c and T = W0 G, A = Gᵀ T:
  //   W_cc = W0 - T A⁻¹ Tᵀ              W_cr = V - T A⁻¹ Gᵀ V      R_c = U + T A⁻¹ (L - Gᵀ U)
  //   W_rr = S_rr - S_rc Z S_cr - Vᵀ G A⁻¹ Gᵀ V,    R_r = F_r - S_rc Z F_c + Vᵀ G A⁻¹ (L - Gᵀ U).
  double
  insert_soft_bars(DenseMatrix &W,
                   DenseMatrix &R,
                   const Indices &soft,
                   const Indices &others,
                   const Vector &C,
                   const RigidMotions &motions)
  {
    const std::size_t n_c = soft.size(), n_r = others.size(), n_p = R.n_columns();
    const SoftMotions of_soft = motions_of_soft_bars(motions, soft, others);
    const RigidMotions &free  = of_soft.motions;
    const DenseMatrix &G      = free.jumps;
    const std::size_t k       = G.n_columns();
    DenseMatrix H             = deformation_stiffness(submatrix(W, soft, soft), C, G);
    const DenseMatrix S_rc    = submatrix(W, others, soft);

    if (!invert_positive_definite(H))
      throw_unheld();
    remove_motions(H, G);
    H = transposed(H);
    remove_motions(H, G);              // now Z
    DenseMatrix given(n_c, n_r + n_p); // [S_cr, F_c]
    for (std::size_t i = 0; i < n_c; ++i)
      {
        for (std::size_t j = 0; j < n_r; ++j)
          given(i, j) = S_rc(j, i);
        for (std::size_t j = 0; j < n_p; ++j)
          given(i, n_r + j) = R(soft[i], j);
      }
    const DenseMatrix answer = multiply(H, given);
    DenseMatrix Y(n_c, n_c + n_r + n_p); // Z [C, S_cr, F_c]
    std::copy_n(answer.data(), n_c * (n_r + n_p), Y.column(n_c));
    for (std::size_t j = 0; j < n_c; ++j)
      for (std::size_t i = 0; i < n_c; ++i)
        Y(i, j) = H(i, j) * C[j];

    const DenseMatrix coupling = multiply(S_rc, Y);
    scale_rows(Y, C);
    for (std::size_t j = 0; j < n_c; ++j)
      for (std::size_t i = 0; i < n_c; ++i)
        Y(i, j) = (i == j ? C[i] : 0.) - Y(i, j); // now W0 = C - C Z C in the first columns

    // Bar forces of a unit motion: T in the soft bars, -Vᵀ G in the others.
    DenseMatrix W0(n_c, n_c);
    std::copy_n(Y.data(), n_c * n_c, W0.data());
    DenseMatrix V_U(n_c, n_r + n_p);
    std::copy_n(Y.column(n_c), n_c * (n_r + n_p), V_U.data());
    const DenseMatrix T = multiply(W0, G);
    DenseMatrix A       = multiply_transposed(G, T);
    DenseMatrix load    = multiply_transposed(G, V_U); // Gᵀ V, then Gᵀ U - L
    for (std::size_t j = 0; j < n_p; ++j)
      for (std::size_t i = 0; i < k; ++i)
        load(i, n_r + j) -= free.load_work(i, j);
    DenseMatrix motion(k, n_c + n_r + n_p); // A⁻¹ [Tᵀ, Gᵀ V, Gᵀ U - L]
    for (std::size_t i = 0; i < k; ++i)
      {
        for (std::size_t j = 0; j < n_c; ++j)
          motion(i, j) = T(j, i);
        for (std::size_t j = 0; j < n_r + n_p; ++j)
          motion(i, n_c + j) = load(i, j);
      }
    if (k > 0 && !solve_positive_definite(A, motion))
      throw_unheld();
    add(Y, -1., multiply(T, motion));
    DenseMatrix V(n_c, n_r);
    std::copy_n(V_U.data(), n_c * n_r, V.data());
    const DenseMatrix other_motion = multiply(multiply_transposed(V, G), motion); // Vᵀ G A⁻¹ [...]

    for (std::size_t j = 0; j < n_r; ++j)
      for (std::size_t i = 0; i < n_r; ++i)
        W(others[i], others[j]) -= coupling(i, n_c + j) + (k > 0 ? other_motion(i, n_c + j) : 0.);
    for (std::size_t j = 0; j < n_p; ++j)
      for (std::size_t i = 0; i < n_r; ++i)
        R(others[i], j) -=
          coupling(i, n_c + n_r + j) + (k > 0 ? other_motion(i, n_c + n_r + j) : 0.);
    for (std::size_t i = 0; i < n_c; ++i)
      {
        for (std::size_t j = 0; j < n_c; ++j)
          W(soft[i], soft[j]) = Y(i, j);
        for (std::size_t j = 0; j < n_r; ++j)
          W(soft[i], others[j]) = W(others[j], soft[i]) = Y(i, n_c + j);
        for (std::size_t j = 0; j < n_p; ++j)
          R(soft[i], j) = Y(i, n_c + n_r + j);
      }
    return of_soft.jump_of_others;
  }

  double
  insert_bars(DenseMatrix &W, DenseMatrix &R, const Vector &D, const RigidMotions &motions)
  {
    Indices soft, stiff_or_rigid, stiff;
    Vector soft_stiffness, stiff_compliance;
    for (std::size_t i = 0; i < D.size(); ++i)
      if (D[i] * W(i, i) >= 1.)
        {
          soft.push_back(i);
          soft_stiffness.push_back(1. / D[i]);
        }
      else
        {
          stiff_or_rigid.push_back(i);
          if (D[i] > 0.)
            {
              stiff.push_back(i);
              stiff_compliance.push_back(D[i]);
            }
        }
    const double jump_of_others =
      soft.empty() ? 0. : insert_soft_bars(W, R, soft, stiff_or_rigid, soft_stiffness, motions);
    if (!stiff.empty())
      insert_stiff_bars(W, R, stiff, stiff_compliance);
    return jump_of_others;
  }
} // namespace fuga
