// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/similar_names.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace fuga
{
  namespace
  {
    char
    lower(const char c)
    {
      return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }

    /** Return the number of letters to insert, delete, replace or exchange with their neighbour;
     * capital and small letters are considered equal. */
    std::size_t
    edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<std::size_t> before;
      std::vector<std::size_t> above;
      std::vector<std::size_t> row(b.size() + 1);
      std::iota(row.begin(), row.end(), std::size_t{0});
      for (std::size_t i = 1; i <= a.size(); ++i)
        {
          before = above;
          above  = row;
          row[0] = i;
          for (std::size_t j = 1; j <= b.size(); ++j)
            {
              const bool same = lower(a[i - 1]) == lower(b[j - 1]);
              row[j] = std::min({above[j - 1] + (same ? 0 : 1), above[j] + 1, row[j - 1] + 1});
              if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                  lower(a[i - 2]) == lower(b[j - 1]))
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
      return row.back();
    }
  } // namespace


  std::string
  did_you_mean(const std::string &wrong,
               const std::vector<std::string> &known,
               const std::string &before)
  {
    std::vector<std::pair<std::size_t, std::string>> close;
    for (const std::string &name : known)
      {
        const auto [shorter, longer] = std::minmax({wrong.size(), name.size()});
        const std::size_t allowed    = std::max<std::size_t>(1, (shorter + 1) / 3);
        if (longer - shorter > allowed)
          continue; // at least this many letters are to be inserted: no need to count
        const std::size_t distance = edit_distance(wrong, name);
        if (distance <= allowed)
          close.emplace_back(distance, name);
      }
    std::sort(close.begin(), close.end());
    if (close.empty())
      return "";
    std::string result = before + "Did you mean '" + close[0].second + "'";
    for (std::size_t i = 1; i < close.size() && close[i].first == close[0].first; ++i)
      result += " or '" + close[i].second + "'";
    return result + "?";
  }
} // namespace fuga
