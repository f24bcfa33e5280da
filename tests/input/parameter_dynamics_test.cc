// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "parameter_wrong_input.h"

#include <fuga/bodies/construction.h>
#include <fuga/input/parameters.h>
#include <fuga/input/read/read_parameters.h>

namespace fuga
{
  namespace
  {
    using testing_files::Changes;
    using testing_files::example_prm;
    using testing_files::expect_explained;
    using testing_files::message_of;
    using testing_files::name_of;
    using testing_files::replaced;
    using testing_files::write_file;
    using testing_files::WrongInput;

    /** The second stage of the example with inertia, and without what may not change in it. */
    const Changes dynamic = {{"set Loads = push: t; crane: sin(pi*t/2); settlement: t^2",
                              "set Loads = push: t; crane: sin(pi*t/2)\n    set Duration = 2"},
                             {"set Loads = weight: t", "set Loads = weight: t; settlement: t"}};

    Parameters
    read(const std::string &name,
         const std::vector<std::string> &overrides,
         const Changes &more = {})
    {
      return read_parameters(write_file(name, replaced(replaced(example_prm(), dynamic), more)),
                             overrides);
    }

    TEST(ParameterDynamics, IsRead)
    {
      const ModelDefinition model = read("dynamics.prm",
                                         {"Dynamics/Time step=0.01",
                                          "Dynamics/Halvings=3",
                                          "Dynamics/Event tolerance=1e-4",
                                          "Dynamics/Spectral radius=0.8",
                                          "Dynamics/Gravity=10",
                                          "Dynamics/Massless bodies=rock",
                                          "Dynamics/Damping ratio=0.05",
                                          "Dynamics/Damping frequencies=2; 2*4",
                                          "Bodies/dam/Initial velocity=0.5; -q"})
                                      .model;
      EXPECT_EQ(model.stages[0].duration, 0.);
      EXPECT_EQ(model.stages[1].duration, 2.);
      EXPECT_FALSE(model.stages[0].keeps_water);
      EXPECT_TRUE(model.stages[1].keeps_water);
      EXPECT_EQ(model.dynamics.time_step, 0.01);
      EXPECT_EQ(model.dynamics.halvings, 3u);
      EXPECT_EQ(model.dynamics.event_tolerance, 1e-4);
      EXPECT_EQ(model.dynamics.spectral_radius, 0.8);
      EXPECT_EQ(model.dynamics.gravity, 10.);
      EXPECT_EQ(model.dynamics.massless_bodies, std::vector<std::string>{"rock"});
      EXPECT_EQ(model.dynamics.damping_ratio, 0.05);
      EXPECT_EQ(model.dynamics.damping_frequencies, (std::array<double, 2>{{2., 8.}}));
      EXPECT_EQ(model.materials[0].initial_velocity, (std::array<double, 3>{{0.5, -0.0144, 0.}}));
      EXPECT_TRUE(model.dynamics.ground[0].accelerations.empty());
      EXPECT_EQ(first_stages_of_phases(model), (std::vector<unsigned int>{0, 1}));
    }

