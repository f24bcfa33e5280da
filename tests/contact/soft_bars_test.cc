// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Forces of joints that are softer than the bodies in one direction.

#include "contact/toy_system.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::tests;

// A block on three elements, soft across the joint and stiff along it, whose nodes lie e, -2e and e
// off the line: as it tilts, their lips move by as much along the joint. That a tilt is resisted
// across the joint only is right but for this, and that is worth s e D ΔN = 3e-9 of the forces. The
// body has the stiffness s against all that is orthogonal to the orthonormal motions m, so that
// its equations are s (x - Σ m m·x) + p = F with x = D p.
TEST(SoftBars, JointThatIsNotQuiteStraight)
{
  constexpr double e = 1e-10, s = 65., D_n = 0.27, D_t = 1e-11;
  const double third = std::sqrt(1. / 3.), half = std::sqrt(0.5);
  const Vector motions[] = {{third, 0., third, 0., third, 0.},
                            {0., third, 0., third, 0., third},
                            {-half, half * e, 0., -2. * half * e, half, half * e}};
  const Vector load      = {-1., 0.3, 0.5, 0.2, 1., 0.};
  const ToyJoint joint(3, 1., make_linear_law(D_n), make_linear_law(D_t), {0.5, 0.});
  ToySystem system;
  system.S            = DenseMatrix(6, 6);
  system.F            = DenseMatrix(6, 1);
  system.motions      = DenseMatrix(6, 3);
  system.motion_loads = DenseMatrix(3, 1);
  for (std::size_t i = 0; i < 6; ++i)
    {
      system.F(i, 0) = load[i];
      system.S(i, i) = s;
      for (std::size_t k = 0; k < 3; ++k)
        {
          system.motions(i, k) = motions[k][i];
          system.motion_loads(k, 0) += motions[k][i] * load[i];
          for (std::size_t j = 0; j < 6; ++j)
            system.S(i, j) -= s * motions[k][i] * motions[k][j];
        }
    }
  const LayeredSystem layered(system, joint.elements);
  const Vector p = layered.forces({1.}, Vector(6, 0.), {});

  Vector x(6), deformation(6);
  for (std::size_t i = 0; i < 6; ++i)
    x[i] = deformation[i] = (i % 2 == 0 ? D_n : D_t) * p[i];
  for (const Vector &motion : motions)
    {
      double share = 0.;
      for (std::size_t i = 0; i < 6; ++i)
        share += motion[i] * x[i];
      for (std::size_t i = 0; i < 6; ++i)
        deformation[i] -= share * motion[i];
    }
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(p[i], load[i] - s * deformation[i], 1e-13) << i;
}
