// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "parameter_wrong_input.h"

#include <fuga/input/parameters.h>
#include <fuga/input/read/read_parameters.h>

namespace fuga
{
  namespace
  {
    using testing_files::expect_explained;
    using testing_files::name_of;
    using testing_files::replaced;
    using testing_files::WrongInput;

    class WrongSafety : public testing::TestWithParam<WrongInput>
    {
    };

    TEST_P(WrongSafety, IsExplained)
    {
      expect_explained(GetParam());
    }

    const testing_files::Changes unchanged;

    const WrongInput wrong[] = {
      {"UnknownLoad",
       unchanged,
       {"Safety/Load factor=pusch"},
       {"Load factor = 'pusch'", "neither a load nor a stage", "push"}},
      {"NoLoad", unchanged, {"Safety/Load factor="}, {"Load factor"}},
      {"UnknownJoint",
       unchanged,
       {"Safety/Strength reduction=yes", "Safety/Joints=basis"},
       {"Joints = 'basis'", "no joint", "base"}},
      {"JointsWithoutReduction",
       unchanged,
       {"Safety/Joints=base"},
       {"Joints = 'base'", "Strength reduction = yes"}},
      {"FactorOfOne",
       unchanged,
       {"Safety/Load factor=push", "Safety/Largest factor=1"},
       {"Largest factor = '1'"}},
      {"WithoutStrength",
       {{"set Friction coefficient = 0.2", "set Friction coefficient = 0"}},
       {"Safety/Strength reduction=yes", "Safety/Joints=base"},
       {"Joints = 'base'", "nothing to reduce"}},
      {"MoreDilatancyThanFriction",
       {{"set Friction coefficient = 0.2",
         "set Friction coefficient = 0.2\nset Dilatancy angle = 5"}},
       {"Safety/Strength reduction=yes"},
       {"Largest factor = '10'", "create energy", "2.28"}},
      {"InASweep",
       unchanged,
       {"Safety/Load factor=push", "Sweep/Safety/Largest factor=2, 1"},
       {"Largest factor = '1'"}}};

    INSTANTIATE_TEST_SUITE_P(Safety, WrongSafety, testing::ValuesIn(wrong), name_of);

    // The searches stand after the stages of the file, the reduction first.
    TEST(ParameterSafety, IsRead)
    {
      const std::string file =
        testing_files::write_file("safety.prm", testing_files::example_prm());
      const Parameters plain = read_parameters(file);
      const Parameters read  = read_parameters(
        file,
        {"Safety/Strength reduction=yes", "Safety/Load factor=push", "Safety/Largest factor=4"});
      const std::size_t n = plain.model.stages.size();
      ASSERT_EQ(read.model.stages.size(), n + 2);
      EXPECT_EQ(read.model.stages[n].purpose, StagePurpose::strength_reduction);
      EXPECT_EQ(read.model.stages[n + 1].purpose, StagePurpose::load_factor);
      EXPECT_EQ(read.model.stages[n + 1].largest_factor, 4.);
      ASSERT_EQ(read.model.stages[n + 1].increased_loads.size(), 1u);
      EXPECT_EQ(read.model.loads[read.model.stages[n + 1].increased_loads[0]].name, "push");
      EXPECT_TRUE(read.joints.at(0).friction.reduced);
      EXPECT_FALSE(plain.joints.at(0).friction.reduced);
    }
  } // namespace
} // namespace fuga
