// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/cone_toy.h"

#include <algorithm>

namespace fuga::tests
{
  namespace
  {
    /** @p others: bars behind those of a system, on which nothing acts. */
    DenseMatrix
    with_empty_rows(const DenseMatrix &A, const std::size_t others)
    {
      DenseMatrix result(A.rows() + others, A.cols());
      for (Eigen::Index j = 0; j < A.cols(); ++j)
        std::copy_n(A.col(j).data(), A.rows(), result.col(j).data());
      return result;
    }

    /** A system with three more bars. */
    ToySystem
    beside_open_element(const ToySystem &system)
    {
      const std::size_t n = system.S.rows();
      ToySystem result;
      result.S = DenseMatrix(n + 3, n + 3);
      result.F = with_empty_rows(system.F, 3);
      for (std::size_t j = 0; j < n + 3; ++j)
        if (j < n)
          std::copy_n(system.S.col(j).data(), n, result.S.col(j).data());
        else
          result.S(j, j) = 1.;
      return result;
    }

    /** An element with two tangential bars, from @p first_bar on, that is open for ever. */
    ContactElement
    open_element(const std::size_t first_bar, const ContactElement &like)
    {
      ContactElement element        = like;
      element.normal_bar            = static_cast<unsigned int>(first_bar);
      element.tangential_bar        = static_cast<unsigned int>(first_bar + 1);
      element.second_tangential_bar = static_cast<unsigned int>(first_bar + 2);
      element.initial_gap           = 1.;
      return element;
    }
  } // namespace

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
        const ConeRun along_tangent(plane, plane_joint.elements, history, levels);
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

  // Where only one tangential bar is free states have the signs of the plane too. An element with
  // two that never closes has the rates of all decided as in space.
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
        DenseMatrix water(2 * n, 3);
        if (seed % 2 == 0) // water that comes into open elements
          {
            for (std::size_t k = 0; k < n; ++k)
              water(2 * k, 0) = 0.1;
            system.water = std::make_shared<ToyWater>(water);
          }
        FrictionLaw friction;
        friction.coefficient = 0.5;
        const ToyJoint joint(n, 1., make_linear_law(0.1), make_linear_law(0.2), friction);
        const LoadHistory history        = roundabout();
        const std::vector<double> levels = {1., 2., 3., 4., 5.};
        const ConeRun along_tangent(system, joint.elements, history, levels);
        const Record &record = along_tangent.record;
        ToySystem space      = beside_open_element(system);
        if (system.water)
          space.water = std::make_shared<ToyWater>(with_empty_rows(water, 3));
        std::vector<ContactElement> with_cone = joint.elements;
        with_cone.push_back(open_element(2 * n, joint.elements.front()));
        const ConeRun run(space, with_cone, history, levels);
        ASSERT_EQ(run.result.verdict, along_tangent.result.verdict) << "seed " << seed;
        ASSERT_EQ(run.record.levels.size(), record.levels.size()) << "seed " << seed;
        for (std::size_t l = 0; l < levels.size(); ++l)
          {
            JointState level = run.record.levels[l];
            level.forces.resize(2 * n);
            level.states.resize(n);
            EXPECT_LT(largest_difference(level.forces, record.levels[l].forces), 1e-9)
              << "seed " << seed;
            EXPECT_EQ(level.states, record.levels[l].states) << "seed " << seed;
          }
        expect_same_events(run.record.events, record.events);
        for (std::size_t i = 0; i < record.events.size(); ++i)
          EXPECT_EQ(run.record.events[i].to, record.events[i].to) << "seed " << seed;
        EXPECT_LT(run.record.worst.worst(), 1e-8) << "seed " << seed;
      }
  }

  // A rigid body on two elements, which all but share their jump (stiffness k), slides by one
  // against a spring and back: forces of one are differences of terms of 1e7. With the pressures 1
  // and 2, f = 1/2 and the push P = T1 + T2 + 2s (d1 + d2), s = 1/4: both slide beyond P = 3/2, d1
  // = d2 = 1 at P = 5/2; then both stick, until T1 = 1/2 - (5/2 - P)/2 = -1/2 at P = 1/2. The load
  // has a corner 4e-6 before, where T1 is short of its strength by 2e-6 and nothing happens.
  TEST(ConePlane, SmallDifferencesOfLargeTermsReachTheirStrengthWhereTheyDo)
  {
    constexpr double k = 1e7, s = 0.25, before = 4e-6, unloading = 0.4;
    ToySystem system;
    system.S = DenseMatrix(6, 6);
    system.F = DenseMatrix(6, 2);
    for (const std::size_t i : {1, 4})
      {
        system.F(i, 1) = 0.5;
        for (const std::size_t j : {1, 4})
          system.S(i, j) = i == j ? k + s : s - k;
        system.S(i + 1, i + 1) = k;
      }
    system.F(0, 0) = -1.;
    system.F(3, 0) = -2.;
    const ConeJoint joint(2, 1., make_rigid_law(), make_rigid_law(), 0.5);
    const double corner = 0.5 + before;
    const LoadHistory history(
      {0., 1., 2., 3., 4.},
      {{0., 0.}, {1., 0.}, {1., 2.5}, {1., corner}, {1., corner - unloading}});
    const ConeRun run(system, joint.elements, history, {4.});
    ASSERT_EQ(run.result.verdict, Verdict::done);
    ASSERT_EQ(run.record.events.size(), 5u);
    const ContactEvent &last = run.record.events.back();
    EXPECT_EQ(last.element, 0u);
    // Forces are known to some 1e-16 k, the event happens 1e-5 behind the corner.
    EXPECT_NEAR(last.t, 3. + before / unloading, 1e-7);
  }
} // namespace fuga::tests
