// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/files/text_table.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** Return the number of characters of UTF-8 text. */
    std::size_t
    width_of(const std::string &text)
    {
      return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](const char c) { return (c & '\xC0') != '\x80'; }));
    }
  } // namespace


  TextTable::TextTable(std::vector<std::string> header) : rows(1, std::move(header))
  {
  }


  void
  TextTable::add(std::vector<std::string> row)
  {
    row.resize(rows.front().size());
    rows.push_back(std::move(row));
  }


  std::vector<std::string>
  TextTable::lines() const
  {
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const auto &row : rows)
      for (std::size_t i = 0; i < row.size(); ++i)
        widths[i] = std::max(widths[i], width_of(row[i]));
    std::vector<std::string> result;
    for (const auto &row : rows)
      {
        std::string line = "  ";
        for (std::size_t i = 0; i < row.size(); ++i)
          {
            const std::string blanks(widths[i] - width_of(row[i]), ' ');
            line += i == 0 ? row[i] + blanks : "  " + blanks + row[i];
          }
        line.erase(line.find_last_not_of(' ') + 1);
        result.push_back(std::move(line));
      }
    return result;
  }


  std::string
  readable(const double value, const double scale)
  {
    return fmt::format("{:.6g}", std::abs(value) <= 1e-12 * scale ? 0. : value);
  }
} // namespace fuga
