// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_campaign_child_process_h
#define fuga_tests_campaign_child_process_h

#include <chrono>
#include <functional>
#include <string>
#include <sys/types.h>

namespace fuga::campaign
{
  /** How a child process ended. */
  struct ChildEnd
  {
    bool ended     = false;
    bool timed_out = false;
    /** Exit code, or -1. */
    int exit_code = -1;
    /** Signal that killed it, or 0. */
    int signal = 0;

    /** "exit code 3", "signal 11 (Segmentation fault)", "no end within the time limit". */
    std::string
    description() const;
  };

  /**
   * A function that runs in a process of its own and sends text back: whatever it does, crash,
   * loop, or eat memory, the parent goes on. The child ends without running destructors of static
   * objects.
   */
  class ChildProcess
  {
  public:
    /** @p write sends text to the parent. @p memory_limit: bytes of address space, 0 = no limit. */
    ChildProcess(
      const std::function<void(const std::function<void(const std::string &)> &write)> &work,
      const std::size_t memory_limit);

    ChildProcess(const ChildProcess &) = delete;
    ChildProcess &
    operator=(const ChildProcess &) = delete;

    /** Kills a child that still runs. */
    ~ChildProcess();

    /** Takes what has arrived, and looks whether the child has ended. */
    ChildEnd
    poll();

    void
    kill();

    /** Begins to measure again: the child has begun with another task. */
    void
    restart_clock();

    /** Whether it has had more than @p limit seconds of a processor, to which other work does not
     * add, or only waits, for many times as long. */
    bool
    has_used_up(const double limit) const;

    /** Everything the child has sent so far. */
    const std::string &
    text() const
    {
      return received;
    }

    /** Waits for text or the end of any of these for at most some milliseconds. */
    int
    descriptor() const
    {
      return pipe_end;
    }

  private:
    void
    receive();
    /** Of a processor so far. */
    double
    seconds() const;

    std::chrono::steady_clock::time_point since = std::chrono::steady_clock::now();
    double seconds_before                       = 0.;

    pid_t id     = -1;
    int pipe_end = -1;
    bool killed  = false;
    std::string received;
    ChildEnd end;
  };
} // namespace fuga::campaign

#endif
