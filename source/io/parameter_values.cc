// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/io/parameter_declarations.h>
#include <fuga/io/parameter_names.h>
#include <fuga/io/parameter_number_pattern.h>
#include <fuga/io/parameter_values.h>

#include <fmt/format.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    [[noreturn]] void
    fail_at(const ScannedEntry &entry, const std::string &problem_and_remedy)
    {
      throw InputError(fmt::format(
        "{}: {} = '{}': {}", entry.origin, entry.full_name(), entry.value, problem_and_remedy));
    }

    /** Names of the sections of the top level. */
    std::vector<std::string>
    section_names()
    {
      std::vector<std::string> names;
      for (const SectionDeclaration &section : parameter_declarations())
        if (!section.name.empty())
          names.push_back(section.name);
      return names;
    }

    /** The declaration behind a path, which is known to be valid. */
    const SectionDeclaration &
    declaration_of(const SectionPath &path)
    {
      return *find_section(path.empty() ? "" : path.front());
    }

    /** "It is an entry of section Joints/NAME." if another section has such an entry. */
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

    /** Names become parts of paths and lists, and must survive that. */
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

    /** "Did you mean ...?" if there is a similar word. */
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


  ParameterValues::ParameterValues(const ParameterScan &scan) : file_name(scan.file)
  {
    for (const SectionDeclaration &section : parameter_declarations())
      if (section.name.empty())
        declare({});
      else if (!section.has_named_subsections())
        declare({section.name});
    for (const ScannedSection &section : scan.sections)
      add_section(section);
    for (const ScannedEntry &entry : scan.entries)
      add_entry(entry);
    for (const SectionPath &path : all_paths())
      require_entries(path);
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
    declare(section.path);
  }


  void
  ParameterValues::declare(const SectionPath &path)
  {
    for (const std::string &name : path)
      handler.enter_subsection(name);
    for (const EntryDeclaration &entry : declaration_of(path).entries)
      {
        // The handler wants a valid default even where the entry has to be given.
        const std::vector<std::string> words = entry.choices();
        const bool needs_word                = !words.empty() && entry.default_value.empty();
        handler.declare_entry(entry.name,
                              needs_word ? words.front() : entry.default_value,
                              *entry.pattern,
                              entry.documentation);
      }
    for (std::size_t i = 0; i < path.size(); ++i)
      handler.leave_subsection();
  }


  void
  ParameterValues::add_entry(const ScannedEntry &entry)
  {
    refuse_unknown(entry);
    const SectionDeclaration &section = declaration_of(entry.path);
    const auto [earlier, is_new]      = entry_origins.emplace(entry.full_name(), entry.origin);
    if (!is_new)
      fail_at(entry,
              fmt::format("this entry is already set, see {}. Keep one of the two lines.",
                          earlier->second));
    if (section.free_entries)
      add_constant(entry);
    else if (entry.value.empty() && !section.find(entry.name)->accepts_empty)
      fail_at(entry,
              fmt::format("there is no value. Allowed: {}. {}",
                          section.find(entry.name)->allowed(),
                          section.find(entry.name)->presence == Presence::required
                            ? section.find(entry.name)->documentation
                            : "Leave the line out if you do not need it."));
    set(entry);
  }


  void
  ParameterValues::refuse_unknown(const ScannedEntry &entry) const
  {
    const std::string where = entry.path.empty() ? "the top level" : path_name(entry.path);
    const auto *section     = find_section(entry.path.empty() ? "" : entry.path.front());
    if (section == nullptr)
      fail_at(entry,
              fmt::format("unknown section '{}'. {}",
                          entry.path.front(),
                          name_hint(entry.path.front(), section_names(), "sections")));
    if (section->has_named_subsections() && entry.path.size() == 1)
      fail_at(
        entry,
        fmt::format("the entries of {} stand in subsections. Write 'subsection NAME' and 'end' "
                    "around this one.",
                    where));
    if (section->has_named_subsections() && section_origins.count(entry.path) == 0)
      fail_at(entry,
              fmt::format("there is no subsection '{}' in {}. {}",
                          entry.path.back(),
                          file_name,
                          name_hint(entry.path.back(),
                                    subsection_names(entry.path.front()),
                                    "subsections of " + entry.path.front())));
    if (entry.path.size() > (section->has_named_subsections() ? 2u : 1u))
      fail_at(entry, fmt::format("section '{}' has no such subsection.", entry.path.front()));
    if (section->free_entries || section->find(entry.name) != nullptr)
      return;
    const std::string hint = name_hint(entry.name, section->entry_names(), "entries of " + where);
    const std::string elsewhere = hint.rfind("Did", 0) == 0 ? "" : elsewhere_hint(entry.name);
    fail_at(
      entry,
      fmt::format("unknown entry '{}'. {}", entry.name, elsewhere.empty() ? hint : elsewhere));
  }


  void
  ParameterValues::add_constant(const ScannedEntry &entry)
  {
    static const std::set<std::string> reserved = {"x", "y", "z", "t", "pi"};
    if (!is_identifier(entry.name) || reserved.count(entry.name) > 0)
      fail_at(
        entry,
        "a constant cannot have this name. Use letters, digits and _, a letter first, and none "
        "of x, y, z, t, pi.");
    if (entry.value.empty())
      fail_at(entry, "there is no value. Allowed: a finite number.");
    handler.enter_subsection(entry.path.front());
    handler.declare_entry(
      entry.name,
      "0",
      NumberPattern(
        NumberPattern::Kind::real, -NumberPattern::infinity, false, NumberPattern::infinity, false),
      "A constant.");
    handler.leave_subsection();
    constant_names.push_back(entry.name);
  }


  void
  ParameterValues::set(const ScannedEntry &entry)
  {
    static const EntryDeclaration constant = {
      "",
      Presence::required,
      "",
      std::make_shared<NumberPattern>(
        NumberPattern::Kind::real, -NumberPattern::infinity, false, NumberPattern::infinity, false),
      "Constants are plain numbers.",
      {}};
    const SectionDeclaration &section = declaration_of(entry.path);
    const EntryDeclaration &declaration =
      section.free_entries ? constant : *section.find(entry.name);
    for (const std::string &name : entry.path)
      handler.enter_subsection(name);
    try
      {
        handler.set(entry.name, entry.value);
      }
    catch (const dealii::ExceptionBase &)
      {
        const auto *number = dynamic_cast<const NumberPattern *>(declaration.pattern.get());
        const auto words   = declaration.choices();
        fail_at(
          entry,
          fmt::format("{}. Allowed: {}. {}",
                      number == nullptr ? "this word is unknown" : number->problem(entry.value),
                      declaration.allowed(),
                      words.empty() ? declaration.documentation : close_word(entry.value, words)));
      }
    for (std::size_t i = 0; i < entry.path.size(); ++i)
      handler.leave_subsection();
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
                                       entry.documentation));
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
        const SectionDeclaration &section = declaration_of(path);
        for (const std::string &name :
             section.free_entries ? constant_names : section.entry_names())
          {
            const std::string value     = handler.get(path, name);
            const std::string full_name = ScannedEntry{path, name, "", ""}.full_name();
            // The handler has a value for every choice between words, wanted or not.
            const bool absent = !section.free_entries &&
                                section.find(name)->presence == Presence::optional &&
                                entry_origins.count(full_name) == 0;
            if (!value.empty() && !absent)
              result.emplace_back(full_name, value);
          }
      }
    return result;
  }
} // namespace fuga
