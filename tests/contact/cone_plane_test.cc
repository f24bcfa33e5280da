// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/cone_toy.h"

#include <fuga/contact/event_path.h>

namespace fuga::tests
{
  // A plane problem with a second tangent that is not loaded is the path of EventPath.
  TEST(ConePlane, PlaneProblemsAreThoseOfTheEventPath)
  {
    for (unsigned int seed = 1; seed <= 30; ++seed)
      {
        SCOPED_TRACE(seed);
        std::mt19937 generator(seed);
        const std::size_t n = 7;
        ToySystem plane, space;
        plane.S             = random_stiffness(2 * n, generator);
        const DenseMatrix F = random_loads(n, generator), second = random_stiffness(n, generator);
        plane.F = DenseMatrix(2 * n, 3);
        space.F = DenseMatrix(3 * n, 3);
        space.S = DenseMatrix(3 * n, 3 * n);
        for (std::size_t k = 0; k < n; ++k)
          for (std::size_t a = 0; a < 2; ++a)
            {
              for (std::size_t j = 0; j < 3; ++j)
                plane.F(2 * k + a, j) = space.F(3 * k + a, j) = F(3 * k + a, j);
              for (std::size_t m = 0; m < n; ++m)
                {
                  for (std::size_t b = 0; b < 2; ++b)
                    space.S(3 * k + a, 3 * m + b) = plane.S(2 * k + a, 2 * m + b);
                  space.S(3 * k + 2, 3 * m + 2) = second(k, m);
                }
            }
        FrictionLaw friction;
        friction.coefficient = 0.5;
        ToyJoint plane_joint(n, 1., make_linear_law(0.1), make_linear_law(0.2), friction);
        ConeJoint space_joint(n, 1., make_linear_law(0.1), make_linear_law(0.2), 0.5);
        for (std::size_t k = 0; k < n; k += 3)
          plane_joint.elements[k].initial_gap = space_joint.elements[k].initial_gap = 0.05;
        const LoadHistory history        = roundabout();
        const std::vector<double> levels = {0.5, 1., 1.5, 2., 3., 3.7, 4., 5.};
        const PathRun<EventPath> along_tangent(plane, plane_joint.elements, history, levels);
        const Record &record = along_tangent.record;
        const ConeRun run(space, space_joint.elements, history, levels);
        ASSERT_EQ(run.result.verdict, along_tangent.result.verdict) << "seed " << seed;
        ASSERT_EQ(run.record.levels.size(), record.levels.size()) << "seed " << seed;
        for (std::size_t l = 0; l < levels.size(); ++l)
          for (std::size_t k = 0; k < n; ++k)
            for (std::size_t a = 0; a < 2; ++a)
              {
                EXPECT_NEAR(
                  run.record.levels[l].forces[3 * k + a], record.levels[l].forces[2 * k + a], 1e-9)
                  << "seed " << seed << ", level " << levels[l];
                EXPECT_NEAR(run.record.levels[l].dislocations[3 * k + a],
                            record.levels[l].dislocations[2 * k + a],
                            1e-9)
                  << "seed " << seed;
              }
        expect_same_events(run.record.events, record.events);
        EXPECT_LT(run.record.worst.worst(), 1e-8) << "seed " << seed;
      }
  }

  // Where only one tangential bar is free, in some elements or in all of them, states have the
  // signs of the plane too.
  TEST(ConePlane, ElementsWithOneTangentialBarAreThoseOfTheEventPath)
  {
    for (unsigned int seed = 1; seed <= 30; ++seed)
      {
        SCOPED_TRACE(seed);
        std::mt19937 generator(seed);
        const std::size_t n = 6;
        ToySystem system;
        system.S            = random_stiffness(2 * n, generator);
        const DenseMatrix F = random_loads(n, generator);
        system.F            = DenseMatrix(2 * n, 3);
        for (std::size_t k = 0; k < n; ++k)
          for (std::size_t a = 0; a < 2; ++a)
            for (std::size_t j = 0; j < 3; ++j)
              system.F(2 * k + a, j) = F(3 * k + a, j);
        if (seed % 2 == 0) // water that comes into open elements
          {
            DenseMatrix water(2 * n, 3);
            for (std::size_t k = 0; k < n; ++k)
              water(2 * k, 0) = 0.1;
            system.water = std::make_shared<ToyWater>(water);
          }
        FrictionLaw friction;
        friction.coefficient = 0.5;
        const ToyJoint joint(n, 1., make_linear_law(0.1), make_linear_law(0.2), friction);
        const LoadHistory history        = roundabout();
        const std::vector<double> levels = {1., 2., 3., 4., 5.};
        const PathRun<EventPath> along_tangent(system, joint.elements, history, levels);
        const Record &record = along_tangent.record;
        const ConeRun run(system, joint.elements, history, levels);
        ASSERT_EQ(run.result.verdict, along_tangent.result.verdict) << "seed " << seed;
        ASSERT_EQ(run.record.levels.size(), record.levels.size()) << "seed " << seed;
        for (std::size_t l = 0; l < levels.size(); ++l)
          {
            EXPECT_LT(largest_difference(run.record.levels[l].forces, record.levels[l].forces),
                      1e-9)
              << "seed " << seed;
            EXPECT_EQ(run.record.levels[l].states, record.levels[l].states) << "seed " << seed;
          }
        expect_same_events(run.record.events, record.events);
        for (std::size_t i = 0; i < record.events.size(); ++i)
          EXPECT_EQ(run.record.events[i].to, record.events[i].to) << "seed " << seed;
        EXPECT_LT(run.record.worst.worst(), 1e-8) << "seed " << seed;
      }
  }
} // namespace fuga::tests
