// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/syntax/parameter_names.h>
#include <fuga/input/syntax/parameter_patterns.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace fuga
{
  namespace
  {
    struct ParsedNumber
    {
      double value = 0.;
      std::string rest;
      std::errc error = std::errc();
    };

    ParsedNumber
    parse_number(const std::string &text)
    {
      ParsedNumber result;
      const bool has_plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
      const char *end     = text.data() + text.size();
      const auto parsed   = std::from_chars(text.data() + (has_plus ? 1 : 0), end, result.value);
      result.error        = parsed.ec;
      result.rest         = std::string(parsed.ptr, end);
      return result;
    }
  } // namespace


  std::string
  NumberRange::description() const
  {
    const std::string noun = is_integer ? "an integer" : "a finite number";
    if (std::isinf(lower) && std::isinf(upper))
      return noun;
    if (std::isinf(upper))
      return fmt::format("{} {} {:.10g}", noun, lower_is_allowed ? ">=" : ">", lower);
    if (lower_is_allowed && upper_is_allowed)
      return fmt::format("{} from {:.10g} to {:.10g}", noun, lower, upper);
    return fmt::format("{} {} {:.10g} and {} {:.10g}",
                       noun,
                       lower_is_allowed ? ">=" : ">",
                       lower,
                       upper_is_allowed ? "<=" : "<",
                       upper);
  }


  std::string
  NumberRange::problem(const std::string &text) const
  {
    if (text.empty())
      return "there is no value";
    const ParsedNumber number = parse_number(text);
    if (number.error == std::errc::result_out_of_range ||
        std::fpclassify(number.value) == FP_SUBNORMAL)
      return "this number is too large or too small for the computer";
    if (number.error != std::errc())
      return "this is not a number";
    if (!number.rest.empty())
      {
        if (number.rest[0] == ',')
          return "this is not a number; write a decimal point, not a comma";
        return fmt::format("this is not a number because of '{}' behind it; units are not written, "
                           "expressions are not allowed here",
                           normalise_blanks(number.rest));
      }
    if (!std::isfinite(number.value))
      return "this is not a finite number";
    if (is_integer && number.value != std::floor(number.value))
      return "this is not an integer";
    if (is_integer && text.find_first_not_of("+-0123456789") != std::string::npos)
      return "write an integer with digits only";
    const bool is_low  = lower_is_allowed ? number.value < lower : number.value <= lower;
    const bool is_high = upper_is_allowed ? number.value > upper : number.value >= upper;
    return is_low || is_high ? "this is out of range" : "";
  }


  std::optional<double>
  number_of_text(const std::string &text)
  {
    if (!NumberRange().problem(text).empty())
      return {};
    return std::stod(text);
  }


  std::string
  short_number(const double value)
  {
    std::string text       = fmt::format("{}", value);
    const std::size_t zero = text.find("e-0");
    return zero == std::string::npos ? text : text.erase(zero + 2, 1);
  }
} // namespace fuga
