// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_names.h>
#include <fuga/io/parameter_number_pattern.h>
#include <fuga/io/parameter_readers.h>

#include <fmt/format.h>

#include <algorithm>

namespace fuga
{
  std::vector<double>
  read_coordinates(const std::string &text)
  {
    const NumberPattern number(
      NumberPattern::Kind::real, -NumberPattern::infinity, false, NumberPattern::infinity, false);
    std::vector<double> coordinates;
    for (const std::string &piece : split_pieces(text, ','))
      if (number.match(piece))
        coordinates.push_back(std::stod(piece));
      else
        return {};
    return coordinates;
  }


  PointReference
  read_point(const ParameterSection &section, const unsigned int dimension)
  {
    const std::string text                = section.text("Point");
    const std::vector<double> coordinates = read_coordinates(text);
    PointReference point;
    if (coordinates.size() == dimension)
      std::copy(coordinates.begin(), coordinates.end(), point.coordinates.begin());
    else if (!coordinates.empty() || text.find(',') != std::string::npos)
      section.fail(
        "Point",
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
    const std::vector<std::string> bodies = values.subsection_names("Bodies");
    std::vector<MonitorDefinition> monitors;
    for (const ParameterSection &section : values.subsections("Monitors"))
      values.attempt(section, [&]() {
        const PointReference point = read_point(section, dimension);
        MonitorDefinition monitor;
        monitor.name        = section.name();
        monitor.point_name  = point.name;
        monitor.coordinates = point.coordinates;
        monitor.origin      = section.origin("Point");
        monitor.stress      = section.text("Stress") == "true";
        if (section.given("Body"))
          monitor.body = section.text("Body");
        if (section.given("Body") &&
            std::find(bodies.begin(), bodies.end(), monitor.body) == bodies.end())
          section.fail("Body",
                       fmt::format("there is no body '{}' in section Bodies. {}",
                                   monitor.body,
                                   name_hint(monitor.body, bodies, "bodies")));
        monitors.push_back(std::move(monitor));
      });
    return monitors;
  }
} // namespace fuga
