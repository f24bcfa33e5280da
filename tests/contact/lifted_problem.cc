// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/lifted_problem.h"

#include <cmath>

namespace fuga::tests
{
  namespace
  {
    /** Rows of the plane's bars in the turned frame, on the plane's columns and @p n_more. */
    DenseMatrix
    lift_rows(const DenseMatrix &A, const std::size_t n_more)
    {
      DenseMatrix result(A.rows() / 2 * 3, A.cols() + n_more);
      for (Eigen::Index j = 0; j < A.cols(); ++j)
        {
          const Vector lifted = LiftedProblem::lift(to_vector(A.col(j)));
          result.col(j)       = view(lifted);
        }
      return result;
    }

    DenseMatrix
    identity(const std::size_t n)
    {
      DenseMatrix result(n, n);
      for (std::size_t i = 0; i < n; ++i)
        result(i, i) = 1.;
      return result;
    }
  } // namespace

  LiftedProblem::LiftedProblem(const ToySystem &plane,
                               const std::vector<ContactElement> &plane_elements)
    : elements(plane_elements)
  {
    const std::size_t n = elements.size(), m = plane.S.rows();
    system.S = DenseMatrix(m + n, m + n);
    system.F = DenseMatrix(m + n, plane.F.cols());
    for (std::size_t i = 0; i < m; ++i)
      {
        for (std::size_t j = 0; j < m; ++j)
          system.S(i, j) = plane.S(i, j);
        for (Eigen::Index j = 0; j < plane.F.cols(); ++j)
          system.F(i, j) = plane.F(i, j);
      }
    system.B = lift_rows(plane.B.size() == 0 ? identity(m) : plane.B, n);
    for (std::size_t k = 0; k < n; ++k)
      {
        system.S(m + k, m + k)     = 1.;
        const TangentVector across = normal_to(tangent(k));
        for (std::size_t i = 0; i < 2; ++i)
          system.B(3 * k + 1 + i, m + k) = across[i];
        elements[k].normal_bar            = static_cast<unsigned int>(3 * k);
        elements[k].tangential_bar        = static_cast<unsigned int>(3 * k + 1);
        elements[k].second_tangential_bar = static_cast<unsigned int>(3 * k + 2);
      }
    if (plane.motions.size() == 0)
      return;
    system.motions      = lift_rows(plane.motions, 0);
    system.motion_loads = plane.motion_loads;
  }

  TangentVector
  LiftedProblem::tangent(const std::size_t k)
  {
    const double angle = static_cast<double>(k) + 0.5;
    return {{std::cos(angle), std::sin(angle)}};
  }

  Vector
  LiftedProblem::lift(const Vector &of_plane_bars)
  {
    Vector result(of_plane_bars.size() / 2 * 3);
    for (std::size_t k = 0; 3 * k < result.size(); ++k)
      {
        result[3 * k] = of_plane_bars[2 * k];
        for (std::size_t i = 0; i < 2; ++i)
          result[3 * k + 1 + i] = of_plane_bars[2 * k + 1] * tangent(k)[i];
      }
    return result;
  }

  JointState
  LiftedProblem::lift(const JointState &state)
  {
    JointState result = state;
    for (Vector JointState::*of_bars :
         {&JointState::forces, &JointState::dislocations, &JointState::unreleased})
      result.*of_bars = lift(state.*of_bars);
    for (std::size_t k = 0; k < state.slips.size(); ++k)
      {
        result.slips[k] = sum({{0., 0.}}, state.slips[k][0], tangent(k));
        if (is_slipping(state.states[k]))
          result.states[k] = ContactState::slip_forward;
      }
    return result;
  }

  PathPoint
  LiftedProblem::lift(const PathPoint &point)
  {
    return {lift(point.state), {lift(point.rates.forces), lift(point.rates.dislocations)}};
  }
} // namespace fuga::tests
