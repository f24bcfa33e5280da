// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/scheme/working_scheme.h>

#include <limits>

namespace fuga
{
  // A bar with an unknown feels the dislocation only as a force of its layer.
  double
  WorkingScheme::imposed_entry(const SchemeRow &row, const std::size_t bar) const
  {
    const ContactElement &element = elements[row.element];
    double value                  = 0.;
    for (std::size_t a = 0; a < element.n_bars(); ++a)
      if (position[bar] == no_row)
        value += row.own[a] == 0. ? 0. : row.own[a] * system.stiffness()(bar, element.bar(a));
      else if (element.bar(a) == bar)
        value -= row.stiffness[a];
    return value;
  }

  namespace
  {
    /** Add M⁻¹ (@p C - M @p x), as given by @p inverse, to @p x; return the largest entry of the
     * correction. */
    double
    correct(const UpdatedInverse &inverse,
            const DenseMatrix &M,
            const DenseMatrix &C,
            DenseMatrix &x)
    {
      DenseMatrix defect = multiply(M, x);
      for (Eigen::Index j = 0; j < C.cols(); ++j)
        for (Eigen::Index i = 0; i < C.rows(); ++i)
          defect(i, j) = C(i, j) - defect(i, j);
      const DenseMatrix correction = inverse.solve(defect);
      for (Eigen::Index j = 0; j < C.cols(); ++j)
        x.col(j) += correction.col(j);
      return max_abs(correction);
    }

    /** Return M⁻¹ C computed by the inverse of a matrix near M; nothing where that matrix is not
     * near enough for a few sweeps to reach rounding. */
    std::optional<DenseMatrix>
    solution_by_inverse_nearby(const UpdatedInverse &inverse,
                               const DenseMatrix &M,
                               const DenseMatrix &C)
    {
      constexpr int max_sweeps  = 8;
      constexpr double rounding = std::numeric_limits<double>::epsilon(), slow = 0.3,
                       accepted = 1e3 * rounding;
      DenseMatrix x             = inverse.solve(C);
      double last               = max_abs(x);
      for (int sweep = 0; sweep < max_sweeps; ++sweep)
        {
          const double change = correct(inverse, M, C, x), size = max_abs(x);
          if (change <= rounding * size)
            return x;
          if (!(change <= slow * last))
            return change <= accepted * size ? std::optional(std::move(x)) : std::nullopt;
          last = change;
        }
      return {};
    }
  } // namespace

  // At least one sweep of refinement is made, as forces of open elements are differences of large
  // terms.
  std::optional<DenseMatrix>
  WorkingScheme::solve_all(const DenseMatrix &C)
  {
    const DenseMatrix M = active_matrix();
    if (stale)
      {
        if (std::optional<DenseMatrix> x = solution_by_inverse_nearby(inverse, M, C))
          return x;
        if ((singular = !rebuild()))
          return {};
      }
    DenseMatrix x = inverse.solve(C);
    correct(inverse, M, C, x);
    return x;
  }

  // Let C be the effect of the imposed dislocations on the rows, and M the active matrix. The
  // forces then lose W_bb - W_ba M⁻¹ C.
  std::optional<DenseMatrix>
  WorkingScheme::stiffness(const std::vector<std::size_t> &of,
                           const std::vector<std::size_t> &against)
  {
    if (!bring_up_to_date())
      return {};
    const DenseMatrix &W = system.stiffness();
    const std::size_t m = rows.size(), n = of.size(), n_against = against.size();
    DenseMatrix C(m, n_against), of_rows(n, m), result(n, n_against);
    for (std::size_t j = 0; j < n_against; ++j)
      {
        for (std::size_t i = 0; i < m; ++i)
          C(i, j) = imposed_entry(rows[i], against[j]);
        for (std::size_t i = 0; i < n && position[against[j]] == no_row; ++i)
          result(i, j) = W(of[i], against[j]);
      }
    if (m == 0 || n == 0 || n_against == 0)
      return result;
    for (std::size_t j = 0; j < m; ++j)
      {
        const ContactElement &element = elements[rows[j].element];
        for (std::size_t a = 0; a < element.n_bars(); ++a)
          if (const double share = rows[j].column[a]; share != 0.)
            for (std::size_t i = 0; i < n; ++i)
              of_rows(i, j) += share * W(of[i], element.bar(a));
      }
    const std::optional<DenseMatrix> x = solve_all(C);
    if (!x)
      return {};
    const DenseMatrix lost = multiply(of_rows, *x);
    for (std::size_t j = 0; j < n_against; ++j)
      result.col(j) -= lost.col(j);
    return result;
  }

  // What a small stiffness leaves of the drive is a free motion in its direction, but for a share
  // of resisted ones as small as that stiffness; a second solution has hardly any share of them.
  Vector
  WorkingScheme::free_motion_along(const Drive &drive) const
  {
    constexpr double same_motion = 1e-3;
    const LuFactors factors(matrix_with_addition(usual_addition));
    if (!(factors.reciprocal_condition() > 0.))
      return {};
    const auto motion_under = [&factors](Vector forces) {
      factors.solve(forces);
      const double largest = max_abs(forces);
      for (double &value : forces)
        value = largest > 0. ? value / largest : 0.;
      return forces;
    };
    const Vector first = motion_under(unbalanced_forces(drives_of_rows(drive), drive.reactions));
    Vector of_addition = first;
    for (std::size_t i = 0; i < rows.size(); ++i)
      of_addition[i] *= addition(rows[i], usual_addition);
    Vector second = motion_under(std::move(of_addition));
    if (max_abs(second) == 0. || max_abs(along(first, -1., second)) > same_motion)
      return {};
    return second;
  }

  JointRates
  WorkingScheme::mechanism(const Drive &drive) const
  {
    Vector x = free_motion_along(drive);
    if (x.empty())
      {
        DenseMatrix M        = active_matrix();
        const double epsilon = 1e-14;
        for (std::size_t i = 0; i < rows.size(); ++i)
          M(i, i) += epsilon * std::max(system.stiffness()(rows[i].bar, rows[i].bar),
                                        epsilon * system.largest_stiffness());
        x = null_vector(std::move(M));
      }
    JointRates result;
    result.forces.assign(system.n_bars(), 0.);
    result.dislocations.assign(system.n_bars(), 0.);
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t a = 0; a < elements[rows[i].element].n_bars(); ++a)
        result.dislocations[elements[rows[i].element].bar(a)] += x[i] * rows[i].column[a];
    return result;
  }
} // namespace fuga
