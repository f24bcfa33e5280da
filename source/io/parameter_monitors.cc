// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_entries.h>
#include <fuga/io/parameter_names.h>
#include <fuga/io/parameter_readers.h>

#include <fmt/format.h>

namespace fuga
{
  std::vector<double>
  read_coordinates(const std::string &text)
  {
    std::vector<double> coordinates;
    for (const std::string &piece : split_pieces(text, ','))
      if (const auto number = number_of_text(piece))
        coordinates.push_back(*number);
      else
        return {};
    return coordinates;
  }


  PointReference
  read_point(const ParameterSection &section, const Text &entry, const unsigned int dimension)
  {
    const std::string text                = section.value(entry);
    const std::vector<double> coordinates = read_coordinates(text);
    PointReference point;
    if (coordinates.size() == dimension)
      std::copy(coordinates.begin(), coordinates.end(), point.coordinates.begin());
    else if (!coordinates.empty() || text.find(',') != std::string::npos)
      section.fail(
        entry,
        fmt::format("this is neither the name of one point nor {} coordinates separated "
                    "by a comma. Write for example 'Point = crest' or 'Point = 2.5, 10'.",
                    dimension));
    else
      point.name = text;
    return point;
  }


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
