// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/files/table.h>

#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    struct ValueWriter
    {
      std::string &text;

      void
      operator()(const double value) const
      {
        fmt::format_to(std::back_inserter(text), "{:.17g}", value);
      }

      void
      operator()(const std::size_t value) const
      {
        fmt::format_to(std::back_inserter(text), "{}", value);
      }

      void
      operator()(const std::string &value) const
      {
        if (value.find_first_of(",\"\r\n") == std::string::npos)
          {
            text += value;
            return;
          }
        text += '"';
        for (const char c : value)
          text += c == '"' ? std::string("\"\"") : std::string(1, c);
        text += '"';
      }
    };
  } // namespace

  std::string
  csv_line(const std::vector<TableField> &fields)
  {
    std::string text;
    for (std::size_t i = 0; i < fields.size(); ++i)
      {
        text += i == 0 ? "" : ",";
        std::visit(ValueWriter{text}, fields[i]);
      }
    return text + "\r\n";
  }
} // namespace fuga
