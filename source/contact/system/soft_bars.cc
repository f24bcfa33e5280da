// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/system/soft_bars.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    using Indices = std::vector<std::size_t>;

    /** Return combinations N of the columns of A (k x k_null) with A N = 0 to rounding. */
    DenseMatrix
    null_combinations(const DenseMatrix &A, const std::size_t k)
    {
      if (k == 0)
        return {};
      const Eigen::SelfAdjointEigenSolver<DenseMatrix> eigenpairs(
        A.rows() > 0 ? multiply_transposed(A, A) : DenseMatrix(k, k));
      if (eigenpairs.info() != Eigen::Success)
        throw NumericalFailure("The rigid motions of the bodies cannot be told apart.");
      // The columns of A have entries of at most one: a motion that some bar resists is far above
      // this.
      constexpr double threshold = 1e-14;
      return eigenpairs.eigenvectors().leftCols(
        (eigenpairs.eigenvalues().array() <= threshold).count());
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
      const std::size_t k = motions.jumps.cols();
      RigidMotions scaled{motions.jumps, motions.load_work};
      for (std::size_t j = 0; j < k; ++j)
        {
          const double size = max_abs(scaled.jumps.col(j));
          if (size > 0.)
            {
              scaled.jumps.col(j) /= size;
              scaled.load_work.row(j) /= size;
            }
        }
      const DenseMatrix of_others = scaled.jumps(others, Eigen::all);
      const DenseMatrix N         = null_combinations(of_others, k);
      RigidMotions result{multiply(scaled.jumps(soft, Eigen::all), N),
                          multiply_transposed(N, scaled.load_work)};
      const DenseMatrix left      = multiply(of_others, N);
      const double jump_of_others = max_abs(left);

      // The Gram-Schmidt method is applied twice; the work follows the motions.
      for (int sweep = 0; sweep < 2; ++sweep)
        for (Eigen::Index j = 0; j < result.jumps.cols(); ++j)
          {
            auto v = result.jumps.col(j);
            for (Eigen::Index i = 0; i < j; ++i)
              {
                const double share = result.jumps.col(i).dot(v);
                v -= share * result.jumps.col(i);
                result.load_work.row(j) -= share * result.load_work.row(i);
              }
            const double length = v.norm();
            if (!(length > 0.))
              throw_unheld();
            v /= length;
            result.load_work.row(j) /= length;
          }
      return {result, jump_of_others};
    }

    /** Compute A ← (I - G Gᵀ) A for orthonormal G. */
    void
    remove_motions(DenseMatrix &A, const DenseMatrix &G)
    {
      if (G.cols() > 0)
        A -= multiply(G, multiply_transposed(G, A));
    }

    /** Return P (S + C) P + σ G Gᵀ: the stiffness against deformation, made definite by the
     * motions. */
    DenseMatrix
    deformation_stiffness(const DenseMatrix &S, const Vector &C, const DenseMatrix &G)
    {
      DenseMatrix H = S;
      H.diagonal() += view(C);
      const double sigma = largest_diagonal(H);
      if (G.cols() == 0)
        return H;
      remove_motions(H, G);
      H.transposeInPlace();
      remove_motions(H, G);
      H += sigma * G * G.transpose();
      return H;
    }

    /** Add the small compliances D to the stiff bars: W ← (W⁻¹ + D)⁻¹ without inverting W. */
    void
    insert_stiff_bars(DenseMatrix &W, DenseMatrix &R, const Indices &stiff, const Vector &D)
    {
      const Eigen::VectorXd root_D = view(D).cwiseSqrt();
      const auto E                 = root_D.asDiagonal();
      const DenseMatrix E_W        = E * W(stiff, Eigen::all);
      DenseMatrix H                = E_W(Eigen::all, stiff) * E;
      H.diagonal().array() += 1.;
      DenseMatrix Z(stiff.size(), W.cols() + R.cols());
      Z.leftCols(W.cols())  = E_W;
      Z.rightCols(R.cols()) = E * R(stiff, Eigen::all);
      if (!solve_positive_definite(H, Z))
        throw_unheld();

      const DenseMatrix change = multiply_transposed(E_W, Z);
      W -= change.leftCols(W.cols());
      R -= change.rightCols(R.cols());
    }
  } // namespace

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
                   const Vector &stiffness,
                   const RigidMotions &motions)
  {
    const auto n_c            = static_cast<Eigen::Index>(soft.size()),
               n_r            = static_cast<Eigen::Index>(others.size());
    const Eigen::Index n_p    = R.cols();
    const SoftMotions of_soft = motions_of_soft_bars(motions, soft, others);
    const RigidMotions &free  = of_soft.motions;
    const DenseMatrix &G      = free.jumps;
    const Eigen::Index k      = G.cols();
    const auto C              = view(stiffness).asDiagonal();
    DenseMatrix H             = deformation_stiffness(W(soft, soft), stiffness, G);
    const DenseMatrix S_rc    = W(others, soft);

    if (!invert_positive_definite(H))
      throw_unheld();
    remove_motions(H, G);
    H.transposeInPlace();
    remove_motions(H, G);              // now Z
    DenseMatrix given(n_c, n_r + n_p); // [S_cr, F_c]
    given.leftCols(n_r)  = S_rc.transpose();
    given.rightCols(n_p) = R(soft, Eigen::all);
    DenseMatrix Y(n_c, n_c + n_r + n_p); // Z [C, S_cr, F_c]
    Y.leftCols(n_c)        = H * C;
    Y.rightCols(n_r + n_p) = multiply(H, given);

    const DenseMatrix coupling = multiply(S_rc, Y);
    Y                          = C * Y; // now [W0, V, U] with W0 = C - C Z C
    Y.leftCols(n_c)            = DenseMatrix(C) - Y.leftCols(n_c);

    // Bar forces of a unit motion: T in the soft bars, -Vᵀ G in the others.
    const DenseMatrix T = multiply(Y.leftCols(n_c), G);
    DenseMatrix A       = multiply_transposed(G, T);
    DenseMatrix load    = multiply_transposed(G, Y.rightCols(n_r + n_p));
    if (k > 0)
      load.rightCols(n_p) -= free.load_work; // [Gᵀ V, Gᵀ U - L]
    DenseMatrix motion(k, n_c + n_r + n_p);  // A⁻¹ [Tᵀ, Gᵀ V, Gᵀ U - L]
    motion.leftCols(n_c)        = T.transpose();
    motion.rightCols(n_r + n_p) = load;
    if (k > 0 && !solve_positive_definite(A, motion))
      throw_unheld();
    Y -= multiply(T, motion);
    const DenseMatrix of_others = // S_rc Z [S_cr, F_c] + Vᵀ G A⁻¹ [Gᵀ V, Gᵀ U - L]
      coupling.rightCols(n_r + n_p) +
      multiply_transposed(load.leftCols(n_r), motion.rightCols(n_r + n_p));

    W(others, others) -= of_others.leftCols(n_r);
    R(others, Eigen::all) -= of_others.rightCols(n_p);
    W(soft, soft)       = Y.leftCols(n_c);
    W(soft, others)     = Y.middleCols(n_c, n_r);
    W(others, soft)     = Y.middleCols(n_c, n_r).transpose();
    R(soft, Eigen::all) = Y.rightCols(n_p);
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
