// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "parameter_wrong_input.h"

#include <fuga/input/parameters.h>
#include <fuga/input/read/read_parameters.h>

namespace fuga
{
  namespace
  {
    using testing_files::example_prm;
    using testing_files::expect_explained;
    using testing_files::name_of;
    using testing_files::Texts;
    using testing_files::write_file;
    using testing_files::WrongInput;

    /** What motions beyond a limit load need. */
    const Texts continuation = {"Solver/Beyond limit load=dynamic",
                                "Dynamics/Time step=0.01",
                                "Dynamics/Damping ratio=0.05",
                                "Dynamics/Damping frequencies=2; 8"};

    Texts
    continuation_with(const Texts &more)
    {
      Texts all = continuation;
      all.insert(all.end(), more.begin(), more.end());
      return all;
    }

    Texts
    continuation_without(const std::size_t first, const std::size_t n)
    {
      Texts rest      = continuation;
      const auto from = rest.begin() + static_cast<std::ptrdiff_t>(first);
      rest.erase(from, from + static_cast<std::ptrdiff_t>(n));
      return rest;
    }

    TEST(ParameterContinuation, IsRead)
    {
      const Parameters parameters = read_parameters(
        write_file("continuation.prm", example_prm()),
        continuation_with({"Dynamics/Longest continuation=20", "Dynamics/Excess load=0.05"}));
      EXPECT_EQ(parameters.solver.beyond_limit, LimitLoadChoice::dynamic);
      EXPECT_TRUE(may_move(parameters));
      const DynamicsDefinition &dynamics = parameters.model.dynamics;
      EXPECT_EQ(dynamics.longest_continuation, 20.);
      EXPECT_EQ(dynamics.end_of_continuation(1.5), 1.55);
      EXPECT_EQ(dynamics.end_of_continuation(1.9375), 1.96875); // half of the rest of the stage
      EXPECT_FALSE(may_move(read_parameters(write_file("slow.prm", example_prm()))));
    }

    class WrongContinuation : public testing::TestWithParam<WrongInput>
    {
    };

    TEST_P(WrongContinuation, IsExplained)
    {
      expect_explained(GetParam());
    }

    const std::string chosen = "Beyond limit load = 'dynamic'";

    const WrongInput wrong_continuations[] = {
      {"NoTimeStepToMoveBy",
       {},
       continuation_without(1, 1),
       {chosen, "'Dynamics/Time step' is missing"}},
      {"NoDamping",
       {},
       continuation_without(2, 2),
       {chosen, "'Dynamics/Damping ratio' is missing", "never come to rest"}},
      {"NoInertia",
       {},
       continuation_with({"Dynamics/Massless bodies=dam"}),
       {chosen, "no body has inertia", "Weight density"}},
      {"TooLong",
       {},
       continuation_with({"Dynamics/Longest continuation=1e6"}),
       {"Longest continuation = '1e6'", "1e+08", "Time step"}},
      {"NothingAbsorbs",
       {},
       continuation_with({"Dynamics/Absorbing boundaries=sides"}),
       {"Absorbing boundaries = 'sides'", "no stage has a Duration", "supports hold"}},
      {"ContinuationOfStageEnds",
       {},
       continuation_with({"Solver/Follow=stage ends"}),
       {chosen, "'Follow = stage ends'"}},
      {"ContinuationWithoutStiffness",
       {},
       continuation_with({"Solver/Bodies=iterative matrix-free"}),
       {chosen, "'Bodies = iterative matrix-free'"}},
      {"ContinuationsOfASweep",
       {},
       continuation_with({"Sweep/Joints/base/Friction coefficient=0.2, 0.3"}),
       {chosen, "sweep"}},
      {"AccuracyOfAContinuation",
       {},
       continuation_with({"Target accuracy/Quantity=resultant"}),
       {"Quantity = 'resultant'", "Beyond limit load = dynamic"}}};

    INSTANTIATE_TEST_SUITE_P(Continuation,
                             WrongContinuation,
                             testing::ValuesIn(wrong_continuations),
                             name_of);
  } // namespace
} // namespace fuga