    // All boundaries through which waves pass absorb. Half of the motion of an outcrop is the wave.
    TEST(ParameterDynamics, GroundThatGoesOn)
    {
      const std::string record    = write_file("wave.txt", "0 0\n0.01 0.1\n0.02 0\n");
      const ModelDefinition model = read("ground.prm",
                                         {"Dynamics/Time step=0.01",
                                          "Dynamics/Absorbing boundaries=right",
                                          "Earthquake/Record x=wave.txt",
                                          "Earthquake/Compliant base=bottom",
                                          "Earthquake/Record motion=outcrop",
                                          "Earthquake/Free field=right, left"})
                                      .model;
      EXPECT_EQ(model.dynamics.absorbing.names,
                (std::vector<std::string>{"right", "bottom", "left"}));
      EXPECT_EQ(model.dynamics.compliant_base.names, std::vector<std::string>{"bottom"});
      EXPECT_EQ(model.dynamics.free_field.names, (std::vector<std::string>{"right", "left"}));
      EXPECT_EQ(model.dynamics.upward_share, 0.5);
      EXPECT_FALSE(releases_supports(model, 0));
      EXPECT_TRUE(releases_supports(model, 1));
      EXPECT_FALSE(keeps_structure(model, 1));
      const auto message = [](const std::vector<std::string> &overrides) {
        std::vector<std::string> all = {"Dynamics/Time step=0.01", "Earthquake/Record x=wave.txt"};
        all.insert(all.end(), overrides.begin(), overrides.end());
        return message_of(write_file("ground_errors.prm", replaced(example_prm(), dynamic)), all);
      };
      EXPECT_NE(message({"Earthquake/Compliant base=bottom"}).find("'Record motion' is missing"),
                std::string::npos);
      EXPECT_NE(message({"Earthquake/Record motion=outcrop"})
                  .find("the record is the motion of the ground itself"),
                std::string::npos);
    }

    // The stage after a dynamic one begins a phase too.
    TEST(ParameterDynamics, DynamicStagesArePhases)
    {
      const ModelDefinition model =
        read("phases.prm",
             {"Dynamics/Time step=0.01"},
             {{"    set Duration = 2\n    set Levels = 10\n  end",
               "    set Duration = 2\n  end\n  subsection rest\n    set Loads = push: 1\n  end\n  "
               "subsection more\n    set Loads = push: 1 + t\n  end"}})
          .model;
      EXPECT_EQ(first_stages_of_phases(model), (std::vector<unsigned int>{0, 1, 2}));
      EXPECT_FALSE(changes_construction(model));
    }

    // g in the unit of length of the file.
    TEST(ParameterDynamics, GravityIsThatOfTheUnit)
    {
      const std::vector<std::string> step = {"Dynamics/Time step=0.01"};
      EXPECT_EQ(read("g.prm", step).model.dynamics.gravity, 9.81);
      EXPECT_NEAR(
        read("g.prm", {step[0], "Output/Length unit=mm"}).model.dynamics.gravity, 9810., 1e-11);
      EXPECT_EQ(read("g.prm", {step[0], "Output/Length unit=cubit", "Dynamics/Gravity=21"})
                  .model.dynamics.gravity,
                21.);
    }

    // Both axes, three formats, units and a factor; the time step is that of the finest record.
    TEST(ParameterDynamics, RecordsAreRead)
    {
      write_file("a.AT2", "X\nNPTS= 3, DT= .01 SEC\n .1 .2 -.3\n");
      write_file("b.txt", "0 1\n0.005 2\n0.01 -1\n");
      write_file("c.txt", "1\n2\n");
      const DynamicsDefinition both =
        read("records.prm",
             {"Earthquake/Record x=a.AT2", "Earthquake/Record y=b.txt", "Earthquake/Scale=-2"})
          .model.dynamics;
      EXPECT_EQ(both.earthquake_stage, 1u);
      EXPECT_EQ(both.time_step, 0.005);
      EXPECT_EQ(both.ground[0].step, 0.01);
      ASSERT_EQ(both.ground[0].accelerations.size(), 3u);
      EXPECT_NEAR(both.ground[0].accelerations[2], 0.3 * 2. * 9.81, 1e-14);
      EXPECT_NEAR(both.ground[1].accelerations[1], -2. * 2. * 9.81, 1e-13);
      EXPECT_TRUE(both.ground[2].accelerations.empty());

      const DynamicsDefinition one = read("one.prm",
                                          {"Earthquake/Record y=c.txt",
                                           "Earthquake/Stage=push",
                                           "Earthquake/Time column=0",
                                           "Earthquake/Acceleration column=1",
                                           "Earthquake/Record step=0.02",
                                           "Earthquake/Record unit=length/s^2",
                                           "Dynamics/Time step=0.001"})
                                       .model.dynamics;
      EXPECT_EQ(one.time_step, 0.001);
      EXPECT_EQ(one.ground[1].step, 0.02);
      EXPECT_EQ(one.ground[1].accelerations, (Vector{1., 2.}));
      // A straight record is a parabola: nothing is left of it.
      const DynamicsDefinition corrected =
        read("parabolic.prm", {"Earthquake/Record x=b.txt", "Earthquake/Baseline=parabolic"})
          .model.dynamics;
      for (const double a : corrected.ground[0].accelerations)
        EXPECT_NEAR(a, 0., 1e-9);
    }

