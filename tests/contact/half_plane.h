// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_contact_half_plane_h
#define fuga_tests_contact_half_plane_h

#include "contact/toy_system.h"

namespace fuga::tests
{
  /**
   * Two like elastic half-planes (normal and tangential problem uncoupled), pressed together by P
   * (load 0) and sheared by Q (load 1): n elements of equal width on |x| ≤ length/2, a constant
   * stress on each, and the approach at its middle,
   *
   *     δ(x) = const - 2/(πE*) ∫ p(s) ln|x - s| ds,
   *
   * integrated in closed form; the same for the tangential jump and q. The bodies may move freely
   * (const), so that P and Q are given, as a half-plane in two dimensions demands.
   */
  struct HalfPlanes
  {
    HalfPlanes(const std::size_t n, const double length, const double modulus);

    std::vector<double> x;
    double h;
    ToySystem system;
  };
} // namespace fuga::tests

#endif
