// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/scene_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  namespace fs = std::filesystem;

  std::vector<std::string>
  shipped_files()
  {
    std::vector<std::string> files;
    for (const auto &entry : fs::directory_iterator(std::string(FUGA_SOURCE_DIR) + "/parameters"))
      if (entry.path().extension() == ".prm")
        files.push_back(entry.path().filename().string());
    std::sort(files.begin(), files.end());
    return files;
  }

  std::vector<std::string>
  names_without_units(const CsvTable &table)
  {
    std::vector<std::string> names;
    for (const std::string &name : table.header)
      names.push_back(name.substr(0, name.find('[')));
    return names;
  }

  class Shipped : public testing::TestWithParam<std::string>
  {
  protected:
    /** The run of the file, which its tests share. */
    const SceneRun &
    run() const
    {
      static std::map<std::string, SceneRun> runs;
      const auto known = runs.find(GetParam());
      return known != runs.end() ? known->second
                                 : runs.emplace(GetParam(), run_scene(GetParam())).first->second;
    }
  };
} // namespace

// The contract: every example runs to its end; the certificate of every
// event, level and of the whole is below 1e-9; the columns are those of doc/results.md,
// and those of space and of water in joints behind them.
TEST_P(Shipped, RunsAndIsCertified)
{
  const SceneRun &run = this->run();
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.summary.at("verdict"), "done");
  EXPECT_LE(run.certificate(), 1e-9) << run.summary.at("certificate").dump(1);
  // The layer of the printed number is stiffer than the bodies, which the program shall say.
  EXPECT_EQ(run.summary.at("warnings").size(), GetParam() == "paper_2_as_printed.prm" ? 1u : 0u)
    << run.summary.at("warnings").dump(1);
  for (std::size_t r = 0; r < run.events.rows.size(); ++r)
    EXPECT_LE(run.events.number(r, "certificate"), 1e-9) << r;
  for (std::size_t r = 0; r < run.resultants.rows.size(); ++r)
    EXPECT_LE(run.resultants.number(r, "certificate"), 1e-9) << r;

  const std::vector<std::string> driven = {"driven_by", "drive"};
  std::vector<std::string> events       = {"event",
                                           "t",
                                           "stage",
                                           "stage_fraction",
                                           "joint",
                                           "element",
                                           "x",
                                           "y",
                                           "z",
                                           "from",
                                           "to",
                                           "certificate",
                                           "continuations",
                                           "path_length"};
  std::vector<std::string> history      = {
         "t",     "joint", "element", "x",      "y",        "z",       "area",
         "state", "N",     "T1",      "T2",     "pressure", "shear1",  "shear2",
         "gap",   "slip1", "slip2",   "jump_n", "jump_t1",  "jump_t2", "path_length"};
  const bool is_block  = GetParam() == "dam_block_3d.prm";
  const bool in_space  = is_block || GetParam() == "arch_dam.prm";
  const bool has_water = GetParam() == "dam.prm" || GetParam() == "dam_earthquake.prm" ||
                         GetParam() == "high_dam.prm" || is_block;
  if (has_water)
    history.push_back("water_pressure");
  if (GetParam() == "dam_earthquake.prm") // its bodies move
    events.push_back("energy");
  events.insert(events.end(), driven.begin(), driven.end());
  history.insert(history.end(), driven.begin(), driven.end());
  EXPECT_EQ(names_without_units(run.events), events);
  EXPECT_EQ(names_without_units(run.history), history);
  std::vector<std::string> resultants = {"t",
                                         "joint",
                                         "N",
                                         "T",
                                         "M",
                                         "position_x",
                                         "position_y",
                                         "share_open",
                                         "share_stick",
                                         "share_slip",
                                         "largest_pressure",
                                         "largest_gap",
                                         "largest_slip",
                                         "sliding_safety",
                                         "external_work",
                                         "energy_bodies",
                                         "energy_layer",
                                         "dissipation",
                                         "certificate",
                                         "path_length",
                                         "eccentricity",
                                         "in_middle_third",
                                         "overturning_safety",
                                         "share_compression",
                                         "cracked_length",
                                         "crack_from_first",
                                         "crack_from_last",
                                         "smallest_pressure",
                                         "joint_dissipation"};
  if (in_space)
    for (const char *column : {"T2",
                               "M1",
                               "Mn",
                               "eccentricity2",
                               "position_z",
                               "normal_x",
                               "normal_y",
                               "normal_z",
                               "t1_x",
                               "t1_y",
                               "t1_z"})
      resultants.push_back(column);
  if (has_water)
    resultants.push_back("water");
  resultants.insert(resultants.end(), driven.begin(), driven.end());
  EXPECT_EQ(names_without_units(run.resultants), resultants);
}

