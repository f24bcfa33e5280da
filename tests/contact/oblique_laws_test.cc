// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Three elements with every law between random bodies, under loads whose directions turn: the judge
// finds nothing wrong.

#include "contact/cone_toy.h"
#include "contact/plane_scenes.h"

using namespace fuga;
using namespace fuga::tests;

namespace
{
  class ObliqueLaws : public testing::TestWithParam<SceneCase>
  {
  };
} // namespace

// The bound of the certificate is the program's own.
TEST_P(ObliqueLaws, HaveRightPaths)
{
  std::size_t n_events = 0;
  for (const unsigned int seed : {1, 2, 3, 4, 5})
    {
      SCOPED_TRACE(seed);
      const PlaneScene scene = oblique_scene(GetParam(), seed);
      const ConeRun run(scene.system, scene.elements, scene.history, scene.levels);
      EXPECT_EQ(run.result.verdict, Verdict::done);
      n_events += run.record.events.size();
      for (const auto &[name, value] : run.record.worst.entries())
        EXPECT_LE(value, 1e-9) << name;
    }
  EXPECT_GT(n_events, 10u);
}

INSTANTIATE_TEST_SUITE_P(Laws, ObliqueLaws, testing::ValuesIn(scene_cases()), name_of_case);
