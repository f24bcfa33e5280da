// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/syntax/parameter_declarations.h>
#include <fuga/input/syntax/parameter_names.h>

namespace fuga
{
  std::string
  EntryDeclaration::allowed() const
  {
    return !words.empty() ? "one of " + quoted_list(words) : range ? range->description() : "text";
  }


  std::string
  EntryDeclaration::problem(const std::string &value) const
  {
    if (range)
      return range->problem(value);
    const bool is_known =
      words.empty() || std::find(words.begin(), words.end(), value) != words.end();
    return is_known ? "" : "this word is unknown";
  }


  SectionDeclaration::SectionDeclaration(const std::string &section_name,
                                         const std::string &text,
                                         const std::vector<std::string> &names,
                                         const bool entries_are_free)
    : name(section_name), documentation(text), example_names(names), free_entries(entries_are_free)
  {
  }


  const EntryDeclaration *
  SectionDeclaration::find(const std::string &entry) const
  {
    const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const auto &e) { return e.name == entry; });
    return found == entries.end() ? nullptr : &*found;
  }


  std::vector<std::string>
  SectionDeclaration::entry_names() const
  {
    std::vector<std::string> names;
    for (const EntryDeclaration &entry : entries)
      names.push_back(entry.name);
    return names;
  }


  const SectionDeclaration *
  find_section(const std::string &name)
  {
    for (const SectionDeclaration &section : parameter_declarations())
      if (section.name == name)
        return &section;
    return nullptr;
  }


  const EntryDeclaration *
  find_entry(const std::string &full_name)
  {
    const std::size_t first = full_name.find('/'), last = full_name.rfind('/');
    if (first == std::string::npos)
      return find_section("")->find(full_name);
    const SectionDeclaration *section = find_section(full_name.substr(0, first));
    return section == nullptr ? nullptr : section->find(full_name.substr(last + 1));
  }
} // namespace fuga
