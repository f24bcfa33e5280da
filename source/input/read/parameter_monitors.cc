// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/read/parameter_readers.h>
#include <fuga/input/syntax/parameter_names.h>
#include <fuga/input/values/value_readers.h>

#include <fmt/format.h>

namespace fuga
{
  std::vector<MonitorDefinition>
  read_monitors(const ParameterValues &values, const unsigned int dimension)
  {
    const MonitorEntries &e               = entries_of<MonitorEntries>();
    const std::vector<std::string> bodies = values.subsection_names<BodyEntries>();
    std::vector<MonitorDefinition> monitors;
    for (const ParameterSection &section : values.subsections<MonitorEntries>())
      values.attempt(section, [&]() {
        const PointReference point = read_point(section, e.point, dimension);
        MonitorDefinition monitor;
        monitor.name        = section.name();
        monitor.point_name  = point.name;
        monitor.coordinates = point.coordinates;
        monitor.origin      = section.origin(e.point);
        section.read(monitor);
        if (section.given(e.body))
          number_of(monitor.body, bodies, "body", section, e.body);
        monitors.push_back(std::move(monitor));
      });
    return monitors;
  }
} // namespace fuga
