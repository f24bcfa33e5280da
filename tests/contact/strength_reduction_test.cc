// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/toy_system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  /** Share of strength at the end of the reductions here: F = 10. */
  constexpr double smallest_share = 0.1;

  FrictionLaw
  reduced_law(const double f, const double cohesion = 0.)
  {
    FrictionLaw law;
    law.coefficient = f;
    law.cohesion    = cohesion;
    law.reduced     = true;
    return law;
  }

  /** A rigid body (ux, uy, rotation about the origin) that a joint's elements hold at given points,
   * against fixed planes with given unit normals. Loads: forces in x, y, moment. */
  ToySystem
  rigid_body(const std::vector<std::array<double, 2>> &points,
             const std::vector<std::array<double, 2>> &normals)
  {
    ToySystem system;
    system.S = DenseMatrix(3, 3);
    system.B = DenseMatrix(2 * points.size(), 3);
    system.F = DenseMatrix(3, 3);
    for (std::size_t k = 0; k < points.size(); ++k)
      {
        const auto [x, y]      = points[k];
        const auto [nx, ny]    = normals[k];
        system.B(2 * k, 0)     = nx;
        system.B(2 * k, 1)     = ny;
        system.B(2 * k, 2)     = ny * x - nx * y;
        system.B(2 * k + 1, 0) = ny;
        system.B(2 * k + 1, 1) = -nx;
        system.B(2 * k + 1, 2) = -nx * x - ny * y;
      }
    for (std::size_t i = 0; i < 3; ++i)
      system.F(i, i) = 1.;
    system.motions      = system.B;
    system.motion_loads = system.F;
    return system;
  }

  /** Keeps the last state as well. */
  class LastState : public Record
  {
  public:
    using Record::Record;

    JointState last;

    void
    advanced(const PathPoint &from, const PathPoint &to, const double length) override
    {
      Record::advanced(from, to, length);
      last = to.state;
    }

    void
    changed(const std::vector<ContactEvent> &new_events, const JointState &state) override
    {
      Record::changed(new_events, state);
      last = state;
    }
  };

  /** A path through stages of loads, and a reduction of the strength after them. */
  struct Search
  {
    PathResult result;
    std::vector<ContactEvent> events;
    JointState last;
    double worst  = 0.;
    double factor = 0.;
    double begin  = 0.;

    /** F at an event. */
    static double
    factor_at(const double fraction)
    {
      return 1. / (1. - (1. - smallest_share) * fraction);
    }
  };

  Search
  reduce_strength(const ToySystem &system,
                  const ToyJoint &joint,
                  const std::vector<Vector> &loads,
                  const PathOptions &options = {})
  {
    std::vector<double> corners(1, 0.);
    std::vector<Vector> factors(1, Vector(3, 0.));
    Vector shares(1, 1.);
    for (const Vector &load : loads)
      {
        corners.push_back(corners.back() + 1.);
        factors.push_back(load);
        shares.push_back(1.);
      }
    corners.push_back(corners.back() + 1.);
    factors.push_back(factors.back());
    shares.push_back(smallest_share);
    const LoadHistory history(corners, factors, shares);
    const LayeredSystem layered(system, joint.elements);
    LastState record(system, joint.elements, history);
    EventPath path(joint.elements, layered, history, options);
    Search search;
    search.result = path.run({corners[loads.size()]}, record);
    search.events = record.events;
    search.last   = record.last;
    search.worst  = record.worst.worst();
    search.begin  = corners[loads.size()];
    search.factor = 1. / history.strength_share(search.result.t);
    return search;
  }

  /** Whether a rigid body with another friction carries the loads. */
  bool
  carries(const ToySystem &system, ToyJoint &joint, const double f, const Vector &load)
  {
    for (ContactElement &element : joint.elements)
      element.friction.coefficient = f;
    const LoadHistory history({0., 1.}, {Vector(3, 0.), load});
    const LayeredSystem layered(system, joint.elements);
    Record record(system, joint.elements, history);
    EventPath path(joint.elements, layered, history, {});
    return path.run({1.}, record).verdict == Verdict::done && record.worst.worst() <= 1e-9;
  }
} // namespace

