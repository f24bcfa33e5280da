// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_rates_boundary_lcp_h
#define fuga_contact_rates_boundary_lcp_h

#include <fuga/contact/joint_state.h>

namespace fuga
{
  /**
   * The rate problem of a boundary set as a linear complementarity problem (doc/theory.md, eq. 7):
   * z ≥ 0 are the rates of opening and of slip in each admissible direction, q + M z ≥ 0 the rates
   * of the reserves. Rows and columns are scaled to a unit diagonal of W.
   */
  struct BoundaryLcp
  {
    /** One component of z: a rate of dislocation that takes its element into `state`. */
    struct Unknown
    {
      std::size_t element;
      std::size_t bar;
      double sign;
      ContactState state;
    };

    std::vector<Unknown> unknowns;
    DenseMatrix M;
    Vector q;
    /** Covering vector of Lemke's method that excludes meaningless rays, and the part of it that
     * does so; the remaining part, here 1, may be any number between 0 and 1.1. */
    Vector covering, friction_share;
    /** Scale of the unknowns: the true rates of dislocation are scale z. */
    Vector scale;
    /** Rates with every boundary element closed and stuck. */
    JointRates stuck;
    /** Rates caused by a unit dislocation rate of each unknown. */
    std::vector<JointRates> responses;

    std::size_t
    size() const
    {
      return unknowns.size();
    }

    /** Return the motion Σ z × response. */
    JointRates
    motion(const Vector &z) const;
  };
} // namespace fuga

#endif
