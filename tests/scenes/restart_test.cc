// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Restart: the oracle is the unbroken run, the tolerance is no byte.

#include "scenes/keyed_blocks.h"
#include "scenes/restarts.h"
#include "scenes/scene_run.h"

#include <fuga/base/errors.h>
#include <fuga/input/read/read_parameters.h>
#include <fuga/output/files/output_files.h>
#include <fuga/run/simulation/simulation.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  namespace fs = std::filesystem;

  /** A copy of a shipped file with one more stage at the end. */
  std::string
  with_added_stage(const std::string &file, const std::string &loads, const unsigned int levels)
  {
    std::string text        = file_text(parameter_path(file));
    const std::string place = "../meshes/";
    text.replace(text.find(place), place.size(), std::string(FUGA_SOURCE_DIR) + "/meshes/");
    const std::size_t end = text.find("\nend", text.find("subsection Stages"));
    text.insert(end,
                "\n  subsection back\n    set Loads = " + loads +
                  "\n    set Levels = " + std::to_string(levels) + "\n  end");
    const std::string copy = temporary_directory() + "/" + file;
    std::ofstream(copy) << text;
    return copy;
  }

  std::size_t
  check(const std::string &file,
        const std::vector<std::string> &overrides,
        const std::size_t n_restarts,
        const ExitCode code = ExitCode::done)
  {
    return restart_everywhere(parameter_path(file), overrides, n_restarts, code);
  }
} // namespace

TEST(Restart, LinearLayer)
{
  EXPECT_GT(check("scene_g_f06.prm", {"Output/Fields=never"}, 25), 30u);
}

// The search for factors of safety is done again as a whole.
TEST(Restart, FactorsOfSafety)
{
  EXPECT_GT(
    check("scene_g_f06.prm",
          {"Output/Fields=never", "Safety/Strength reduction=yes", "Safety/Load factor=water"},
          4),
    30u);
}

TEST(Restart, LawNine)
{
  EXPECT_GT(check("paper_3_cubic_root.prm", {"Output/Fields=never"}, 12), 11u);
}

// Two elements at every corner.
TEST(Restart, Corners)
{
  const std::string file =
    write_scene(keyed_mesh(Profile::key, 2), keyed_blocks({{0.012, -0.006}}));
  EXPECT_GT(check(file, {"Output/Fields=never"}, 8), 15u);
}

TEST(Restart, RigidLayer)
{
  EXPECT_GT(check("scene_g_rigid_f06.prm", {"Output/Fields=never"}, 12), 20u);
}

// Bonds break, and the load goes back.
TEST(Restart, CohesionAndReversal)
{
  for (const char *law : {"linear", "cubic root"})
    EXPECT_GT(check(with_added_stage("paper_2_linear.prm", "push: 1.2-2.4*t", 5),
                    {"Output/Fields=never",
                     std::string("Joints/base/Normal law=") + law,
                     "Joints/base/Cohesion=0.002",
                     "Stages/push/Loads=push: 1.2*t"},
                    12),
              16u);
}

// With fields, whose collections go on; and to a limit load, after which one more state is
// written.
TEST(Restart, FieldsAndLimitLoad)
{
  EXPECT_GT(
    check("paper_2_linear.prm", {"Loads/push/Value=0.03"}, 6, ExitCode::loss_of_equilibrium), 8u);
}

// The table of the monitors goes on as the others do.
TEST(Restart, Monitors)
{
  const std::string file = with_added_stage("paper_2_linear.prm", "push: 1-t", 3);
  std::ofstream(file, std::ios::app) << "subsection Monitors\nsubsection crest\n"
                                        "set Point = 0, 12\nset Stress = true\nend\nend\n";
  EXPECT_GT(check(file, {"Output/Fields=never", "Output/Monitors=events"}, 6), 10u);
}

// Water that comes into the joint as it opens.
TEST(Restart, WaterInJoint)
{
  EXPECT_GT(check("dam.prm", {"Output/Fields=never", "Mesh/Polynomial degree=1"}, 8), 12u);
}

TEST(Restart, StageEnds)
{
  EXPECT_GE(check("paper_2_linear.prm", {"Output/Fields=never", "Solver/Follow=stage ends"}, 12),
            8u);
}

