// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// What the estimates decide where one of them decides alone.

#include <fuga/base/process_info.h>
#include <fuga/bodies/solver_choice.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

using namespace fuga;

namespace
{
  EliminationSize
  hundred_thousand_unknowns()
  {
    EliminationSize size;
    size.dimension         = 3;
    size.n_entries         = 4000000;
    size.n_unknowns        = 100000;
    size.n_interface       = 1000;
    size.direct_megabytes  = 1.;
    size.direct_operations = 1e11;
    return size;
  }

  /** Files as the kernel shows them, in a folder of their own. */
  class MachineFiles : public ::testing::Test
  {
  protected:
    void
    SetUp() override
    {
      root = ::testing::TempDir() + "fuga_machine_" +
             ::testing::UnitTest::GetInstance()->current_test_info()->name();
      std::filesystem::remove_all(root);
      write("/proc/meminfo",
            "MemTotal:       16777216 kB\nMemFree:        " + std::to_string(kilobytes_free) +
              " kB\nMemAvailable:   " + std::to_string(kilobytes_free) + " kB\n");
    }

    void
    write(const std::string &path, const std::string &text) const
    {
      std::filesystem::create_directories(std::filesystem::path(root + path).parent_path());
      std::ofstream(root + path) << text;
    }

    std::string root;
    long kilobytes_free = 12000000;
  };
} // namespace

TEST(SolverChoice, FactorThatFits)
{
  EXPECT_EQ(estimate_solvers(hundred_thousand_unknowns()).choice, BodySolver::direct);
}

TEST(SolverChoice, FactorThatDoesNotFit)
{
  EliminationSize size  = hundred_thousand_unknowns();
  size.direct_megabytes = size.on_disk_megabytes = 1e12;
  EXPECT_EQ(estimate_solvers(size).choice, BodySolver::iterative);
  size.may_be_matrix_free = true;
  EXPECT_EQ(estimate_solvers(size).choice, BodySolver::matrix_free);
  size.n_interface = 4; // S costs less than a scheme without it
  EXPECT_EQ(estimate_solvers(size).choice, BodySolver::iterative);
}

// The factor does not fit, what is left without it does.
TEST(SolverChoice, FactorThatFitsOnDiskOnly)
{
  EliminationSize size   = hundred_thousand_unknowns();
  size.direct_megabytes  = 1e12;
  size.on_disk_megabytes = 1.;
  EXPECT_EQ(estimate_solvers(size).choice, BodySolver::direct_on_disk);
  size.n_interface       = 0;
  size.direct_operations = 1e15; // the iterative way is much faster
  EXPECT_EQ(estimate_solvers(size).choice, BodySolver::iterative);
}

// No joint: one solution against a factorisation of 1e15 operations.
TEST(SolverChoice, IterationThatIsMuchFaster)
{
  EliminationSize size   = hundred_thousand_unknowns();
  size.n_interface       = 0;
  size.direct_operations = 1e15;
  EXPECT_EQ(estimate_solvers(size).choice, BodySolver::iterative);
}

// The documented share of the memory of the machine (doc/theory.md, section 1): 0.7.
TEST(SolverChoice, ShareOfTheMachine)
{
  const double machine  = machine_memory_in_megabytes();
  EliminationSize size  = hundred_thousand_unknowns();
  size.direct_megabytes = 0.699 * machine;
  EXPECT_EQ(estimate_solvers(size).available_megabytes, machine);
  EXPECT_EQ(estimate_solvers(size).choice, BodySolver::direct);
  size.direct_megabytes = 0.701 * machine;
  EXPECT_EQ(estimate_solvers(size).choice, BodySolver::direct_on_disk);
  size.on_disk_megabytes = 0.701 * machine;
  EXPECT_EQ(estimate_solvers(size).choice, BodySolver::iterative);
}

// 16777216 kB are 16384 MB, whatever other programs leave free.
TEST_F(MachineFiles, FreeMemoryDoesNotMatter)
{
  EXPECT_EQ(machine_memory_in_megabytes(root), 16384.);
  kilobytes_free = 1000;
  SetUp();
  EXPECT_EQ(machine_memory_in_megabytes(root), 16384.);
}

// The smallest limit on the way from the group to the root holds (cgroup v2): 4 GiB of the parent.
TEST_F(MachineFiles, LimitOfAControlGroup)
{
  write("/proc/self/cgroup", "0::/jobs/job7\n");
  write("/sys/fs/cgroup/jobs/job7/memory.max", "max\n");
  EXPECT_EQ(machine_memory_in_megabytes(root), 16384.);
  write("/sys/fs/cgroup/jobs/memory.max", "4294967296\n");
  EXPECT_EQ(machine_memory_in_megabytes(root), 4096.);
}

// Version 1 gives every controller a tree; 9223372036854771712 is its "no limit". In a container
// the group is at the root, under whatever name the host knows it.
TEST_F(MachineFiles, LimitOfAnOldControlGroup)
{
  write("/proc/self/cgroup", "5:cpu:/a\n4:memory:/docker/abc\n");
  write("/sys/fs/cgroup/cpu/a/memory.limit_in_bytes", "1048576\n");
  write("/sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
  EXPECT_EQ(machine_memory_in_megabytes(root), 16384.);
  write("/sys/fs/cgroup/memory/memory.limit_in_bytes", "2147483648\n");
  EXPECT_EQ(machine_memory_in_megabytes(root), 2048.);
}
