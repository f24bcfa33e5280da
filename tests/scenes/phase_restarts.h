// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_scenes_phase_restarts_h
#define fuga_tests_scenes_phase_restarts_h

#include <cstddef>
#include <string>
#include <vector>

namespace fuga::tests
{
  /** Runs a file in the plane with a checkpoint at every event, stops it behind the first
   * checkpoint and every
   * @p stride th one after it, restarts it there, and expects the files of the unbroken run, byte
   * for byte. How many checkpoints there were. */
  std::size_t
  restart_everywhere(const std::string &file,
                     const std::vector<std::string> &overrides,
                     const std::size_t stride);
} // namespace fuga::tests

#endif
