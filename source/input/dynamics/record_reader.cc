// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/input/dynamics/record_reader.h>
#include <fuga/input/syntax/parameter_patterns.h>
#include <fuga/mesh/text_scanner.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>

namespace fuga
{
  namespace
  {
    /** Size beyond which an acceleration is meaningless, and its integrals may overflow. */
    constexpr double largest_number = 1e15;

    /** Share of a step by which times may be off, because their digits are rounded. */
    constexpr double rounding_of_times = 0.05;

    constexpr std::size_t smallest_number_of_samples = 2;

    /** A text that is read line by line. */
    class Lines
    {
    public:
      Lines(const std::string &file_name, const std::string &whole_text)
        : name(file_name), text(whole_text)
      {
      }

      bool
      next()
      {
        if (end >= text.size())
          return false;
        const std::size_t begin = end;
        end                     = std::min(text.find('\n', begin), text.size());
        line                    = std::string_view(text).substr(begin, end - begin);
        ++end;
        ++number;
        return true;
      }

      /** Return the numbers of the line up to a comment. */
      std::vector<double>
      numbers() const
      {
        const std::string_view content = line.substr(0, line.find('#'));
        constexpr const char *blanks   = " \t\r\v\f,;";
        std::vector<double> result;
        for (std::size_t at = content.find_first_not_of(blanks); at != std::string_view::npos;)
          {
            const std::size_t stop = std::min(content.find_first_of(blanks, at), content.size());
            result.push_back(number_of(content.substr(at, stop - at)));
            at = content.find_first_not_of(blanks, stop);
          }
        return result;
      }

      [[noreturn]] void
      fail(const std::string &problem_and_remedy, const unsigned int line_number) const
      {
        throw InputError(fmt::format("{}:{}: {}", name, line_number, problem_and_remedy));
      }

      [[noreturn]] void
      fail(const std::string &problem_and_remedy) const
      {
        fail(problem_and_remedy, std::max(number, 1u));
      }

      std::string_view line;
      unsigned int number = 0;

    private:
      double
      number_of(const std::string_view word) const
      {
        const std::optional<double> value = number_of_text(std::string(word));
        if (!value || std::abs(*value) > largest_number)
          fail(fmt::format("{} is not a number that a record may have (finite, with a decimal "
                           "point, at most {:g}). Correct it; a comment begins with #.",
                           TextScanner::quote(word),
                           largest_number));
        return *value;
      }

      const std::string &name;
      const std::string &text;
      std::size_t end = 0;
    };


    /** Times of samples, with the lines in which they are given. */
    struct Times
    {
      std::vector<double> values;
      std::vector<unsigned int> lines;
    };


    /** Return the step of times that are equally spaced. */
    double
    step_of(const Times &times, const Lines &lines)
    {
      const std::vector<double> &t = times.values;
      const std::size_t last       = t.size() - 1;
      for (std::size_t i = 1; i <= last; ++i)
        if (t[i] <= t[i - 1])
          lines.fail(fmt::format("the time {:g} comes after {:g}: times must increase. Is 'Time "
                                 "column' the number of the column of times, and is the decimal "
                                 "sign a point?",
                                 t[i],
                                 t[i - 1]),
                     times.lines[i]);
      std::vector<double> steps;
      for (std::size_t i = 1; i <= last; ++i)
        steps.push_back(t[i] - t[i - 1]);
      const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
      std::nth_element(steps.begin(), middle, steps.end());
      const double usual = *middle, mean = (t[last] - t[0]) / static_cast<double>(last);
      const auto complain = [&](const std::size_t i) {
        lines.fail(fmt::format("the step to the time {:g} is {:g} s, but most are {:g} s (the mean "
                               "is {:g} s): a record has equal steps. Is a line missing? Otherwise "
                               "interpolate the record at equal steps.",
                               t[i],
                               t[i] - t[i - 1],
                               usual,
                               mean),
                   times.lines[i]);
      };
      for (std::size_t i = 1; i <= last; ++i)
        if (std::abs(t[i] - t[i - 1] - usual) > rounding_of_times * usual)
          complain(i);
      for (std::size_t i = 1; i <= last; ++i)
        if (std::abs(t[i] - t[0] - static_cast<double>(i) * mean) > rounding_of_times * usual)
          complain(i);
      return mean;
    }


