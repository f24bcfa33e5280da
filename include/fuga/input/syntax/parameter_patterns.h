// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_syntax_parameter_patterns_h
#define fuga_input_syntax_parameter_patterns_h

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fuga
{
  /** A finite number or integer within bounds; it can say what is wrong with a text. */
  struct NumberRange
  {
    bool is_integer       = false;
    double lower          = -std::numeric_limits<double>::infinity();
    bool lower_is_allowed = false;
    double upper          = std::numeric_limits<double>::infinity();
    bool upper_is_allowed = false;

    /** "a finite number > 0", "an integer from 1 to 3". */
    std::string
    description() const;

    /** Why @p text is none of these numbers; "" if it is one. */
    std::string
    problem(const std::string &text) const;
  };

  /** The finite number that @p text is, or nothing. */
  std::optional<double>
  number_of_text(const std::string &text);

  /** As a user would write it: 1e-9, 0.01, 1000000. */
  std::string
  short_number(const double value);

  /** Whether expressions of constants may stand in a text. */
  enum class TextContent
  {
    words,
    /** A table, a vector or coordinates, or a name. */
    numbers,
    /** The numbers of a level, or a function of time: a quantity with a unit. */
    level
  };

  template <typename Value>
  using Words = std::vector<std::pair<std::string, Value>>;

  /** What may stand as a value, and what it means: one of the words, a number, or a text. */
  template <typename Value>
  struct Pattern
  {
    Words<Value> words               = {};
    std::optional<NumberRange> range = {};
    TextContent content              = TextContent::words;

    /** How a file says @p value. */
    std::string
    text_of(const Value &value) const
    {
      for (const auto &[word, meaning] : words)
        if (meaning == value)
          return word;
      if constexpr (std::is_same_v<Value, std::string>)
        return value;
      else
        return short_number(static_cast<double>(value));
    }
  };

  /** The words in which the tables of entries are written. */
  namespace parameter_patterns
  {
    inline Pattern<std::string>
    text(const TextContent content = TextContent::words)
    {
      return {{}, {}, content};
    }

    /** One of the words, with what each means. */
    template <typename Value>
    Pattern<Value>
    choice(const Words<Value> &words)
    {
      return {words};
    }

    inline Pattern<unsigned int>
    integer(const double lower, const double upper)
    {
      return {{}, NumberRange{true, lower, true, upper, true}};
    }

    inline Pattern<double>
    any_number()
    {
      return {{}, NumberRange{}};
    }

    inline Pattern<double>
    number_above(const double lower)
    {
      return {{}, NumberRange{false, lower}};
    }

    inline Pattern<double>
    number_from(const double lower)
    {
      return {{}, NumberRange{false, lower, true}};
    }

    inline Pattern<double>
    number_between(const double lower, const bool lower_is_allowed, const double upper)
    {
      return {{}, NumberRange{false, lower, lower_is_allowed, upper}};
    }

    /** Both bounds are allowed. */
    inline Pattern<double>
    number_in(const double lower, const double upper)
    {
      return {{}, NumberRange{false, lower, true, upper, true}};
    }
  } // namespace parameter_patterns
} // namespace fuga

#endif
