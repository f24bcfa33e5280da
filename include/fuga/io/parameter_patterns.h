// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_io_parameter_patterns_h
#define fuga_io_parameter_patterns_h

#include <deal.II/base/patterns.h>

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace fuga
{
  /** Whether expressions of constants may stand in a text. */
  enum class TextContent
  {
    words,
    /** A table or coordinates, or a name. */
    numbers,
    /** The numbers of a level, or a function of time: a quantity with a unit. */
    level
  };

  template <typename Value>
  using Words = std::vector<std::pair<std::string, Value>>;

  /** As a user would write it: 1e-9, 0.01, 1000000. */
  std::string
  short_number(const double value);

  /** What may stand as a value, and what it means. */
  template <typename Value>
  struct Pattern
  {
    std::shared_ptr<const dealii::Patterns::PatternBase> check;
    Words<Value> words  = {};
    TextContent content = TextContent::words;

    /** How a file says @p value. */
    std::string
    text_of(const Value &value) const
    {
      const auto word =
        std::find_if(words.begin(), words.end(), [&](const auto &w) { return w.second == value; });
      if (word != words.end())
        return word->first;
      if constexpr (std::is_same_v<Value, double>)
        return short_number(value);
      else if constexpr (std::is_enum_v<Value>)
        return "";
      else
        return fmt::format("{}", value);
    }
  };

  /** The words in which the tables of entries are written. */
  namespace parameter_patterns
  {
    Pattern<std::string>
    text(const TextContent content = TextContent::words);

    /** One of the words, with what each means. */
    template <typename Value>
    Pattern<Value>
    choice(const Words<Value> &words)
    {
      std::string list;
      for (const auto &[word, value] : words)
        list += (list.empty() ? "" : "|") + word;
      return {std::make_shared<dealii::Patterns::Selection>(list), words};
    }

    Pattern<unsigned int>
    integer(const double lower, const double upper);

    Pattern<double>
    any_number();

    Pattern<double>
    number_above(const double lower);

    Pattern<double>
    number_from(const double lower);

    Pattern<double>
    number_between(const double lower, const bool lower_is_allowed, const double upper);

    /** Both bounds are allowed. */
    Pattern<double>
    number_in(const double lower, const double upper);
  } // namespace parameter_patterns
} // namespace fuga

#endif
