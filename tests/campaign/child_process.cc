// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "campaign/child_process.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

namespace fuga::campaign
{
  std::string
  ChildEnd::description() const
  {
    if (timed_out)
      return "no end within the time limit";
    if (signal != 0)
      return "signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
    return "exit code " + std::to_string(exit_code);
  }

  ChildProcess::ChildProcess(
    const std::function<void(const std::function<void(const std::string &)> &write)> &work,
    const std::size_t memory_limit)
  {
    int ends[2];
    if (pipe(ends) != 0)
      throw std::runtime_error("no pipe");
    std::fflush(nullptr);
    id = fork();
    if (id < 0)
      throw std::runtime_error("no process");
    if (id == 0)
      {
        close(ends[0]);
        if (memory_limit > 0)
          {
            const rlimit limit{memory_limit, memory_limit};
            setrlimit(RLIMIT_AS, &limit);
          }
        const rlimit no_core{0, 0};
        setrlimit(RLIMIT_CORE, &no_core);
        const int target = ends[1];
        const auto write = [target](const std::string &text) {
          for (std::size_t done = 0; done < text.size();)
            {
              const ssize_t n = ::write(target, text.data() + done, text.size() - done);
              if (n <= 0)
                _exit(99);
              done += static_cast<std::size_t>(n);
            }
        };
        int code = 0;
        try
          {
            work(write);
          }
        catch (const std::exception &error)
          {
            write(std::string("\nexception: ") + error.what());
            code = 98;
          }
        catch (...)
          {
            write("\nexception: of an unknown kind");
            code = 98;
          }
        std::fflush(nullptr);
        _exit(code);
      }
    close(ends[1]);
    pipe_end = ends[0];
    fcntl(pipe_end, F_SETFL, O_NONBLOCK);
  }

  ChildProcess::~ChildProcess()
  {
    if (!end.ended)
      {
        kill();
        waitpid(id, nullptr, 0);
      }
    close(pipe_end);
  }

  void
  ChildProcess::receive()
  {
    char buffer[4096];
    for (ssize_t n; (n = read(pipe_end, buffer, sizeof buffer)) > 0;)
      received.append(buffer, static_cast<std::size_t>(n));
  }

  ChildEnd
  ChildProcess::poll()
  {
    if (end.ended)
      return end;
    receive();
    int status = 0;
    if (waitpid(id, &status, WNOHANG) == id)
      {
        receive();
        end.ended     = true;
        end.timed_out = killed;
        if (WIFEXITED(status))
          end.exit_code = WEXITSTATUS(status);
        else if (WIFSIGNALED(status))
          end.signal = WTERMSIG(status);
      }
    return end;
  }

  void
  ChildProcess::kill()
  {
    if (end.ended)
      return;
    killed = true;
    ::kill(id, SIGKILL);
  }

  void
  ChildProcess::restart_clock()
  {
    since          = std::chrono::steady_clock::now();
    seconds_before = seconds();
  }

  bool
  ChildProcess::has_used_up(const double limit) const
  {
    constexpr double waiting = 20.;
    const double passed =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
    return seconds() - seconds_before > limit || passed > waiting * limit;
  }

  double
  ChildProcess::seconds() const
  {
    clockid_t clock;
    timespec time;
    if (end.ended || clock_getcpuclockid(id, &clock) != 0 || clock_gettime(clock, &time) != 0)
      return 0.;
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
} // namespace fuga::campaign
