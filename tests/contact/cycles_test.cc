// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/cycle_record.h"
#include "known_answer.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::tests;

// V6, Jenkins element beside a spring k under ±F0: U = (F0 - fN)/k, loss per cycle 4 fN (U -
// fN/k_t), closed form. k = 2, k_t = 5, fN = 0.3, F0 = 1: U = 0.35, loss 0.348.
TEST(Cycles, JenkinsElement)
{
  const std::size_t n_cycles = 50;
  const ToyJoint joint(1, 1., make_rigid_law(), make_linear_law(1. / 5.), {0.3, 0.});
  const ToySystem system = spring_beside_joint(2.);
  const LayeredSystem layered(system, joint.elements);
  const LoadHistory history = cyclic_history(n_cycles, {1., -1.}, {1., 1.}, {1., 1.});
  EventPath path(joint.elements, layered, history, {});
  class LossRecord : public Record
  {
  public:
    using Record::Record;
    std::vector<double> loss, jump;

    void
    reached(const std::size_t index, const JointState &state) override
    {
      Record::reached(index, state);
      loss.push_back(judge.energies().dissipation);
      jump.push_back(state.dislocations[1] + state.forces[1] / 5.);
    }
  };
  LossRecord record(system, joint.elements, history);
  const PathResult result = path.run(whole_numbers(1 + 2 * n_cycles), record);
  EXPECT_EQ(result.verdict, Verdict::done);
  EXPECT_LE(record.worst.worst(), 1e-12);
  const double tolerance = 1e-12; // a few roundings of numbers of order one per cycle
  for (std::size_t cycle = 1; cycle <= n_cycles; ++cycle)
    {
      EXPECT_NEAR(record.loss[2 * cycle] - record.loss[2 * cycle - 2], 0.348, tolerance);
      EXPECT_NEAR(record.jump[2 * cycle], 0.35, tolerance);
      EXPECT_NEAR(record.jump[2 * cycle - 1], -0.35, tolerance);
    }
}

// V6, rocking block on two bars: N0(1 ± β) alternates, Q constant. D = Q - 2 f N0 (1 - β) > 0: the
// block advances 2D/k_t per cycle and loses 2QD/k_t, for ever; Q = 0.9, N0 = 1, β = 0.5, f = 0.6,
// k_t = 2: 0.3 and 0.27. Bars at ±1/2, so the moment that moves N by βN0 is βN0.
TEST(Cycles, RatchetOfRockingBlock)
{
  const std::size_t n_cycles = 40;
  const ToyJoint joint(2, 1., make_linear_law(1.), make_linear_law(0.5), {0.6, 0.});
  const ToySystem system = rigid_block(1, 1.);
  const LayeredSystem layered(system, joint.elements);
  const LoadHistory history =
    cyclic_history(n_cycles, {0.9, -2., 0.5}, {0.9, -2., -0.5}, {0.9, -2., 0.});
  EventPath path(joint.elements, layered, history, {});
  Record record(system, joint.elements, history);
  const PathResult result = path.run(whole_numbers(1 + 2 * n_cycles), record);
  EXPECT_EQ(result.verdict, Verdict::done);
  EXPECT_LE(record.worst.worst(), 1e-12);
  const double tolerance = 1e-11; // the advance grows to 12 in 40 cycles
  for (std::size_t cycle = 3; cycle <= n_cycles; ++cycle)
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(record.levels[2 * cycle].slips[k][0] - record.levels[2 * cycle - 2].slips[k][0],
                  0.3,
                  tolerance);
}

// V6, shakedown: the Jenkins element with F0 ≤ fN(1 + k/k_t) = 0.42 never slips again after the
// first loading (here never at all; at 0.42 itself the limit is touched in every cycle).
TEST(Cycles, JenkinsElementShakesDown)
{
  for (const double F0 : {0.3, 0.42})
    {
      const std::size_t n_cycles = 50;
      const ToyJoint joint(1, 1., make_rigid_law(), make_linear_law(1. / 5.), {0.3, 0.});
      const ToySystem system = spring_beside_joint(2.);
      const LayeredSystem layered(system, joint.elements);
      const LoadHistory history = cyclic_history(n_cycles, {1., -F0}, {1., F0}, {1., F0});
      EventPath path(joint.elements, layered, history, {});
      CycleRecord record(system, joint.elements, history);
      EXPECT_EQ(path.run(whole_numbers(1 + 2 * n_cycles), record).verdict, Verdict::done);
      EXPECT_LE(record.worst.worst(), 1e-12);
      for (const double loss : record.loss)
        EXPECT_NEAR(loss, 0., 1e-14);
      EXPECT_NEAR(record.last.slips[0][0], 0., 1e-14);
    }
}

