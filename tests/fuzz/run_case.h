// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_fuzz_run_case_h
#define fuga_tests_fuzz_run_case_h

#include <cstdint>
#include <string>
#include <vector>

namespace fuga::fuzz
{
  /** A parameter file with its mesh: what is spoilt. */
  struct Seed
  {
    std::string parameter_name, parameters, mesh_name, mesh;
  };

  /** Reads tests/fuzz/seeds. */
  std::vector<Seed>
  read_seeds(const std::string &directory);

  /** Case @p number of a campaign: the seeds as they are, then one seed with one to six mutations. */
  Seed
  make_case(const std::vector<Seed> &seeds,
            const std::uint64_t campaign,
            const std::uint64_t number);

  /** How far a case got. */
  enum class Reach
  {
    /** Reading and all checks, as with --check. */
    check,
    /** The whole run, if it is a small problem. */
    run
  };

  struct CaseResult
  {
    /** The exit code that the program would have given. */
    int exit_code = 0;
    bool was_run  = false;
    /** The message on the error stream, or the verdict. */
    std::string message;
    /** Why this end is wrong; empty if it is not. */
    std::string complaint;
  };

  /**
   * Writes the files into @p directory and reads them as the program does. Wrong are: an exception
   * that no one has put into words, a message without content, an exit code other than 0 and 1 (in
   * a whole run 3, and 2 or 4 with the reason).
   */
  CaseResult
  run_case(const Seed &files, const std::string &directory, const Reach reach);
} // namespace fuga::fuzz

#endif
