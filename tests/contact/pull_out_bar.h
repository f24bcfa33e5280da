// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_contact_pull_out_bar_h
#define fuga_tests_contact_pull_out_bar_h

#include "contact/toy_system.h"

#include <cmath>

namespace fuga::tests
{
  /**
   * Problem V5: an elastic bar of length L on a compliant frictional base, pulled at x = 0 by P;
   * n equal bar elements, a contact element at each node. Load patterns: 0 the pressure that gives
   * the strength q per length, 1 the pull.
   */
  struct PullOutBar
  {
    static constexpr double EA = 1000., k = 4., q = 2., f = 0.5;

    PullOutBar(const std::size_t n, const double length);

    /** λ = √(k/EA) of the continuous bar. */
    static double
    lambda()
    {
      return std::sqrt(k / EA);
    }

    /** P_e = q/λ: the pull at which slip begins. */
    static double
    first_slip()
    {
      return q / lambda();
    }

    /** Loss per cycle ±P0 of the continuous, infinite bar: 2 (P0 - P_e)² (P0 + 2 P_e)/(3 EA q). */
    static double
    loss_per_cycle(const double P0);

    /**
     * The pull at which node j reaches its strength while nodes 0 … j-1 slip, exact for this chain:
     * where it sticks, u_i = U cosh μ(n - i) with cosh μ = 1 + k h²/(2 EA), free end included.
     */
    double
    pull_of_front(const std::size_t j) const;

    std::size_t n;
    double h;
    ToyJoint joint;
    ToySystem system;
  };
} // namespace fuga::tests

#endif