// V6, shakedown of the rocking block: D = Q - 2 f N0 (1 - β) ≤ 0. f = 1 gives D = -0.1, f = 0.9
// gives D = 0, where both bars touch their limits in every cycle. What slips in the first cycles
// stays; then nothing is lost any more.
TEST(Cycles, RockingBlockShakesDown)
{
  for (const double f : {0.9, 1.})
    {
      const std::size_t n_cycles = 50;
      const ToyJoint joint(2, 1., make_linear_law(1.), make_linear_law(0.5), {f, 0.});
      const ToySystem system = rigid_block(1, 1.);
      const LayeredSystem layered(system, joint.elements);
      const LoadHistory history =
        cyclic_history(n_cycles, {0.9, -2., 0.5}, {0.9, -2., -0.5}, {0.9, -2., 0.});
      EventPath path(joint.elements, layered, history, {});
      CycleRecord record(system, joint.elements, history);
      EXPECT_EQ(path.run(whole_numbers(1 + 2 * n_cycles), record).verdict, Verdict::done);
      EXPECT_LE(record.worst.worst(), 1e-12);
      // Some roundings of numbers of order one; 0.27 where the block ratchets.
      for (std::size_t cycle = 1; cycle < n_cycles; ++cycle)
        EXPECT_NEAR(record.loss[cycle], 0., 1e-14) << f << ' ' << cycle;
      for (const std::size_t k : {0u, 1u})
        EXPECT_NEAR(record.last.slips[k][0], record.end_of_second.slips[k][0], 1e-13);
      expect_answer({"V6 rocking block",
                     fmt::format("loss of cycle 50 with D = {:.1f}", 0.9 - f),
                     0.,
                     "closed form (shakedown)"},
                    record.loss.back(),
                    1e-14);
    }
}

// Cohesion lost at opening. One element, springs k_n = k_t = 1, rigid layer, f = 0, c A = 2;
// sheared to T = 1 while pressed, then pulled open: at the load that takes N to zero the bond
// breaks and the shear spring takes over the whole T = 1, so the tangential jump is 1 from then on,
// and the loss is ½ T²/k_t = ½.
TEST(Cohesion, IsGivenUpAtOpening)
{
  const ToyJoint joint(1, 1., make_rigid_law(), make_rigid_law(), {0., 2.});
  ToySystem system;
  system.S       = DenseMatrix(2, 2);
  system.S(0, 0) = system.S(1, 1) = 1.;
  system.F                        = DenseMatrix(2, 2);
  system.F(0, 0) = system.F(1, 1) = 1.;
  const LayeredSystem layered(system, joint.elements);
  const LoadHistory history({0., 1., 2., 3.}, {{0., 0.}, {-1., 1.}, {1., 1.}, {-1., 1.}});
  EventPath path(joint.elements, layered, history, {});
  Record record(system, joint.elements, history);
  const PathResult result = path.run({1., 2., 3.}, record);
  EXPECT_EQ(result.verdict, Verdict::done);
  EXPECT_LE(record.worst.worst(), 1e-13);
  ASSERT_GE(record.events.size(), 2u);
  EXPECT_NEAR(record.events[0].t, 1.5, 1e-14);
  EXPECT_EQ(record.events[0].to, ContactState::open);
  EXPECT_NEAR(record.levels[1].dislocations[0], 1., 1e-14);
  EXPECT_NEAR(record.levels[1].dislocations[1], 1., 1e-14);
  EXPECT_NEAR(record.judge.energies().dissipation, 0.5, 1e-14);
  // Closed again it has no bond: no shear comes back.
  EXPECT_NEAR(record.levels[2].forces[1], 0., 1e-14);
}
