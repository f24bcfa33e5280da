// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/syntax/parameter_names.h>
#include <fuga/input/values/parameter_values.h>

#include <fmt/format.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    /** Return the names of the sections of the top level. */
    std::vector<std::string>
    section_names()
    {
      std::vector<std::string> names;
      for (const SectionDeclaration &section : parameter_declarations())
        if (!section.name.empty())
          names.push_back(section.name);
      return names;
    }

    /** Return the declaration that belongs to a path, which is known to be valid. */
    const SectionDeclaration &
    declaration_of(const SectionPath &path)
    {
      return *find_section(path.empty() ? "" : path.front());
    }

    /** Return "It is an entry of section Joints/NAME." if another section has such an entry. */
    std::string
    elsewhere_hint(const std::string &name)
    {
      for (const SectionDeclaration &section : parameter_declarations())
        if (section.find(name) != nullptr)
          return fmt::format("It is an entry of {}{}.",
                             section.name.empty() ? "the top level, outside of all sections"
                                                  : "section " + section.name,
                             section.has_named_subsections() ? "/NAME" : "");
      return "";
    }

    /** Check a name. Names become parts of paths and lists, and must survive that. */
    void
    check_subsection_name(const ScannedSection &section)
    {
      const std::string &name = section.path.back();
      const std::size_t bad   = name.find_first_of("/,;:=\"\\");
      if (bad != std::string::npos)
        throw InputError(
          fmt::format("{}: the name '{}' contains the character '{}', which separates "
                      "names elsewhere. Choose a name without any of / , ; : = \" \\.",
                      section.origin,
                      name,
                      name[bad]));
    }

    /** Return "Did you mean ...?" if there is a similar word. */
    std::string
    close_word(const std::string &wrong, const std::vector<std::string> &words)
    {
      const std::string hint = name_hint(wrong, words, "words");
      return hint.rfind("Did", 0) == 0 ? hint : "Write one of these words.";
    }


    bool
    is_identifier(const std::string &name)
    {
      const std::string letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
      return name.find_first_not_of(letters + "0123456789") == std::string::npos &&
             letters.find(name[0]) != std::string::npos;
    }
  } // namespace


  ParameterValues::ParameterValues(const ParameterScan &scan, InputErrors &collected)
    : file_name(scan.file), of_sweep(scan.is_variant), swept(scan.swept), errors(collected)
  {
    for (const ScannedSection &section : scan.sections)
      if (broken.count({section.path.begin(), section.path.end() - 1}) > 0)
        broken.insert(section.path);
      else
        attempt(section.path, [&]() { add_section(section); });
    // The contents of unknown sections are not examined.
    errors.throw_if_any();
    find_units(scan);
    const auto is_constant = [](const ScannedEntry &entry) {
      return entry.path == SectionPath{entries_of<ConstantEntries>().name};
    };
    for (const bool constants_now : {true, false})
      for (const ScannedEntry &entry : scan.entries)
        if (is_constant(entry) == constants_now)
          attempt(entry.path, [&]() { add_entry(entry); });
    for (const SectionPath &path : all_paths())
      if (broken.count(path) == 0)
        attempt(path, [&]() { require_entries(path); });
  }


  void
  ParameterValues::add_section(const ScannedSection &section)
  {
    const std::string &top                = section.path.front();
    const SectionDeclaration *declaration = find_section(top);
    if (declaration == nullptr)
      throw InputError(fmt::format("{}: unknown section '{}'. {}",
                                   section.origin,
                                   path_name(section.path),
                                   name_hint(top, section_names(), "sections")));
    const std::size_t depth = declaration->has_named_subsections() ? 2 : 1;
    if (section.path.size() > depth)
      throw InputError(
        fmt::format("{}: section '{}' has no subsection '{}'. Is an 'end' missing above?",
                    section.origin,
                    path_name({section.path.begin(), section.path.end() - 1}),
                    section.path.back()));
    const auto [earlier, is_new] = section_origins.emplace(section.path, section.origin);
    if (section.path.size() < 2)
      return;
    check_subsection_name(section);
    if (!is_new)
      throw InputError(
        fmt::format("{}: subsection '{}' is already there, see {}. Give each its own "
                    "name, or unite the two.",
                    section.origin,
                    path_name(section.path),
                    earlier->second));
    subsection_paths[top].push_back(section.path);
  }


  void
  ParameterValues::add_entry(const ScannedEntry &entry)
  {
    refuse_unknown(entry);
    const SectionDeclaration &section = declaration_of(entry.path);
    const auto [earlier, is_new]      = entry_origins.emplace(entry.full_name(), entry.origin);
    if (!is_new)
      entry.fail(fmt::format("this entry is already set, see {}. Keep one of the two lines.",
                             earlier->second));
    if (section.free_entries)
      {
        add_constant(entry);
        return;
      }
    const EntryDeclaration &declaration = *section.find(entry.name);
    if (entry.value.empty() && !declaration.accepts_empty)
      entry.fail(fmt::format("there is no value. Allowed: {}. {}",
                             declaration.allowed(),
                             declaration.presence == Presence::required
                               ? in_units(declaration.documentation, units)
                               : "Leave the line out if you do not need it."));
    set(with_numbers(entry, declaration), declaration);
  }


  void
  ParameterValues::refuse_unknown(const ScannedEntry &entry) const
  {
    const std::string where = entry.path.empty() ? "the top level" : path_name(entry.path);
    const auto *section     = find_section(entry.path.empty() ? "" : entry.path.front());
    if (section == nullptr)
      entry.fail(fmt::format("unknown section '{}'. {}",
                             entry.path.front(),
                             name_hint(entry.path.front(), section_names(), "sections")));
    if (section->has_named_subsections() && entry.path.size() == 1)
      entry.fail(
        fmt::format("the entries of {} stand in subsections. Write 'subsection NAME' and 'end' "
                    "around this one.",
                    where));
    if (section->has_named_subsections() && section_origins.count(entry.path) == 0)
      entry.fail(fmt::format("there is no subsection '{}' in {}. {}",
                             entry.path.back(),
                             file_name,
                             name_hint(entry.path.back(),
                                       subsection_names(entry.path.front()),
                                       "subsections of " + entry.path.front())));
    if (entry.path.size() > (section->has_named_subsections() ? 2u : 1u))
      entry.fail(fmt::format("section '{}' has no such subsection.", entry.path.front()));
    if (section->free_entries || section->find(entry.name) != nullptr)
      return;
    const std::string hint = name_hint(entry.name, section->entry_names(), "entries of " + where);
    const std::string elsewhere = hint.rfind("Did", 0) == 0 ? "" : elsewhere_hint(entry.name);
    entry.fail(
      fmt::format("unknown entry '{}'. {}", entry.name, elsewhere.empty() ? hint : elsewhere));
  }


  void
  ParameterValues::add_constant(const ScannedEntry &entry)
  {
    static const std::set<std::string> reserved = {"x", "y", "z", "t", "pi"};
    EntryDeclaration constant;
    constant.range         = NumberRange();
    constant.documentation = "A constant is a number or an expression of constants above it.";
    expressions.add_unknown(entry.name);
    if (!is_identifier(entry.name) || reserved.count(entry.name) > 0)
      entry.fail(
        "a constant cannot have this name. Use letters, digits and _, a letter first, and none "
        "of x, y, z, t, pi.");
    if (entry.value.empty())
      entry.fail("there is no value. Allowed: a finite number.");
    const ScannedEntry evaluated = with_numbers(entry, constant);
    if (evaluated.value.empty())
      return; // another constant has an error
    constant_names.push_back(entry.name);
    set(evaluated, constant);
    expressions.add(entry.name, std::stod(evaluated.value));
  }


  // Anything that depends on a constant with an error of its own is not reported.
  ScannedEntry
  ParameterValues::with_numbers(const ScannedEntry &entry,
                                const EntryDeclaration &declaration) const
  {
    ConstantExpressions::Result result;
    if (declaration.range)
      result = expressions.number(entry.value);
    else if (declaration.content != TextContent::words)
      result = expressions.numbers(entry.value);
    else
      return entry;
    if (!result.problem.empty())
      entry.fail(result.problem);
    ScannedEntry evaluated = entry;
    evaluated.value        = result.is_unknown ? declaration.default_value : result.text;
    return evaluated;
  }


  void
  ParameterValues::set(const ScannedEntry &entry, const EntryDeclaration &declaration)
  {
    if (entry.value.empty())
      return; // the constants of the entry have an error of their own, or its default is empty
    const std::string problem = declaration.problem(entry.value);
    if (!problem.empty())
      entry.fail(fmt::format("{}. Allowed: {}. {}",
                             problem,
                             declaration.allowed(),
                             declaration.words.empty()
                               ? in_units(declaration.documentation, units)
                               : close_word(entry.value, declaration.words)));
    given_values[entry.full_name()] = entry.value;
  }


  std::string
  ParameterValues::value_of(const std::string &full_name, const EntryDeclaration &declaration) const
  {
    const auto given = given_values.find(full_name);
    return given == given_values.end() ? declaration.default_value : given->second;
  }


  void
  ParameterValues::require_entries(const SectionPath &path) const
  {
    for (const EntryDeclaration &entry : declaration_of(path).entries)
      {
        const ScannedEntry wanted{path, entry.name, "", ""};
        if (entry.presence == Presence::required && entry_origins.count(wanted.full_name()) == 0)
          throw InputError(fmt::format("{}: {} is missing. Allowed: {}. {}",
                                       ParameterSection(*this, path).origin(),
                                       wanted.full_name(),
                                       entry.allowed(),
                                       in_units(entry.documentation, units)));
      }
  }


  std::vector<SectionPath>
  ParameterValues::all_paths() const
  {
    std::vector<SectionPath> paths;
    for (const SectionDeclaration &section : parameter_declarations())
      if (section.name.empty())
        paths.push_back({});
      else if (!section.has_named_subsections())
        paths.push_back({section.name});
      else if (const auto found = subsection_paths.find(section.name);
               found != subsection_paths.end())
        paths.insert(paths.end(), found->second.begin(), found->second.end());
    return paths;
  }


  std::vector<std::pair<std::string, std::string>>
  ParameterValues::echo() const
  {
    std::vector<std::pair<std::string, std::string>> result;
    for (const SectionPath &path : all_paths())
      {
        const auto add = [&](const std::string &name, const EntryDeclaration &declaration) {
          const std::string full_name = ScannedEntry{path, name, "", ""}.full_name();
          if (const std::string value = value_of(full_name, declaration); !value.empty())
            result.emplace_back(full_name, value);
        };
        for (const EntryDeclaration &entry : declaration_of(path).entries)
          add(entry.name, entry);
        if (declaration_of(path).free_entries)
          for (const std::string &name : constant_names)
            add(name, {});
      }
    return result;
  }
} // namespace fuga
