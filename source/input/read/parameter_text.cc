// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/parameters.h>
#include <fuga/input/read/read_parameters.h>
#include <fuga/input/syntax/parameter_declarations.h>
#include <fuga/input/syntax/parameter_names.h>

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

namespace fuga
{
  namespace
  {
    /** Return comment lines of at most 100 columns. */
    std::string
    comment(const std::string &text, const std::string &indent)
    {
      std::istringstream words(text);
      std::string result;
      std::string line;
      std::string word;
      while (words >> word)
        {
          if (!line.empty() && indent.size() + 3 + line.size() + word.size() > 100)
            {
              result += indent + "#" + line + "\n";
              line.clear();
            }
          line += " " + word;
        }
      return line.empty() ? result : result + indent + "#" + line + "\n";
    }


    /** Return "Allowed: ...; default: ...". */
    std::string
    rule(const EntryDeclaration &entry)
    {
      std::string result = entry.allowed() == "text" ? "" : "Allowed: " + entry.allowed() + "; ";
      if (entry.presence == Presence::required)
        result += "required";
      else if (entry.presence == Presence::optional)
        result += "optional";
      else
        result += "default: " + (entry.default_value.empty() ? "empty" : entry.default_value);
      result[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(result[0])));
      return result + ".";
    }


    std::string
    entry_text(const EntryDeclaration &entry, const std::size_t example, const std::string &indent)
    {
      std::string value = entry.default_value;
      if (example < entry.examples.size())
        value = entry.examples[example];
      const bool is_comment = value.empty() && !entry.accepts_empty;
      return fmt::format("{}{}set {} = {}\n", indent, is_comment ? "# " : "", entry.name, value);
    }


    std::string
    section_text(const SectionDeclaration &section,
                 const std::size_t example,
                 const std::string &indent)
    {
      std::string result;
      for (const EntryDeclaration &entry : section.entries)
        {
          if (example == 0)
            result += comment(entry.documentation + " " + rule(entry), indent);
          const bool is_said = example == 0 || example < entry.examples.size();
          if (is_said && !(example > 0 && entry.examples[example].empty()))
            result += entry_text(entry, example, indent);
        }
      return result;
    }


    std::string
    named_sections_text(const SectionDeclaration &section)
    {
      std::string result;
      for (std::size_t i = 0; i < section.example_names.size(); ++i)
        result += fmt::format(
          "  subsection {}\n{}  end\n", section.example_names[i], section_text(section, i, "    "));
      return result;
    }
  } // namespace


  std::string
  default_parameter_text()
  {
    std::string result = comment(
      "Every entry of a parameter file, with its default, or with an example where it has none. "
      "The "
      "subsections of Bodies, Joints, Boundaries, Loads, Stages and Monitors are examples, too. A "
      "line that "
      "begins with '# set' is an entry which is left out here.",
      "");
    for (const SectionDeclaration &section : parameter_declarations())
      if (section.name.empty())
        result += "\n" + section_text(section, 0, "");
      else
        result += fmt::format("\n{}subsection {}\n{}end\n",
                              comment(section.documentation, ""),
                              section.name,
                              section.has_named_subsections() ? named_sections_text(section)
                                                              : section_text(section, 0, "  "));
    return result;
  }


  std::string
  echo_json(const Parameters &parameters)
  {
    nlohmann::ordered_json result = nlohmann::ordered_json::object();
    for (const auto &[path, value] : parameters.echo)
      {
        nlohmann::ordered_json *node = &result;
        for (const std::string &name : split_pieces(path, '/'))
          node = &(*node)[name];
        *node = value;
      }
    return result.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  }
} // namespace fuga
