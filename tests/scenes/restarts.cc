// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/restarts.h"

#include "scenes/scene_run.h"

#include <fuga/input/read/read_parameters.h>
#include <fuga/output/files/output_files.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

namespace fuga::tests
{
  namespace fs = std::filesystem;

  namespace
  {
    class Stop
    {
    };

    std::string
    without_costs(const std::string &summary)
    {
      nlohmann::ordered_json remains = nlohmann::ordered_json::parse(summary);
      for (const char *key : {"seconds", "memory_MB", "work"})
        remains.erase(key);
      return remains.dump(1);
    }

    std::string
    without_restarts(const std::string &log)
    {
      std::istringstream lines(log);
      std::string remains;
      for (std::string line; std::getline(lines, line);)
        if (line.rfind("Time ", 0) != 0 && line.rfind("Restarted ", 0) != 0)
          remains += line + "\n";
      return remains;
    }

    std::unique_ptr<const Model<2>>
    model_of(const Parameters &parameters, const Checkpoint *checkpoint)
    {
      if (checkpoint == nullptr)
        return std::make_unique<const Model<2>>(parameters);
      return std::make_unique<const Model<2>>(parameters, checkpoint->construction);
    }
  } // namespace

  Results
  results(const std::string &directory)
  {
    Results files;
    for (const auto &entry : fs::directory_iterator(directory))
      {
        const std::string name = entry.path().filename();
        const std::string text = file_text(entry.path());
        if (name != checkpoint_file_name)
          files[name] = name == "summary.json" ? without_costs(text)
                        : name == "log.txt"    ? without_restarts(text)
                                               : text;
      }
    return files;
  }

  std::string
  differences(const Results &a, const Results &b)
  {
    std::string names;
    for (const auto &[name, text] : a)
      if (b.count(name) == 0 || b.at(name) != text)
        names += name + " ";
    for (const auto &[name, text] : b)
      if (a.count(name) == 0)
        names += name + " ";
    return names;
  }

  void
  run_until(const Parameters &parameters, const std::size_t last, const Checkpoint *checkpoint)
  {
    std::size_t count = 0;
    EXPECT_THROW(run_all_phases<2>(model_of(parameters, checkpoint),
                                   checkpoint,
                                   [&]() {
                                     if (++count == last)
                                       throw Stop();
                                   }),
                 Stop);
  }

  ExitCode
  run_rest(const Parameters &parameters)
  {
    const Checkpoint checkpoint = read_checkpoint(parameters.output.directory);
    EXPECT_FALSE(is_complete(checkpoint, parameters));
    EXPECT_NO_THROW(check_same_problem(checkpoint, parameters));
    return run_all_phases<2>(model_of(parameters, &checkpoint), &checkpoint);
  }

  std::size_t
  restart_everywhere(const std::string &file,
                     const std::vector<std::string> &overrides,
                     const std::size_t n_restarts,
                     const ExitCode code)
  {
    std::vector<std::string> all = {"Output/Log=quiet", "Output/Checkpoint=every event"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    Parameters parameters       = read_parameters(file, all);
    const std::string directory = parameters.output.directory = temporary_directory();
    std::size_t n_checkpoints                                 = 0;
    EXPECT_EQ(run_all_phases<2>(model_of(parameters, nullptr), nullptr, [&]() { ++n_checkpoints; }),
              code);
    const Results expected = results(directory);

    // The last one belongs to the finished run.
    const std::size_t stride = 1 + n_checkpoints / n_restarts;
    for (std::size_t i = 1; i < n_checkpoints; i += stride)
      {
        run_until(parameters, i);
        EXPECT_EQ(run_rest(parameters), code);
        EXPECT_EQ(differences(expected, results(directory)), "") << "checkpoint " << i;
        EXPECT_TRUE(is_complete(read_checkpoint(directory), parameters));
      }
    fs::remove_all(directory);
    return n_checkpoints;
  }
} // namespace fuga::tests
