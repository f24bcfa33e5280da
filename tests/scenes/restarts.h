// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_scenes_restarts_h
#define fuga_tests_scenes_restarts_h

#include <fuga/run/simulation/phases.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace fuga::tests
{
  /** Files of a run by name, without what may differ: times, memory, work of the process, and that
   * the run was restarted. */
  using Results = std::map<std::string, std::string>;

  Results
  results(const std::string &directory);

  /** Names of the files that differ. */
  std::string
  differences(const Results &a, const Results &b);

  /** Ends a run in the plane, or the rest of it behind @p checkpoint, as a kill does, behind its
   * checkpoint number @p last. */
  void
  run_until(const Parameters &parameters,
            const std::size_t last,
            const Checkpoint *checkpoint = nullptr);

  /** The rest of a run after what read_checkpoint() finds. */
  ExitCode
  run_rest(const Parameters &parameters);

  /** Runs a file in the plane with a checkpoint at every event, stops it after about
   * @p n_restarts of them, restarts it there, and expects @p code and the files of the unbroken
   * run, byte for byte. How many checkpoints there were. */
  std::size_t
  restart_everywhere(const std::string &file,
                     const std::vector<std::string> &overrides,
                     const std::size_t n_restarts,
                     const ExitCode code = ExitCode::done);
} // namespace fuga::tests

#endif
