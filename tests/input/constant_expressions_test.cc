// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "parameter_wrong_input.h"

#include <fuga/input/parameters.h>
#include <fuga/input/read/read_parameters.h>

#include "parameter_test_files.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace fuga
{
  namespace
  {
    using namespace testing_files;

    // Constants H = 40 and B = 3/4 H = 30, and a load with a level.
    const Changes with_constants = {
      {"  set q = 0.0144\n", "  set q = 0.0144\n  set H = 40\n  set B = 3*H/4\n"},
      {"  subsection push\n    set Type = pressure\n",
       "  subsection water\n    set Type = hydrostatic\n    set Boundaries = downstream\n"
       "    set Level = 1: 0; 1.5: H/4; 2: 0.9*H\n    set Unit weight = 0.01\n  end\n"
       "  subsection push\n    set Type = pressure\n"},
      {"set Loads = push: t;", "set Loads = water: 1; push: t;"},
      {"= 30600", "= 30600*(1 + 0.5)"},
      {"set Point = 4, 12", "set Point = B/2, 0.3*H"},
      {"set Levels = 10", "set Levels = B/3"}};

    // By hand: E = 45900, levels 0, 10, 36, the point (15, 12), 10 levels.
    TEST(ConstantExpressions, NumbersAreEvaluatedOnce)
    {
      const std::string file = write_file("constants.prm", replaced(example_prm(), with_constants));
      const Parameters p     = read_parameters(file, {});
      EXPECT_EQ(p.model.constants.at("B"), 30.);
      EXPECT_DOUBLE_EQ(p.model.materials[1].young_modulus, 45900.);
      const auto load = std::find_if(p.model.loads.begin(), p.model.loads.end(), [](const auto &l) {
        return l.name == "water";
      });
      const std::vector<std::array<double, 2>> levels = {{{1., 0.}}, {{1.5, 10.}}, {{2., 36.}}};
      EXPECT_EQ(load->depth.level_table, levels);
      const auto crane = std::find_if(p.model.loads.begin(),
                                      p.model.loads.end(),
                                      [](const auto &l) { return l.name == "crane"; });
      EXPECT_DOUBLE_EQ(crane->coordinates[0], 15.);
      EXPECT_DOUBLE_EQ(crane->coordinates[1], 12.);
      EXPECT_EQ(p.model.stages[1].levels, 10u);
      // What was computed with stands in the echo.
      for (const auto &[name, value] : std::vector<std::pair<std::string, std::string>>{
             {"Constants/B", "30"},
             {"Bodies/rock/Young modulus", "45900"},
             {"Loads/water/Level", "1: 0; 1.5: 10; 2: 36"},
             {"Loads/crane/Point", "15, 12"}})
        EXPECT_NE(std::find(p.echo.begin(), p.echo.end(), std::make_pair(name, value)),
                  p.echo.end())
          << name;
    }

    TEST(ConstantExpressions, OptionsOfTheCommandLine)
    {
      const std::string file =
        write_file("constants_set.prm", replaced(example_prm(), with_constants));
      const Parameters p = read_parameters(file, {"Constants/H=20", "Mesh/Thickness=sqrt(B + 1)"});
      EXPECT_EQ(p.model.constants.at("B"), 15.);
      EXPECT_EQ(p.model.thickness, 4.);
      EXPECT_EQ(p.model.stages[1].levels, 5u);
    }

    class WrongConstants : public testing::TestWithParam<WrongInput>
    {
    };

    TEST_P(WrongConstants, AreExplained)
    {
      expect_explained(GetParam());
    }

    const WrongInput inputs[] = {
      {"UnknownNameInNumber",
       {{"= 30600", "= 100*Q"}},
       {},
       {".prm:18: Bodies/rock/Young modulus = '100*Q'", "unknown name 'Q'", "Did you mean 'q'?"}},
      {"UnknownNameInCoordinates",
       {{"set Point = 4, 12", "set Point = 4*p, 12"}},
       {},
       {".prm:65: Loads/crane/Point", "unknown name 'p'", "'q'"}},
      {"MisspeltConstantAlone",
       {{"  set q = 0.0144\n", "  set height = 4\n  set q = 0.0144\n"}, {"= 30600", "= heigth"}},
       {},
       {".prm:19", "Did you mean 'height'?"}},
      {"LaterConstant",
       {{"  set q = 0.0144\n", "  set q = 2*later\n  set later = 3\n"}},
       {},
       {".prm:3: Constants/q = '2*later'", "unknown name 'later'"}},
      {"NotFinite", {{"= 30600", "= 1/(q - q)"}}, {}, {".prm:18", "not a finite number"}},
      {"OutOfRange", {{"= 30600", "= -q*2"}}, {}, {".prm:18", "out of range", "> 0"}},
      {"NoInteger", {{"set Levels = 10", "set Levels = 10*q"}}, {}, {"not an integer"}},
      {"NotUnderstood", {{"= 30600", "= 3*(q + 1"}}, {}, {".prm:18", "cannot be understood"}},
      {"Place", {{"= 30600", "= 2*x"}}, {}, {".prm:18", "unknown name 'x'"}},
      {"WordsAsBefore",
       {{"= 30600", "= 30600 MN/m2"}},
       {},
       {".prm:18", "because of 'MN/m2' behind it; units are not written"}},
    };
    INSTANTIATE_TEST_SUITE_P(Inputs,
                             WrongConstants,
                             testing::ValuesIn(inputs),
                             testing_files::name_of);
  } // namespace
} // namespace fuga
