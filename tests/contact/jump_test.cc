// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Where no continuous path goes on: an equilibrium near by.

#include "contact/cone_toy.h"
#include "contact/lifted_problem.h"

#include <fuga/contact/path/slow_motion.h>
#include <fuga/contact/virgin_state.h>

namespace fuga::tests
{
  namespace
  {
    /** V10: one rigid node on [[1, -0.6], [-0.6, 1]], f = 2. */
    struct Node
    {
      Node() : joint(1, 1., make_rigid_law(), make_rigid_law(), {2., 0.})
      {
        system.S       = DenseMatrix(2, 2);
        system.S(0, 0) = system.S(1, 1) = 1.;
        system.S(0, 1) = system.S(1, 0) = -0.6;
        system.F                        = DenseMatrix(2, 2);
        system.F(0, 0) = system.F(1, 1) = 1.;
      }

      ToyJoint joint;
      ToySystem system;
    };

    /** Pressed, then pushed; @p observer hears of it. */
    PathResult
    run(const ContactSystem &system,
        const std::vector<ContactElement> &elements,
        const LoadHistory &history,
        const bool follow_jumps,
        PathObserver &observer)
    {
      const LayeredSystem layered(system, elements);
      PathOptions options;
      options.follow_jumps = follow_jumps;
      EventPath path(elements, layered, history, options);
      return path.run({1., 2.}, observer);
    }

    // On the strength of T = f|N| = 2, at t = 1 + 2/3, the shear grows and no rate goes on. Open,
    // S d = (-1, 2): d = (0.2, 1.4)/0.64. What is given off is ½ p·d with p = (-1, 2) before and
    // nothing after it; the loads of the judged state are those of 1e-6 later.
    void
    expect_jump(const PathResult &result)
    {
      EXPECT_TRUE(result.jump.found);
      EXPECT_NEAR(result.jump.t, 1. + 2. / 3., 1e-12);
      EXPECT_NEAR(result.jump.size, 1.4 / 0.64, 1e-5);
      EXPECT_NEAR(result.jump.released, 0.5 * (-0.2 + 2. * 1.4) / 0.64, 1e-5);
      // Sliding until N = -1 + 0.6 s = 0 under T = 2|N| takes 5/3; steps find less, and no more
      // than is given off.
      EXPECT_GT(result.jump.dissipated, 0.);
      EXPECT_LT(result.jump.dissipated, 5. / 3.);
    }

    const std::vector<Vector> loads = {{0., 0.}, {-1., 0.}, {-1., 3.}};
  } // namespace

  TEST(Jump, IsNamedWhereThePathStops)
  {
    const Node node;
    const LoadHistory history({0., 1., 2.}, loads);
    Record record(node.system, node.joint.elements, history);
    const PathResult result = run(node.system, node.joint.elements, history, false, record);
    EXPECT_EQ(result.verdict, Verdict::no_continuation);
    EXPECT_NEAR(result.t, 1. + 2. / 3., 1e-12);
    expect_jump(result);
  }

  TEST(Jump, IsFollowed)
  {
    const Node node;
    const LoadHistory history({0., 1., 2.}, loads);
    Record record(node.system, node.joint.elements, history);
    const PathResult result = run(node.system, node.joint.elements, history, true, record);
    EXPECT_EQ(result.verdict, Verdict::done);
    EXPECT_EQ(result.n_followed_jumps, 1u);
    expect_jump(result);
    ASSERT_FALSE(record.events.empty());
    EXPECT_EQ(record.events.back().to, ContactState::open);
    EXPECT_LT(record.worst.worst(), 1e-12);
    // S d = (-1, 3).
    EXPECT_NEAR(record.levels.back().dislocations[0], 0.8 / 0.64, 1e-12);
    EXPECT_NEAR(record.levels.back().dislocations[1], 2.4 / 0.64, 1e-12);
  }

  // In space, with tangents turned by any angle, and bars that are not the coordinates.
  TEST(Jump, IsFollowedInSpace)
  {
    const Node node;
    const LiftedProblem lifted(node.system, node.joint.elements);
    const LoadHistory history({0., 1., 2.}, loads);
    Record record(lifted.system, lifted.elements, history);
    const PathResult result = run(lifted.system, lifted.elements, history, true, record);
    EXPECT_EQ(result.verdict, Verdict::done);
    EXPECT_EQ(result.n_followed_jumps, 1u);
    EXPECT_NEAR(result.jump.released, 0.5 * (-0.2 + 2. * 1.4) / 0.64, 1e-5);
    EXPECT_LT(record.worst.worst(), 1e-12);
    ASSERT_FALSE(record.levels.empty());
    EXPECT_NEAR(record.levels.back().dislocations[0], 0.8 / 0.64, 1e-12);
    EXPECT_NEAR(
      length(tangential(lifted.elements[0], record.levels.back().dislocations)), 2.4 / 0.64, 1e-12);
  }

