// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/scene_run.h"

#include <fuga/input/read/read_parameters.h>
#include <fuga/run/simulation/simulation.h>
#include <fuga/study/sweep.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

using namespace fuga;
using namespace fuga::tests;

// Nothing is computed that a scene does not need. Counters and phases, all of them exact numbers
// that follow from what was asked for.
namespace
{
  using Phases = std::vector<std::pair<std::string, double>>;

  Parameters
  parameters_of(const std::string &file, std::vector<std::string> overrides)
  {
    overrides.push_back("Output/Log=quiet");
    Parameters parameters       = read_parameters(parameter_path(file), overrides);
    parameters.output.directory = temporary_directory();
    return parameters;
  }

  double
  seconds_of(const Phases &phases, const std::string &name)
  {
    for (const auto &[phase, seconds] : phases)
      if (phase == name)
        return seconds;
    return 0.;
  }

  std::size_t
  n_files(const std::string &directory, const std::string &begin)
  {
    std::size_t n = 0;
    for (const auto &entry : std::filesystem::recursive_directory_iterator(directory))
      n +=
        entry.path().extension() == ".vtu" && entry.path().filename().string().rfind(begin, 0) == 0;
    return n;
  }
} // namespace

// Without friction there are normal bars only (the block is held along the joint by its other
// side); with it, two per element, but for one at a corner that is fixed.
TEST(Skip, TangentialBarsWithoutFriction)
{
  const SceneRun with    = run_scene("raous_near_rigid.prm");
  const SceneRun without = run_scene(
    "raous_near_rigid.prm", {"Joints/base/Friction coefficient=0", "Joints/base/Shear stiffness="});
  const auto n = without.summary.at("sizes").at("contact_elements").get<std::size_t>();
  EXPECT_EQ(with.summary.at("sizes").at("contact_elements"), n);
  EXPECT_GE(with.summary.at("sizes").at("bars").get<std::size_t>(), 2 * n - 1);
  EXPECT_EQ(without.summary.at("sizes").at("bars"), n);
}

// Linear laws are never iterated; law (9) is.
TEST(Skip, IterationsOfLinearLaws)
{
  const SceneRun linear = run_scene("paper_2_linear.prm");
  const SceneRun curved = run_scene("paper_3_cubic_root.prm");
  EXPECT_EQ(linear.summary.at("iterations").at("iterations"), 0);
  EXPECT_GT(curved.summary.at("iterations").at("iterations"), 0);
}

// Fields are recovered at written levels only: eleven files, one, none; and then no time at all is
// booked to recovery and fields.
TEST(Skip, FieldsThatAreNotWritten)
{
  const std::pair<const char *, std::size_t> cases[] = {{"levels", 11}, {"end", 1}, {"never", 0}};
  for (const auto &[fields, n] : cases)
    {
      const Parameters parameters =
        parameters_of("scene_g_f06.prm", {std::string("Output/Fields=") + fields});
      const Model<2> model(parameters);
      EXPECT_EQ(Simulation<2>(model).run(), ExitCode::done);
      EXPECT_EQ(n_files(parameters.output.directory, "bodies"), n) << fields;
      for (const char *phase : {"recovery of displacements", "fields"})
        EXPECT_EQ(seconds_of(model.timer.seconds(), phase) > 0., n > 0) << phase;
    }
}

// The end of a monotone stage alone: no events, one implicit step per stage, and the state to which
// the events lead (1e-12: the same linear equations).
TEST(Skip, EventsIfOnlyStageEndsAreAskedFor)
{
  const std::vector<std::string> quick = {"Stages/water/Levels=1"};
  std::vector<std::string> ends        = quick;
  ends.push_back("Solver/Follow=stage ends");
  const SceneRun events = run_scene("scene_g_f06.prm", quick);
  const SceneRun steps  = run_scene("scene_g_f06.prm", ends);
  EXPECT_EQ(events.summary.at("events").at("total"), 30);
  EXPECT_EQ(steps.summary.at("events").at("total"), 0);
  EXPECT_EQ(steps.summary.at("events").at("implicit_steps"), 2);
  EXPECT_LT(steps.summary.at("events").at("schemes_tried"),
            events.summary.at("events").at("schemes_tried"));
  EXPECT_LE(deviation(steps.values("N", 2.), events.values("N", 2.)), 1e-12);
}

