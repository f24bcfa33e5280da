// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_tables_run_log_h
#define fuga_output_tables_run_log_h

#include <fuga/contact/path/event_path.h>
#include <fuga/input/parameters.h>
#include <fuga/output/files/output_files.h>
#include <fuga/output/tables/history_writer.h>

#include <string>

namespace fuga
{
  /** The state of the log in a checkpoint. */
  struct LogMemory
  {
    TextMemory text;
    std::vector<std::string> warnings;
  };

  template <typename Memory, typename Visitor, only_for<Memory, LogMemory> = 0>
  void
  for_each_field(Memory &memory, Visitor &&visit)
  {
    auto &[text, warnings] = memory;
    visit("text", text);
    visit("warnings", warnings);
  }

  /**
   * The output of a run on the screen and in log.txt: a header, one line per event or per level,
   * warnings (repeated at the end) and a closing table. On a terminal a progress bar shows the load
   * time.
   */
  class RunLog
  {
  public:
    /** @p file is the file to which publish() writes the log. */
    RunLog(const LogDetail detail, const HistoryContext &context, const std::string &file);

    /** Write a line, unless the run is quiet. */
    void
    line(const std::string &text);

    /** Record a line that was on the screen before this log began. */
    void
    earlier_line(const std::string &text)
    {
      record.append(text + "\n");
    }

    /** Write a line that is repeated before the closing table. */
    void
    warning(const std::string &text);

    void
    events(const std::vector<ContactEvent> &events, const double certificate);

    void
    level(const double t, const std::vector<ElementResult> &results, const double certificate);

    /** Redraw the progress bar; without effect unless the screen is a terminal. */
    void
    progress(const double t, const double t_end);

    /** Repeat the warnings. */
    void
    close();

    /** Bring the file up to date. */
    void
    publish(const bool now)
    {
      record.publish(now);
    }

    LogMemory
    memory() const
    {
      return {record.memory(), warnings};
    }

    /** Restore the log; everything logged before in this run is discarded. */
    void
    restore(const LogMemory &memory);

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
    TextFile record;
    std::vector<std::string> warnings;
  };
} // namespace fuga

#endif
