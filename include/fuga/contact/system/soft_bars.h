// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_system_soft_bars_h
#define fuga_contact_system_soft_bars_h

#include <fuga/base/numerics/dense_matrix.h>

namespace fuga
{
  /** Rigid motions of floating bodies: the jumps of all bars (in columns), and the work of the
   * loads on them. */
  struct RigidMotions
  {
    DenseMatrix jumps;
    DenseMatrix load_work;
  };

  /**
   * Insert springs between the bodies: the bars @p soft get the relation p = C (δ - d), with the
   * @p stiffness C, instead of δ = d; the bars @p others keep theirs. W and R (on entry S and F of
   * the bodies) are overwritten.
   *
   * A body that only soft bars hold moves far more than it deforms, and W is then a small
   * difference of large numbers: with S/C = 1e9 nine digits would be lost. The motions that only
   * soft bars resist are therefore explicit unknowns q, δ = G q + y, and W is accurate relative to
   * C; equilibrium of the floating bodies holds to rounding. Derivation: doc/theory.md, section 3.
   *
   * Return the largest jump of another bar in a motion of size one that only soft bars are said to
   * resist. It is zero up to the rounding of the geometry, and is the relative error of W in these
   * motions.
   *
   * @throws NumericalFailure if the bodies are not held even with all bars closed and sticking.
   */
  double
  insert_soft_bars(DenseMatrix &W,
                   DenseMatrix &R,
                   const std::vector<std::size_t> &soft,
                   const std::vector<std::size_t> &others,
                   const Vector &stiffness,
                   const RigidMotions &motions);

  /**
   * Insert a bar of the compliance D between the bodies along every coordinate. The bars are split
   * at the bodies' own stiffness: each half uses the formula that does not cancel. W and R (on
   * entry S and F of the bodies) are overwritten. Return and throw the same as insert_soft_bars().
   */
  double
  insert_bars(DenseMatrix &W, DenseMatrix &R, const Vector &D, const RigidMotions &motions);

  [[noreturn]] void
  throw_unheld();
} // namespace fuga

#endif
