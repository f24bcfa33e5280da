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
    using testing_files::replaced;
    using testing_files::write_file;

    /** The example with other entries in the load 'push', a pressure on 'upstream' (line 58 on). */
    LoadDefinition
    read_push(const std::string &name, const std::string &entries)
    {
      const std::string text =
        replaced(example_prm(),
                 {{"    set Type = pressure\n    set Boundaries = upstream\n    set Value = "
                   "q*(12 - y)/12\n",
                   entries}});
      return read_parameters(write_file(name + ".prm", text)).model.loads.at(1);
    }

    const std::string on_upstream = "set Boundaries = upstream\n";
  } // namespace


  TEST(LoadTypes, Hydrostatic)
  {
    const LoadDefinition load =
      read_push("water",
                "set Type = hydrostatic\n" + on_upstream +
                  "set Level = 1: 0; 1.5: 10 ;2 : 12.5\nset Unit weight = 0.00981\n");
    EXPECT_EQ(load.kind, LoadKind::depth_pressure);
    EXPECT_EQ(load.targets, (std::vector<std::string>{"upstream"}));
    EXPECT_TRUE(load.expressions.empty());
    ASSERT_EQ(load.depth.level_table.size(), 3u);
    EXPECT_EQ(load.depth.level_table[1], (std::array<double, 2>{{1.5, 10.}}));
    EXPECT_EQ(load.depth.level_table[2], (std::array<double, 2>{{2., 12.5}}));
    EXPECT_EQ(load.depth.gradient, 0.00981);
    EXPECT_EQ(load.depth.surcharge, 0.);
    EXPECT_EQ(load.depth.root, 0.);
    // An expression with the two signs of a condition is no table.
    const LoadDefinition by_expression =
      read_push("condition",
                "set Type = hydrostatic\n" + on_upstream +
                  "set Level = t < 1 ? 0 : 100*q*(t - 1)\nset Unit weight = 1\n");
    EXPECT_TRUE(by_expression.depth.level_table.empty());
    EXPECT_EQ(by_expression.depth.level, "t < 1 ? 0 : 100*q*(t - 1)");
  }


  TEST(LoadTypes, EarthAndEarthquake)
  {
    const LoadDefinition earth =
      read_push("earth",
                "set Type = earth pressure\n" + on_upstream +
                  "set Level = 7\nset Unit weight = 0.02\nset Earth pressure coefficient = 0.5\n"
                  "set Surcharge = 0.01\n");
    EXPECT_EQ(earth.depth.level, "7");
    EXPECT_EQ(earth.depth.gradient, 0.01);
    EXPECT_EQ(earth.depth.surcharge, 0.005);

    const LoadDefinition water =
      read_push("moved",
                "set Type = westergaard\n" + on_upstream +
                  "set Level = 10\nset Bottom level = -2\nset Unit weight = 0.01\n"
                  "set Horizontal coefficient = -0.2\n");
    EXPECT_DOUBLE_EQ(water.depth.root, -7. / 8. * 0.2 * 0.01);
    EXPECT_EQ(water.depth.bottom, -2.);
    EXPECT_EQ(water.depth.gradient, 0.);

    const LoadDefinition shaking = read_push(
      "shaking", "set Type = seismic\nset Bodies = dam\nset Vertical coefficient = 0.05\n");
    EXPECT_EQ(shaking.kind, LoadKind::weight);
    EXPECT_EQ(shaking.targets, (std::vector<std::string>{"dam"}));
    EXPECT_EQ(shaking.expressions, (std::vector<std::string>{"0", "0.05"}));
  }


  TEST(LoadTypes, Uplift)
  {
    const std::string on_base  = "set Type = uplift\nset Joints = base\nset Level = 7\n"
                                 "set Unit weight = 0.01\nset Upstream end = left\n";
    const LoadDefinition plain = read_push("plain", on_base);
    EXPECT_EQ(plain.kind, LoadKind::uplift);
    EXPECT_EQ(plain.targets, (std::vector<std::string>{"base"}));
    EXPECT_EQ(plain.depth.level, "7");
    EXPECT_EQ(plain.depth.gradient, 0.01);
    EXPECT_EQ(plain.uplift.flow, (std::array<double, 3>{{1., 0., 0.}}));
    EXPECT_EQ(plain.uplift.profile_from, Uplift::ProfileFrom::crack_tip);
    EXPECT_FALSE(plain.uplift.has_tailwater);
    EXPECT_EQ(plain.uplift.profile, (std::vector<std::array<double, 2>>{{{0., 1.}}, {{1., 0.}}}));

    const LoadDefinition drained = read_push(
      "drained",
      on_base + "set Tailwater level = -1\nset Drain distance = 2\nset Drain efficiency = 0.5\n");
    EXPECT_TRUE(drained.uplift.has_tailwater);
    EXPECT_EQ(drained.uplift.tailwater.level, "-1");
    EXPECT_EQ(drained.uplift.drains_after_crack, Uplift::Drains::lost);
    EXPECT_EQ(drained.uplift.drain_distance, 2.);
    EXPECT_EQ(drained.uplift.drain_efficiency, 0.5);

    const LoadDefinition given =
      read_push("given", on_base + "set Pressure profile = 0: 1; 0.2: 0.3; 1: 0\n");
    ASSERT_EQ(given.uplift.profile.size(), 3u);
    EXPECT_EQ(given.uplift.profile[1], (std::array<double, 2>{{0.2, 0.3}}));
  }


  TEST(LoadTypes, Temperature)
  {
    const std::string text = replaced(
      example_prm(),
      {{"    set Type = pressure\n    set Boundaries = upstream\n    set Value = "
        "q*(12 - y)/12\n",
        "set Type = temperature\nset Value = -20*x/12\n"},
       {"set Poisson ratio  = 0.2\n", "set Poisson ratio  = 0.2\nset Thermal expansion = 1e-5\n"}});
    const ModelDefinition model = read_parameters(write_file("heat.prm", text)).model;
    EXPECT_EQ(model.loads[1].kind, LoadKind::temperature);
    EXPECT_EQ(model.loads[1].expressions, (std::vector<std::string>{"-20*x/12"}));
    EXPECT_EQ(model.materials[0].thermal_expansion, 1e-5);
    EXPECT_EQ(model.materials[1].thermal_expansion, 0.);
  }


  namespace
  {
    using testing_files::expect_explained;
    using testing_files::name_of;
    using testing_files::WrongInput;

    class WrongLoads : public testing::TestWithParam<WrongInput>
    {
    };

    TEST_P(WrongLoads, AreExplained)
    {
      expect_explained(GetParam());
    }

    // The load 'push' begins at line 58, its type stands at line 59.
    const std::string pressure = "set Type = pressure", value = "    set Value = q*(12 - y)/12\n",
                      water = "set Type = hydrostatic\nset Unit weight = 1\nset Level = ",
                      uplift =
                        "set Type = uplift\nset Joints = base\nset Level = 3\nset Unit weight = 1";

    const WrongInput loads[] = {
      {"NoUnitWeight",
       {{pressure, "set Type = hydrostatic\nset Level = 3"}, {value, ""}},
       {},
       {".prm:58", "Loads/push", "'Unit weight' is missing", "type hydrostatic", "MN/m^3"}},
      {"NoLevel",
       {{pressure, "set Type = hydrostatic\nset Unit weight = 3"}, {value, ""}},
       {},
       {".prm:58", "'Level' is missing"}},
      {"ValueOfWater",
       {{pressure, water + "3"}},
       {},
       {".prm:63", "Loads/push/Value", "type hydrostatic", ".prm:59", "'Boundaries', 'Level'"}},
      {"LevelOfPressure",
       {{value, value + "set Level = 3\n"}},
       {},
       {".prm:62", "Loads/push/Level", "type pressure", ".prm:59", "Remove this line"}},
      {"TableDoesNotIncrease",
       {{pressure, water + "0: 0; 2: 10; 2: 12"}, {value, ""}},
       {},
       {".prm:61", "Loads/push/Level", "do not increase", "2 comes after 2"}},
      {"TablePointWithoutNumber",
       {{pressure, water + "0: 0; 2: high"}, {value, ""}},
       {},
       {".prm:61", "'2: high'", "'high' is not a number", "'t: level'"}},
      {"TablePointWithoutLevel",
       {{pressure, water + "0: 0; 2:"}, {value, ""}},
       {},
       {".prm:61", "'2:'", "is empty"}},
      {"TablePointWithoutTime",
       {{pressure, water + "0: 0; 10"}, {value, ""}},
       {},
       {".prm:61", "'10' is no point of a table"}},
      {"LevelOfPlace",
       {{pressure, water + "10 - x"}, {value, ""}},
       {},
       {".prm:61", "'10 - x'", "\"x\"", "Known here: t"}},
      {"NegativeUnitWeight",
       {{pressure, "set Type = hydrostatic\nset Level = 3\nset Unit weight = -1"}, {value, ""}},
       {},
       {".prm:61", "Unit weight = '-1'", "> 0"}},
      {"EarthWithoutCoefficient",
       {{pressure, "set Type = earth pressure\nset Level = 3\nset Unit weight = 1"}, {value, ""}},
       {},
       {".prm:58", "'Earth pressure coefficient' is missing"}},
      {"WestergaardWithoutBottom",
       {{pressure,
         "set Type = westergaard\nset Level = 3\nset Unit weight = 1\nset Horizontal coefficient = "
         "1"},
        {value, ""}},
       {},
       {".prm:58", "'Bottom level' is missing"}},
      {"WestergaardOfNothing",
       {{pressure,
         "set Type = westergaard\nset Level = 3\nset Unit weight = 1\nset Bottom level = 0\n"
         "set Horizontal coefficient = 0"},
        {value, ""}},
       {},
       {".prm:63", "Horizontal coefficient = '0'", "does nothing"}},
      {"SeismicWithoutCoefficient",
       {{pressure, "set Type = seismic"}, {value, ""}, {"    set Boundaries = upstream\n", ""}},
       {},
       {".prm:58", "no coefficient", "'Vertical coefficient'"}},
      {"SeismicOnBoundary",
       {{pressure, "set Type = seismic\nset Horizontal coefficient = 0.1"}, {value, ""}},
       {},
       {".prm:61", "Boundaries = 'upstream'", "type seismic"}},
      {"UpliftWithoutEnd",
       {{pressure, uplift}, {value, ""}, {"    " + on_upstream, ""}},
       {},
       {".prm:58", "'Upstream end' is missing", "reservoir"}},
      {"UpliftOnBoundary",
       {{pressure, uplift + "\nset Upstream end = left"}, {value, ""}},
       {},
       {".prm:64", "Boundaries = 'upstream'", "type uplift"}},
      {"UpliftInNoJoint",
       {{pressure,
         "set Type = uplift\nset Level = 3\nset Unit weight = 1\nset Upstream end = left\n"
         "set Joints = bsae"},
        {value, ""},
        {"    " + on_upstream, ""}},
       {},
       {".prm:63", "no joint 'bsae'", "base"}},
      {"DrainWithoutEfficiency",
       {{pressure, uplift + "\nset Upstream end = left\nset Drain distance = 2"},
        {value, ""},
        {"    " + on_upstream, ""}},
       {},
       {".prm:64", "Drain distance", "Add 'Drain efficiency'"}},
      {"DrainAndProfile",
       {{pressure,
         uplift + "\nset Upstream end = left\nset Drain distance = 2\nset Drain efficiency = 1\n"
                  "set Pressure profile = 0: 1; 1: 0"},
        {value, ""},
        {"    " + on_upstream, ""}},
       {},
       {".prm:66", "Pressure profile", ".prm:64", "Remove one"}},
      {"ProfileTooShort",
       {{pressure, uplift + "\nset Upstream end = left\nset Pressure profile = 0: 1; 0.9: 0"},
        {value, ""},
        {"    " + on_upstream, ""}},
       {},
       {".prm:64", "Pressure profile", "to 0.9"}},
      {"ProfileTooHigh",
       {{pressure, uplift + "\nset Upstream end = left\nset Pressure profile = 0: 1; 1: 1.5"},
        {value, ""},
        {"    " + on_upstream, ""}},
       {},
       {".prm:64", "Pressure profile", "1.5 at s = 1"}},
      {"NothingExpands",
       {{pressure, "set Type = temperature"}, {"    set Boundaries = upstream\n", ""}},
       {},
       {".prm:58", "no body has a thermal expansion", "'Thermal expansion'"}},
      {"ExpandsNotThere",
       {{pressure, "set Type = temperature\nset Bodies = rock"},
        {"    set Boundaries = upstream\n", ""},
        {"set Poisson ratio  = 0.2\n", "set Poisson ratio  = 0.2\nset Thermal expansion = 1e-5\n"}},
       {},
       {".prm:61", "'rock' has thermal expansion 0", "Bodies/rock/Thermal expansion"}},
      {"TwoTemperatures",
       {{pressure, "set Type = temperature"},
        {"    set Boundaries = upstream\n", ""},
        {"q*(12 - y)/12", "1; 2"},
        {"set Poisson ratio  = 0.2\n", "set Poisson ratio  = 0.2\nset Thermal expansion = 1e-5\n"}},
       {},
       {".prm:61", "Loads/push/Value", "one value"}},
      {"NegativeExpansion",
       {{"set Poisson ratio  = 0.2\n", "set Poisson ratio  = 0.2\nset Thermal expansion = -1\n"}},
       {},
       {".prm:15", "Thermal expansion = '-1'", ">= 0"}},
    };
    INSTANTIATE_TEST_SUITE_P(Loads, WrongLoads, testing::ValuesIn(loads), name_of);
  } // namespace
} // namespace fuga