// Row counts by definition: one per element and level, one per joint and level, one per event;
// numbered events in the order of their loads; shares add to one; stage and fraction belong to t.
TEST_P(Shipped, TablesAreComplete)
{
  const SceneRun &run = this->run();
  std::set<double> levels;
  std::set<std::string> joints;
  for (std::size_t r = 0; r < run.resultants.rows.size(); ++r)
    {
      levels.insert(run.resultants.number(r, "t"));
      joints.insert(run.resultants.text(r, "joint"));
      EXPECT_NEAR(run.resultants.number(r, "share_open") + run.resultants.number(r, "share_stick") +
                    run.resultants.number(r, "share_slip"),
                  1.,
                  1e-9);
    }
  std::size_t expected_levels = 0;
  for (const auto &stage : run.summary.at("parameters").at("Stages"))
    expected_levels += std::stoul(stage.at("Levels").get<std::string>());
  const auto n_elements = run.summary.at("sizes").at("contact_elements").get<std::size_t>();
  EXPECT_EQ(levels.size(), expected_levels);
  bool in_phases = false;
  for (const auto &body : run.summary.at("parameters").at("Bodies"))
    in_phases = in_phases || body.contains("Built at stage");
  if (in_phases) // joints that are built later have fewer rows
    EXPECT_LT(run.history.rows.size(), levels.size() * n_elements);
  else
    {
      EXPECT_EQ(run.resultants.rows.size(), levels.size() * joints.size());
      EXPECT_EQ(run.history.rows.size(), levels.size() * n_elements);
    }
  EXPECT_EQ(run.events.rows.size(), run.summary.at("events").at("total").get<std::size_t>());
  std::size_t by_kind = 0;
  for (const auto &count : run.summary.at("events").at("by_kind"))
    by_kind += count.get<std::size_t>();
  EXPECT_EQ(by_kind, run.events.rows.size());

  double before = 0.;
  for (std::size_t r = 0; r < run.events.rows.size(); ++r)
    {
      const double t = run.events.number(r, "t");
      EXPECT_EQ(run.events.text(r, "event"), std::to_string(r + 1));
      EXPECT_GE(t, before);
      EXPECT_NE(run.events.text(r, "from"), run.events.text(r, "to"));
      const double fraction = run.events.number(r, "stage_fraction");
      const double offset   = t - fraction;
      EXPECT_NEAR(offset, std::round(offset), 1e-12);
      EXPECT_GE(fraction, 0.);
      EXPECT_LE(fraction, 1.);
      before = t;
    }
}

// What the columns of joint_history.csv mean (doc/results.md): pressure = -N/A ≥ 0, shear =
// T/A, gap only where open, no force there. The numbers have 17 digits: 1e-15 relative.
TEST_P(Shipped, ColumnsAgree)
{
  const CsvTable &history = run().history;
  for (std::size_t r = 0; r < history.rows.size(); ++r)
    {
      const double A = history.number(r, "area"), N = history.number(r, "N");
      EXPECT_GT(A, 0.);
      EXPECT_LE(N, 0.);
      EXPECT_NEAR(history.number(r, "pressure") * A, -N, 4e-16 * std::abs(N));
      EXPECT_NEAR(history.number(r, "shear1") * A,
                  history.number(r, "T1"),
                  4e-16 * std::abs(history.number(r, "T1")));
      EXPECT_GE(history.number(r, "gap"), 0.);
      const std::string &state = history.text(r, "state");
      if (state == "open")
        {
          EXPECT_EQ(N, 0.);
          EXPECT_EQ(history.number(r, "T1"), 0.);
        }
      else
        {
          EXPECT_TRUE(state == "stick" || state == "slip") << state;
          EXPECT_EQ(history.number(r, "gap"), 0.);
        }
    }
}

// What summary.json must contain.
TEST_P(Shipped, SummaryIsComplete)
{
  const nlohmann::json &summary = run().summary;
  for (const char *entry : {"verdict",
                            "exit_code",
                            "sizes",
                            "events",
                            "certificate",
                            "seconds",
                            "memory_MB",
                            "versions",
                            "parameters",
                            "warnings",
                            "t",
                            "load_factors"})
    EXPECT_TRUE(summary.contains(entry)) << entry;
  EXPECT_EQ(summary.at("exit_code"), 0);
  EXPECT_GT(summary.at("memory_MB").get<double>(), 1.);
  EXPECT_EQ(summary.at("certificate").at("entries").size(), 9u);
  EXPECT_TRUE(summary.at("versions").contains("fuga"));
  for (const char *section :
       {"Mesh", "Bodies", "Joints", "Boundaries", "Loads", "Stages", "Solver", "Output"})
    EXPECT_TRUE(summary.at("parameters").contains(section)) << section;
}

INSTANTIATE_TEST_SUITE_P(Files, Shipped, testing::ValuesIn(shipped_files()));
