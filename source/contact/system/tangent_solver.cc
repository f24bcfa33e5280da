// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/system/tangent_solver.h>

namespace fuga
{
  void
  TangentSolver::Solution::add(const double factor, const Solution &step)
  {
    add_multiple(factor, step.x, x);
    add_multiple(factor, step.resistance, resistance);
    if (!interior.empty())
      add_multiple(factor, step.interior, interior);
  }
} // namespace fuga
