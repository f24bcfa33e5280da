// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_number_pattern.h>
#include <fuga/io/parameter_patterns.h>

namespace fuga
{
  std::string
  short_number(const double value)
  {
    std::string text       = fmt::format("{}", value);
    const std::size_t zero = text.find("e-0");
    return zero == std::string::npos ? text : text.erase(zero + 2, 1);
  }


  namespace parameter_patterns
  {
    namespace
    {
      template <typename Value>
      Pattern<Value>
      number(const double lower,
             const bool lower_is_allowed,
             const double upper,
             const bool upper_is_allowed)
      {
        const bool is_real = std::is_same_v<Value, double>;
        return {std::make_shared<NumberPattern>(is_real ? NumberPattern::Kind::real
                                                        : NumberPattern::Kind::integer,
                                                lower,
                                                lower_is_allowed,
                                                upper,
                                                upper_is_allowed,
                                                is_real)};
      }
    } // namespace

    Pattern<std::string>
    text(const TextContent content)
    {
      return {std::make_shared<dealii::Patterns::Anything>(), {}, content};
    }

    Pattern<unsigned int>
    integer(const double lower, const double upper)
    {
      return number<unsigned int>(lower, true, upper, true);
    }

    Pattern<double>
    any_number()
    {
      return number<double>(-NumberPattern::infinity, false, NumberPattern::infinity, false);
    }

    Pattern<double>
    number_above(const double lower)
    {
      return number<double>(lower, false, NumberPattern::infinity, false);
    }

    Pattern<double>
    number_from(const double lower)
    {
      return number<double>(lower, true, NumberPattern::infinity, false);
    }

    Pattern<double>
    number_between(const double lower, const bool lower_is_allowed, const double upper)
    {
      return number<double>(lower, lower_is_allowed, upper, false);
    }

    Pattern<double>
    number_in(const double lower, const double upper)
    {
      return number<double>(lower, true, upper, true);
    }
  } // namespace parameter_patterns
} // namespace fuga