    void
    require_samples(const GroundMotion &motion, const Lines &lines)
    {
      if (motion.accelerations.size() < smallest_number_of_samples)
        lines.fail(
          fmt::format("the record has {} samples, and needs {} at least. Is this the right "
                      "file?",
                      motion.accelerations.size(),
                      smallest_number_of_samples));
    }


    /** Move past the line that contains the number of samples and the step, and return both. */
    std::pair<std::size_t, double>
    read_header_of_at2(Lines &lines)
    {
      // The length is bounded because std::regex recurses once more with every character.
      constexpr std::size_t longest_header = 200, last_line_of_header = 20;
      static const std::regex named("NPTS\\s*=\\s*(\\d+)\\s*,?\\s*DT\\s*=\\s*([-+.0-9E]+)",
                                    std::regex::icase),
        unnamed("^\\s*(\\d+)\\s+([-+.0-9E]+)\\s+NPTS\\s*,\\s*DT", std::regex::icase),
        other("(VELOCITY|DISPLACEMENT) TIME (SERIES|HISTORY)", std::regex::icase);
      while (lines.number < last_line_of_header && lines.next())
        {
          const std::string line(lines.line.substr(0, longest_header));
          std::smatch found;
          if (std::regex_search(line, found, other))
            lines.fail(fmt::format("this is a record of the {}. Take that of the acceleration "
                                   "(.AT2).",
                                   found.str(1)));
          if (!std::regex_search(line, found, named) && !std::regex_search(line, found, unnamed))
            continue;
          const std::optional<double> number = number_of_text(found.str(1)),
                                      step   = number_of_text(found.str(2));
          if (!number || !step || *step <= 0. || *number > largest_number)
            lines.fail(fmt::format("NPTS = {}, DT = {} are no number of samples and step [s] > 0.",
                                   found.str(1),
                                   found.str(2)));
          return {static_cast<std::size_t>(*number), *step};
        }
      lines.fail("there is no line with NPTS and DT, as the form .AT2 of the PEER data base has it "
                 "('NPTS= 4000, DT= .005 SEC'). Correct 'Record format'.");
    }
  } // namespace


  GroundMotion
  read_record_in_columns(const std::string &name,
                         const std::string &text,
                         const RecordColumns &columns)
  {
    Lines lines(name, text);
    GroundMotion motion;
    Times times;
    std::size_t width = 0;
    while (lines.next())
      {
        const std::vector<double> row = lines.numbers();
        if (row.empty())
          continue;
        if (width == 0)
          width = row.size();
        if (std::max(columns.time, columns.acceleration) > row.size())
          lines.fail(
            fmt::format("the line has {} column(s), but 'Time column' is {} and "
                        "'Acceleration column' {}, counted from 1. Correct these "
                        "entries; for lines of accelerations alone write 'Time column = 0' "
                        "and 'Acceleration column = 1'.",
                        row.size(),
                        columns.time,
                        columns.acceleration));
        if (row.size() != width)
          lines.fail(fmt::format("the line has {} columns, those before have {}. Is the file "
                                 "whole?",
                                 row.size(),
                                 width));
        motion.accelerations.push_back(row[columns.acceleration - 1]);
        if (columns.time > 0)
          {
            times.values.push_back(row[columns.time - 1]);
            times.lines.push_back(lines.number);
          }
      }
    require_samples(motion, lines);
    motion.step = columns.time > 0 ? step_of(times, lines) : columns.step;
    return motion;
  }


  GroundMotion
  read_record_at2(const std::string &name, const std::string &text)
  {
    Lines lines(name, text);
    const auto [number, step] = read_header_of_at2(lines);
    GroundMotion motion;
    motion.step = step;
    while (lines.next())
      for (const double value : lines.numbers())
        motion.accelerations.push_back(value);
    if (motion.accelerations.size() != number)
      lines.fail(fmt::format("the file ends with {} samples, but says NPTS = {}. Was it copied to "
                             "the end?",
                             motion.accelerations.size(),
                             number));
    require_samples(motion, lines);
    return motion;
  }
} // namespace fuga
