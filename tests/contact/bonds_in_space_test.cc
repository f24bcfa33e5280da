// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/cone_toy.h"

#include <fuga/laws/cubic_root_law.h>

namespace fuga::tests
{
  // Lips with cohesion that the first load tears apart and shears: T lies inside the strength when
  // they open, but what opens carries nothing. Their shear lifts the lips of a second element from
  // each other, which it would not if the bond held it: all are open, and S δ = F.
  TEST(BondsInSpace, LipsThatOpenFromTheApexCarryNoShear)
  {
    constexpr double k = 2., coupling = -1.5, tension = 3., shear = 4., pressing = 1.;
    ToySystem system;
    system.S = DenseMatrix(6, 6);
    system.F = DenseMatrix(6, 1);
    for (std::size_t i = 0; i < 6; ++i)
      system.S(i, i) = k;
    system.S(1, 3) = system.S(3, 1) = coupling;
    system.F(0, 0)                  = tension;
    system.F(1, 0)                  = shear;
    system.F(3, 0)                  = -pressing;
    ConeJoint joint(2, 1., std::make_unique<CubicRootLaw>(0.3, 2.), make_rigid_law(), 0.5);
    joint.elements[0].friction.cohesion = 100.;
    const ConeRun run(system, joint.elements, LoadHistory({0., 1.}, {{0.}, {1.}}), {1.});
    ASSERT_EQ(run.result.verdict, Verdict::done);
    const JointState &end    = run.record.levels.back();
    const double determinant = k * k - coupling * coupling;
    const Vector opened      = {tension / k,
                                (k * shear + coupling * pressing) / determinant,
                                0.,
                                -(k * pressing + coupling * shear) / determinant,
                                0.,
                                0.};
    for (std::size_t i = 0; i < 6; ++i)
      {
        EXPECT_NEAR(end.forces[i], 0., 1e-12) << i;
        EXPECT_NEAR(end.dislocations[i], opened[i], 1e-12) << i;
      }
    EXPECT_LT(run.record.worst.worst(), 1e-12);
  }
} // namespace fuga::tests
