// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_cones_cone_barrier_h
#define fuga_contact_cones_cone_barrier_h

#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/contact/tangent_vector.h>

#include <optional>

namespace fuga
{
  /** The answers that an element of a rate problem in space can give (doc/theory.md, eq. 31). */
  struct ConeAnswer
  {
    enum class Place
    {
      /** v = γ (e + n tan ψ), γ ≥ 0, e·q_t + f q_n ≤ ρ̇. */
      on_cone,
      /** v_n ≥ 0, |q_t| ≤ -f q_n. */
      at_apex,
      /** v_n ≥ 0, q_n ≤ ρ̇: without friction, or at a tensile strength. */
      parting
    };

    Place place = Place::on_cone;
    /** The first row of the element: that of n, which those of its tangents follow. */
    std::size_t row = 0, n_tangents = 2;
    /** The coefficient of friction f, and tan ψ. */
    double friction = 0., rise = 0.;
    /** The rate of strength ρ̇ [MN per unit of the path]. */
    double strength_rate = 0.;
    /** The direction e of slip. */
    TangentVector direction = {{1., 0.}};
  };

  /**
   * Find virtual dislocations y that show that no rates v with q = r - W v answer the load: with
   * p = W y, for all answers of all elements
   *
   *     y·q + p·v ≤ Σ z ρ̇,    but    y·r > Σ z ρ̇,
   *
   * while y·q + p·v = y·r for every v (doc/theory.md, eq. 31c). The answers of all states are
   * combined into their convex hull, without complementarity: where a solution exists there is no
   * such y, but where there is none such a y need not exist. W is symmetric; entry i of @p diagonal
   * is the size of the terms in its row i. y is only as exact as rounding allows, and the caller
   * has to judge it.
   */
  std::optional<Vector>
  find_barrier(const DenseMatrix &W,
               const Vector &r,
               const Vector &diagonal,
               const std::vector<ConeAnswer> &answers);
} // namespace fuga

#endif
