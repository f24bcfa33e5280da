// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/input/syntax/parameter_names.h>
#include <fuga/input/values/parameter_values.h>

#include <fmt/format.h>

#include <algorithm>

namespace fuga
{
  ParameterSection::ParameterSection(const ParameterValues &all_values,
                                     const SectionPath &section_path)
    : values(&all_values), path(section_path)
  {
  }


  bool
  ParameterSection::given(const AnyEntry &entry) const
  {
    return values->entry_origins.count(full_name(entry)) > 0;
  }


  std::string
  ParameterSection::text(const AnyEntry &entry) const
  {
    return values->value_of(full_name(entry), *entry.declaration);
  }


  std::vector<std::string>
  ParameterSection::list(const AnyEntry &entry) const
  {
    const std::vector<std::string> pieces = split_pieces(text(entry), ',');
    for (auto piece = pieces.begin(); piece != pieces.end(); ++piece)
      {
        if (piece->empty())
          fail(entry, "the list has an empty item. Write names separated by single commas.");
        if (std::find(pieces.begin(), piece, *piece) != piece)
          fail(entry, fmt::format("'{}' is in the list twice. Remove one of the two.", *piece));
      }
    return pieces;
  }


  std::vector<std::string>
  ParameterSection::swept(const AnyEntry &entry) const
  {
    const auto found = values->swept.find(full_name(entry));
    return found == values->swept.end() ? std::vector<std::string>() : found->second;
  }


  std::string
  ParameterSection::origin(const AnyEntry &entry) const
  {
    const auto at = values->entry_origins.find(full_name(entry));
    return at == values->entry_origins.end() ? origin() : at->second;
  }


  std::string
  ParameterSection::origin() const
  {
    const auto at = values->section_origins.find(path);
    return at == values->section_origins.end() ? values->file_name : at->second;
  }


  std::string
  ParameterSection::full_name(const AnyEntry &entry) const
  {
    return ScannedEntry{path, entry.name(), "", ""}.full_name();
  }


  const SectionDeclaration &
  ParameterSection::declaration() const
  {
    return *find_section(path.empty() ? "" : path.front());
  }


  void
  ParameterSection::fail(const AnyEntry &entry, const std::string &problem_and_remedy) const
  {
    throw InputError(fmt::format("{}: {} = '{}': {}",
                                 origin(entry),
                                 full_name(entry),
                                 text(entry),
                                 in_units(problem_and_remedy, values->units)));
  }


  void
  ParameterSection::fail(const std::string &problem_and_remedy) const
  {
    throw InputError(fmt::format(
      "{}: {}: {}", origin(), path_name(path), in_units(problem_and_remedy, values->units)));
  }
} // namespace fuga
