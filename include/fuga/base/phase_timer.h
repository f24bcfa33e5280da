// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_phase_timer_h
#define fuga_base_phase_timer_h

#include <fuga/base/process_info.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace fuga
{
  /**
   * A stop watch that books wall time to named phases and records the peak memory at the end of
   * each of them.
   */
  class PhaseTimer
  {
  public:
    PhaseTimer() : start(now())
    {
    }

    void
    restart()
    {
      start = now();
    }

    /** Book the time since the last call to @p name. */
    void
    finish(const std::string &name)
    {
      const double end = now();
      add(name, end - start);
      start = end;
    }

    /** Book @p seconds that belong to none of the calls of finish(). */
    void
    book(const std::string &name, const double seconds)
    {
      add(name, seconds);
    }

    /** Add the phases of another watch; finish() will not book them again. */
    void
    set_apart(const PhaseTimer &other)
    {
      for (std::size_t i = 0; i < other.phases.size(); ++i)
        {
          add(other.phases[i].first, other.phases[i].second, other.peaks[i].second);
          start += other.phases[i].second;
        }
    }

    /** Return the sum over all phases [s]. */
    double
    sum() const
    {
      double result = 0.;
      for (const auto &phase : phases)
        result += phase.second;
      return result;
    }

    /** Return the seconds booked to every phase, in the order of first use. */
    const std::vector<std::pair<std::string, double>> &
    seconds() const
    {
      return phases;
    }

    /**
     * Return the peak memory of the process up to the last end of every phase [MB], in the same
     * order.
     */
    const std::vector<std::pair<std::string, double>> &
    peak_megabytes() const
    {
      return peaks;
    }

  private:
    static double
    now()
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
    }

    void
    add(const std::string &name,
        const double seconds,
        const double megabytes = peak_memory_in_megabytes())
    {
      const auto phase = std::find_if(
        phases.begin(), phases.end(), [&](const auto &entry) { return entry.first == name; });
      if (phase == phases.end())
        {
          phases.emplace_back(name, seconds);
          peaks.emplace_back(name, megabytes);
        }
      else
        {
          phase->second += seconds;
          peaks[static_cast<std::size_t>(phase - phases.begin())].second = megabytes;
        }
    }

    std::vector<std::pair<std::string, double>> phases, peaks;
    double start;
  };
} // namespace fuga

#endif