  // Where the path snaps the jump is as large after ever so little load, where it goes on it is
  // not: on f = 2, and on f = 1, below 1/0.6, from the same state of slip, T = -f N = f.
  TEST(Jump, ShowsInstabilityIfItStaysAsLarge)
  {
    for (const double friction : {2., 1.})
      {
        Node node;
        node.joint = ToyJoint(1, 1., make_rigid_law(), make_rigid_law(), {friction, 0.});
        const LayeredSystem layered(node.system, node.joint.elements);
        JointState state = virgin_state(node.joint.elements, 2, false);
        state.states[0]  = ContactState::slip_forward;
        state.forces     = {-1., friction};
        const auto jump  = [&](const double load) {
          Course course;
          course.length = course.t_end = load;
          course.factors               = {-1., friction};
          course.factor_rates          = {0., 1.};
          return find_equilibrium_nearby(node.joint.elements, layered, course, state)->jump;
        };
        Jump found        = jump(1e-6);
        found.size_nearer = jump(1e-8).size;
        // On the path N = -1 + 0.6 d and T = 1 + 1e-6 - d = -N.
        EXPECT_NEAR(found.size, friction == 2. ? 1.4 / 0.64 : 2.5e-6, 1e-5 * found.size);
        EXPECT_EQ(found.shows_instability(), friction == 2.);
      }
  }

  // A block that hangs above its base is held by nothing, and falls under the first millionth of
  // its load. It rests where it meets the base: the layer closes by no more than the load times its
  // compliance, and what is given off is the work of the load. Then it slides where the shear is
  // 0.4 of the load.
  TEST(Jump, BodyFallsOntoItsBase)
  {
    const std::size_t n  = 4;
    constexpr double gap = 0.3, load = 1e-6;
    ToyJoint joint = rigid_block_joint(n, 1., make_linear_law(1.), make_linear_law(1.), {0.4, 0.});
    for (ContactElement &element : joint.elements)
      element.initial_gap = gap;
    const ToySystem block = rigid_block(n, 1.);
    const LiftedProblem lifted(block, joint.elements);
    const LoadHistory history({0., 1., 2.}, {{0., 0., 0.}, {0., -1., 0.}, {0.8, -1., 0.}});
    const auto falls = [&](const ContactSystem &system,
                           const std::vector<ContactElement> &elements) {
      Record stopped(system, elements, history), record(system, elements, history);
      const PathResult end = run(system, elements, history, false, stopped);
      EXPECT_EQ(end.verdict, Verdict::no_continuation);
      EXPECT_EQ(end.mechanism, MechanismKind::closing);
      EXPECT_EQ(end.t, 0.);
      EXPECT_TRUE(end.jump.shows_instability());
      const PathResult result = run(system, elements, history, true, record);
      EXPECT_EQ(result.verdict, Verdict::limit_load);
      EXPECT_EQ(result.mechanism, MechanismKind::sliding);
      EXPECT_NEAR(result.t, 1.5, 1e-12);
      EXPECT_EQ(result.n_followed_jumps, 1u);
      for (const Jump &jump : {end.jump, result.jump})
        {
          EXPECT_NEAR(jump.size, gap, 10. * load);
          EXPECT_NEAR(jump.released, load * gap, 10. * load * load);
          EXPECT_NEAR(jump.dissipated, 0., 10. * load * load);
        }
      EXPECT_LT(record.worst.worst(), 1e-12);
      ASSERT_EQ(record.levels.size(), 1u);
      double pressed = 0.;
      for (const ContactElement &element : elements)
        pressed += record.levels.back().forces[element.normal_bar];
      EXPECT_NEAR(pressed, -1., 1e-12);
    };
    falls(block, joint.elements);
    falls(lifted.system, lifted.elements);
  }

  // A block that slides away rests nowhere.
  TEST(Jump, LimitLoadIsNone)
  {
    const std::size_t n = 4;
    const ToyJoint joint =
      rigid_block_joint(n, 1., make_linear_law(1.), make_linear_law(1.), {0.4, 0.});
    const ToySystem system = rigid_block(n, 1.);
    const LoadHistory history({0., 1., 2.}, {{0., 0., 0.}, {0., -1., 0.}, {0.8, -1., 0.}});
    Record record(system, joint.elements, history);
    const PathResult result = run(system, joint.elements, history, true, record);
    EXPECT_EQ(result.verdict, Verdict::limit_load);
    EXPECT_FALSE(result.jump.found);
    EXPECT_NEAR(result.t, 1.5, 1e-9);
  }
} // namespace fuga::tests
