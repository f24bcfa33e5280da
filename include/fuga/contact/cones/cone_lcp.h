// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_cones_cone_lcp_h
#define fuga_contact_cones_cone_lcp_h

#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/base/numerics/lcp_search.h>
#include <fuga/contact/tangent_vector.h>

#include <cstddef>

namespace fuga
{
  /** One unknown of the rate problem where directions of slip are given, in units of `scale`: the
   * rate of slip of a candidate in a direction, or that at which its lips part. */
  struct ConeUnknown
  {
    std::size_t candidate;
    double scale;
    bool slips;
    TangentVector direction;
  };

  /** The linear complementarity problem of these unknowns (doc/theory.md, eq. 7), scaled to a unit
   * diagonal before bars were released. */
  struct ConeLcp
  {
    DenseMatrix M;
    Vector q;
    LcpNoise noise;
  };
} // namespace fuga

#endif
