// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/scene_run.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  namespace fs = std::filesystem;

  /** Names and contents of all files. */
  std::map<std::string, std::string>
  contents(const std::string &directory)
  {
    std::map<std::string, std::string> files;
    for (const auto &entry : fs::recursive_directory_iterator(directory))
      files[entry.path().string()] = entry.is_regular_file() ? file_text(entry.path()) : "";
    return files;
  }

  ProgramRun
  run_into(const std::string &directory, std::vector<std::string> arguments)
  {
    arguments.insert(arguments.end(), {"--output-dir", directory});
    return run_program(arguments);
  }
} // namespace

// Exit codes (doc/results.md): 0 done, 3 at a limit load, 4 with a bound that nothing meets,
// 1 for wrong input (with a message on the error stream); the summary says the same code.
TEST(Program, ExitCodes)
{
  const std::string directory = temporary_directory(), file = parameter_path("paper_2_linear.prm");
  const auto summary_code = [&]() {
    return nlohmann::json::parse(file_text(directory + "/summary.json")).at("exit_code").get<int>();
  };
  EXPECT_EQ(run_into(directory, {file}).exit_code, 0);
  EXPECT_EQ(summary_code(), 0);
  // S0 slides at q = f·1.152/12 = 0.0192.
  EXPECT_EQ(run_into(directory, {file, "--set", "Loads/push/Value=0.03"}).exit_code, 3);
  EXPECT_EQ(summary_code(), 3);
  EXPECT_EQ(nlohmann::json::parse(file_text(directory + "/summary.json")).at("verdict"),
            "limit load");
  EXPECT_EQ(run_into(directory, {file, "--set", "Solver/Certificate bound=1e-300"}).exit_code, 4);
  EXPECT_EQ(summary_code(), 4);
  const ProgramRun wrong =
    run_into(directory, {file, "--set", "Joints/base/Friction coefficient=-1"});
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_NE(wrong.err.find("Friction coefficient"), std::string::npos) << wrong.err;
  EXPECT_EQ(run_program({"no_such_file.prm"}).exit_code, 1);
  const ProgramRun alone = run_program({}); // says what to type
  EXPECT_EQ(alone.exit_code, 1);
  for (const char *word : {"fuga my.prm", "--check", "report", "--print-parameters", "--help"})
    EXPECT_NE(alone.err.find(word), std::string::npos) << alone.err;
  EXPECT_EQ(run_program({file, "--no-such-option"}).exit_code, 1);
}

// Wrong input ends before anything is written: an earlier result remains as it was, to the byte,
// and no new directory appears. The same for --check. Errors in file, mesh, model and loads.
TEST(Program, WrongInputTouchesNothing)
{
  const std::string directory = temporary_directory(), file = parameter_path("paper_2_linear.prm");
  ASSERT_EQ(run_into(directory, {file}).exit_code, 0);
  const auto before = contents(directory);
  EXPECT_GE(before.size(), 6u);
  for (const char *mistake : {"Bodies/structure/Young modulus=-1",
                              "Mesh/File=missing.msh",
                              "Joints/base/Line=no_such_line",
                              "Boundaries/no_such_boundary/Fixed=all",
                              "Loads/push/Boundaries=nowhere",
                              "Stages/push/Loads=push: foo(t)",
                              "Stages/push/Loads=push: 1+t",
                              "Joints/base/Initial gap=-1",
                              "Bodies/structure/Young moduls=1",
                              "Output/Fields=sometimes"})
    {
      EXPECT_EQ(run_into(directory, {file, "--set", mistake}).exit_code, 1) << mistake;
      EXPECT_EQ(contents(directory), before) << mistake;
    }
  EXPECT_EQ(run_into(directory, {file, "--check"}).exit_code, 0);
  EXPECT_EQ(contents(directory), before);
  const std::string absent = directory + "/absent";
  EXPECT_EQ(run_into(absent, {file, "--check"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(absent));
  EXPECT_EQ(run_into(absent, {file, "--set", "Mesh/File=missing.msh"}).exit_code, 1);
  EXPECT_FALSE(fs::exists(absent));
}

// A directory never shows two runs: a shorter run removes what a longer one left, and nothing that
// is not ours.
TEST(Program, ResultsOfTwoRunsDoNotMix)
{
  const std::string directory = temporary_directory(), file = parameter_path("paper_2_linear.prm");
  std::ofstream(directory + "/notes.txt") << "mine";
  ASSERT_EQ(run_into(directory, {file}).exit_code, 0);
  const std::size_t n_long = contents(directory).size();
  ASSERT_EQ(run_into(directory, {file, "--set", "Output/Fields=end"}).exit_code, 0);
  EXPECT_LT(contents(directory).size(), n_long);
  EXPECT_EQ(file_text(directory + "/notes.txt"), "mine");
  std::size_t n_vtu = 0;
  for (const auto &[name, text] : contents(directory))
    n_vtu += fs::path(name).extension() == ".vtu" ? 1 : 0;
  EXPECT_EQ(n_vtu, 3u);
}

// --quiet says nothing; the default says a header, the events and the verdict; --version and
// --help and --print-parameters work without a file, and the printed parameters can be read.
TEST(Program, WhatItSays)
{
  const std::string directory = temporary_directory(), file = parameter_path("paper_2_linear.prm");
  const ProgramRun quiet = run_into(directory, {file, "--quiet"});
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_EQ(quiet.out + quiet.err, "");
  const ProgramRun loud = run_into(directory, {file});
  EXPECT_NE(loud.out.find("Verdict"), std::string::npos);
  EXPECT_EQ(loud.err, "");
  for (const char *option : {"--version", "--help", "--print-parameters"})
    {
      const ProgramRun run = run_program({option});
      EXPECT_EQ(run.exit_code, 0) << option;
      EXPECT_FALSE(run.out.empty()) << option;
    }
}

// Threads are no part of the problem: results agree to rounding amplified by the condition, 1e-10.
TEST(Program, ThreadsDoNotMatter)
{
  const std::string one = temporary_directory(), two = temporary_directory(),
                    file = parameter_path("scene_g_f06.prm");
  ASSERT_EQ(run_into(one, {file, "--set", "Output/Fields=never"}).exit_code, 0);
  ASSERT_EQ(run_into(two, {file, "--set", "Output/Fields=never", "--threads", "2"}).exit_code, 0);
  SceneRun a, b;
  a.history = parse_csv(file_text(one + "/joint_history.csv"));
  b.history = parse_csv(file_text(two + "/joint_history.csv"));
  for (const char *name : {"N", "T1", "jump_n", "jump_t1"})
    EXPECT_LE(deviation(a.values(name, 2.), b.values(name, 2.)), 1e-10) << name;
}
