// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_io_run_timer_h
#define fuga_io_run_timer_h

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace fuga
{
  /** Wall time of the phases of a run, one after the other, in the order of their first use. */
  class RunTimer
  {
  public:
    RunTimer();

    /** Ends the phase that runs (its time is added to what it had before) and begins @p name. */
    void
    begin(const std::string &name);

    /** Enters times that were measured elsewhere and takes them from the phase that runs. */
    void
    include(const std::vector<std::pair<std::string, double>> &phases);

    std::vector<std::pair<std::string, double>>
    seconds();

  private:
    using Clock = std::chrono::steady_clock;

    double &
    entry(const std::string &name);

    std::vector<std::pair<std::string, double>> phases;
    std::string running;
    Clock::time_point start;
  };

  /** Seconds since the operating system started this process, and its largest memory so far [MB].
   */
  double
  seconds_since_process_start();
  double
  peak_memory_in_megabytes();
} // namespace fuga

#endif
