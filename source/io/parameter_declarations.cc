// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_declarations.h>
#include <fuga/io/parameter_names.h>
#include <fuga/io/parameter_number_pattern.h>

#include <algorithm>
#include <set>

namespace fuga
{
  std::string
  EntryDeclaration::allowed() const
  {
    const std::vector<std::string> words = choices();
    if (!words.empty())
      return "one of " + quoted_list(words);
    if (is_number())
      return pattern->description(dealii::Patterns::PatternBase::Text);
    return "text";
  }


  bool
  EntryDeclaration::is_number() const
  {
    return dynamic_cast<const NumberPattern *>(pattern.get()) != nullptr;
  }


  bool
  EntryDeclaration::holds_numbers() const
  {
    static const std::set<std::string> names = {"Point",
                                                "Level",
                                                "Tailwater level",
                                                "Flow direction",
                                                "Pressure profile",
                                                "Normal table",
                                                "Shear table"};
    return names.count(name) > 0;
  }


  std::vector<std::string>
  EntryDeclaration::choices() const
  {
    if (dynamic_cast<const dealii::Patterns::Selection *>(pattern.get()) == nullptr)
      return {};
    const std::string words  = pattern->description(dealii::Patterns::PatternBase::Text);
    const std::string prefix = "Any one of ";
    return split_pieces(words.substr(words.rfind(prefix, 0) == 0 ? prefix.size() : 0), ',');
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
    const auto &sections = parameter_declarations();
    const auto found     = std::find_if(
      sections.begin(), sections.end(), [&](const auto &section) { return section.name == name; });
    return found == sections.end() ? nullptr : &*found;
  }
} // namespace fuga