// A restarted run can be restarted itself, also from the same checkpoint again.
TEST(Restart, Again)
{
  Parameters parameters       = read_parameters(parameter_path("paper_2_linear.prm"),
                                          {"Output/Log=quiet", "Output/Checkpoint=every event"});
  const std::string directory = parameters.output.directory = temporary_directory();
  run_all_phases<2>(std::make_unique<const Model<2>>(parameters));
  const Results expected = results(directory);
  run_until(parameters, 2);
  for (const std::size_t last : {1u, 1u, 3u, 2u})
    {
      const Checkpoint checkpoint = read_checkpoint(directory);
      run_until(parameters, last, &checkpoint);
    }
  EXPECT_EQ(run_rest(parameters), ExitCode::done);
  EXPECT_EQ(differences(expected, results(directory)), "");
}

// Stages that are added to a finished run: as if they had been there from the beginning. Only the
// scale of the energy in the certificates of the earlier rows knows the loads of their time.
TEST(Restart, AddedStages)
{
  const std::string first  = parameter_path("paper_3_cubic_root.prm"),
                    all    = with_added_stage("paper_3_cubic_root.prm", "push: 1-1.7*t", 4);
  const std::string in_two = temporary_directory(), in_one = temporary_directory();
  const auto run = [&](const std::string &file, const std::string &directory, const bool restart) {
    Parameters parameters = read_parameters(file, {"Output/Fields=never", "Output/Log=quiet"});
    parameters.output.directory = directory;
    const Model<2> model(parameters);
    Simulation<2> simulation(model);
    if (!restart)
      return simulation.run();
    const Checkpoint checkpoint = read_checkpoint(directory);
    check_same_problem(checkpoint, parameters);
    EXPECT_FALSE(is_complete(checkpoint, parameters));
    return simulation.resume(checkpoint);
  };
  run(all, in_one, false);
  run(first, in_two, false);
  EXPECT_EQ(run(all, in_two, true), ExitCode::done);
  EXPECT_EQ(file_text(in_one + "/joint_history.csv"), file_text(in_two + "/joint_history.csv"));
  for (const char *name : {"/events.csv", "/resultants.csv"})
    {
      CsvTable a = parse_csv(file_text(in_one + name)), b = parse_csv(file_text(in_two + name));
      const auto certificate = static_cast<std::ptrdiff_t>(a.column("certificate"));
      for (CsvTable *table : {&a, &b})
        for (auto &row : table->rows)
          row.erase(row.begin() + certificate);
      EXPECT_TRUE(a.rows == b.rows) << name;
      EXPECT_GE(a.rows.size(), 10u);
    }
}

namespace
{
  /** What --restart says with these changes after a finished run, whose files must remain. */
  class RestartedProgram
  {
  public:
    RestartedProgram() : directory(temporary_directory())
    {
      EXPECT_EQ(run({}, false).exit_code, 0);
      before = all_files();
    }

    ProgramRun
    run(const std::vector<std::string> &more,
        const bool restart      = true,
        const std::string &file = parameter_path("paper_2_linear.prm")) const
    {
      std::vector<std::string> words = {file, "--output-dir", directory};
      if (restart)
        words.push_back("--restart");
      words.insert(words.end(), more.begin(), more.end());
      return run_program(words);
    }

    std::map<std::string, std::string>
    all_files() const
    {
      std::map<std::string, std::string> files;
      for (const auto &entry : fs::directory_iterator(directory))
        files[entry.path().filename()] = file_text(entry.path());
      return files;
    }

    void
    expect_refusal(const std::vector<std::string> &more,
                   const std::vector<std::string> &words,
                   const std::string &file = parameter_path("paper_2_linear.prm")) const
    {
      const auto found     = all_files();
      const ProgramRun run = this->run(more, true, file);
      EXPECT_EQ(run.exit_code, 1);
      for (const std::string &word : words)
        EXPECT_NE(run.err.find(word), std::string::npos) << word << " not in\n" << run.err;
      EXPECT_TRUE(all_files() == found);
    }

    const std::string directory;
    std::map<std::string, std::string> before;
  };
} // namespace