// The block of V4 (event_path_test.cc), whose eccentric weight presses the element k by N_k, under
// the horizontal force H at the level of the joint. An element slips where its share of H reaches
// f N_k/F. With the elements 1 ... k slipping, the others carry H - (f/F) ΣN by their stiffness
// C_t: 1/F_k = (H C_k/ΣC) / (f N_k + f C_k ΣN_slip/ΣC). All at once slide at F = f N/H. Tolerance:
// rounding.
TEST(StrengthReduction, ProgressiveSlipOfARigidBlock)
{
  constexpr std::size_t n = 8;
  constexpr double f      = 0.2;
  constexpr double H      = 0.1; // below the first slip: 0.103
  constexpr double moment = -1. / 12.;
  const ToySystem system  = rigid_block(n, 1.);
  const ToyJoint joint =
    rigid_block_joint(n, 1., make_linear_law(1.), make_linear_law(1.), reduced_law(f));
  const Search search = reduce_strength(system, joint, {{0., -1., moment}, {H, -1., moment}});
  EXPECT_EQ(search.result.verdict, Verdict::limit_load);
  EXPECT_EQ(search.result.mechanism, MechanismKind::sliding);
  EXPECT_NEAR(search.factor, f / H, 1e-13 * f / H);
  EXPECT_LE(search.worst, 1e-13);

  // Σ A x² of the nodal areas, N_k = A_k (1 + x M/I) for a unit pressure.
  double inertia = 0.;
  std::vector<double> N;
  const auto place = [](const std::size_t k) { return static_cast<double>(k) / n - 0.5; };
  for (std::size_t k = 0; k <= n; ++k)
    inertia += joint.elements[k].area * place(k) * place(k);
  for (std::size_t k = 0; k <= n; ++k)
    N.push_back(joint.elements[k].area * (1. - place(k) * moment / inertia));
  std::vector<std::size_t> order(n + 1);
  for (std::size_t k = 0; k <= n; ++k)
    order[k] = k;
  std::sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b) {
    return N[a] / joint.elements[a].area < N[b] / joint.elements[b].area;
  });
  ASSERT_EQ(search.events.size(), n + 1);
  double stuck = 1., slipping = 0.;
  for (std::size_t i = 0; i <= n; ++i)
    {
      const std::size_t k  = order[i];
      const double C       = joint.elements[k].area;
      const double share   = H * C / stuck / (f * N[k] + f * C * slipping / stuck);
      const double reached = Search::factor_at(search.events[i].t - search.begin);
      EXPECT_EQ(search.events[i].element, k);
      EXPECT_NEAR(reached, 1. / share, 1e-12);
      stuck -= C;
      slipping += N[k];
    }
}

// Cohesion is divided as well: F = (c A + f N)/H, whether nothing slips at the end of the loads,
// most elements do, or all but one. Closed form; tolerance: rounding.
TEST(StrengthReduction, FrictionAndCohesionOfASlidingBlock)
{
  constexpr double f = 0.2, c = 0.1;
  const ToySystem system = rigid_block(6, 1.);
  const ToyJoint joint =
    rigid_block_joint(6, 1., make_linear_law(1.), make_linear_law(1.), reduced_law(f, c));
  for (const double H : {0.05, 0.2, 0.26, 0.299})
    {
      SCOPED_TRACE(H);
      const Search search = reduce_strength(system, joint, {{0., -1., -0.1}, {H, -1., -0.1}});
      EXPECT_EQ(search.result.verdict, Verdict::limit_load);
      EXPECT_EQ(search.result.mechanism, MechanismKind::sliding);
      EXPECT_NEAR(search.factor, (c + f) / H, 1e-12);
      EXPECT_LE(search.worst, 1e-12);
    }
}

