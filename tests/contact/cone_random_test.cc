// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/cone_toy.h"

#include <cmath>

namespace fuga::tests
{
  // Against backward Euler's return mapping with short steps. Its error is of first order, with a
  // factor that depends on where in a step lips close; 0.3 is the largest seen, roughly doubled.
  TEST(ConeRandom, FollowsReturnMappingWithShortSteps)
  {
    for (const unsigned int seed : {1u, 2u, 3u})
      {
        std::mt19937 generator(seed);
        const std::size_t n    = 5;
        const ToySystem system = random_bodies(n, generator);
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

  // Turning the tangents of every element in their plane changes nothing but the components.
  TEST(ConeRandom, TangentsMayBeTurned)
  {
    for (unsigned int seed = 1; seed <= 20; ++seed)
      {
        SCOPED_TRACE(seed);
        std::mt19937 generator(seed);
        const std::size_t n    = 6;
        const ToySystem system = random_bodies(n, generator);
        ToySystem turned;
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
        expect_same_events(a.record.events, b.record.events);
        EXPECT_LT(a.record.worst.worst(), 1e-8) << "seed " << seed;
      }
  }

  namespace
  {
    /** A rigid plate on n elements at random places, or on a grid; load 0 presses its middle. */
    ToySystem
    random_plate(const std::size_t n, const bool on_grid, std::mt19937 &generator)
    {
      std::uniform_real_distribution<double> uniform(-1., 1.);
      ToySystem system;
      system.S = DenseMatrix(6, 6);
      system.B = DenseMatrix(3 * n, 6);
      system.F = DenseMatrix(6, 3);
      for (std::size_t k = 0; k < n; ++k)
        {
          const double x = on_grid ? static_cast<double>(k % 3) - 1. : uniform(generator);
          const double y = on_grid ? static_cast<double>(k / 3) - 1. : uniform(generator);
          for (std::size_t i = 0; i < 3; ++i)
            system.B(3 * k + i, i) = 1.;
          system.B(3 * k, 3)     = y;
          system.B(3 * k, 4)     = -x;
          system.B(3 * k + 1, 5) = -y;
          system.B(3 * k + 2, 5) = x;
        }
      system.F(0, 0) = -1.;
      for (std::size_t j = 1; j < 3; ++j)
        for (std::size_t i = 0; i < 6; ++i)
          system.F(i, j) = uniform(generator) * (i == 0 ? 0.1 : 0.3);
      system.motions      = system.B;
      system.motion_loads = system.F;
      return system;
    }
  } // namespace

  // Elastic bodies and rigid plates, soft, stiff and rigid layers, friction up to 1.2, gaps,
  // elements without friction, six random load cases one after the other: every path ends with the
  // history, at a limit load or where a plate falls on an open element, and satisfies the judge at
  // every event.
  TEST(ConeRandom, ManyPathsEndProperly)
  {
    std::size_t n_limits = 0;
    for (unsigned int seed = 1; seed <= 150; ++seed)
      {
        std::mt19937 generator(seed);
        const auto pick = [&](const double a, const double b) {
          return std::uniform_real_distribution<double>(a, b)(generator);
        };
        const bool is_plate   = seed % 3 == 0;
        const std::size_t n   = 4 + generator() % 7;
        const double friction = std::array<double, 4>{{0.2, 0.5, 0.8, 1.2}}[generator() % 4];
        const double rho      = std::array<double, 3>{{1e-4, 0.05, 0.5}}[generator() % 3];
        const bool is_rigid   = !is_plate && generator() % 4 == 0;
        ToySystem system;
        if (is_plate)
          system = random_plate(n, seed % 2 == 0, generator);
        else
          system = random_bodies(n, generator);
        ConeJoint joint(n,
                        1.,
                        is_rigid ? make_rigid_law() : make_linear_law(rho),
                        is_rigid ? make_rigid_law() : make_linear_law(rho * pick(0.5, 2.)),
                        friction);
        for (std::size_t k = 0; k < n; ++k)
          {
            if (generator() % 4 == 0)
              joint.elements[k].initial_gap = pick(0., 0.2) * (is_plate ? rho : 1.);
            if (!is_plate && generator() % 6 == 0)
              joint.elements[k].friction.coefficient = 0.;
          }
        std::vector<Vector> factors = {{0., 0., 0.}, {1., 0., 0.}};
        Vector corners              = {0., 1.};
        for (double corner = 2.; corner <= 6.; ++corner)
          {
            corners.push_back(corner);
            factors.push_back({pick(0.5, 1.2), pick(-1.2, 1.2), pick(-1.2, 1.2)});
          }
        const LoadHistory history(corners, factors);
        const ConeRun run(system, joint.elements, history, {1., 1.5, 3.3, 6.});
        EXPECT_TRUE(
          run.result.verdict == Verdict::done ||
          (is_plate && (run.result.verdict == Verdict::limit_load || run.result.jump.found)))
          << "seed " << seed;
        // The default bound of a run.
        EXPECT_LT(run.record.worst.worst(), 1e-9) << "seed " << seed;
        n_limits += run.result.verdict == Verdict::limit_load ? 1 : 0;
      }
    EXPECT_GT(n_limits, 10u);
  }

  // Virgin joints without gaps under one load: everything is decided at the apex of the cones, and
  // the state grows in proportion to the load. Against Gauss-Seidel sweeps on the whole load at
  // once.
  TEST(ConeRandom, VirginStatesAreDecidedAtTheApex)
  {
    for (unsigned int seed = 1; seed <= 40; ++seed)
      {
        std::mt19937 generator(seed);
        const std::size_t n    = 12;
        const ToySystem system = random_bodies(n, generator);
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

  // Elements close under a block that slides far: Newton's first direction is that of the slip the
  // open lips had, whatever rounding has left of their forces. (Where that was lost, 20 of these
  // paths took more, up to 26 schemes for a step, and in a large joint no sweeps after Newton
  // helped.)
  TEST(ConeRandom, ClosingWhileSlidingTakesFewSchemes)
  {
    std::size_t n_events = 0;
    for (unsigned int seed = 1; seed <= 100; ++seed)
      {
        std::mt19937 generator(seed);
        std::uniform_real_distribution<double> gaps(0., 0.3);
        const std::size_t n    = 12;
        const ToySystem system = random_bodies(n, generator);
        ConeJoint joint(n, 1., make_linear_law(0.05), make_linear_law(0.05), 0.4);
        for (ContactElement &element : joint.elements)
          element.initial_gap = gaps(generator);
        const LoadHistory history({0., 1.}, {{0., 0., 0.}, {1., 40., -30.}});
        const ConeRun run(system, joint.elements, history, {1.});
        if (run.result.verdict != Verdict::done)
          continue;
        n_events += run.result.n_events;
        EXPECT_LE(run.result.n_schemes, 6 * (run.result.n_steps + run.result.n_zero_steps))
          << "seed " << seed;
        EXPECT_LT(run.record.worst.worst(), 1e-8) << "seed " << seed;
      }
    EXPECT_GT(n_events, 500u);
  }

  namespace
  {
    /** The cut at every report, and the last state. */
    class Cuts : public PathObserver
    {
    public:
      const EventPath *path = nullptr;
      std::vector<PathCut> cuts;
      JointState last;
      std::size_t n_reports = 0;

      bool
      wants_cuts() const override
      {
        return true;
      }

      void
      advanced(const PathPoint &, const PathPoint &to, const double) override
      {
        note(to.state);
      }

      void
      jumped(const JointState &) override
      {
      }

      void
      changed(const std::vector<ContactEvent> &, const JointState &state) override
      {
        note(state);
      }

      void
      reached(const std::size_t, const JointState &state) override
      {
        note(state);
      }

    private:
      void
      note(const JointState &state)
      {
        last = state;
        ++n_reports;
        cuts.push_back(path->last_cut());
      }
    };
  } // namespace

  // A path that is followed again from any of its cuts is the unbroken one, bit for bit, and what
  // was reported before is not repeated.
  TEST(ConeRandom, PathsCanBeCut)
  {
    for (unsigned int seed = 1; seed <= 4; ++seed)
      {
        std::mt19937 generator(seed);
        const std::size_t n    = 5;
        const ToySystem system = random_bodies(n, generator);
        ConeJoint joint(n, 1., make_linear_law(0.1), make_linear_law(0.1), 0.5);
        joint.elements[1].initial_gap    = 0.1;
        const LoadHistory history        = roundabout();
        const std::vector<double> levels = {0.5, 1.5, 2., 3.3};
        const LayeredSystem layered(system, joint.elements);
        EventPath path(joint.elements, layered, history, PathOptions());
        Cuts unbroken;
        unbroken.path           = &path;
        const PathResult result = path.run(levels, unbroken);
        ASSERT_EQ(result.verdict, Verdict::done);
        for (std::size_t i = 0; i < unbroken.cuts.size(); i += 53)
          {
            EventPath rest(joint.elements, layered, history, PathOptions());
            Cuts second;
            second.path                  = &rest;
            const PathResult rest_result = rest.resume(unbroken.cuts[i], levels, second);
            EXPECT_EQ(second.n_reports, unbroken.n_reports - i - 1) << "seed " << seed;
            EXPECT_EQ(rest_result.n_events, result.n_events) << "seed " << seed;
            if (second.n_reports == 0)
              continue;
            EXPECT_EQ(second.last.forces, unbroken.last.forces) << "seed " << seed << ", " << i;
            EXPECT_EQ(second.last.dislocations, unbroken.last.dislocations) << "seed " << seed;
          }
      }
  }
} // namespace fuga::tests
