// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "parameter_test_files.h"

#include <fuga/base/errors.h>
#include <fuga/input/parameters.h>
#include <fuga/input/read/read_parameters.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;

namespace
{
  std::string
  file(const std::string &text = testing_files::example_prm())
  {
    return testing_files::write_file("sweep.prm", text);
  }

  Parameters
  read(const std::vector<std::string> &overrides)
  {
    return read_parameters(file(), overrides);
  }

  std::string
  message(const std::vector<std::string> &overrides, const std::string &text = {})
  {
    try
      {
        read_parameters(text.empty() ? file() : file(text), overrides);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }

  std::vector<std::vector<std::string>>
  settings(const Parameters &parameters)
  {
    std::vector<std::vector<std::string>> result;
    for (const Variant &variant : parameters.variants)
      result.push_back(variant.settings);
    return result;
  }

  using Settings = std::vector<std::vector<std::string>>;
} // namespace

TEST(Sweep, WithoutSectionThereIsNone)
{
  const Parameters parameters = read({});
  EXPECT_TRUE(parameters.variants.empty());
  EXPECT_FALSE(parameters.of_sweep);
}

// 3 x 2 combinations; the range 0.2 : 0.2 : 0.6 is 0.2, 0.4, 0.6. The last line varies fastest.
TEST(Sweep, AllCombinations)
{
  const Parameters parameters = read(
    {"Sweep/Joints/base/Friction coefficient=0.2 : 0.2 : 0.6", "Sweep/Joints/*/Cohesion=0, q"});
  ASSERT_EQ(parameters.variants.size(), 6u);
  ASSERT_EQ(parameters.swept.size(), 2u);
  EXPECT_EQ(parameters.swept[0].name, "Joints/base/Friction coefficient");
  EXPECT_EQ(parameters.swept[0].unit, "");
  EXPECT_EQ(parameters.swept[1].name, "Joints/*/Cohesion");
  EXPECT_EQ(parameters.swept[1].unit, "MPa");
  const Variant &variant = parameters.variants[3];
  EXPECT_EQ(variant.settings, (std::vector<std::string>{"0.4", "0.0144"})); // q of the example
  EXPECT_DOUBLE_EQ(variant.joints[0].friction.coefficient, 0.4);
  EXPECT_DOUBLE_EQ(variant.joints[1].friction.coefficient, 1.); // tan 45
  for (const JointParameters &joint : variant.joints)
    EXPECT_DOUBLE_EQ(joint.friction.cohesion, 0.0144);
  // The bodies do not feel any of it.
  EXPECT_EQ(parameters.condensations.size(), 1u);
}

TEST(Sweep, InStep)
{
  const Parameters parameters = read({"Sweep/Joints/base/Friction angle=10, 20",
                                      "Sweep/Bodies/dam/Young modulus=3000, 2*3000",
                                      "Sweep/Combination=in step"});
  EXPECT_EQ(settings(parameters), (Settings{{"10", "3000"}, {"20", "6000"}}));
  EXPECT_EQ(parameters.swept[0].unit, "degrees");
  EXPECT_EQ(parameters.swept[1].unit, "MPa");
  ASSERT_EQ(parameters.condensations.size(), 2u);
  EXPECT_EQ(parameters.condensations[1]->model.materials[0].young_modulus, 6000.);
  // An angle takes the place of the coefficient of the file.
  EXPECT_NEAR(parameters.variants[1].joints[0].friction.coefficient,
              std::tan(20. * std::acos(-1.) / 180.),
              1e-15);
}

// Variants with the same condensation follow one another, whatever the order of the lines.
TEST(Sweep, CondensationsInOrder)
{
  const Parameters parameters = read({"Sweep/Joints/base/Friction coefficient=0.3, 0.4",
                                      "Sweep/Bodies/dam/Young modulus=3000, 6000"});
  EXPECT_EQ(settings(parameters),
            (Settings{{"0.3", "3000"}, {"0.4", "3000"}, {"0.3", "6000"}, {"0.4", "6000"}}));
  ASSERT_EQ(parameters.condensations.size(), 2u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(parameters.variants[i].condensation, i / 2);
  // So do those with the same layer within one condensation.
  EXPECT_EQ(settings(read({"Sweep/Joints/base/Friction coefficient=0.3, 0.4",
                           "Sweep/Joints/base/Normal compliance=1e-4, 2e-4"})),
            (Settings{{"0.3", "1e-4"}, {"0.4", "1e-4"}, {"0.3", "2e-4"}, {"0.4", "2e-4"}}));
}

// A joint without shear strength has no tangential bars, hence a condensation of its own.
TEST(Sweep, FrictionOfZeroIsAnotherModel)
{
  EXPECT_EQ(read({"Sweep/Joints/base/Friction coefficient=0, 0.1, 0.2"}).condensations.size(), 2u);
}

// A constant reaches everything that is written with it; values may be tables and coordinates.
TEST(Sweep, ConstantsAndTexts)
{
  const Parameters constants = read({"Sweep/Constants/q=0.01, 0.02"});
  ASSERT_EQ(constants.condensations.size(), 2u);
  EXPECT_EQ(constants.condensations[1]->model.constants.at("q"), 0.02);
  const Parameters points = read({"Sweep/Loads/crane/Point=4, 12 | 2, 12"});
  ASSERT_EQ(points.condensations.size(), 2u);
  EXPECT_EQ(points.condensations[1]->model.loads[2].coordinates,
            (std::array<double, 3>{{2., 12., 0.}}));
  EXPECT_EQ(settings(read({"Sweep/Loads/push/Value=max(0, q), q*x"})),
            (Settings{{"max(0, q)"}, {"q*x"}}));
  EXPECT_EQ(settings(read({"Sweep/Mesh/Refinements=q/q : 1 : 2"})), (Settings{{"1"}, {"2"}}));
  EXPECT_EQ(read({"Sweep/Mesh/Assumption=plane stress, plane strain"}).condensations.size(), 2u);
}

TEST(Sweep, OrderOfStages)
{
  const Parameters parameters = read({"Sweep/Stages=push, weight | weight"});
  ASSERT_EQ(parameters.condensations.size(), 2u);
  EXPECT_EQ(settings(parameters), (Settings{{"push, weight"}, {"weight"}}));
  EXPECT_EQ(parameters.condensations[0]->model.stages[0].name, "push");
  EXPECT_EQ(parameters.condensations[0]->model.stages[1].name, "weight");
  EXPECT_EQ(parameters.condensations[1]->model.stages.size(), 1u);
}

// Entries of all joints by their own names, and a list of the joints.
TEST(Sweep, OlderForms)
{
  const Parameters older = read({"Sweep/Friction coefficient=0.2, 0.3",
                                 "Sweep/Joints=base",
                                 "Sweep/Load sequences=weight; weight, push"});
  const Parameters today =
    read({"Sweep/Joints/base/Friction coefficient=0.2, 0.3", "Sweep/Stages=weight | weight, push"});
  EXPECT_EQ(settings(older), settings(today));
  EXPECT_EQ(older.swept[0].today, "Joints/base/Friction coefficient = ...");
  EXPECT_EQ(older.swept[1].today, "Stages = weight | weight, push");
  EXPECT_EQ(today.swept[0].today, "");
}

// Subsections inside of Sweep, and the echo, which is a parameter file.
TEST(Sweep, NestedSections)
{
  const std::string text = testing_files::example_prm() +
                           "subsection Sweep\n  subsection Joints\n    subsection base\n"
                           "      set Cohesion = 0, 0.1\n    end\n  end\n"
                           "  set Bodies/dam/Poisson ratio = 0.1, 0.2\nend\n";
  const Parameters parameters = read_parameters(file(text));
  EXPECT_EQ(parameters.swept[0].name, "Joints/base/Cohesion");
  EXPECT_EQ(parameters.swept[1].name, "Bodies/dam/Poisson ratio");
  const std::string echo = echo_json(parameters);
  const Parameters again = read_parameters(testing_files::write_file("sweep.json", echo));
  EXPECT_EQ(settings(again), settings(parameters));
  EXPECT_EQ(echo_json(again), echo);
}

// The line of the sweep is named, and each mistake once.
TEST(Sweep, WrongValuesAreExplained)
{
  using Texts                                      = std::vector<std::string>;
  const std::vector<std::pair<Texts, Texts>> wrong = {
    {{"Sweep/Joints/base/Friction coefficient=0.2, 0,3 m"},
     {"--set \"Sweep/Joints/base",
      "Joints/base/Friction coefficient = '3 m'",
      "finite number >= 0"}},
    {{"Sweep/Joints/base/Friction coefficient=0.3, -0.2"}, {"= '-0.2'", ">= 0"}},
    {{"Sweep/Joints/base/Friction coefficient=0.2 : 0.6"}, {"first : step : last"}},
    {{"Sweep/Joints/base/Friction coefficient=0.2 : 0 : 0.6"}, {"step > 0"}},
    {{"Sweep/Joints/base/Friction coefficient=0 : 1e-9 : 1"}, {"more than 20000 values"}},
    {{"Sweep/Joints/base/Friction coefficient=0.2, "}, {"empty value"}},
    {{"Sweep/Joints/base/Friction coefficient=0.2, 0.2"}, {"'0.2' is there twice"}},
    {{"Sweep/Joints/base/Friction coefficient=Q, 0.2"}, {"'Q'", "Did you mean 'q'"}},
    {{"Sweep/Joints/base/Frictions=0.2, 0.3"}, {"unknown entry 'Frictions'", "Friction"}},
    {{"Sweep/Joints/bsae/Cohesion=0.2, 0.3"}, {"no subsection 'bsae'", "Did you mean 'base'"}},
    {{"Sweep/Joint/base/Cohesion=0.2, 0.3"}, {"unknown section 'Joint'", "Did you mean 'Joints'"}},
    {{"Sweep/Joints/Cohesion=0.2, 0.3"}, {"Joints/NAME/Cohesion"}},
    {{"Sweep/Constants/Q=1, 2"}, {"no constant 'Q'", "Did you mean 'q'"}},
    {{"Sweep/Mesh/File=example.msh, finer.msh"}, {"finer.msh", "does not exist"}},
    {{"Sweep/Mesh/Refinements=0, 0.5"}, {"Mesh/Refinements = '0.5'", "an integer"}},
    {{"Sweep/Output/Fields=end, never"}, {"cannot be varied"}},
    {{"Sweep/Joints/*/Cohesion=0, 1", "Sweep/Joints/wall/Cohesion=2, 3"},
     {"Joints/wall/Cohesion is varied already", "Sweep/Joints/*/Cohesion"}},
    {{"Sweep/Joints/base/Friction angle=10, 20", "Sweep/Joints/base/Friction coefficient=0.1"},
     {"is given as well"}},
    {{"Sweep/Combination=in step", "Sweep/Joints/base/Cohesion=0, 1", "Sweep/Constants/q=1"},
     {"as many values", "here are 1", "Sweep/Joints/base/Cohesion", "2."}},
    {{"Sweep/Combination=grid", "Sweep/Joints/base/Cohesion=0, 1"}, {"'all', 'in step'"}},
    {{"Sweep/Joints/base/Normal law=elastic, linear"}, {"= 'elastic'", "'cubic root'"}},
    {{"Sweep/Stages=wieght"}, {"no such stage 'wieght'", "Did you mean 'weight'"}},
    {{"Sweep/Stages=weight, push, weight"}, {"'weight' comes twice"}},
    {{"Sweep/Frictions=0.1"}, {"Friction coefficient"}},
    {{"Sweep/Joints=bsae", "Sweep/Cohesion=1"}, {"no subsection 'bsae'", "Did you mean 'base'"}},
    {{"Sweep/Constants/q=1 : 1 : 200", "Sweep/Bodies/dam/Young modulus=1 : 1 : 200"},
     {"more than 20000 variants"}}};
  for (const auto &[overrides, sentences] : wrong)
    for (const std::string &sentence : sentences)
      EXPECT_NE(message(overrides).find(sentence), std::string::npos)
        << overrides.front() << ": no '" << sentence << "' in: " << message(overrides);
}

// What is wrong at another line, but in some variants only, names the first of them.
TEST(Sweep, ErrorsOfVariants)
{
  const std::string text = testing_files::replaced(
    testing_files::example_prm(),
    {{"set Friction coefficient = 0.2",
      "set Friction coefficient = 0.2\nset Residual friction coefficient = 0.1"}});
  const std::string of_one =
    message({"Sweep/Joints/base/Friction coefficient=0.2, 0.05, 0.04"}, text);
  EXPECT_NE(of_one.find(".prm:32: Joints/base/Residual friction coefficient = '0.1'"),
            std::string::npos)
    << of_one;
  EXPECT_NE(of_one.find("(In the variant Joints/base/Friction coefficient = 0.05"),
            std::string::npos)
    << of_one;
  // One mistake of a line, in all of four variants.
  const std::string once = message({"Sweep/Joints/base/Frictions=1, 2", "Sweep/Constants/q=1, 2"});
  EXPECT_EQ(once.find("unknown entry"), once.rfind("unknown entry")) << once;
  EXPECT_EQ(once.find("errors"), std::string::npos) << once;
}
