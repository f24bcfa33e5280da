// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_condensed_linear_response_h
#define fuga_bodies_condensed_linear_response_h

#include <fuga/base/numerics/dense_matrix.h>

namespace fuga
{
  /**
   * A linear quantity of the full model, expressed by the condensed one, see
   * CondensedSystem::response().
   */
  struct LinearResponse
  {
    /** Values per interface coordinate, and per load pattern at factor one. */
    Vector coordinates, patterns;

    /** Return the quantity for interface coordinates @p x and load factors @p a. */
    double
    value(const Vector &x, const Vector &a) const;
  };
} // namespace fuga

#endif
