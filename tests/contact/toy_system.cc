// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/toy_system.h"

namespace fuga::tests
{
  // n elements along the base, so n + 1 bars at their ends. Load patterns: 0 horizontal force, 1
  // vertical force (upwards), 2 moment (counter-clockwise).
  ToySystem
  rigid_block(const std::size_t n, const double base)
  {
    ToySystem system;
    system.S = DenseMatrix(3, 3);
    system.B = DenseMatrix(2 * (n + 1), 3);
    for (std::size_t k = 0; k <= n; ++k)
      {
        const double x         = base * (static_cast<double>(k) / static_cast<double>(n) - 0.5);
        system.B(2 * k, 1)     = 1.;
        system.B(2 * k, 2)     = x;
        system.B(2 * k + 1, 0) = 1.;
      }
    system.F = DenseMatrix(3, 3);
    for (std::size_t i = 0; i < 3; ++i)
      system.F(i, i) = 1.;
    system.motions      = system.B;
    system.motion_loads = system.F;
    return system;
  }

  ToySystem
  spring_beside_joint(const double k)
  {
    ToySystem system;
    system.S       = DenseMatrix(2, 2);
    system.S(0, 0) = 1.;
    system.S(1, 1) = k;
    system.F       = DenseMatrix(2, 2);
    system.F(0, 0) = -1.;
    system.F(1, 1) = 1.;
    return system;
  }

  ToyJoint
  rigid_block_joint(const std::size_t n,
                    const double base,
                    std::unique_ptr<ComplianceLaw> normal_law,
                    std::unique_ptr<ComplianceLaw> shear_law,
                    const FrictionLaw &friction)
  {
    const double h = base / static_cast<double>(n);
    ToyJoint joint(n + 1, h, std::move(normal_law), std::move(shear_law), friction);
    joint.elements.front().area = joint.elements.back().area = 0.5 * h;
    return joint;
  }
} // namespace fuga::tests
