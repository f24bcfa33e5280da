// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_judges_linear_solve_h
#define fuga_tests_judges_linear_solve_h

#include <fuga/base/numerics/dense_matrix.h>

namespace fuga::judges
{
  /** What solve_linear() found. */
  struct LinearSolution
  {
    /** The columns; meaningful if regular or consistent. */
    DenseMatrix X;
    /** LAPACK's estimate for the equilibrated matrix. */
    double reciprocal_condition = 0.;
    /** One solution. */
    bool regular = false;
    /** Singular, but the equations have a solution; X is (nearly) the one of least norm. */
    bool consistent = false;
  };

  /**
   * Solves A X = B: rows and columns are equilibrated, then LAPACK's expert driver dgesvx with
   * iterative refinement. If the reciprocal condition number is below 1e-14 the matrix counts as
   * singular; then, if @p allow_singular, the least-squares driver dgelsd is asked for a solution.
   */
  LinearSolution
  solve_linear(DenseMatrix A, DenseMatrix B, const bool allow_singular = false);

  /** The same for one right-hand side. */
  LinearSolution
  solve_linear(DenseMatrix A, const Vector &b, const bool allow_singular = false);
} // namespace fuga::judges

#endif