// Changed physics is refused: every change is named with both values, and no file is touched.
TEST(Restart, ChangedProblemIsRefused)
{
  const RestartedProgram program;
  program.expect_refusal({"--set",
                          "Bodies/structure/Young modulus=3061",
                          "--set",
                          "Joints/base/Friction coefficient=",
                          "--set",
                          "Joints/base/Friction angle=20"},
                         {"Bodies/structure/Young modulus: was 3060, is 3061",
                          "Joints/base/Friction coefficient: was 0.2, is not there now",
                          "Joints/base/Friction angle: was not there, is 20",
                          "without --restart"});
  program.expect_refusal({"--set", "Stages/push/Levels=9"}, {"Stages/push/Levels: was 10, is 9"});
  program.expect_refusal({"--set", "Solver/Follow=stage ends"},
                         {"Solver/Follow: was events, is stage ends"});
  program.expect_refusal({"--set", "Loads/push/Value=0.0144*t"},
                         {"Loads/push/Value: was 0.0144, is 0.0144*t", "Stages/back: added"},
                         with_added_stage("paper_2_linear.prm", "push: 1-t", 1));
  program.expect_refusal({"--set", "Sweep/Cohesion=0, 1"}, {"sweep cannot be restarted"});

  const std::string mesh = temporary_directory() + "/changed.msh";
  std::ofstream(mesh) << file_text(std::string(FUGA_SOURCE_DIR) + "/meshes/s0.msh") << "\n";
  program.expect_refusal({"--set", "Mesh/File=" + mesh}, {"changed.msh: another content"});
}

// A complete run: nothing happens, and the exit code is that of the run; also with entries changed
// that do not matter, and with the same mesh in another place.
TEST(Restart, CompleteRunRemains)
{
  const RestartedProgram program;
  const std::string mesh = temporary_directory() + "/copy.msh";
  fs::copy_file(std::string(FUGA_SOURCE_DIR) + "/meshes/s0.msh", mesh);
  for (const std::vector<std::string> &more :
       {std::vector<std::string>(),
        {"--set", "Title=other", "--set", "Output/Fields=never", "--set", "Output/Log=levels"},
        {"--set", "Solver/Certificate bound=1e-8", "--set", "Mesh/File=" + mesh}})
    {
      const ProgramRun run = program.run(more);
      EXPECT_EQ(run.exit_code, 0) << run.err;
      EXPECT_NE(run.out.find("complete"), std::string::npos) << run.out;
      EXPECT_TRUE(program.all_files() == program.before);
    }
  const std::string limit = temporary_directory();
  for (const bool restart : {false, true})
    {
      std::vector<std::string> words = {restart
                                          ? with_added_stage("paper_2_linear.prm", "push: 1-t", 1)
                                          : parameter_path("paper_2_linear.prm"),
                                        "--output-dir",
                                        limit,
                                        "--set",
                                        "Loads/push/Value=0.03"};
      if (restart)
        words.push_back("--restart");
      EXPECT_EQ(run_program(words).exit_code, 3);
    }
}

// What cannot be continued is said, with what to do; nothing is written.
TEST(Restart, DamagedOrMissing)
{
  const RestartedProgram program;
  const std::string path = program.directory + "/" + checkpoint_file_name;
  const std::string good = file_text(path);
  const auto put         = [&](const std::string &name, const std::string &text) {
    std::ofstream(program.directory + "/" + name, std::ios::binary) << text;
  };
  for (const double share : {0., 0.1, 0.5, 0.999})
    {
      put(checkpoint_file_name,
          good.substr(0, static_cast<std::size_t>(share * static_cast<double>(good.size()))));
      program.expect_refusal({}, {"damaged", "without --restart"});
    }
  for (const double share : {0.3, 0.6, 0.9})
    {
      std::string bad = good;
      bad[static_cast<std::size_t>(share * static_cast<double>(good.size()))] ^= 1;
      put(checkpoint_file_name, bad);
      program.expect_refusal({}, {"damaged", "without --restart"});
    }
  put(checkpoint_file_name, good);
  const std::string table = program.before.at("joint_history.csv");
  put("joint_history.csv", table.substr(0, table.size() - 2));
  program.expect_refusal({}, {"joint_history.csv", "without --restart"});
  put("joint_history.csv", table);
  fs::remove(program.directory + "/bodies_0003.vtu");
  program.expect_refusal({}, {"bodies_0003.vtu is gone"});
  fs::remove(path);
  program.expect_refusal({}, {"no checkpoint", "--output-dir"});
  const std::string absent = program.directory + "/absent";
  EXPECT_EQ(run_program({parameter_path("paper_2_linear.prm"), "--restart", "--output-dir", absent})
              .exit_code,
            1);
  EXPECT_FALSE(fs::exists(absent));
}
