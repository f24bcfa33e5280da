// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_files_text_table_h
#define fuga_output_files_text_table_h

#include <string>
#include <vector>

namespace fuga
{
  /** A table for the screen: the first column is left-aligned, all others are right-aligned. */
  class TextTable
  {
  public:
    explicit TextTable(std::vector<std::string> header);

    /** Add a row with as many cells as the header. */
    void
    add(std::vector<std::string> row);

    bool
    is_empty() const
    {
      return rows.size() == 1;
    }

    /** Return the header and all rows, indented. */
    std::vector<std::string>
    lines() const;

  private:
    std::vector<std::vector<std::string>> rows;
  };

  /**
   * Return a number in readable form: six digits, and 0 for a value that is only rounding of
   * @p scale.
   */
  std::string
  readable(const double value, const double scale = 0.);
} // namespace fuga

#endif
