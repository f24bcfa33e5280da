// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// The judge of space says of a plane path, put into space with turned tangents, what the judge of
// the plane says: of right states, and of wrong ones, so that every condition of the plane stands
// in space too.

#include "contact/lifted_problem.h"
#include "contact/plane_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  /** Share by which what is planted is wrong. */
  constexpr double error = 1e-3;

  void
  expect_same(const double of_space, const double of_plane, const std::string_view name)
  {
    if (of_space == of_plane) // infinite, too
      return;
    // Two evaluations of the same sums, whose terms are of the order of one, in turned frames.
    EXPECT_NEAR(of_space, of_plane, 1e-12 + 1e-9 * std::abs(of_plane)) << name;
  }

  void
  expect_same(const Judge &space, const Judge &plane)
  {
    const JudgeMemory &a = space.memory(), &b = plane.memory();
    expect_same(a.ledger.external_work, b.ledger.external_work, "external work");
    expect_same(a.ledger.bodies, b.ledger.bodies, "bodies");
    expect_same(a.ledger.layer, b.ledger.layer, "layer");
    expect_same(a.ledger.dissipation, b.ledger.dissipation, "dissipation");
    expect_same(a.largest_force, b.largest_force, "largest force");
    expect_same(a.largest_jump, b.largest_jump, "largest jump");
    for (std::size_t k = 0; k < a.element_dissipation.size(); ++k)
      expect_same(a.element_dissipation[k], b.element_dissipation[k], "dissipation of an element");
  }

  /** Has a plane path judged in both ways. */
  class BothJudges : public PathObserver
  {
  public:
    explicit BothJudges(const PlaneScene &scene)
      : lifted(scene.system, scene.elements)
      , plane(scene.system, scene.elements, scene.history)
      , space(lifted.system, lifted.elements, scene.history)
    {
    }

    LiftedProblem lifted;
    Judge plane, space;
    Certificate worst;
    std::size_t n_planted = 0, n_events = 0;

    void
    advanced(const PathPoint &from, const PathPoint &to, const double length) override
    {
      plant_on_the_way(from, to, length);
      plane.follow(from, to, length);
      space.follow(LiftedProblem::lift(from), LiftedProblem::lift(to), length);
    }

    void
    jumped(const JointState &) override
    {
      plane.lose_track();
      space.lose_track();
    }

    void
    changed(const std::vector<ContactEvent> &events, const JointState &state) override
    {
      n_events += events.size();
      reached(0, state);
    }

    void
    reached(const std::size_t, const JointState &state) override
    {
      worst.absorb(compare(plane, space, state));
      plant(state);
    }

  private:
    /** What both say of a state; that of the plane. */
    Certificate
    compare(Judge &in_plane, Judge &in_space, const JointState &state) const
    {
      const Certificate a = in_plane.judge(state), b = in_space.judge(LiftedProblem::lift(state));
      for (std::size_t i = 0; i < a.entries().size(); ++i)
        expect_same(b.entries()[i].second, a.entries()[i].second, a.entries()[i].first);
      expect_same(in_space, in_plane);
      return a;
    }

    void
    disturb(double &value)
    {
      value *= 1. + std::uniform_real_distribution<double>(-error, error)(random);
    }

    void
    disturb(Vector &values)
    {
      for (double &value : values)
        disturb(value);
    }

    void
    count(const Certificate &found)
    {
      if (found.worst() > 1e-6)
        ++n_planted;
    }

    void
    plant(const JointState &state)
    {
      for (int what = 0; what < 6; ++what)
        {
          JointState wrong = state;
          switch (what)
            {
              case 0:
                disturb(wrong.forces);
                break;
              case 1:
                disturb(wrong.dislocations);
                break;
              case 2:
                for (TangentVector &slip : wrong.slips)
                  disturb(slip[0]);
                break;
              case 3:
                disturb(wrong.dilations);
                break;
              case 4:
                disturb(wrong.unreleased);
                break;
              default:
                for (Strength &strength : wrong.strengths)
                  disturb(strength.tension);
            }
          Judge wrong_plane = plane, wrong_space = space;
          count(compare(wrong_plane, wrong_space, wrong));
        }
    }

    void
    plant_on_the_way(const PathPoint &from, const PathPoint &to, const double length)
    {
      for (int what = 0; what < 4; ++what)
        {
          PathPoint wrong = to;
          switch (what)
            {
              case 0:
                disturb(wrong.state.forces);
                break;
              case 1:
                for (TangentVector &slip : wrong.state.slips)
                  disturb(slip[0]);
                break;
              case 2:
                disturb(wrong.state.dilations);
                break;
              default:
                disturb(wrong.rates.forces);
            }
          Judge wrong_plane = plane, wrong_space = space;
          wrong_plane.follow(from, wrong, length);
          wrong_space.follow(LiftedProblem::lift(from), LiftedProblem::lift(wrong), length);
          count(compare(wrong_plane, wrong_space, to.state));
        }
    }

    std::mt19937 random{1};
  };

  class LiftedScenes : public testing::TestWithParam<SceneCase>
  {
  };
} // namespace

