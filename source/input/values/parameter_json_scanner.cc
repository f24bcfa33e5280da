// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/input/syntax/parameter_names.h>
#include <fuga/input/values/parameter_scanner.h>

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

namespace fuga
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    /** Goes through a text and counts its lines, because the JSON library does not report its
     * position. */
    class CountingIterator
    {
    public:
      using iterator_category = std::input_iterator_tag;
      using value_type        = char;
      using difference_type   = std::ptrdiff_t;
      using pointer           = const char *;
      using reference         = const char &;

      CountingIterator(const char *start, unsigned int &count) : position(start), line(&count)
      {
      }

      reference
      operator*() const
      {
        return *position;
      }

      CountingIterator &
      operator++()
      {
        if (*position == '\n')
          ++*line;
        ++position;
        return *this;
      }

      CountingIterator
      operator++(int)
      {
        const CountingIterator old = *this;
        ++*this;
        return old;
      }

      bool
      operator==(const CountingIterator &other) const
      {
        return position == other.position;
      }

      bool
      operator!=(const CountingIterator &other) const
      {
        return position != other.position;
      }

    private:
      const char *position;
      unsigned int *line;
    };


    /** Turns the events of the JSON parser into sections and entries. */
    class JsonScanner : public nlohmann::json_sax<Json>
    {
    public:
      JsonScanner(const std::string &file, const unsigned int &current_line) : line(current_line)
      {
        scan.file = file;
      }

      ParameterScan
      result() const
      {
        return scan;
      }

      bool
      null() override
      {
        refuse("null", "Leave the entry out, or give it a value.");
      }

      bool
      boolean(const bool value) override
      {
        return take(value ? "true" : "false");
      }

      bool
      number_integer(const number_integer_t value) override
      {
        return take(std::to_string(value));
      }

      bool
      number_unsigned(const number_unsigned_t value) override
      {
        return take(std::to_string(value));
      }

      bool
      number_float(const number_float_t /*value*/, const string_t &text) override
      {
        return take(text);
      }

      bool
      string(string_t &text) override
      {
        return take(text);
      }

      bool
      binary(binary_t & /*value*/) override
      {
        refuse("binary data", "Write text.");
      }

      bool
      start_object(const std::size_t /*n_elements*/) override
      {
        if (depth++ > 0)
          {
            path.push_back(name);
            require_shallow(path, name_origin);
            scan.sections.push_back({path, name_origin});
          }
        return true;
      }

      bool
      end_object() override
      {
        if (--depth > 0)
          path.pop_back();
        return true;
      }

      bool
      start_array(const std::size_t /*n_elements*/) override
      {
        refuse("an array", "Write a list as one string, as in a .prm file: \"left, right\".");
      }

      bool
      end_array() override
      {
        return true;
      }

      bool
      key(string_t &text) override
      {
        name        = normalise_blanks(text);
        name_origin = origin();
        if (name.empty())
          throw InputError(fmt::format("{}: a name in the JSON file is empty.", origin()));
        return true;
      }

      bool
      parse_error(const std::size_t /*position*/,
                  const std::string & /*last_token*/,
                  const nlohmann::detail::exception &error) override
      {
        const std::string what   = error.what();
        const std::size_t prefix = what.find("] ");
        throw InputError(fmt::format("{}: JSON syntax error: {}. Correct the file near this line.",
                                     origin(),
                                     prefix == std::string::npos ? what : what.substr(prefix + 2)));
      }

    private:
      std::string
      origin() const
      {
        return fmt::format("{}:{}", scan.file, line);
      }

      bool
      take(const std::string &value)
      {
        if (depth == 0)
          refuse("a single value", "The file must be one object: {\"Mesh\": {...}, ...}.");
        scan.entries.push_back({path, name, normalise_blanks(value), name_origin});
        return true;
      }

      [[noreturn]] void
      refuse(const std::string &what, const std::string &remedy) const
      {
        const std::string where =
          path_name(path) + (path.empty() || name.empty() ? "" : "/") + name;
        throw InputError(fmt::format(
          "{}: {} is {}, which is not allowed. {}",
          origin(),
          where.empty() ? "the JSON file" : where,
          what,
          depth == 0 ? "The file must be one object: {\"Mesh\": {...}, ...}." : remedy));
      }

      const unsigned int &line;
      ParameterScan scan;
      SectionPath path;
      std::string name;
      std::string name_origin;
      unsigned int depth = 0;
    };
  } // namespace


  ParameterScan
  scan_json(const std::string &file, const std::string &text)
  {
    unsigned int line = 1;
    JsonScanner scanner(file, line);
    Json::sax_parse(CountingIterator(text.data(), line),
                    CountingIterator(text.data() + text.size(), line),
                    &scanner);
    return scanner.result();
  }
} // namespace fuga