// A sweep whose eight variants differ in the strength of a joint condenses the bodies and the two
// loads once, and forms one layered system.
TEST(Skip, CondensationOfVariants)
{
  const Parameters parameters = parameters_of(
    "scene_g_f06.prm",
    {"Output/Fields=never", "Sweep/Friction coefficient=0.5 : 0.1 : 0.8", "Sweep/Cohesion=0, 10"});
  ASSERT_EQ(parameters.variants.size(), 8u);
  EXPECT_EQ(Sweep<2>(parameters).run(), ExitCode::done);
  const nlohmann::json summary =
    nlohmann::json::parse(std::ifstream(parameters.output.directory + "/summary.json"));
  EXPECT_EQ(summary.at("variants"), 8);
  EXPECT_EQ(summary.at("condensations"), 1);
  const nlohmann::json &work = summary.at("work");
  EXPECT_EQ(work.at("factorisations_of_bodies"), 1);
  EXPECT_EQ(work.at("condensed_loads"), 2);
  EXPECT_EQ(work.at("solutions_of_bodies"), 2);
  EXPECT_EQ(work.at("layered_systems"), 1);
}

// The bodies away from the joint are condensed, never seen again: of 5036 degrees of freedom the
// system of the path keeps the 66 jumps. And of these only those of elements that change their
// state are ever unknown: all rows and exchanges of the working scheme belong to them.
TEST(Skip, WhatNeverLeavesItsFirstState)
{
  class Watch : public PathObserver
  {
  public:
    std::set<std::size_t> changing;

    bool
    wants_cuts() const override
    {
      return true;
    }

    void
    advanced(const PathPoint &, const PathPoint &, const double) override
    {
    }

    void
    jumped(const JointState &) override
    {
    }

    void
    changed(const std::vector<ContactEvent> &events, const JointState &) override
    {
      for (const ContactEvent &event : events)
        changing.insert(event.element);
    }

    void
    reached(const std::size_t, const JointState &) override
    {
    }
  };

  const Parameters parameters = parameters_of("scene_g_f02.prm", {});
  const Model<2> model(parameters);
  EXPECT_EQ(model.bodies.discretization().n_dofs(), 5036u);
  EXPECT_EQ(model.bodies.stiffness().rows(), 66u);

  const JointModel joint =
    make_joint_model<2>(model.bodies, parameters.joints, parameters.model.constants);
  const LayeredSystem layered(model.bodies, joint.elements);
  EventPath path(joint.elements, layered, model.loads.history, model.path_options());
  Watch watch;
  path.run(model.loads.levels, watch);
  EXPECT_GE(watch.changing.size(), 3u);
  EXPECT_LT(watch.changing.size(), joint.elements.size());
  const SchemeMemory &scheme = path.last_cut().memory.scheme;
  EXPECT_FALSE(scheme.rows.empty());
  for (const auto *rows : {&scheme.rows, &scheme.factorised_rows})
    for (const SchemeRow &row : *rows)
      EXPECT_EQ(watch.changing.count(row.element), 1u) << row.element;
  for (const RowExchange &exchange : scheme.exchanges)
    if (exchange.removed == RowExchange::none)
      {
        EXPECT_EQ(watch.changing.count(exchange.appended.element), 1u);
      }
}

// A joint that holds costs one scheme for each of the two stages; no row is ever active.
TEST(Skip, SchemesOfAJointThatHolds)
{
  const std::vector<std::string> bonded = {"Joints/base/Normal law=rigid",
                                           "Joints/base/Shear law=rigid",
                                           "Joints/base/Normal stiffness=",
                                           "Joints/base/Shear stiffness=",
                                           "Joints/base/Friction coefficient=5",
                                           "Joints/base/Cohesion=1e9",
                                           "Joints/base/Tensile strength=1e8",
                                           "Stages/water/Levels=1"};
  const SceneRun run                    = run_scene("scene_g_f06.prm", bonded);
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.summary.at("events").at("total"), 0);
  EXPECT_EQ(run.summary.at("events").at("schemes_tried"), 2);
  EXPECT_EQ(run.summary.at("events").at("steps"), 2);
}
