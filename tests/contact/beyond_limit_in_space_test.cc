// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Beyond a limit load in two directions: the load is an unknown while the direction of slip turns.

#include "contact/beyond_record.h"
#include "contact/cone_toy.h"

#include <fuga/contact/virgin_state.h>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  /** One element of a rigid joint, normal and two tangents, pressed by load 0; load 1 acts along
   * the tangents at the angle @p alpha. */
  ToySystem
  oblique_load(const DenseMatrix &S, const double alpha)
  {
    ToySystem system;
    system.S       = S;
    system.F       = DenseMatrix(3, 2);
    system.F(0, 0) = -1.;
    system.F(1, 1) = std::cos(alpha);
    system.F(2, 1) = std::sin(alpha);
    return system;
  }

  /** Slip, load and direction θ of a node with f = 2 that slip along x unloads, N = -1 + 0.6 s_x,
   * T = λ (cos α, sin α) - (s_x, k s_y) = -2 N (cos θ, sin θ), from s = 0, θ = α, λ = 2 on. */
  struct TurningNode
  {
    static constexpr double f = 2., coupling = 0.6;
    double k, alpha;
    /** s_x, s_y, λ, θ */
    std::array<double, 4> y = {{0., 0., 2., alpha}};

    std::array<double, 4>
    rates(const std::array<double, 4> &at) const
    {
      const double c = std::cos(at[3]), s = std::sin(at[3]);
      const double R1 = c - f * coupling * c * c, R2 = k * s - f * coupling * c * s;
      const double r = f * (1. - coupling * at[0]), slant = std::cos(at[3] - alpha);
      return {{c,
               s,
               (c * R1 + s * R2) / slant,
               (std::sin(alpha) * R1 - std::cos(alpha) * R2) / (r * slant)}};
    }

    /** Runge and Kutta's method along the arc until s_x has the given value. */
    void
    slide_to(const double s_x)
    {
      const double step = 1e-4;
      const auto moved_by =
        [](const std::array<double, 4> &from, const double h, const std::array<double, 4> &slope) {
          std::array<double, 4> result = from;
          for (std::size_t i = 0; i < 4; ++i)
            result[i] += h * slope[i];
          return result;
        };
      while (std::abs(s_x - y[0]) > 1e-15)
        {
          const double h = std::min(step, (s_x - y[0]) / std::cos(y[3]));
          const auto a = rates(y), b = rates(moved_by(y, 0.5 * h, a)),
                     c = rates(moved_by(y, 0.5 * h, b)), d = rates(moved_by(y, h, c));
          for (std::size_t i = 0; i < 4; ++i)
            y[i] += h / 6. * (a[i] + 2. * b[i] + 2. * c[i] + d[i]);
        }
    }
  };
} // namespace

// The node of V10 (section 7) with a second direction, in which it is softer: from λ = 2 on the
// load falls as the direction of slip turns. Reference: the equations of TurningNode, integrated
// along the arc.
TEST(BeyondLimitInSpace, LoadFallsAsTheSlipTurns)
{
  const double alpha = 0.3, k = 0.4;
  DenseMatrix S(3, 3);
  S(0, 0) = S(1, 1) = 1.;
  S(0, 1) = S(1, 0)      = -TurningNode::coupling;
  S(2, 2)                = k;
  const ToySystem system = oblique_load(S, alpha);
  const ConeJoint joint(1, 1., make_rigid_law(), make_rigid_law(), TurningNode::f);
  const LoadHistory history({0., 1., 2.}, {{0., 0.}, {1., 0.}, {1., 3.}});
  const BeyondRun run = follow_beyond(system, joint.elements, history, 1., {1., 2.});

  EXPECT_EQ(run.result.verdict, Verdict::no_continuation);
  EXPECT_NEAR(run.result.t, 1. + 2. / 3., 1e-12);
  EXPECT_EQ(run.result.beyond.end, BeyondLimit::End::largest_jump);
  EXPECT_LE(run.record.worst.worst(), 1e-9);
  ASSERT_FALSE(run.record.beyond.empty());
  TurningNode node{k, alpha};
  for (const JointState &state : run.record.beyond)
    {
      node.slide_to(state.slips[0][0]);
      EXPECT_NEAR(state.slips[0][1], node.y[1], 1e-9);
      EXPECT_NEAR(3. * (state.t - 1.), node.y[2], 1e-9);
      const double r = TurningNode::f * (1. - TurningNode::coupling * node.y[0]);
      EXPECT_NEAR(state.forces[1], r * std::cos(node.y[3]), 1e-9);
      EXPECT_NEAR(state.forces[2], r * std::sin(node.y[3]), 1e-9);
    }
  EXPECT_GT(std::abs(node.y[3] - alpha), 0.1); // it does turn
  EXPECT_LT(node.y[2], 1.85);                  // and the load does fall
}

