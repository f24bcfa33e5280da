// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/beyond_record.h"

#include "contact/cone_toy.h"
#include "contact/lifted_problem.h"

namespace fuga::tests
{
  BeyondRun
  follow_beyond(const ContactSystem &system,
                const std::vector<ContactElement> &elements,
                const LoadHistory &history,
                const double largest_jump,
                const std::vector<double> &levels)
  {
    PathOptions options;
    options.beyond_limit = true;
    options.beyond_jump  = largest_jump;
    const LayeredSystem layered(system, elements);
    EventPath path(elements, layered, history, options);
    BeyondRun run{{}, BeyondRecord(system, elements, history)};
    run.result = path.run(levels, run.record);
    return run;
  }

  BeyondRun
  follow_beyond_in_plane_and_space(const ToySystem &system,
                                   const std::vector<ContactElement> &elements,
                                   const LoadHistory &history,
                                   const double largest_jump,
                                   const std::vector<double> &levels)
  {
    constexpr double rounding = 1e-11; // of numbers of order one, in a turned frame
    const BeyondRun plane     = follow_beyond(system, elements, history, largest_jump, levels);
    const LiftedProblem lifted(system, elements);
    const BeyondRun space =
      follow_beyond(lifted.system, lifted.elements, history, largest_jump, levels);
    EXPECT_EQ(space.result.verdict, plane.result.verdict);
    EXPECT_NEAR(space.result.t, plane.result.t, rounding);
    EXPECT_EQ(space.result.beyond.end, plane.result.beyond.end);
    EXPECT_NEAR(space.result.beyond.length, plane.result.beyond.length, rounding);
    EXPECT_LE(space.record.worst.worst(), 1e-11);
    EXPECT_EQ(space.record.beyond.size(), plane.record.beyond.size());
    for (std::size_t i = 0; i < std::min(space.record.beyond.size(), plane.record.beyond.size());
         ++i)
      {
        const JointState &state   = space.record.beyond[i];
        const JointState expected = LiftedProblem::lift(plane.record.beyond[i]);
        EXPECT_NEAR(space.record.lengths[i], plane.record.lengths[i], rounding);
        EXPECT_NEAR(state.t, expected.t, rounding);
        EXPECT_LT(largest_difference(state.forces, expected.forces), rounding);
        EXPECT_LT(largest_difference(state.dislocations, expected.dislocations), rounding);
      }
    return plane;
  }
} // namespace fuga::tests