    // The motion of the ground decides nothing that is condensed, but for the time step if that is
    // the step of a record.
    TEST(ParameterDynamics, RecordsShareACondensation)
    {
      write_file("coarse.txt", "0 1\n0.01 2\n0.02 -1\n");
      write_file("fine.txt", "0 1\n0.005 -3\n");
      const std::vector<std::string> sweep = {"Sweep/Earthquake/Record x=coarse.txt, fine.txt",
                                              "Sweep/Earthquake/Scale=0.1, 0.2",
                                              "Earthquake/Scale=1",
                                              "Earthquake/Record x=coarse.txt"};
      const auto with                      = [&sweep](const std::string &more) {
        std::vector<std::string> all = sweep;
        all.push_back(more);
        return read("sweep_of_records.prm", all);
      };
      EXPECT_EQ(read("sweep_of_records.prm", sweep).condensations.size(), 2u);
      EXPECT_EQ(with("Sweep/Dynamics/Time step=0.01, 0.02").condensations.size(), 2u);
      const Parameters shared = with("Dynamics/Time step=0.01");
      EXPECT_EQ(shared.condensations.size(), 1u);
      ASSERT_EQ(shared.variants.size(), 4u);
      EXPECT_NEAR(shared.variants[1].ground[0].accelerations[1], 0.2 * 2. * 9.81, 1e-14);
      EXPECT_NEAR(shared.variants[2].ground[0].accelerations[1], 0.1 * -3. * 9.81, 1e-14);
    }

    TEST(ParameterDynamics, AddedMassIsRead)
    {
      write_file("b.txt", "0 1\n0.005 2\n");
      const DynamicsDefinition dynamics = read("added.prm",
                                               {"Earthquake/Record x=b.txt",
                                                "Earthquake/Added mass boundaries=upstream, bed",
                                                "Earthquake/Added mass level=12",
                                                "Earthquake/Added mass bottom=0",
                                                "Earthquake/Added mass unit weight=0.01"})
                                            .model.dynamics;
      ASSERT_EQ(dynamics.added_masses.size(), 1u);
      EXPECT_EQ(dynamics.added_masses[0].boundaries, (std::vector<std::string>{"upstream", "bed"}));
      EXPECT_EQ(dynamics.added_masses[0].level, 12.);
      EXPECT_EQ(dynamics.added_masses[0].bottom, 0.);
      EXPECT_EQ(dynamics.added_masses[0].unit_weight, 0.01);
    }

    class WrongDynamics : public testing::TestWithParam<WrongInput>
    {
    };

    TEST_P(WrongDynamics, IsExplained)
    {
      WrongInput input = GetParam();
      input.changes.insert(input.changes.begin(), dynamic.begin(), dynamic.end());
      write_file("record.txt", "0 1\n0.01 2\n");
      expect_explained(input);
    }

    const Changes unchanged;
    const std::string step = "Dynamics/Time step=0.01", record = "Earthquake/Record x=record.txt";
    const Changes slow = {{"    set Duration = 2\n", ""}};

