// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "parameter_test_files.h"

#include <fuga/base/errors.h>
#include <fuga/io/parameters.h>

#include <gtest/gtest.h>

using namespace fuga;

namespace
{
  std::string
  file()
  {
    return testing_files::write_file("sweep.prm", testing_files::example_prm());
  }

  std::string
  message(const std::vector<std::string> &overrides)
  {
    try
      {
        read_parameters(file(), overrides);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

TEST(Sweep, WithoutSectionThereIsNone)
{
  EXPECT_TRUE(read_parameters(file()).variants.empty());
}

// 3 x 2 combinations; the range 0.2 : 0.2 : 0.6 is 0.2, 0.4, 0.6. Friction varies fastest.
TEST(Sweep, AllCombinations)
{
  const Parameters parameters = read_parameters(
    file(),
    {"Sweep/Friction coefficient=0.2 : 0.2 : 0.6", "Sweep/Cohesion=0, 0.1", "Sweep/Joints=base"});
  ASSERT_EQ(parameters.variants.size(), 6u);
  const Variant &variant = parameters.variants[4];
  ASSERT_EQ(variant.settings.size(), 2u);
  EXPECT_EQ(variant.settings[0].first, "Cohesion");
  EXPECT_EQ(variant.settings[0].second, "0.1");
  EXPECT_EQ(variant.settings[1].second, "0.4");
  for (std::size_t j = 0; j < variant.joints.size(); ++j)
    {
      const bool varied = variant.joints[j].definition.name == "base";
      EXPECT_DOUBLE_EQ(variant.joints[j].friction.coefficient,
                       varied ? 0.4 : parameters.joints[j].friction.coefficient);
    }
}

TEST(Sweep, WrongValuesAreExplained)
{
  const std::vector<std::pair<std::string, std::string>> wrong = {
    {"Sweep/Friction coefficient=0.2, x", "'x' is not a number"},
    {"Sweep/Friction coefficient=-0.2", "negative"},
    {"Sweep/Friction coefficient=0.2 : 0.6", "first : step : last"},
    {"Sweep/Friction coefficient=0.2 : 0 : 0.6", "step > 0"},
    {"Sweep/Normal law=elastic", "no law 'elastic'"},
    {"Sweep/Load sequences=wieght", "no such stage"},
    {"Sweep/Frictions=0.1", "Friction coefficient"}};
  for (const auto &[override_text, sentence] : wrong)
    EXPECT_NE(message({override_text}).find(sentence), std::string::npos)
      << override_text << ": " << message({override_text});
  EXPECT_NE(message({"Sweep/Joints=bsae", "Sweep/Cohesion=1"}).find("no such joint"),
            std::string::npos);
}
