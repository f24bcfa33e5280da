// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_journal_passing_line_h
#define fuga_run_journal_passing_line_h

#include <fuga/bodies/processes.h>

#include <cstdio>
#include <fmt/format.h>
#include <string>

namespace fuga
{
  /** A line on a terminal that disappears when this object is destroyed. */
  class PassingLine
  {
  public:
    PassingLine(const std::string &text, const bool is_wanted)
      : width(is_wanted && processes::have_terminal() ? text.size() : 0)
    {
      show(text);
    }

    ~PassingLine()
    {
      show(std::string(width, ' '));
    }

    PassingLine(const PassingLine &) = delete;

  private:
    void
    show(const std::string &text) const
    {
      if (width == 0)
        return;
      fmt::print("\r{}\r", text);
      std::fflush(stdout);
    }

    const std::size_t width;
  };
} // namespace fuga

#endif
