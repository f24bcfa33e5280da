// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/values/parameter_values.h>

#include <algorithm>

namespace fuga
{
  // Messages refer to the units that the user named.
  void
  ParameterValues::find_units(const ParameterScan &scan)
  {
    const OutputEntries &output = entries_of<OutputEntries>();
    for (const ScannedEntry &entry : scan.entries)
      if (entry.path == SectionPath{output.name} && !entry.value.empty())
        {
          if (entry.name == output.force_unit.name())
            units.force = entry.value;
          if (entry.name == output.length_unit.name())
            units.length = entry.value;
        }
  }


  std::vector<std::string>
  ParameterValues::subsection_names(const std::string &name) const
  {
    std::vector<std::string> names;
    for (const ParameterSection &section : subsections(name))
      names.push_back(section.name());
    return names;
  }


  ParameterSection
  ParameterValues::section(const std::string &name) const
  {
    return {*this, name.empty() ? SectionPath{} : SectionPath{name}};
  }


  std::vector<ParameterSection>
  ParameterValues::subsections(const std::string &name) const
  {
    std::vector<ParameterSection> result;
    if (const auto found = subsection_paths.find(name); found != subsection_paths.end())
      for (const SectionPath &path : found->second)
        result.emplace_back(*this, path);
    return result;
  }


  void
  ParameterValues::attempt(const SectionPath &path, const std::function<void()> &action) const
  {
    if (!errors.attempt(action))
      broken.insert(path);
  }


  void
  ParameterValues::attempt(const ParameterSection &section,
                           const std::function<void()> &action) const
  {
    if (!is_broken(section))
      attempt(section.path, action);
  }


  bool
  ParameterValues::is_broken(const ParameterSection &section) const
  {
    return broken.count(section.path) > 0;
  }


  bool
  ParameterValues::is_broken(const std::string &name) const
  {
    return std::any_of(broken.begin(), broken.end(), [&](const SectionPath &path) {
      return name.empty() ? path.empty() : !path.empty() && path.front() == name;
    });
  }


  std::map<std::string, double>
  ParameterValues::constants() const
  {
    std::map<std::string, double> result;
    for (const std::string &name : constant_names)
      result[name] =
        std::stod(given_values.at(path_name({entries_of<ConstantEntries>().name, name})));
    return result;
  }
} // namespace fuga
