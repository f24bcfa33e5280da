// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Spoilt parameter files and meshes: every one must end with an exit code and a message, within
// bounds of time and memory. To be built with sanitizers. Cases run in child processes, many in
// each; a case during which the child dies or stands still has failed, and its files are kept.

#include "campaign/child_process.h"
#include "fuzz/run_case.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <list>
#include <thread>
#include <unistd.h>

// Options of the sanitizers: undefined behaviour is an error like any other; 2 GB are enough for
// small meshes. MPI and the BLAS keep memory of their own until the process ends.
extern "C" const char *
__asan_default_options()
{
  return "detect_leaks=0:hard_rss_limit_mb=2048:max_allocation_size_mb=2048:abort_on_error=0";
}

extern "C" const char *
__ubsan_default_options()
{
  return "halt_on_error=1:print_stacktrace=1";
}

namespace
{
  using namespace fuga::fuzz;
  using fuga::campaign::ChildEnd;
  using fuga::campaign::ChildProcess;
  using Clock = std::chrono::steady_clock;

  struct Options
  {
    std::string seeds = FUGA_SOURCE_DIR "/tests/fuzz/seeds", keep = "failures";
    std::uint64_t campaign = 1, first = 0, n_cases = 50000;
    unsigned int n_jobs = 2, batch = 250;
    /** Every so many-th case is run, the others are checked. */
    unsigned int run_every = 8;
    double time_limit      = 5.;
    double last_start      = 1e9;
    bool verbose           = false;
  };

  class Campaign
  {
  public:
    explicit Campaign(const Options &campaign_options)
      : options(campaign_options), seeds(read_seeds(options.seeds)), next(options.first)
    {
      root = std::filesystem::temp_directory_path() / fmt::format("fuga_fuzz_{}", getpid());
      std::filesystem::create_directories(root);
    }

    ~Campaign()
    {
      std::filesystem::remove_all(root);
    }

