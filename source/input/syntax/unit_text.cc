// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/syntax/unit_text.h>

#include <functional>
#include <regex>

namespace fuga
{
  namespace
  {
    /** Return @p text with every match of the pattern replaced by what @p replacement makes of
     * it. */
    std::string
    replaced(const std::string &text,
             const std::regex &pattern,
             const std::function<std::string(const std::string &)> &replacement)
    {
      std::string result;
      std::size_t end = 0;
      for (std::sregex_iterator at(text.begin(), text.end(), pattern), none; at != none; ++at)
        {
          const auto begin = static_cast<std::size_t>(at->position());
          result += text.substr(end, begin - end) + replacement(at->str());
          end = begin + static_cast<std::size_t>(at->length());
        }
      return result + text.substr(end);
    }
  } // namespace


  std::string
  in_units(const std::string &text, const Units &units)
  {
    // The length is bounded because std::regex recurses once more with every character, and a text
    // may quote anything.
    static const std::regex brackets("\\[[^\\[\\]]{0,80}\\]"), unit("\\b(MPa|MN|m)\\b");
    return replaced(text, brackets, [&](const std::string &bracket) {
      return replaced(bracket, unit, [&](const std::string &word) {
        return word == "MPa" ? units.stress() : word == "MN" ? units.force : units.length;
      });
    });
  }
} // namespace fuga