TEST_P(LiftedScenes, SaysInSpaceWhatItSaysInThePlane)
{
  std::size_t n_events = 0;
  for (const unsigned int seed : {1, 2, 3})
    {
      SCOPED_TRACE(seed);
      const PlaneScene scene = make_scene(GetParam(), seed);
      const LayeredSystem layered(scene.system, scene.elements);
      EventPath path(scene.elements, layered, scene.history, scene.options);
      BothJudges judges(scene);
      const PathResult result = path.run(scene.levels, judges);
      EXPECT_EQ(result.verdict, Verdict::done);
      for (const auto &[name, value] : judges.worst.entries())
        EXPECT_LE(value, 1e-9) << name;
      EXPECT_GT(judges.n_planted, 20u);
      n_events += judges.n_events;
    }
  EXPECT_GT(n_events, 10u);
}

INSTANTIATE_TEST_SUITE_P(Laws, LiftedScenes, testing::ValuesIn(scene_cases()), name_of_case);

// A block that is pushed off, or loses its strength, under loads that stay: what the judge says of
// its motion and of wrong ones, and the motion that it finds itself.
TEST(LiftedJudge, JudgesMechanismsAsInThePlane)
{
  for (const bool reduction : {false, true})
    for (const double cohesion : {0., 0.05})
      {
        FrictionLaw law;
        law.coefficient = 0.3;
        law.cohesion    = cohesion;
        law.reduced     = reduction;
        const ToyJoint joint =
          rigid_block_joint(4, 1., make_linear_law(1.), make_linear_law(1.), law);
        const ToySystem block = rigid_block(4, 1.);
        const double push     = reduction ? 0.2 : 1.;
        const LoadHistory history(
          {0., 1., 2., 3.},
          {{0., 0., 0.}, {0., -1., -0.05}, {push, -1., -0.05}, {push, -1., -0.05}},
          {1., 1., 1., reduction ? 0.1 : 1.});
        const LayeredSystem layered(block, joint.elements);
        Record record(block, joint.elements, history);
        EventPath path(joint.elements, layered, history, {});
        const PathResult result = path.run({}, record);
        ASSERT_EQ(result.verdict, Verdict::limit_load);
        const LiftedProblem lifted(block, joint.elements);
        Judge space(lifted.system, lifted.elements, history);
        const JointState state = record.last, state_in_space = LiftedProblem::lift(state);
        space.judge(state_in_space);

        for (int wrong = 0; wrong < 4; ++wrong)
          {
            // Backwards; rising or turning besides.
            Vector motion = result.mechanism_jumps;
            for (std::size_t bar = 0; bar < motion.size(); ++bar)
              motion[bar] += wrong == 0   ? 0.
                             : wrong == 1 ? -2. * motion[bar]
                                          : 0.1 * block.B(bar, wrong - 1);
            const MechanismCertificate a = record.judge.judge_mechanism(state, motion),
                                       b = space.judge_mechanism(state_in_space,
                                                                 LiftedProblem::lift(motion));
            EXPECT_EQ(a.proves(), wrong == 0);
            expect_same(b.inadmissible, a.inadmissible, "inadmissible");
            expect_same(b.balance, a.balance, "balance");
            expect_same(b.drive, a.drive, "drive");
          }
        for (const Judge::Motions motions :
             {Judge::Motions::possible, Judge::Motions::resisted_by_none})
          {
            const std::optional<Vector> a = record.judge.driven_motion(state, motions),
                                        b = space.driven_motion(state_in_space, motions);
            ASSERT_TRUE(a && b);
            const Vector expected = LiftedProblem::lift(*a);
            double largest        = 0.;
            for (const double jump : expected)
              largest = std::max(largest, std::abs(jump));
            for (std::size_t bar = 0; bar < expected.size(); ++bar)
              EXPECT_NEAR((*b)[bar], expected[bar] / largest, 1e-9);
          }
      }
}