    std::size_t
    run()
    {
      const std::uint64_t last = options.first + options.n_cases;
      const auto start         = Clock::now();
      const auto may_start     = [&]() {
        return next < last &&
               std::chrono::duration<double>(Clock::now() - start).count() < options.last_start;
      };
      while (may_start() || !running.empty())
        {
          while (running.size() < options.n_jobs && may_start())
            {
              const std::uint64_t end = std::min(last, next + options.batch);
              start_batch(next, end);
              next = end;
            }
          for (auto batch = running.begin(); batch != running.end();)
            batch = is_finished(*batch) ? running.erase(batch) : std::next(batch);
          std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
      fmt::print("{} cases in {:.0f} s: exit code 0 {}, 1 {}, 2 {}, 3 {}, 4 {}; {} run to the end; "
                 "{} failures\n",
                 n_cases,
                 std::chrono::duration<double>(Clock::now() - start).count(),
                 codes[0],
                 codes[1],
                 codes[2],
                 codes[3],
                 codes[4],
                 n_run,
                 n_failures);
      return n_failures;
    }

  private:
    /** The first cases are the seeds as they are. What ends before it was run would only show the
     * first lines of its input to the program: they must be computed. */
    bool
    is_seed(const std::uint64_t number) const
    {
      return number < seeds.size();
    }

    struct Batch
    {
      std::uint64_t first, end;
      std::string directory;
      std::unique_ptr<ChildProcess> child;
      std::size_t n_read = 0;
      /** The case that is running. */
      std::uint64_t current = 0;
    };

    void
    start_batch(const std::uint64_t first, const std::uint64_t end)
    {
      Batch batch{first, end, root / fmt::format("{}", first), nullptr, 0, first};
      std::filesystem::create_directories(batch.directory);
      const std::string directory = batch.directory;
      batch.child                 = std::make_unique<ChildProcess>(
        [this, first, end, directory](const auto &write) {
          if (std::freopen((directory + "/stderr").c_str(), "w", stderr) == nullptr ||
              std::freopen("/dev/null", "w", stdout) == nullptr)
            throw std::runtime_error("no place for the output");
          for (std::uint64_t i = first; i < end; ++i)
            {
              write(fmt::format("begin {}\n", i));
              const CaseResult result =
                run_case(make_case(seeds, options.campaign, i),
                         directory,
                         is_seed(i) || i % options.run_every == 0 ? Reach::run : Reach::check);
              std::string message = result.complaint.empty() ? result.message : result.complaint;
              std::replace(message.begin(), message.end(), '\n', ' ');
              std::replace(message.begin(), message.end(), '\0', ' ');
              write(fmt::format("end {} {} {} {} {}\n",
                                i,
                                result.exit_code,
                                int(result.was_run),
                                int(!result.complaint.empty()),
                                message.substr(0, 600)));
            }
        },
        0);
      running.push_back(std::move(batch));
    }

    /** Reads what the batch has said. True if it has come to its end; what is left of it after a
     * crash begins as a new one. */
    bool
    is_finished(Batch &batch)
    {
      const ChildEnd end      = batch.child->poll();
      const std::string &text = batch.child->text();
      for (std::size_t line_end; (line_end = text.find('\n', batch.n_read)) != std::string::npos;
           batch.n_read = line_end + 1)
        take_line(batch, text.substr(batch.n_read, line_end - batch.n_read));
      if (!end.ended)
        {
          if (batch.child->has_used_up(options.time_limit))
            batch.child->kill();
          return false;
        }
      if (end.timed_out || end.signal != 0 || end.exit_code != 0)
        {
          fail(batch.current, batch.directory, end.description() + text.substr(batch.n_read));
          ++n_cases;
          if (batch.current + 1 < batch.end)
            start_batch(batch.current + 1, batch.end);
        }
      std::filesystem::remove_all(batch.directory);
      return true;
    }

    void
    take_line(Batch &batch, const std::string &line)
    {
      batch.child->restart_clock();
      std::istringstream words(line);
      std::string kind, message;
      std::uint64_t number = 0;
      words >> kind >> number;
      batch.current = number;
      if (kind != "end")
        return;
      std::size_t code = 0;
      int was_run = 0, is_wrong = 0;
      words >> code >> was_run >> is_wrong;
      std::getline(words, message);
      ++n_cases;
      ++codes[std::min<std::size_t>(code, 4)];
      n_run += was_run != 0 ? 1 : 0;
      // A whole run of a spoilt but valid problem may end at a limit load, or say that it could
      // not be computed; reading and checking may not.
      if (is_wrong != 0 || (code > 1 && was_run == 0) ||
          (is_seed(number) && code != 0 && code != 3))
        fail(number, "", message);
      else if (options.verbose)
        fmt::print("{} {}{}\n", number, code, message);
    }

    void
    fail(const std::uint64_t number, const std::string &directory, const std::string &reason)
    {
      ++n_failures;
      fmt::print("FAILED case {}: {}\n", number, reason);
      std::fflush(stdout);
      const std::filesystem::path target =
        std::filesystem::path(options.keep) / fmt::format("case_{}", number);
      std::filesystem::create_directories(target);
      const Seed files = make_case(seeds, options.campaign, number);
      std::ofstream(target / files.parameter_name, std::ios::binary) << files.parameters;
      std::ofstream(target / files.mesh_name, std::ios::binary) << files.mesh;
      std::ofstream(target / "reason.txt") << reason << '\n';
      std::error_code none;
      if (!directory.empty())
        std::filesystem::copy(directory + "/stderr", target / "stderr.txt", none);
    }

    const Options options;
    const std::vector<Seed> seeds;
    std::filesystem::path root;
    std::uint64_t next;
    std::list<Batch> running;
    std::size_t n_cases = 0, n_run = 0, n_failures = 0;
    std::array<std::size_t, 5> codes = {{0, 0, 0, 0, 0}};
  };
} // namespace

int
main(int argc, char **argv)
{
  Options options;
  CLI::App app("fuzz: spoilt input ends with a message, never otherwise");
  app.add_option("--campaign", options.campaign, "Seed of all mutations");
  app.add_option("--first", options.first, "Number of the first case");
  app.add_option("--cases", options.n_cases, "Number of cases");
  app.add_option("--jobs", options.n_jobs, "Processes at once")->check(CLI::Range(1, 256));
  app.add_option("--time-limit", options.time_limit, "Seconds of a processor for one case");
  app.add_option("--last-start", options.last_start, "Seconds after which no batch is begun");
  app.add_option("--keep", options.keep, "Directory for the files of cases that failed");
  app.add_flag("--verbose", options.verbose, "Print the end of every case");
  CLI11_PARSE(app, argc, argv);
  return Campaign(options).run() == 0 ? 0 : 1;
}
