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
  /** A range of finite numbers or integers; it can tell what is wrong with a text. */
  struct NumberRange
  {
    bool is_integer       = false;
    double lower          = -std::numeric_limits<double>::infinity();
    bool lower_is_allowed = false;
    double upper          = std::numeric_limits<double>::infinity();
    bool upper_is_allowed = false;

    /** Return a description such as "a finite number > 0" or "an integer from 1 to 3". */
    std::string
    description() const;

    /** Return the reason why @p text is none of these numbers; "" if it is one. */
    std::string
    problem(const std::string &text) const;
  };

  /** Return the finite number that @p text represents, or nothing. */
  std::optional<double>
  number_of_text(const std::string &text);

  /** Return a number as a user would write it: 1e-9, 0.01, 1000000. */
  std::string
  short_number(const double value);

  /** Tells whether a text may contain expressions of constants. */
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

  /** The allowed values of an entry and their meaning: one of the words, a number, or a text. */
  template <typename Value>
  struct Pattern
  {
    Words<Value> words               = {};
    std::optional<NumberRange> range = {};
    TextContent content              = TextContent::words;

    /** Return the text for @p value in a file. */
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

  /** Functions with which the tables of entries are written. */
  namespace parameter_patterns
  {
    inline Pattern<std::string>
    text(const TextContent content = TextContent::words)
    {
      return {{}, {}, content};
    }

    /** One of the words, each with its meaning. */
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

    /** A number between two bounds, both of which are allowed. */
    inline Pattern<double>
    number_in(const double lower, const double upper)
    {
      return {{}, NumberRange{false, lower, true, upper, true}};
    }
  } // namespace parameter_patterns
} // namespace fuga

#endif
