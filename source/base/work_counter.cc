// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/work_counter.h>

#include <ctime>

namespace fuga::work
{
  namespace internal
  {
    std::array<Counts, n_phases> counts;
    std::size_t current = 0;
  } // namespace internal

  namespace
  {
    double
    cpu_seconds()
    {
      timespec time{};
      clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
      return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

    // The work of the process before its first phase counts as work on the model.
    double last = 0.;

    void
    settle_time()
    {
      const double time = cpu_seconds();
      now().cpu_seconds += time - last;
      last = time;
    }
  } // namespace

  const char *
  name_of(const Phase phase)
  {
    constexpr const char *names[] = {
      "model", "elimination", "loads", "layered system", "path", "judge", "results"};
    return names[static_cast<std::size_t>(phase)];
  }

  Scope::Scope(const Phase phase) : before(internal::current)
  {
    settle_time();
    internal::current = static_cast<std::size_t>(phase);
  }

  Scope::~Scope()
  {
    settle_time();
    internal::current = before;
  }

  const std::array<Counts, n_phases> &
  all()
  {
    settle_time();
    return internal::counts;
  }
} // namespace fuga::work
