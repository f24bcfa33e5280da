// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "parameter_wrong_input.h"

namespace fuga
{
  namespace
  {
    using testing_files::expect_explained;
    using testing_files::name_of;
    using testing_files::WrongInput;

    class WrongEntries : public testing::TestWithParam<WrongInput>
    {
    };

    TEST_P(WrongEntries, AreExplained)
    {
      expect_explained(GetParam());
    }

    const WrongInput names[] = {
      {"UnknownSection",
       {{"subsection Mesh", "subsection Mehs"}},
       {},
       {".prm:5", "Mehs", "'Mesh'?"}},
      {"UnknownEntry",
       {{"set Thickness         = 0.5", "set Thicknes = 0.5"}},
       {},
       {".prm:9", "Mesh/Thicknes = '0.5'", "unknown entry", "Did you mean 'Thickness'?"}},
      {"CapitalLetters",
       {{"Young modulus  =", "Young Modulus  ="}},
       {},
       {".prm:13", "Bodies/dam/Young Modulus = '3060'", "Did you mean 'Young modulus'?"}},
      {"FarAwayEntry",
       {{"set Assumption        = plane stress", "set Colour = red"}},
       {},
       {".prm:8", "The entries of Mesh are", "'File'", "'Assumption'"}},
      {"EntryOfAnotherSection",
       {{"set Poisson ratio  = 0.2", "set Friction angle = 20"}},
       {},
       {".prm:14", "Friction angle", "It is an entry of section Joints/NAME"}},
      {"EntryOutsideOfSubsection",
       {{"subsection Joints\n", "subsection Joints\n  set Line = base\n"}},
       {},
       {".prm:23", "Joints/Line", "stand in subsections", "'subsection NAME'"}},
      {"SectionTooDeep",
       {{"subsection Mesh\n", "subsection Mesh\nsubsection Bodies\nend\n"}},
       {},
       {".prm:6", "'Mesh' has no subsection 'Bodies'", "'end' missing above"}},
      {"DuplicateEntry",
       {{"set Weight density = 0.024", "set Poisson ratio = 0.3"}},
       {},
       {".prm:15", "Poisson ratio = '0.3'", "already set", ".prm:14", "Keep one"}},
      {"DuplicateSubsection",
       {{"subsection rock", "subsection dam"}},
       {},
       {".prm:17", "'Bodies/dam' is already there", ".prm:12"}},
      {"SlashInName",
       {{"subsection wall", "subsection wall/left"}},
       {},
       {".prm:34", "'wall/left'", "character '/'", "Choose a name"}},
      {"ColonInName", {{"subsection crane", "subsection a:b"}}, {}, {"'a:b'", "':'"}},
      {"ReservedConstant",
       {{"set q =", "set t ="}},
       {},
       {".prm:3", "Constants/t", "none of x, y, z, t, pi"}},
      {"ConstantWithBlank",
       {{"set q =", "set my q ="}},
       {},
       {".prm:3", "my q", "letters, digits and _"}},
    };
    INSTANTIATE_TEST_SUITE_P(Names, WrongEntries, testing::ValuesIn(names), name_of);


    const WrongInput numbers[] = {
      {"MissingRequired",
       {{"    set Poisson ratio = 0.25\n", ""}},
       {},
       {".prm:17", "Bodies/rock/Poisson ratio is missing", "> -1 and < 0.5"}},
      {"MissingMeshSection",
       {{"set File              = example.msh", ""}},
       {},
       {".prm:5", "Mesh/File is missing", ".msh"}},
      {"NegativeModulus",
       {{"= 3060\n", "= -3060\n"}},
       {},
       {".prm:13", "Young modulus = '-3060'", "out of range", "a finite number > 0"}},
      {"ZeroModulus", {{"= 3060\n", "= 0\n"}}, {}, {"Young modulus = '0'", "out of range"}},
      {"PoissonTooLarge",
       {{"= 0.25", "= 0.5"}},
       {},
       {".prm:19", "Poisson ratio = '0.5'", "out of range", "< 0.5", "0.49"}},
      {"NotANumber", {{"= 0.25", "= small"}}, {}, {".prm:19", "'small'", "not a number"}},
      {"Nan", {{"= 0.25", "= nan"}}, {}, {".prm:19", "'nan'", "not a finite number"}},
      {"Infinity", {{"= 30600", "= inf"}}, {}, {".prm:18", "'inf'", "not a finite number"}},
      {"Overflow", {{"= 30600", "= 1e999"}}, {}, {"'1e999'", "too large"}},
      {"DecimalComma", {{"= 0.25", "= 0,25"}}, {}, {".prm:19", "'0,25'", "decimal point"}},
      {"UnitBehindNumber",
       {{"= 30600", "= 30600 MPa"}},
       {},
       {".prm:18", "'MPa'", "units are not written"}},
      {"NoValue", {{"= 30600", "="}}, {}, {".prm:18", "no value", "> 0"}},
      {"NegativeInteger",
       {{"degree = 2", "degree = -2"}},
       {},
       {".prm:7", "Polynomial degree = '-2'", "out of range", "from 1 to 3"}},
      {"DegreeTooHigh", {{"degree = 2", "degree = 4"}}, {}, {"'4'", "from 1 to 3"}},
      {"FractionalInteger",
       {{"Levels = 10", "Levels = 2.5"}},
       {},
       {"Levels = '2.5'", "not an integer"}},
      {"ZeroLevels",
       {{"Levels = 10", "Levels = 0"}},
       {},
       {"Stages/push/Levels", "from 1 to 1000000"}},
      {"UnknownWord",
       {{"plane stress", "plain strain"}},
       {},
       {".prm:8",
        "'plain strain'",
        "'plane strain', 'plane stress'",
        "Did you mean 'plane strain'?"}},
      {"AssumptionInSpace",
       {{"set Title = An example", "set Dimension = 3"}},
       {},
       {".prm:8", "Mesh/Assumption", "nothing across it"}},
      {"ThicknessInSpace",
       {{"set Title = An example", "set Dimension = 3"}, {"plane stress", "plane strain"}},
       {"Mesh/Assumption="},
       {"Mesh/Thickness", "nothing across it"}},
      {"FourDimensions",
       {{"set Title = An example", "set Dimension = 4"}},
       {},
       {"Dimension", "out of range"}},
      {"CornerAngleTooSmall",
       {{"set Initial gap = 0.001*x", "set Corner angle = 0.5"}},
       {},
       {".prm:32", "Corner angle = '0.5'", "out of range", "from 1 to 180"}},
      {"CornerAngleTooLarge",
       {{"set Initial gap = 0.001*x", "set Corner angle = 181"}},
       {},
       {"Corner angle = '181'", "out of range"}},
      {"NegativeDensity", {{"= 0.024", "= -1"}}, {}, {".prm:15", "Weight density", ">= 0"}},
    };
    INSTANTIATE_TEST_SUITE_P(Numbers, WrongEntries, testing::ValuesIn(numbers), name_of);
  } // namespace
} // namespace fuga
