// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/cone_toy.h"

#include <cmath>

namespace fuga::tests
{
  namespace
  {
    /** Random forces on the jumps: pattern 0 presses, the others are arbitrary. */
    DenseMatrix
    random_loads(const std::size_t n_elements, std::mt19937 &generator)
    {
      std::uniform_real_distribution<double> uniform(-1., 1.);
      DenseMatrix F(3 * n_elements, 3);
      for (std::size_t k = 0; k < n_elements; ++k)
        {
          F(3 * k, 0) = -1. - 0.3 * uniform(generator);
          for (std::size_t j = 1; j < 3; ++j)
            for (std::size_t i = 0; i < 3; ++i)
              F(3 * k + i, j) = uniform(generator) * (i == 0 ? 0.6 : 1.);
        }
      return F;
    }

    /** Pressing, then round about with reversals. */
    LoadHistory
    roundabout()
    {
      return LoadHistory({0., 1., 2., 3., 4., 5.},
                         {{0., 0., 0.},
                          {1., 0., 0.},
                          {1., 1.2, 0.},
                          {0.9, 0.6, 1.3},
                          {1.1, -1., 0.4},
                          {1., 0.2, -1.2}});
    }

    double
    largest_difference(const Vector &a, const Vector &b)
    {
      double result = 0.;
      for (std::size_t i = 0; i < a.size(); ++i)
        result = std::max(result, std::abs(a[i] - b[i]));
      return result;
    }
  } // namespace

  // Against backward Euler's return mapping with short steps. Its error is of first order, with a
  // factor that depends on where in a step lips close; 0.3 is the largest seen, roughly doubled.
  TEST(ConeRandom, FollowsReturnMappingWithShortSteps)
  {
    for (const unsigned int seed : {1u, 2u, 3u})
      {
        std::mt19937 generator(seed);
        const std::size_t n = 5;
        ToySystem system;
        system.S = random_stiffness(3 * n, generator);
        system.F = random_loads(n, generator);
        ConeJoint joint(n, 1., make_linear_law(0.2), make_linear_law(0.3), 0.4);
        Vector gaps(n, 0.);
        for (std::size_t k = 0; k < n; k += 2)
          gaps[k] = joint.elements[k].initial_gap = 0.1 * static_cast<double>(k);
        const LoadHistory history         = roundabout();
        const std::vector<double> corners = {1., 2., 3., 4., 5.};
        const ConeRun run(system, joint.elements, history, corners);
        ASSERT_EQ(run.result.verdict, Verdict::done) << "seed " << seed;
        EXPECT_LT(run.record.worst.worst(), 1e-8) << "seed " << seed;

        const LayeredSystem layered(system, joint.elements);
        const auto march = [&](const int n_steps) {
          Vector d(3 * n, 0.);
          std::vector<Vector> forces;
          for (const double corner : corners)
            {
              for (int i = 1; i <= n_steps; ++i)
                d = return_mapping(
                  layered.stiffness(),
                  multiply(layered.reactions(),
                           history.factors(corner - 1. + static_cast<double>(i) / n_steps)),
                  gaps,
                  0.4,
                  d,
                  1e-13);
              forces.push_back(layered.forces(history.factors(corner), d));
            }
          return forces;
        };
        for (const int n_steps : {100, 1000})
          {
            const std::vector<Vector> forces = march(n_steps);
            for (std::size_t c = 0; c < corners.size(); ++c)
              EXPECT_LT(largest_difference(run.record.levels[c].forces, forces[c]), 0.3 / n_steps)
                << "seed " << seed << ", corner " << c;
          }
      }
  }

  // A plane problem with a second tangent that is not loaded is the path of EventPath.
  TEST(ConeRandom, PlaneProblemsAreThoseOfTheEventPath)
  {
    for (unsigned int seed = 1; seed <= 30; ++seed)
      {
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
        const LayeredSystem layered(plane, plane_joint.elements);
        Record record(plane, plane_joint.elements, history);
        EventPath path(plane_joint.elements, layered, history, PathOptions());
        const PathResult result = path.run(levels, record);
        const ConeRun run(space, space_joint.elements, history, levels);
        ASSERT_EQ(run.result.verdict, result.verdict) << "seed " << seed;
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
        ASSERT_EQ(run.record.events.size(), record.events.size()) << "seed " << seed;
        for (std::size_t i = 0; i < record.events.size(); ++i)
          {
            EXPECT_NEAR(run.record.events[i].t, record.events[i].t, 1e-9) << "seed " << seed;
            EXPECT_EQ(run.record.events[i].element, record.events[i].element) << "seed " << seed;
            EXPECT_EQ(state_name(run.record.events[i].to), state_name(record.events[i].to))
              << "seed " << seed;
          }
        EXPECT_LT(run.record.worst.worst(), 1e-8) << "seed " << seed;
      }
  }

