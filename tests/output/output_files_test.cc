// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// The order in which the results of an earlier run go: killed.py hits it by chance only.

#include <fuga/output/files/output_files.h>
#include <gtest/gtest.h>

#include <filesystem>

using namespace fuga;

TEST(OutputFiles, NothingCanBeRestartedWhoseResultsBeginToGo)
{
  namespace fs         = std::filesystem;
  const fs::path where = fs::path(testing::TempDir()) / "fuga_output_files";
  fs::remove_all(where);
  fs::create_directories(where);
  const auto exists = [&](const char *name) { return fs::exists(where / name); };
  for (const char *name : {"checkpoint.cbor", "summary.json", "joints.pvd", "joints_0000.vtu"})
    write_complete_file((where / name).string(), name);
  begin_results(where.string(), [&]() {
    EXPECT_FALSE(exists("checkpoint.cbor"));
    EXPECT_TRUE(exists("joints.pvd"));
    write_complete_file((where / "summary.json").string(), "unfinished");
  });
  EXPECT_EQ(read_file((where / "summary.json").string()), "unfinished");
  EXPECT_FALSE(exists("joints.pvd"));
  EXPECT_FALSE(exists("joints_0000.vtu"));
  fs::remove_all(where);
}