// The same node pulled back at its strength, from λ = 2: it may stick, or slide on along the
// falling branch, whose scheme has the determinant cos²α + k sin²α - f 0.6 cos α < 0.
TEST(CriticalFrictionInSpace, TwoContinuationsOfANodeThatTurns)
{
  const double alpha = 0.3, k = 0.4, last = 1.9;
  DenseMatrix S(3, 3);
  S(0, 0) = S(1, 1) = 1.;
  S(0, 1) = S(1, 0)      = -TurningNode::coupling;
  S(2, 2)                = k;
  const ToySystem system = oblique_load(S, alpha);
  const ConeJoint joint(1, 1., make_rigid_law(), make_rigid_law(), TurningNode::f);
  const LoadHistory history({0., 1., 2., 3.}, {{0., 0.}, {1., 0.}, {1., 2.}, {1., last}});
  const LayeredSystem layered(system, joint.elements);
  const auto follow = [&](const PathOptions::NonUnique choice) {
    PathOptions options;
    options.non_unique = choice;
    EventPath path(joint.elements, layered, history, options);
    BeyondRun run{{}, BeyondRecord(system, joint.elements, history)};
    run.result = path.run({1., 2., 3.}, run.record);
    EXPECT_LE(run.record.worst.worst(), 1e-9);
    return run;
  };
  const BeyondRun stop = follow(PathOptions::NonUnique::stop);
  EXPECT_EQ(stop.result.verdict, Verdict::non_unique_continuation);
  EXPECT_EQ(stop.result.t, 2.);
  EXPECT_EQ(stop.result.critical.n_branches, 2u);
  EXPECT_TRUE(stop.result.critical.all_counted);
  std::vector<int> signs = stop.result.critical.determinant_signs;
  std::sort(signs.begin(), signs.end());
  EXPECT_EQ(signs, (std::vector<int>{-1, 1}));

  const BeyondRun first = follow(PathOptions::NonUnique::first);
  EXPECT_EQ(first.result.verdict, Verdict::done);
  EXPECT_NEAR(length(first.record.levels.back().slips[0]), 0., 1e-12);

  const BeyondRun most = follow(PathOptions::NonUnique::largest_dissipation);
  EXPECT_EQ(most.result.verdict, Verdict::done);
  const JointState &end = most.record.levels.back();
  TurningNode node{k, alpha};
  node.slide_to(end.slips[0][0]);
  EXPECT_NEAR(node.y[2], last, 1e-9);
  EXPECT_NEAR(end.slips[0][1], node.y[1], 1e-9);
  EXPECT_GT(end.slips[0][1], 0.01);
}

