// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/similar_names.h>
#include <fuga/input/syntax/parameter_names.h>

#include <algorithm>
#include <cctype>

namespace fuga
{
  namespace
  {
    bool
    is_blank(const char c)
    {
      return std::isspace(static_cast<unsigned char>(c)) != 0;
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
    const std::string close = did_you_mean(wrong, known);
    if (!close.empty())
      return close;
    return known.empty() ? "There are no " + what + "."
                         : "The " + what + " are: " + quoted_list(known) + ".";
  }
} // namespace fuga
