// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_declarations.h>
#include <fuga/io/parameter_values.h>

namespace fuga
{
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


  std::map<std::string, double>
  ParameterValues::constants() const
  {
    std::map<std::string, double> result;
    for (const std::string &name : constant_names)
      result[name] = handler.get_double({"Constants"}, name);
    return result;
  }
} // namespace fuga
