// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Ten thousand load cycles: the last one is as the second.

#include "contact/cycle_record.h"
#include "contact/pull_out_bar.h"
#include "known_answer.h"

#include <gtest/gtest.h>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  constexpr std::size_t n_cycles = 10000;
} // namespace

// V5, n = 100. The loss of the chain: independent.json, 7.6e-4 (two digits) above the closed form.
TEST(LargeCycles, PullOut)
{
  const PullOutBar bar(100, 200.);
  const double P0 = 3. * PullOutBar::first_slip(), W = PullOutBar::loss_per_cycle(P0);
  const LayeredSystem layered(bar.system, bar.joint.elements);
  const LoadHistory history = cyclic_history(n_cycles, {1., -P0}, {1., P0}, {1., P0});
  EventPath path(bar.joint.elements, layered, history, {});
  CycleRecord record(bar.system, bar.joint.elements, history);
  EXPECT_EQ(path.run(whole_numbers(1 + 2 * n_cycles), record).verdict, Verdict::done);
  expect_steady_cycles(record, bar.joint.elements, W);
  expect_answer({"V5 pull-out of a bar", "W of cycle 10000, n = 100", W, "closed form"},
                record.loss.back(),
                7.65e-4 * W);
  expect_answer({"V5 pull-out of a bar", "W of cycle 10000 over W of cycle 2", 1., "no drift"},
                record.loss.back() / record.loss[1],
                1e-9);
}

// V6, Jenkins element beside a spring, as in Cycles.JenkinsElement: 4 fN (U - fN/k_t) = 0.348.
TEST(LargeCycles, JenkinsElement)
{
  const ToyJoint joint(1, 1., make_rigid_law(), make_linear_law(1. / 5.), {0.3, 0.});
  const ToySystem system = spring_beside_joint(2.);
  const LayeredSystem layered(system, joint.elements);
  const LoadHistory history = cyclic_history(n_cycles, {1., -1.}, {1., 1.}, {1., 1.});
  EventPath path(joint.elements, layered, history, {});
  CycleRecord record(system, joint.elements, history);
  EXPECT_EQ(path.run(whole_numbers(1 + 2 * n_cycles), record).verdict, Verdict::done);
  expect_steady_cycles(record, joint.elements, 0.348);
  expect_answer({"V6 Jenkins element", "loss of cycle 10000", 0.348, "closed form"},
                record.loss.back(),
                1e-9 * 0.348);
}

// V6, ratchet of the rocking block: 0.3 of advance and 0.27 of loss, for ever.
TEST(LargeCycles, RatchetOfRockingBlock)
{
  const ToyJoint joint(2, 1., make_linear_law(1.), make_linear_law(0.5), {0.6, 0.});
  const ToySystem system = rigid_block(1, 1.);
  const LayeredSystem layered(system, joint.elements);
  const LoadHistory history =
    cyclic_history(n_cycles, {0.9, -2., 0.5}, {0.9, -2., -0.5}, {0.9, -2., 0.});
  EventPath path(joint.elements, layered, history, {});
  CycleRecord record(system, joint.elements, history);
  EXPECT_EQ(path.run(whole_numbers(1 + 2 * n_cycles), record).verdict, Verdict::done);
  expect_steady_cycles(record, joint.elements, 0.27, 0.3);
  expect_answer({"V6 rocking block", "loss of cycle 10000", 0.27, "closed form"},
                record.loss.back(),
                1e-9 * 0.27);
  expect_answer({"V6 rocking block", "advance in cycles 3 to 10000", 0.3 * 9998., "closed form"},
                record.last.slips[0][0] - record.end_of_second.slips[0][0],
                1e-10 * 3000.);
}