// Nothing is lost without a horizontal force: no factor up to the largest one asked for.
TEST(StrengthReduction, NothingToReduceFor)
{
  const ToySystem system = rigid_block(4, 1.);
  const ToyJoint joint =
    rigid_block_joint(4, 1., make_linear_law(1.), make_linear_law(1.), reduced_law(0.2));
  const Search search = reduce_strength(system, joint, {{0., -1., 0.}});
  EXPECT_EQ(search.result.verdict, Verdict::done);
  EXPECT_NEAR(search.factor, 1. / smallest_share, 1e-14);
  EXPECT_TRUE(search.events.empty());
}

// A uniform ladder at the angle θ to the ground, which leans on a wall, both with friction f: it
// slides when tan θ = (1 - f²)/(2 f) (textbook of statics), f = sec θ - tan θ. Here N and T depend
// on each other, the path is a curve in F, and wall and ground move. Tolerance: rounding.
TEST(StrengthReduction, LadderAgainstAWall)
{
  for (const double theta : {0.8, 1.1, 1.4})
    for (const double f : {0.45, 0.6, 0.9})
      {
        const double least = 1. / std::cos(theta) - std::tan(theta);
        if (f < 1.05 * least || f > 9.5 * least)
          continue;
        SCOPED_TRACE(testing::Message() << "theta " << theta << ", f " << f);
        const double a = std::cos(theta), b = std::sin(theta);
        const ToySystem system = rigid_body({{{a, -b}}, {{-a, b}}}, {{{0., 1.}}, {{1., 0.}}});
        const ToyJoint joint(2, 1., make_linear_law(0.01), make_linear_law(0.02), reduced_law(f));
        const Search search = reduce_strength(system, joint, {{0., -1., 0.}});
        EXPECT_EQ(search.result.verdict, Verdict::limit_load);
        EXPECT_NEAR(search.factor, f / least, 1e-12 * f / least);
        EXPECT_LE(search.worst, 1e-11);
      }
}

// Rigid bodies on up to six elements with random places and normals under random forces. Whoever
// runs the loads with the friction f/F from the beginning sees them carried for F slightly smaller
// than the factor found, and not for F slightly larger; unless the mechanism closes an element that
// was open, and a jump so leads to another equilibrium.
TEST(StrengthReduction, AgreesWithRunsWithReducedFriction)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-1., 1.);
  constexpr double step  = 1e-7;
  std::size_t n_compared = 0, n_mechanisms = 0, n_slipping_at_start = 0, n_caught = 0;
  for (unsigned int i = 0; i < 400; ++i)
    {
      SCOPED_TRACE(i);
      const std::size_t n = 2 + random() % 5;
      std::vector<std::array<double, 2>> points, normals;
      for (std::size_t k = 0; k < n; ++k)
        {
          const double angle = 0.5 * number(random);
          points.push_back({{number(random), 0.3 * number(random)}});
          normals.push_back({{std::sin(angle), std::cos(angle)}});
        }
      const double f         = 0.4 + 0.3 * number(random);
      const Vector load      = {0.4 * number(random), -1., 0.2 * number(random)};
      const ToySystem system = rigid_body(points, normals);
      ToyJoint joint(n, 1., make_linear_law(0.01), make_linear_law(0.02), reduced_law(f));
      if (!carries(system, joint, f, load))
        continue;
      const Search search = reduce_strength(system, joint, {load});
      EXPECT_LE(search.worst, 1e-9);
      if (search.result.verdict == Verdict::done)
        continue;
      const bool mechanism = search.result.mechanism != MechanismKind::none;
      ++n_compared;
      n_mechanisms += mechanism ? 1 : 0;
      for (const ContactEvent &event : search.events)
        if (event.t < search.begin && is_slipping(event.to))
          {
            ++n_slipping_at_start;
            break;
          }
      const bool caught = search.result.jump.found;
      n_caught += caught ? 1 : 0;
      EXPECT_TRUE(carries(system, joint, f / (search.factor * (1. - step)), load));
      if (!caught)
        {
          EXPECT_FALSE(carries(system, joint, f / (search.factor * (1. + step)), load));
        }
    }
  EXPECT_GE(n_compared, 100u);
  EXPECT_GE(n_mechanisms, 100u);
  EXPECT_GE(n_slipping_at_start, 50u);
  EXPECT_LE(n_caught, 20u);
}
