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

    class WrongAccuracy : public testing::TestWithParam<WrongInput>
    {
    };

    TEST_P(WrongAccuracy, IsExplained)
    {
      expect_explained(GetParam());
    }

    const testing_files::Changes unchanged;
    const std::string pressure = "Target accuracy/Quantity=contact pressure";

    const WrongInput wrong[] = {
      {"UnknownQuantity",
       unchanged,
       {"Target accuracy/Quantity=stress"},
       {"Quantity = 'stress'", "contact pressure"}},
      {"ZeroError",
       unchanged,
       {pressure, "Target accuracy/Relative error=0"},
       {"Relative error = '0'"}},
      {"NoRounds",
       unchanged,
       {pressure, "Target accuracy/Largest number of rounds=0"},
       {"Largest number of rounds = '0'"}},
      {"UnknownJoint",
       unchanged,
       {pressure, "Target accuracy/Joints=basis"},
       {"Joints = 'basis'", "no joint", "base"}},
      {"WrongExpression",
       unchanged,
       {pressure, "Target accuracy/Where=abs(x <= 1"},
       {"Where = 'abs(x <= 1'"}},
      {"ExpressionOfTime", unchanged, {pressure, "Target accuracy/Where=x + t"}, {"Where", "t"}},
      {"WhereOfMonitor",
       unchanged,
       {"Target accuracy/Quantity=monitor", "Target accuracy/Where=1"},
       {"Where = '1'", "contact pressure"}},
      {"ComponentOfPressure",
       unchanged,
       {pressure, "Target accuracy/Components=N"},
       {"Components = 'N'", "resultant"}},
      {"UnknownComponent",
       unchanged,
       {"Target accuracy/Quantity=resultant", "Target accuracy/Components=N, V"},
       {"Components = 'N, V'", "no component 'V'"}},
      {"NoMonitors",
       unchanged,
       {"Target accuracy/Quantity=monitor"},
       {"Quantity = 'monitor'", "no monitors"}},
      {"JointsWithoutQuantity",
       unchanged,
       {"Target accuracy/Joints=base"},
       {"Joints = 'base'", "Quantity = none"}},
      {"InASweep",
       unchanged,
       {pressure, "Sweep/Friction coefficient=0.2, 0.3"},
       {"Quantity = 'contact pressure'", "Sweep"}},
      {"WithConstruction",
       unchanged,
       {pressure, "Bodies/dam/Built at stage=push"},
       {"Quantity = 'contact pressure'", "built or removed"}}};

    INSTANTIATE_TEST_SUITE_P(Accuracy, WrongAccuracy, testing::ValuesIn(wrong), name_of);

    TEST(ParameterAccuracy, IsRead)
    {
      const std::string file =
        testing_files::write_file("accuracy.prm", testing_files::example_prm());
      EXPECT_EQ(read_parameters(file).accuracy.quantity, AccuracyTarget::Quantity::none);

      const Parameters read = read_parameters(file,
                                              {pressure,
                                               "Target accuracy/Joints=wall",
                                               "Target accuracy/Where=y > q",
                                               "Target accuracy/Relative error=0.05"});
      EXPECT_EQ(read.accuracy.quantity, AccuracyTarget::Quantity::pressure);
      EXPECT_EQ(read.accuracy.items, std::vector<unsigned int>{1});
      EXPECT_EQ(read.accuracy.where, "y > q");
      EXPECT_EQ(read.accuracy.relative_error, 0.05);
      EXPECT_EQ(read.accuracy.max_unknowns, 1e6);
      EXPECT_EQ(read.accuracy.max_rounds, 20u);

      const Parameters resultant = read_parameters(
        file, {"Target accuracy/Quantity=resultant", "Target accuracy/Components=M"});
      EXPECT_EQ(resultant.accuracy.items, (std::vector<unsigned int>{0, 1}));
      EXPECT_EQ(resultant.accuracy.components, std::vector<unsigned int>{2});
    }
  } // namespace
} // namespace fuga
