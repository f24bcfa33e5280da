// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_scenes_scene_run_h
#define fuga_tests_scenes_scene_run_h

#include <fuga/base/numerics/dense_matrix.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace fuga::tests
{
  /** A CSV file as it was read: strict RFC 4180, the lines end in CR LF. */
  struct CsvTable
  {
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;

    /** Number of a column; @p name with or without its [unit]. @throws std::out_of_range */
    std::size_t
    column(const std::string &name) const;

    const std::string &
    text(const std::size_t row, const std::string &name) const;

    double
    number(const std::size_t row, const std::string &name) const;
  };

  /** @throws std::runtime_error for anything RFC 4180 does not allow, and for ragged rows. */
  CsvTable
  parse_csv(const std::string &text);

  /** A directory of this process that vanishes at its end; a new one with every call. */
  std::string
  temporary_directory();

  std::string
  file_text(const std::string &path);

  /** A run of the program, read back from its files. */
  struct SceneRun
  {
    int exit_code = -1;
    CsvTable events, history, resultants;
    /** Empty if there are no monitors. */
    CsvTable monitors;
    nlohmann::json summary;

    /** A column of joint_history.csv at load time @p t, by growing x (then y, then z). */
    Vector
    values(const std::string &name, const double t) const;

    /** In the same order. */
    std::vector<std::string>
    states(const double t) const;

    /** How many elements are in a state. */
    std::size_t
    count(const std::string &state, const double t) const;

    /** The row of a resultants.csv column at load time @p t (one joint). */
    double
    resultant(const std::string &name, const double t) const;

    /** Loads of the events with t > @p after. */
    Vector
    event_times(const double after) const;

    /** Largest entry of the certificate over all events and levels. */
    double
    certificate() const
    {
      return summary.at("certificate").at("worst").get<double>();
    }

    /** Last load time in the history. */
    double
    last_t() const;
  };

  /** Names a file of parameters/ of the repository; an absolute path remains. */
  std::string
  parameter_path(const std::string &file);

  /** Runs a parameter file in this process and reads the files it wrote; without fields unless told
   * otherwise. */
  SceneRun
  run_scene(const std::string &file, const std::vector<std::string> &overrides = {});

  /** What the program said and returned; -signal if one ended it. */
  struct ProgramRun
  {
    int exit_code = -1;
    std::string out, err;
  };

  /** Starts the built program with these arguments. */
  ProgramRun
  run_program(const std::vector<std::string> &arguments);

  /** Largest |a - factor b| over the largest |factor b|; 0 if they are equal. */
  double
  deviation(const Vector &a, const Vector &b, const double factor = 1.);
} // namespace fuga::tests

#endif
