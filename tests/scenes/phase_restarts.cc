// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/phase_restarts.h"

#include "scenes/scene_run.h"

#include <fuga/input/read/read_parameters.h>
#include <fuga/output/files/output_files.h>
#include <fuga/run/simulation/phases.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <sstream>

namespace fuga::tests
{
  namespace fs = std::filesystem;

  namespace
  {
    class Stop
    {
    };

    /** Files of a run by name, without what may differ: times, memory, and that it was restarted.
     */
    std::map<std::string, std::string>
    results(const std::string &directory)
    {
      std::map<std::string, std::string> files;
      for (const auto &entry : fs::directory_iterator(directory))
        {
          const std::string name = entry.path().filename();
          std::string text       = file_text(entry.path());
          if (name == checkpoint_file_name)
            continue;
          if (name == "summary.json")
            {
              nlohmann::ordered_json summary = nlohmann::ordered_json::parse(text);
              for (const char *key : {"seconds", "memory_MB", "work"})
                summary.erase(key);
              text = summary.dump(1);
            }
          if (name == "log.txt")
            {
              std::istringstream lines(text);
              text.clear();
              for (std::string line; std::getline(lines, line);)
                if (line.rfind("Time ", 0) != 0 && line.rfind("Restarted ", 0) != 0)
                  text += line + "\n";
            }
          files[name] = text;
        }
      return files;
    }
  } // namespace

  std::size_t
  restart_everywhere(const std::string &file,
                     const std::vector<std::string> &overrides,
                     const std::size_t stride)
  {
    std::vector<std::string> all = overrides;
    all.push_back("Output/Checkpoint=every event");
    Parameters parameters       = read_parameters(file, all);
    const std::string directory = parameters.output.directory = temporary_directory();
    std::size_t n_checkpoints                                 = 0;
    const auto code                                           = run_all_phases<2>(
      std::make_unique<const Model<2>>(parameters), nullptr, [&]() { ++n_checkpoints; });
    EXPECT_EQ(code, ExitCode::done);
    const auto expected = results(directory);
    for (std::size_t last = 1; last < n_checkpoints; last += stride)
      {
        std::size_t count = 0;
        EXPECT_THROW(run_all_phases<2>(std::make_unique<const Model<2>>(parameters),
                                       nullptr,
                                       [&]() {
                                         if (++count == last)
                                           throw Stop();
                                       }),
                     Stop);
        const Checkpoint checkpoint = read_checkpoint(directory);
        EXPECT_EQ(
          run_all_phases<2>(std::make_unique<const Model<2>>(parameters, checkpoint.construction),
                            &checkpoint),
          code);
        const auto found = results(directory);
        for (const auto &[name, text] : expected)
          EXPECT_TRUE(found.count(name) == 1 && found.at(name) == text)
            << name << " behind checkpoint " << last;
        EXPECT_EQ(found.size(), expected.size());
      }
    return n_checkpoints;
  }
} // namespace fuga::tests