    const WrongInput wrong[] = {
      {"NegativeDuration", {{"Duration = 2", "Duration = -2"}}, {}, {"Duration = '-2'", "> 0"}},
      {"NoTimeStep",
       unchanged,
       {},
       {"Stages/push/Duration = '2'", "'Dynamics/Time step' is missing"}},
      {"TooManySteps",
       unchanged,
       {"Dynamics/Time step=1e-9"},
       {"Duration = '2'", "2e+09", "1e+06", "Time step"}},
      {"TimeStepWithoutDuration", slow, {step}, {"Time step = '0.01'", "no stage has a Duration"}},
      {"VelocityWithoutDuration",
       slow,
       {"Bodies/dam/Initial velocity=1; 0"},
       {"Initial velocity = '1; 0'", "no stage has a Duration"}},
      {"RecordWithoutDuration", slow, {record}, {"Record x", "no stage has a Duration"}},
      {"VelocityOfThreeComponents",
       unchanged,
       {step, "Bodies/dam/Initial velocity=1; 0; 0"},
       {"3 number(s) instead of 2", "'vx; vy'"}},
      {"VelocityInWords",
       unchanged,
       {step, "Bodies/dam/Initial velocity=1; fast"},
       {"Initial velocity = '1; fast'", "fast"}},
      {"VelocityOfABodyThatIsGone",
       {{"set Poisson ratio = 0.25", "set Poisson ratio = 0.25\n    set Removed at stage = push"},
        {"    set Poisson ratio = 0.25",
         "    set Initial velocity = 1; 0\n    set Poisson ratio = 0.25"}},
       {step},
       {"Bodies/rock/Initial velocity", "not there in stage 'push'"}},
      {"UnknownMasslessBody",
       unchanged,
       {step, "Dynamics/Massless bodies=rok"},
       {"Massless bodies = 'rok'", "no body 'rok'", "rock"}},
      {"MasslessBodyThatMoves",
       unchanged,
       {step, "Dynamics/Massless bodies=dam", "Bodies/dam/Initial velocity=1; 0"},
       {"Massless bodies = 'dam'", "Initial velocity"}},
      {"DampingWithoutFrequencies",
       unchanged,
       {step, "Dynamics/Damping ratio=0.05"},
       {"Damping ratio = '0.05'", "'Damping frequencies' is missing"}},
      {"FrequenciesWithoutDamping",
       unchanged,
       {step, "Dynamics/Damping frequencies=2; 10"},
       {"Damping frequencies = '2; 10'", "without 'Damping ratio'"}},
      {"FrequenciesThatFall",
       unchanged,
       {step, "Dynamics/Damping ratio=0.05", "Dynamics/Damping frequencies=10; 2"},
       {"Damping frequencies = '10; 2'", "increase"}},
      {"DampingInPercent",
       unchanged,
       {step, "Dynamics/Damping ratio=5"},
       {"Damping ratio = '5'", "from 0 to 1"}},
      {"UnknownUnitOfLength",
       unchanged,
       {step, "Output/Length unit=cubit"},
       {"Dynamics", "'Gravity' is missing", "cubit"}},
      {"StageEnds",
       unchanged,
       {step, "Solver/Follow=stage ends"},
       {"Duration = '2'", "'Solver/Follow = stage ends'"}},
      {"BeyondLimitLoad",
       unchanged,
       {step, "Solver/Beyond limit load=arc length"},
       {"Duration = '2'", "'Solver/Beyond limit load = arc length'"}},
      {"MatrixFree",
       unchanged,
       {step, "Solver/Bodies=iterative matrix-free"},
       {"Duration = '2'", "'Solver/Bodies = iterative matrix-free'"}},
      {"TargetAccuracy",
       unchanged,
       {step, "Target accuracy/Quantity=resultant"},
       {"Quantity = 'resultant'", "stage 'push'", "Duration"}},
      {"SearchBehind",
       unchanged,
       {step, "Safety/Strength reduction=yes"},
       {"Duration = '2'", "search for safety", "stage without a Duration"}},
      {"Built",
       {{"set Poisson ratio = 0.25", "set Poisson ratio = 0.25\n    set Built at stage = push"}},
       {step},
       {"Duration = '2'", "built or removed"}},
      {"Grouted",
       {{"set Duration = 2", "set Duration = 2\n    set Grouted joints = base"}},
       {step},
       {"Duration = '2'", "grouted"}},
      {"WaterThatFollows",
       {{"set Duration = 2", "set Duration = 2\n    set Water in joints = follows opening"}},
       {step},
       {"Water in joints = 'follows opening'", "unchanged"}},
      {"SettlementThatChanges",
       {{"crane: sin(pi*t/2)", "crane: t; settlement: 1 + 0.1*sin(pi*t)"}},
       {step},
       {"Stages/push/Loads", "'settlement' must not change"}},
      {"SettlementWithATimeOfItsOwn",
       {{"set Value = ; -0.001", "set Value = ; -0.001*t"}},
       {step},
       {"Stages/push/Duration = '2'", "'settlement'", "depends on t"}},
      {"NoRecord",
       unchanged,
       {step, "Earthquake/Stage=push"},
       {"Earthquake", "no record is given", "Record x"}},
      {"StageWithoutDuration",
       unchanged,
       {record, "Earthquake/Stage=weight"},
       {"Stage = 'weight'", "has no Duration", "push"}},
      {"UnknownStage",
       unchanged,
       {record, "Earthquake/Stage=quake"},
       {"Stage = 'quake'", "no stage 'quake'", "push"}},
      {"SeveralStages",
       {{"set Loads = weight: t;", "set Duration = 1\n    set Loads = weight: t;"},
        {"settlement: t", "settlement: 0"}},
       {record},
       {"Earthquake", "'Stage' is missing", "weight", "push"}},
      {"MissingFile",
       unchanged,
       {"Earthquake/Record x=nothing.txt"},
       {"Record x = 'nothing.txt'", "does not exist", "folder"}},
      {"Folder", unchanged, {"Earthquake/Record x=."}, {"Record x = '.'", "cannot be read"}},
      {"RecordZInThePlane",
       unchanged,
       {"Earthquake/Record z=record.txt"},
       {"Record z = 'record.txt'", "plane"}},
      {"SpoiltRecord",
       unchanged,
       {record, "Earthquake/Acceleration column=3"},
       {"record.txt:1:", "2 column(s)"}},
      {"SameColumn",
       unchanged,
       {record, "Earthquake/Acceleration column=1"},
       {"Acceleration column = '1'", "'Time column'"}},
      {"NoTimes",
       unchanged,
       {record, "Earthquake/Time column=0"},
       {"Time column = '0'", "'Record step' is needed"}},
      {"TimesAndAStep",
       unchanged,
       {record, "Earthquake/Record step=0.01"},
       {"Record step = '0.01'", "column of times"}},
      {"At2WithAStep",
       unchanged,
       {record, "Earthquake/Record format=at2", "Earthquake/Record step=0.01"},
       {"Record step = '0.01'", "at2"}},
      {"ScaleOfZero", unchanged, {record, "Earthquake/Scale=0"}, {"Scale = '0'", "not 0"}},
      {"AddedMassWithoutLevel",
       unchanged,
       {record,
        "Earthquake/Added mass boundaries=upstream",
        "Earthquake/Added mass bottom=0",
        "Earthquake/Added mass unit weight=0.01"},
       {"Added mass boundaries = 'upstream'", "'Added mass level' is missing"}},
      {"AddedMassWithoutBoundaries",
       unchanged,
       {record, "Earthquake/Added mass level=10"},
       {"Added mass level = '10'", "'Added mass boundaries' is missing"}},
      {"AddedMassWithoutDepth",
       unchanged,
       {record,
        "Earthquake/Added mass boundaries=upstream",
        "Earthquake/Added mass level=0",
        "Earthquake/Added mass bottom=0",
        "Earthquake/Added mass unit weight=0.01"},
       {"Added mass level = '0'", "no depth"}}};

    INSTANTIATE_TEST_SUITE_P(Dynamics, WrongDynamics, testing::ValuesIn(wrong), name_of);
  } // namespace
} // namespace fuga
