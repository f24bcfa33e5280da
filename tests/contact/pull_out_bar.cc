// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/pull_out_bar.h"

namespace fuga::tests
{
  PullOutBar::PullOutBar(const std::size_t n_elements, const double length)
    : n(n_elements)
    , h(length / static_cast<double>(n_elements))
    , joint(n_elements + 1, h, make_rigid_law(), make_linear_law(1. / k), {f, 0.})
  {
    joint.elements.front().area = joint.elements.back().area = 0.5 * h;
    system.S                                                 = DenseMatrix(2 * n + 2, 2 * n + 2);
    system.F                                                 = DenseMatrix(2 * n + 2, 2);
    for (std::size_t i = 0; i <= n; ++i)
      system.F(2 * i, 0) = -q / f * joint.elements[i].area;
    system.F(1, 1) = 1.;
    for (std::size_t i = 0; i < n; ++i)
      for (const std::size_t a : {2 * i + 1, 2 * i + 3})
        for (const std::size_t b : {2 * i + 1, 2 * i + 3})
          system.S(a, b) += (a == b ? 1. : -1.) * EA / h;
  }

  double
  PullOutBar::loss_per_cycle(const double P0)
  {
    const double Pe = first_slip();
    return 2. * (P0 - Pe) * (P0 - Pe) * (P0 + 2. * Pe) / (3. * EA * q);
  }

  // The slipping nodes carry q h each (the first one half of it); the rest is the force at the left
  // of node j, which the sticking part of the chain carries.
  double
  PullOutBar::pull_of_front(const std::size_t j) const
  {
    const double mu = std::acosh(1. + k * h * h / (2. * EA));
    const double U  = q / k / std::cosh(mu * static_cast<double>(n - j));
    double carried  = 0.;
    for (std::size_t i = j; i <= n; ++i)
      carried += joint.elements[i].area * k * U * std::cosh(mu * static_cast<double>(n - i));
    const double slipping = j == 0 ? 0. : (static_cast<double>(j) - 0.5) * h * q;
    return slipping + carried;
  }
} // namespace fuga::tests