// At the apex. For one element in the plane f_c = W_tt/|W_tn| is known: above it uniqueness must
// not be certain. And where it is certain, of two elements on random bodies, a search from all
// states and eight directions finds no second continuation.
TEST(CriticalFrictionInSpace, WhatIsCertainAtTheApexIsTrue)
{
  const auto is_certain = [](const ToySystem &system, const double f, std::mt19937 &generator) {
    const std::size_t n = system.S.rows() / 3;
    const ConeJoint joint(n, 1., make_rigid_law(), make_rigid_law(), f);
    const LayeredSystem layered(system, joint.elements);
    WorkingScheme scheme(joint.elements, layered);
    RateProblem problem(joint.elements, layered, scheme);
    const JointState state = virgin_state(joint.elements, 3 * n, false);
    std::vector<BoundaryElement> set;
    for (std::size_t k = 0; k < n; ++k)
      set.push_back({k, true, ShearPosition::at_apex});
    std::uniform_real_distribution<double> any(-1., 1.);
    Vector factors;
    for (Eigen::Index j = 0; j < system.F.cols(); ++j)
      factors.push_back(any(generator));
    const Drive drive        = {multiply(layered.reactions(), factors), {}, {}};
    const Continuation found = problem.solve(state, set, drive);
    const bool certain       = !problem.may_have_others(set, found);
    if (certain)
      {
        EXPECT_TRUE(found.exists);
        EXPECT_EQ(problem.branches(state, set, drive).size(), 1u);
      }
    return certain;
  };
  std::mt19937 generator(1);
  DenseMatrix S(3, 3);
  S(0, 0) = S(1, 1) = S(2, 2) = 1.;
  S(0, 1) = S(1, 0)    = -TurningNode::coupling;
  const ToySystem node = oblique_load(S, 0.3);
  EXPECT_TRUE(is_certain(node, 0.3, generator));
  EXPECT_FALSE(is_certain(node, 1.01 / TurningNode::coupling, generator));
  std::size_t n_certain = 0, n_uncertain = 0;
  for (int i = 0; i < 40; ++i)
    for (const double f : {0.3, 1., 4.})
      (is_certain(random_bodies(2, generator), f, generator) ? n_certain : n_uncertain) += 1;
  EXPECT_GT(n_certain, 10u);
  EXPECT_GT(n_uncertain, 10u);
}

// Nothing but the joint, C_t = 1, holds the node along x, and a spring of stiffness 1 along y. So
// with F = λ (cos α, sin α) and T = (cos θ, sin θ), λ cos α = cos θ and 2 sin θ = λ sin α - s_y.
// With ds_y = tan θ ds_x the slip turns towards x as
//     s_x = 2 (ln(tan(θ0/2) / tan(θ/2)) + cos θ0 - cos θ) + tan α (sin θ0 - sin θ),
// tan θ0 = tan α / 2. The load approaches its limit 1 / cos α without reaching it.
TEST(BeyondLimitInSpace, SlipGoesOnTurningIntoTheMechanism)
{
  const double alpha = 0.6, theta_0 = std::atan(0.5 * std::tan(alpha));
  DenseMatrix S(3, 3);
  S(0, 0) = S(2, 2)         = 1.;
  ToySystem system          = oblique_load(S, alpha);
  system.motions            = DenseMatrix(3, 1);
  system.motions(1, 0)      = 1.;
  system.motion_loads       = DenseMatrix(1, 2);
  system.motion_loads(0, 1) = std::cos(alpha);
  const ConeJoint joint(1, 1., make_rigid_law(), make_linear_law(1.), 1.);
  const LoadHistory history({0., 1., 2.}, {{0., 0.}, {1., 0.}, {1., 2.}});
  const BeyondRun run = follow_beyond(system, joint.elements, history, 2., {1., 2.});

  EXPECT_EQ(run.result.verdict, Verdict::limit_load);
  EXPECT_NEAR(run.result.t, 1. + 0.5 / std::cos(alpha), 2e-6);
  EXPECT_EQ(run.result.beyond.end, BeyondLimit::End::largest_jump);
  EXPECT_LE(run.record.worst.worst(), 1e-9);
  ASSERT_FALSE(run.record.beyond.empty());
  for (const JointState &state : run.record.beyond)
    {
      const double theta = std::atan2(state.forces[2], state.forces[1]);
      const double load  = 2. * (state.t - 1.);
      EXPECT_NEAR(load, std::cos(theta) / std::cos(alpha), 1e-9);
      EXPECT_NEAR(state.slips[0][1], load * std::sin(alpha) - 2. * std::sin(theta), 1e-9);
      const double slip = 2. * (std::log(std::tan(0.5 * theta_0) / std::tan(0.5 * theta)) +
                                std::cos(theta_0) - std::cos(theta)) +
                          std::tan(alpha) * (std::sin(theta_0) - std::sin(theta));
      EXPECT_NEAR(0.5 * theta * (state.slips[0][0] - slip), 0., 1e-9); // an error of θ
    }
}
