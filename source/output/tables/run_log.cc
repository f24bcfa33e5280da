// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/processes.h>
#include <fuga/output/tables/run_log.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fmt/format.h>

namespace fuga
{
  RunLog::RunLog(const LogDetail log_detail,
                 const HistoryContext &history_context,
                 const std::string &file)
    : detail(log_detail)
    , context(history_context)
    , terminal(log_detail != LogDetail::quiet && processes::have_terminal())
    , record(file)
  {
  }

  void
  RunLog::line(const std::string &text)
  {
    record.append(text + "\n");
    if (detail == LogDetail::quiet)
      return;
    clear_progress();
    fmt::print("{}\n", text);
    std::fflush(stdout);
  }

  void
  RunLog::warning(const std::string &text)
  {
    line("Warning: " + text);
    warnings.push_back(text);
  }

  void
  RunLog::events(const std::vector<ContactEvent> &new_events, const double certificate)
  {
    if (detail != LogDetail::events)
      return;
    for (const ContactEvent &event : new_events)
      {
        const ContactElement &element = context.elements[event.element];
        const auto [stage, fraction]  = stage_of_event(event.t, context.stage_names.size());
        line(fmt::format("  t = {:<12.9g} {:>9.5f} of {:<12} {}  {} {:>4}  at ({:.6g})  {:>5} "
                         "-> {:<5}  certificate {:.1e}",
                         event.t,
                         fraction,
                         context.stage_names[stage],
                         context.driving.at(event.t, stage).text(),
                         context.joint_names[element.joint],
                         element.number,
                         fmt::join(element.position.begin(),
                                   element.position.begin() + (context.in_space ? 3 : 2),
                                   ", "),
                         event.names()[0],
                         event.names()[1],
                         certificate));
      }
  }

  void
  RunLog::level(const double t, const std::vector<ElementResult> &results, const double certificate)
  {
    std::array<int, 3> count{};
    double pressure = 0.;
    for (const ElementResult &result : results)
      {
        ++count[static_cast<std::size_t>(state_code(result.state))];
        pressure = std::max(pressure, result.pressure);
      }
    const auto [stage, fraction] = stage_of(t, context.stage_names.size());
    line(fmt::format(
      "Level {:>6.1f} % of {:<12} {}  open {} stick {} slip {}  largest pressure {:.4g} "
      "{}  certificate {:.1e}",
      100. * fraction,
      context.stage_names[stage],
      context.driving.at(t, stage).text(),
      count[0],
      count[1],
      count[2],
      pressure,
      context.units.stress(),
      certificate));
  }

  void
  RunLog::progress(const double t, const double t_end)
  {
    if (!terminal)
      return;
    constexpr int width = 40;
    const int done      = static_cast<int>(width * t / t_end);
    fmt::print("\r[{:=<{}}{: <{}}] {:5.1f} %", "", done, "", width - done, 100. * t / t_end);
    std::fflush(stdout);
    bar_shown = true;
  }

  void
  RunLog::clear_progress()
  {
    if (bar_shown)
      fmt::print("\r{: <60}\r", "");
    bar_shown = false;
  }

  void
  RunLog::restore(const LogMemory &memory)
  {
    record.restore(memory.text);
    warnings = memory.warnings;
  }

  void
  RunLog::close()
  {
    const std::vector<std::string> repeated = warnings;
    for (const std::string &text : repeated)
      line("Warning (repeated): " + text);
    clear_progress();
  }
} // namespace fuga
