// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_io_run_log_h
#define fuga_io_run_log_h

#include <fuga/contact/event_path.h>
#include <fuga/io/history_writer.h>
#include <fuga/io/parameters.h>

#include <string>

namespace fuga
{
  /**
   * What a run says on the screen, and keeps in log.txt: a header, one line per event or per level,
   * warnings (repeated at the end) and a closing table. On a terminal a progress bar shows the load
   * time.
   */
  class RunLog
  {
  public:
    RunLog(const LogDetail detail, const HistoryContext &context);

    /** A line, unless the run is quiet. */
    void
    line(const std::string &text);

    /** A line that is also repeated before the closing table. */
    void
    warning(const std::string &text);

    void
    events(const std::vector<ContactEvent> &events, const double certificate);

    void
    level(const double t, const std::vector<ElementResult> &results, const double certificate);

    /** Redraws the progress bar; without effect unless the screen is a terminal. */
    void
    progress(const double t, const double t_end);

    /** Repeats the warnings. */
    void
    close();

    /** Everything said so far. */
    const std::string &
    text() const
    {
      return record;
    }

    const std::vector<std::string> &
    all_warnings() const
    {
      return warnings;
    }

  private:
    void
    clear_progress();

    const LogDetail detail;
    const HistoryContext context;
    const bool terminal;
    bool bar_shown = false;
    std::string record;
    std::vector<std::string> warnings;
  };
} // namespace fuga

#endif