  // Turning the tangents of every element in their plane changes nothing but the components.
  TEST(ConeRandom, TangentsMayBeTurned)
  {
    for (unsigned int seed = 1; seed <= 20; ++seed)
      {
        std::mt19937 generator(seed);
        const std::size_t n = 6;
        ToySystem system, turned;
        system.S = random_stiffness(3 * n, generator);
        system.F = random_loads(n, generator);
        std::uniform_real_distribution<double> angle(-3., 3.);
        DenseMatrix Q(3 * n, 3 * n); // new components = Q old components
        for (std::size_t k = 0; k < n; ++k)
          {
            const double phi        = angle(generator);
            Q(3 * k, 3 * k)         = 1.;
            Q(3 * k + 1, 3 * k + 1) = Q(3 * k + 2, 3 * k + 2) = std::cos(phi);
            Q(3 * k + 1, 3 * k + 2)                           = std::sin(phi);
            Q(3 * k + 2, 3 * k + 1)                           = -std::sin(phi);
          }
        turned.F = multiply(Q, system.F);
        DenseMatrix Q_T(3 * n, 3 * n);
        for (std::size_t i = 0; i < 3 * n; ++i)
          for (std::size_t j = 0; j < 3 * n; ++j)
            Q_T(i, j) = Q(j, i);
        turned.S = multiply(Q, multiply(system.S, Q_T));
        ConeJoint joint(n, 1., make_linear_law(0.1), make_linear_law(0.1), 0.5);
        joint.elements[1].initial_gap    = 0.1;
        const LoadHistory history        = roundabout();
        const std::vector<double> levels = {1., 2., 2.5, 3., 4., 5.};
        const ConeRun a(system, joint.elements, history, levels);
        const ConeRun b(turned, joint.elements, history, levels);
        ASSERT_EQ(a.result.verdict, Verdict::done) << "seed " << seed;
        ASSERT_EQ(b.result.verdict, Verdict::done) << "seed " << seed;
        for (std::size_t l = 0; l < levels.size(); ++l)
          EXPECT_LT(
            largest_difference(multiply(Q, a.record.levels[l].forces), b.record.levels[l].forces),
            1e-9)
            << "seed " << seed << ", level " << levels[l];
        ASSERT_EQ(a.record.events.size(), b.record.events.size()) << "seed " << seed;
        for (std::size_t i = 0; i < a.record.events.size(); ++i)
          EXPECT_NEAR(a.record.events[i].t, b.record.events[i].t, 1e-9) << "seed " << seed;
        EXPECT_LT(a.record.worst.worst(), 1e-8) << "seed " << seed;
      }
  }

  // Virgin joints without gaps under one load: everything is decided at the apex of the cones, and
  // the state grows in proportion to the load. Against Gauss-Seidel sweeps on the whole load at
  // once.
  TEST(ConeRandom, VirginStatesAreDecidedAtTheApex)
  {
    for (unsigned int seed = 1; seed <= 40; ++seed)
      {
        std::mt19937 generator(seed);
        const std::size_t n = 12;
        ToySystem system;
        system.S = random_stiffness(3 * n, generator);
        system.F = random_loads(n, generator);
        ConeJoint joint(n, 1., make_linear_law(0.05), make_linear_law(0.05), 0.4);
        const LoadHistory history({0., 1.}, {{0., 0., 0.}, {1., 1., -1.}});
        const ConeRun run(system, joint.elements, history, {0.25, 1.});
        ASSERT_EQ(run.result.verdict, Verdict::done) << "seed " << seed;
        EXPECT_EQ(run.result.n_steps, 1u) << "seed " << seed;
        const LayeredSystem layered(system, joint.elements);
        const Vector d = return_mapping(layered.stiffness(),
                                        multiply(layered.reactions(), history.factors(1.)),
                                        Vector(n, 0.),
                                        0.4,
                                        Vector(3 * n, 0.),
                                        1e-14);
        EXPECT_LT(largest_difference(d, run.record.levels.back().dislocations), 1e-10)
          << "seed " << seed;
        Vector quarter = run.record.levels.back().forces;
        for (double &value : quarter)
          value *= 0.25;
        EXPECT_LT(largest_difference(quarter, run.record.levels.front().forces), 1e-12);
        EXPECT_LT(run.record.worst.worst(), 1e-8) << "seed " << seed;
      }
  }
} // namespace fuga::tests
