// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/system/layered_system.h>
#include <fuga/contact/system/soft_bars.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    using Numbers = std::vector<std::size_t>;

    /** Return the bars whose jumps are the coordinates themselves, in their order; empty if a
     * coordinate has none. */
    Numbers
    bars_along_coordinates(const SparseOperator &B)
    {
      Numbers result(B.n_columns(), B.n_rows());
      for (std::size_t bar = 0; bar < B.n_rows(); ++bar)
        {
          std::size_t n_entries = 0, coordinate = 0;
          bool is_along = false;
          B.for_each_in_row(bar, [&](const std::size_t c, const double factor) {
            ++n_entries;
            coordinate = c;
            is_along   = factor == 1.;
          });
          if (n_entries == 1 && is_along)
            result[coordinate] = std::min(result[coordinate], bar);
        }
      const bool has_all = std::find(result.begin(), result.end(), B.n_rows()) == result.end();
      return has_all ? result : Numbers();
    }

    Numbers
    all_but(const Numbers &some, const std::size_t n)
    {
      std::vector<bool> left(n, true);
      for (const std::size_t i : some)
        left[i] = false;
      Numbers result;
      for (std::size_t i = 0; i < n; ++i)
        if (left[i])
          result.push_back(i);
      return result;
    }

    Vector
    entries(const Vector &values, const Numbers &numbers)
    {
      Vector result;
      for (const std::size_t i : numbers)
        result.push_back(values[i]);
      return result;
    }

    /** Refine V = (1 + S D)⁻¹ B_eᵀ, with @p residual = B_eᵀ; as a difference it has lost digits
     * where S D is large. */
    void
    refine_at_corners(const DenseMatrix &S,
                      DenseMatrix residual,
                      const DenseMatrix &W_0,
                      const Vector &compliances,
                      DenseMatrix &V)
    {
      const auto D = view(compliances).asDiagonal();
      residual -= V + multiply(S, D * V);
      V += residual - multiply(W_0, D * residual);
    }
  } // namespace

  void
  throw_repeated_bars()
  {
    throw NumericalFailure("The forces in the bars are not unique: rigid bars repeat each other "
                           "(rigid joints that cross, or several rigid bars under one rigid body). "
                           "Give one of the joints there a compliance.");
  }

  // Where joints have corners but do not cross, the coordinates are the jumps of some bars b, with
  // W₀ and R₀ as if there were no others. The other bars e press the bodies by -B_eᵀ p_e, which
  // changes forces and jumps as water does:
  //   p_b = R₀ a - W₀ d_b - V p_e,   V = (1 - W₀ D_b) B_eᵀ,   B_e (d_b + D_b p_b) = d_e + D_e p_e,
  // so that H p_e = Vᵀ d_b + B_e D_b R₀ a - d_e with H = D_e + B_e D_b V, a matrix of the corners
  // only. In very soft joints V is a small difference; those are for the saddle point problem.
  bool
  LayeredSystem::eliminate_at_corners(const ContactSystem &system)
  {
    const SparseOperator &B = system.jump_operator();
    const Numbers basis     = bars_along_coordinates(B);
    if (basis.empty() || has_soft_joint())
      return false;
    const Numbers extra = all_but(basis, n_bars());
    const std::size_t n = basis.size(), m = extra.size();
    const Vector D_b = entries(compliances, basis), D_e = entries(compliances, extra);

    DenseMatrix W_0 = system.stiffness(), R_0 = system.load_patterns();
    if (has_soft_joint(insert_bars(
          W_0, R_0, D_b, {system.rigid_motions()(basis, Eigen::all), system.rigid_motion_loads()})))
      return false;

    const DenseMatrix B_e_t = submatrix(B, extra, all_but({}, n)).transpose();
    const DenseMatrix DB    = view(D_b).asDiagonal() * B_e_t;
    DenseMatrix V           = B_e_t - multiply(W_0, DB);
    refine_at_corners(system.stiffness(), B_e_t, W_0, D_b, V);
    DenseMatrix H = multiply_transposed(DB, V);
    H.diagonal() += view(D_e);

    LuFactors factors(std::move(H));
    constexpr double smallest_trusted_condition = 1e-15;
    if (factors.reciprocal_condition() < smallest_trusted_condition)
      throw_repeated_bars();
    DenseMatrix H_V = V.transpose(), H_R = multiply_transposed(DB, R_0),
                inverse = DenseMatrix::Identity(m, m);
    factors.solve(H_V);
    factors.solve(H_R);
    factors.solve(inverse);

    W.resize(n_bars(), n_bars());
    R.resize(n_bars(), R_0.cols());
    W(basis, basis)      = W_0 + multiply(V, H_V);
    W(extra, basis)      = -H_V;
    W(basis, extra)      = -H_V.transpose();
    W(extra, extra)      = inverse;
    R(basis, Eigen::all) = R_0 - multiply(V, H_R);
    R(extra, Eigen::all) = H_R;
    return true;
  }
} // namespace fuga
