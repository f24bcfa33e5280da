// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_cones_cone_barrier_h
#define fuga_contact_cones_cone_barrier_h

#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/contact/tangent_vector.h>

#include <optional>

namespace fuga
{
  /** What an element of a rate problem in space can answer (doc/theory.md, eq. 31). */
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
    /** First of its rows: n, then those of its tangents. */
    std::size_t row = 0, n_tangents = 2;
    /** f and tan ψ. */
    double friction = 0., rise = 0.;
    /** ρ̇ [MN per unit of the path]. */
    double strength_rate = 0.;
    /** e */
    TangentVector direction = {{1., 0.}};
  };

  /**
   * Virtual dislocations y that show that no rates v with q = r - W v answer the load: with
   * p = W y, for all answers of all elements
   *
   *     y·q + p·v ≤ Σ z ρ̇,    but    y·r > Σ z ρ̇,
   *
   * while y·q + p·v = y·r for every v (doc/theory.md, eq. 31c). The answers are taken together
   * state by state, without complementarity, in their convex hull: where a solution exists there is
   * no such y, and where there is none there need not be one. W is symmetric; entry i of
   * @p diagonal is the size of the terms in its row i. y is only as exact as rounding allows:
   * it has to be judged.
   */
  std::optional<Vector>
  find_barrier(const DenseMatrix &W,
               const Vector &r,
               const Vector &diagonal,
               const std::vector<ConeAnswer> &answers);
} // namespace fuga

#endif
