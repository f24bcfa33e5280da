// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_names.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace fuga
{
  namespace
  {
    bool
    is_blank(const char c)
    {
      return std::isspace(static_cast<unsigned char>(c)) != 0;
    }

    char
    lower(const char c)
    {
      return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }

    /** Number of letters to insert, delete, replace or exchange with their neighbour; capitals and
     * small letters are the same. */
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
  normalise_blanks(const std::string &text)
  {
    std::string result;
    for (const char c : text)
      if (!is_blank(c))
        result += c;
      else if (!result.empty() && result.back() != ' ')
        result += ' ';
    if (!result.empty() && result.back() == ' ')
      result.pop_back();
    return result;
  }


  std::vector<std::string>
  split_pieces(const std::string &text, const char separator)
  {
    std::vector<std::string> pieces;
    if (normalise_blanks(text).empty())
      return pieces;
    std::size_t begin = 0;
    while (begin <= text.size())
      {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        pieces.push_back(normalise_blanks(text.substr(begin, end - begin)));
        begin = end + 1;
      }
    return pieces;
  }


  std::string
  quoted_list(const std::vector<std::string> &names)
  {
    std::string result;
    for (const std::string &name : names)
      result += (result.empty() ? "'" : ", '") + name + "'";
    return result;
  }


  std::string
  name_hint(const std::string &wrong,
            const std::vector<std::string> &known,
            const std::string &what)
  {
    std::vector<std::pair<std::size_t, std::string>> close;
    for (const std::string &name : known)
      {
        const auto [shorter, longer] = std::minmax({wrong.size(), name.size()});
        const std::size_t allowed    = std::max<std::size_t>(1, (shorter + 1) / 3);
        if (longer - shorter > allowed)
          continue; // so many letters are to be inserted at least: no need to count
        const std::size_t distance = edit_distance(wrong, name);
        if (distance <= allowed)
          close.emplace_back(distance, name);
      }
    std::sort(close.begin(), close.end());
    if (close.empty())
      return known.empty() ? "There are no " + what + "."
                           : "The " + what + " are: " + quoted_list(known) + ".";
    std::string result = "Did you mean '" + close[0].second + "'";
    for (std::size_t i = 1; i < close.size() && close[i].first == close[0].first; ++i)
      result += " or '" + close[i].second + "'";
    return result + "?";
  }
} // namespace fuga
