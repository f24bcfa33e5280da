// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "fuzz/mutator.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace fuga::fuzz
{
  using campaign::Random;

  namespace
  {
    const std::vector<std::string> &
    nasty_numbers()
    {
      static const std::vector<std::string> numbers = {"nan",
                                                       "inf",
                                                       "-inf",
                                                       "-nan",
                                                       "1e400",
                                                       "-1e400",
                                                       "1e308",
                                                       "1e-320",
                                                       "-1",
                                                       "0",
                                                       "-0",
                                                       "1",
                                                       "2147483647",
                                                       "2147483648",
                                                       "4294967295",
                                                       "4294967296",
                                                       "9223372036854775807",
                                                       "9223372036854775808",
                                                       "18446744073709551616",
                                                       "-9223372036854775808",
                                                       "1000000000000000000000000",
                                                       "0x10",
                                                       "1,5",
                                                       "1.5.2",
                                                       "1e",
                                                       "--1",
                                                       "+",
                                                       "1e-300",
                                                       "1e300",
                                                       ".",
                                                       "1 2",
                                                       "",
                                                       "99999999",
                                                       "0.5",
                                                       "3",
                                                       "7",
                                                       "140"};
      return numbers;
    }

    const std::vector<std::string> &
    nasty_words()
    {
      static const std::vector<std::string> words = {"rigid",
                                                     "linear",
                                                     "cubic root",
                                                     "cubic root tangent",
                                                     "all",
                                                     "free",
                                                     "x",
                                                     "y",
                                                     "z",
                                                     "x, y",
                                                     "x, y, z",
                                                     "weight",
                                                     "pressure",
                                                     "traction",
                                                     "displacement",
                                                     "point force",
                                                     "end",
                                                     "subsection",
                                                     "set",
                                                     "subsection Joints",
                                                     "set File",
                                                     "=",
                                                     ":",
                                                     ";",
                                                     ",",
                                                     "x: t; x: t",
                                                     "t",
                                                     "1/0",
                                                     "0/0",
                                                     "sqrt(-1)",
                                                     "log(0)",
                                                     "x^999",
                                                     "tabular",
                                                     "expression",
                                                     "power",
                                                     "w^999",
                                                     "1/w",
                                                     "0: 0; 1: 1",
                                                     "0: 0; 1: nan",
                                                     "hydrostatic",
                                                     "uplift",
                                                     "if(",
                                                     "sin(",
                                                     "((((((((",
                                                     "pi",
                                                     "e",
                                                     "_",
                                                     "\"",
                                                     "\\",
                                                     "{",
                                                     "}",
                                                     "[",
                                                     "]",
                                                     "null",
                                                     "true",
                                                     "1:1:10",
                                                     "0:1e-9:1",
                                                     "1:-1:5",
                                                     "..",
                                                     "/",
                                                     "/dev/null",
                                                     ".",
                                                     "$Nodes",
                                                     "$EndNodes",
                                                     "$Elements",
                                                     "$EndElements",
                                                     "$Entities",
                                                     "$PhysicalNames",
                                                     "$EndMeshFormat",
                                                     "4.1 0 8",
                                                     "2.2 0 8",
                                                     "4.1 1 8",
                                                     "2.2 1 4",
                                                     "#",
                                                     "\xEF\xBB\xBF",
                                                     "\xC3\x28",
                                                     "%s%n%d",
                                                     "exp(exp(x))",
                                                     "rint(t)*1e308",
                                                     "x=5",
                                                     "a,b",
                                                     "t, t",
                                                     "-",
                                                     "--",
                                                     "min()",
                                                     "max(1)"};
      return words;
    }

    std::vector<std::string>
    lines_of(const std::string &text)
    {
      std::vector<std::string> lines;
      std::string line;
      for (const char c : text)
        {
          line += c;
          if (c == '\n')
            {
              lines.push_back(line);
              line.clear();
            }
        }
      if (!line.empty())
        lines.push_back(line);
      return lines;
    }

    std::string
    joined(const std::vector<std::string> &lines)
    {
      std::string text;
      for (const std::string &line : lines)
        text += line;
      return text;
    }

    std::size_t
    place_in(const std::size_t size, Random &random)
    {
      return size == 0 ? 0 : random.bits() % size;
    }

    /** Begin and end of a random word: no white space in it. */
    std::pair<std::size_t, std::size_t>
    word_in(const std::string &text, Random &random)
    {
      const auto is_space = [&](const std::size_t i) {
        return std::isspace(static_cast<unsigned char>(text[i])) != 0;
      };
      std::size_t begin = place_in(text.size(), random);
      while (begin < text.size() && is_space(begin))
        ++begin;
      while (begin > 0 && begin < text.size() && !is_space(begin - 1))
        --begin;
      std::size_t end = begin;
      while (end < text.size() && !is_space(end))
        ++end;
      return {begin, end};
    }

    /** Begin and end of a random number, or of a word if there is none behind a random place. */
    std::pair<std::size_t, std::size_t>
    number_in(const std::string &text, Random &random)
    {
      const std::size_t begin = text.find_first_of("0123456789", place_in(text.size(), random));
      if (begin == text.npos)
        return word_in(text, random);
      const std::size_t end = text.find_first_not_of("0123456789.eE+-", begin);
      return {begin, end == text.npos ? text.size() : end};
    }

    std::string
    replaced(const std::string &text,
             const std::pair<std::size_t, std::size_t> &range,
             const std::string &by)
    {
      return text.substr(0, range.first) + by + text.substr(range.second);
    }

    std::string
    mutate_bytes(std::string text, Random &random)
    {
      if (text.empty())
        return std::string(1, static_cast<char>(random.bits()));
      for (unsigned int n = random.integer(1, 8); n > 0; --n)
        {
          char &c = text[place_in(text.size(), random)];
          if (random.chance(0.5))
            c = static_cast<char>(c ^ (1 << random.integer(0, 7)));
          else
            c = static_cast<char>(random.bits());
        }
      return text;
    }

    std::string
    mutate_range(std::string text, Random &random)
    {
      const std::size_t begin = place_in(text.size() + 1, random);
      const std::size_t length =
        std::min(text.size() - begin, place_in(random.chance(0.8) ? 20 : 2000, random));
      const std::string piece = text.substr(begin, length);
      switch (random.integer(0, 3))
        {
          case 0:
            return text.erase(begin, length);
          case 1:
            return text.insert(begin, piece);
          case 2:
            return text.insert(place_in(text.size() + 1, random), piece);
          default:
            {
              std::string noise(length, '\0');
              for (char &c : noise)
                c = static_cast<char>(random.bits());
              return text.replace(begin, length, noise);
            }
        }
    }

    std::string
    swap_words(const std::string &text, Random &random)
    {
      auto a = word_in(text, random), b = word_in(text, random);
      if (b.first < a.first)
        std::swap(a, b);
      if (a.second > b.first)
        return text;
      return text.substr(0, a.first) + text.substr(b.first, b.second - b.first) +
             text.substr(a.second, b.first - a.second) + text.substr(a.first, a.second - a.first) +
             text.substr(b.second);
    }

    std::string
    mutate_lines(const std::string &text, Random &random, const std::vector<std::string> &others)
    {
      std::vector<std::string> lines = lines_of(text);
      if (lines.empty())
        return text;
      const auto at = [&]() { return static_cast<std::ptrdiff_t>(place_in(lines.size(), random)); };
      std::ptrdiff_t a = at(), b = at();
      const auto begin = lines.begin();
      switch (random.integer(0, 5))
        {
          case 0:
            lines.erase(begin + a);
            break;
          case 1:
            lines.insert(begin + b, std::string(lines[static_cast<std::size_t>(a)]));
            break;
          case 2:
            std::swap(lines[static_cast<std::size_t>(a)], lines[static_cast<std::size_t>(b)]);
            break;
          case 3: // two blocks change places
            std::rotate(begin + std::min(a, b), begin + (a + b) / 2, begin + std::max(a, b));
            break;
          case 4:
            lines.erase(begin + std::min(a, b), begin + std::max(a, b));
            break;
          default:
            {
              const std::vector<std::string> foreign =
                lines_of(others[place_in(others.size(), random)]);
              lines.insert(begin + a, foreign[place_in(foreign.size(), random)]);
            }
        }
      return joined(lines);
    }

    std::string
    repeated(const std::string &piece, const std::size_t n)
    {
      std::string result;
      for (std::size_t i = 0; i < n; ++i)
        result += piece;
      return result;
    }

    /** Very long lines and very deep nesting. */
    std::string
    exaggerate(const std::string &text, Random &random)
    {
      const std::size_t n     = static_cast<std::size_t>(random.power_of_ten(2., 5.));
      const std::string piece = random.one_of<std::string>(
        {"a",     " ",  "9",       "(",  "-",    "1+",    "x*", "subsection a\n",
         "end\n", "[",  "{\"a\":", "0 ", "sin(", "if(x,", "# ", "\"",
         "\\\n",  "\t", "a/",      ",",  "\n",   "1;",    "t: "});
      const auto range  = random.chance(0.5) ? word_in(text, random) : number_in(text, random);
      const bool closed = random.chance(0.4) && (piece.back() == '(' || piece == "[");
      std::string body  = repeated(piece, n);
      if (closed)
        body += "1" + repeated(piece == "[" ? "]" : ")", n);
      return replaced(
        text, random.chance(0.5) ? range : std::make_pair(range.first, range.first), body);
    }
  } // namespace

  std::string
  mutate(const std::string &text, Random &random, const std::vector<std::string> &others)
  {
    switch (random.integer(0, 19))
      {
        case 0:
        case 1:
          return mutate_bytes(text, random);
        case 2:
          return mutate_range(text, random);
        case 3:
        case 4:
          return swap_words(text, random);
        case 5:
        case 6:
        case 7:
        case 8:
          return mutate_lines(text, random, others);
        case 9:
          return random.chance(0.3)
                   ? text.substr(0, place_in(text.size() + 1, random))
                   : text.substr(0, text.size() - place_in(text.size() / 4 + 1, random));
        case 10:
          return random.chance(0.3) ? exaggerate(text, random) : mutate_bytes(text, random);
        case 11:
        case 12:
        case 13:
          return replaced(text, word_in(text, random), random.one_of(nasty_words()));
        case 14: // a number like the others
          return replaced(text,
                          number_in(text, random),
                          random.chance(0.5) ? std::to_string(random.integer(0, 40))
                                             : std::to_string(random.uniform(-2., 2.)));
        default:
          return replaced(text, number_in(text, random), random.one_of(nasty_numbers()));
      }
  }
} // namespace fuga::fuzz
