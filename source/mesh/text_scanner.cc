// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/mesh/text_scanner.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Size beyond which a coordinate is meaningless, and its square or cube may overflow. */
    constexpr double largest_coordinate = 1e15;

    bool
    is_blank(const char c)
    {
      return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
    }

    /** from_chars reports underflow like overflow; only the latter is a mistake by the user. */
    double
    value_out_of_range(const char *begin, const char *end)
    {
      const double value = std::strtod(std::string(begin, end).c_str(), nullptr);
      return std::abs(value) < 1. ? value : std::numeric_limits<double>::infinity();
    }
  } // namespace


  TextScanner::TextScanner(const std::string &name, const std::string_view whole_text)
    : file_name(name)
    , text(whole_text)
    , cursor(whole_text.data())
    , line_begin(whole_text.data())
    , line_end(whole_text.data())
  {
  }


  bool
  TextScanner::next_line()
  {
    const char *const text_end = text.data() + text.size();
    const char *begin          = number == 0 || line_end == text_end ? line_end : line_end + 1;
    while (begin < text_end)
      {
        const std::size_t left = static_cast<std::size_t>(text_end - begin);
        const void *const stop = std::memchr(begin, '\n', left);
        line_begin             = begin;
        line_end               = stop == nullptr ? text_end : static_cast<const char *>(stop);
        ++number;
        cursor = line_begin;
        skip_blanks();
        if (cursor != line_end)
          return true;
        begin = line_end == text_end ? text_end : line_end + 1;
      }
    cursor = line_begin = line_end;
    return false;
  }


  void
  TextScanner::require_line(const std::string_view section)
  {
    if (!next_line())
      fail(
        fmt::format("the file ends in the middle of section ${}; the section must end with $End{}; "
                    "write the mesh file again (was it copied or written to the end?)",
                    section,
                    section));
  }


  std::string_view
  TextScanner::line() const
  {
    const char *begin = line_begin;
    const char *end   = line_end;
    while (begin < end && is_blank(*begin))
      ++begin;
    while (begin < end && is_blank(end[-1]))
      --end;
    return {begin, static_cast<std::size_t>(end - begin)};
  }


  unsigned int
  TextScanner::line_number() const
  {
    return number;
  }


  void
  TextScanner::skip_blanks()
  {
    while (cursor < line_end && is_blank(*cursor))
      ++cursor;
  }


  std::string_view
  TextScanner::token()
  {
    skip_blanks();
    const char *const begin = cursor;
    while (cursor < line_end && !is_blank(*cursor))
      ++cursor;
    return {begin, static_cast<std::size_t>(cursor - begin)};
  }


  std::int64_t
  TextScanner::integer(const char *what, const std::int64_t smallest, const std::int64_t largest)
  {
    const std::string_view word = token();
    if (word.empty())
      fail(
        fmt::format("the line ends where {} should stand; expected an integer; write the mesh file "
                    "again",
                    what));
    const char *const begin = word.data();
    const char *const end   = begin + word.size();
    std::int64_t value      = 0;
    const auto found        = std::from_chars(begin + (*begin == '+' ? 1 : 0), end, value);
    if (found.ec != std::errc() || found.ptr != end)
      fail(fmt::format(
        "{} is {}, which is not an integer; write the mesh file again", what, quote(word)));
    if (value < smallest || value > largest)
      fail(fmt::format("{} is {}; allowed is {} to {}; write the mesh file again",
                       what,
                       value,
                       smallest,
                       largest));
    return value;
  }


  double
  TextScanner::coordinate(const char *what)
  {
    const std::string_view word = token();
    if (word.empty())
      fail(
        fmt::format("the line ends where {} should stand; expected a number; write the mesh file "
                    "again",
                    what));
    const char *const begin = word.data();
    const char *const end   = begin + word.size();
    double value            = 0;
    const auto found        = std::from_chars(begin + (*begin == '+' ? 1 : 0), end, value);
    if (found.ec == std::errc::result_out_of_range && found.ptr == end)
      value = value_out_of_range(begin, end);
    else if (found.ec != std::errc() || found.ptr != end)
      fail(fmt::format(
        "{} is {}, which is not a number; write the mesh file again", what, quote(word)));
    if (!std::isfinite(value) || std::abs(value) > largest_coordinate)
      fail(fmt::format("{} is {}; it must be finite and not larger than {:g}; correct the geometry "
                       "or write the mesh file again",
                       what,
                       quote(word),
                       largest_coordinate));
    return value;
  }


  void
  TextScanner::require_end_of_line(const char *what)
  {
    const std::string_view word = token();
    if (!word.empty())
      fail(
        fmt::format("there is more in this line than {}, from {} on; remove it or write the mesh "
                    "file again",
                    what,
                    quote(word)));
  }


  void
  TextScanner::fail(const std::string &message) const
  {
    fail_at(std::max(number, 1U), message);
  }


  void
  TextScanner::fail_at(const unsigned int line_of_text, const std::string &message) const
  {
    throw InputError(fmt::format("{}:{}: {}", file_name, line_of_text, message));
  }


  std::string
  TextScanner::quote(const std::string_view piece)
  {
    constexpr std::size_t longest = 40;
    std::string result            = "'";
    // bytes above 127 stay: they are letters in UTF-8
    for (const char c : piece.substr(0, longest))
      result += (c >= 0 && c < 32) || c == 127 ? '?' : c;
    return result + (piece.size() > longest ? "...'" : "'");
  }
} // namespace fuga
