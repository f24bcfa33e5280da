// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_phase_timer_h
#define fuga_base_phase_timer_h

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace fuga
{
  /** A stop watch that books wall time to named phases. */
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

    /** Books the time since the last call to @p name. */
    void
    finish(const std::string &name)
    {
      const double end = now();
      add(name, end - start);
      start = end;
    }

    /** Books @p seconds that belong to none of the calls of finish(). */
    void
    book(const std::string &name, const double seconds)
    {
      add(name, seconds);
    }

    /** Books @p seconds to @p name that finish() must not book again. */
    void
    set_apart(const std::string &name, const double seconds)
    {
      add(name, seconds);
      start += seconds;
    }

    /** In the order of first use. */
    const std::vector<std::pair<std::string, double>> &
    seconds() const
    {
      return phases;
    }

  private:
    static double
    now()
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
    }

    void
    add(const std::string &name, const double seconds)
    {
      const auto phase = std::find_if(
        phases.begin(), phases.end(), [&](const auto &entry) { return entry.first == name; });
      if (phase == phases.end())
        phases.emplace_back(name, seconds);
      else
        phase->second += seconds;
    }

    std::vector<std::pair<std::string, double>> phases;
    double start;
  };
} // namespace fuga

#endif
