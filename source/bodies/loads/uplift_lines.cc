// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/quadrature_lib.h>

#include <fuga/bodies/loads/uplift_assembly.h>

#include <algorithm>
#include <cmath>

// The lines on which the water of an uplift is integrated.
namespace fuga
{
  namespace
  {
    /** Share of the width of a way by which coordinates across it that are the same may differ. */
    constexpr double same_line = 1e-12;
  } // namespace


  template <int dim>
  std::vector<Vector>
  UpliftAssembly<dim>::corner_functions(const std::size_t f,
                                        const bool for_closed_joint,
                                        const std::vector<WaterLevels> &levels) const
  {
    const auto &face         = its_way.faces()[f];
    const auto difference_to = [](const Vector &values, const double at) {
      Vector result = values;
      for (double &value : result)
        value -= at;
      return result;
    };
    std::vector<Vector> functions;
    const auto [least, most] = std::minmax_element(face.across.begin(), face.across.end());
    const auto &outline      = its_way.ways()[face.way].outline;
    const double same        = same_line * (outline.width()[1] - outline.width()[0]);
    for (const auto &edge : outline.edges())
      if (edge[0].across > *least + same && edge[0].across < *most - same)
        functions.push_back(difference_to(face.across, edge[0].across));
    if (!for_closed_joint)
      return functions;
    const auto lines = its_way.lines_through(face.way, its_way.corner_points(f));
    std::vector<Vector> at_corner;
    for (std::size_t v = 0; v < lines.size(); ++v)
      {
        Vector values;
        for (const double corner :
             WaterLine(load.uplift, load.depth.gradient, lines[v], {}).corners())
          values.push_back(face.along[v] - corner);
        for (const WaterLevels &level : levels)
          {
            values.push_back(lines[v].upstream_height - level.reservoir);
            values.push_back(lines[v].downstream_height - level.tailwater);
          }
        at_corner.push_back(values);
      }
    for (std::size_t i = 0; i < at_corner.front().size(); ++i)
      {
        functions.emplace_back();
        for (const Vector &values : at_corner)
          functions.back().push_back(values[i]);
      }
    return functions;
  }


  template <int dim>
  auto
  UpliftAssembly<dim>::make_lines(const bool for_closed_joint,
                                  const std::vector<WaterLevels> &levels) const -> std::vector<Line>
  {
    std::vector<Line> lines;
    const unsigned int n_points = discretization.reference_element().scalar_element().degree + 2;
    for (std::size_t f = 0; f < maps.size(); ++f)
      {
        const auto &face              = its_way.faces()[f];
        const Vector heights          = maps[f].heights();
        const auto &width             = its_way.ways()[face.way].outline.width();
        std::vector<Vector> functions = {face.along};
        for (Vector &function : corner_functions(f, for_closed_joint, levels))
          functions.push_back(std::move(function));
        for (const WaterLevels &level : levels)
          for (const double height : {level.reservoir, level.tailwater})
            {
              functions.push_back(heights);
              for (double &value : functions.back())
                value -= height;
            }
        for (const auto &line : maps[f].lines(functions, n_points))
          {
            Line result{f, line};
            const auto fill = [&](const Vector &values, double(&ends)[2]) {
              ends[0] = maps[f].interpolate(values, line.begin);
              ends[1] = maps[f].interpolate(values, line.end);
            };
            fill(face.along, result.along);
            fill(face.across, result.across);
            // Lines along the flow that continue each other have the same water.
            if (const double step = same_line * (width[1] - width[0]); step > 0.)
              for (double &across : result.across)
                across = step * std::round(across / step);
            fill(heights, result.height);
            lines.push_back(result);
          }
      }
    return lines;
  }


  // A line across the face that is oblique to the flow meets the water of different lines of flow.
  // Their corners lie on straight lines between those at its two ends.
  template <int dim>
  std::vector<double>
  UpliftAssembly<dim>::cuts(const Line &line,
                            const WaterAcross &water,
                            const std::vector<WaterLevels> &levels) const
  {
    std::vector<double> result = {0., 1.};
    const auto cut             = [&](const double begin, const double end) {
      if (begin * end < 0.)
        result.push_back(begin / (begin - end));
    };
    const double middle = (line.across[0] + line.across[1]) / 2.;
    const auto corners  = [&](const unsigned int end) {
      return water(just_inside(line.across[end], middle)).corners();
    };
    const std::vector<double> first = corners(0), last = line.is_along_flow() ? first : corners(1);
    if (first.size() == last.size())
      for (std::size_t i = 0; i < first.size(); ++i)
        cut(line.along[0] - first[i], line.along[1] - last[i]);
    for (const WaterLevels &level : levels)
      for (const double height : {level.reservoir, level.tailwater})
        cut(line.height[0] - height, line.height[1] - height);
    std::sort(result.begin(), result.end());
    return result;
  }


  // Between corners the integrand is a polynomial; its degree consists of the degree p of the shape
  // function, one of the pressure, and one of a radius or of the density of the area.
  template <int dim>
  auto
  UpliftAssembly<dim>::points_between(const Line &line, const double begin, const double end) const
    -> std::vector<QuadraturePoint>
  {
    const FaceMap<dim> &map = maps[line.face];
    const dealii::QGauss<1> rule(discretization.reference_element().scalar_element().degree + 2);
    std::vector<QuadraturePoint> points;
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        const double position = begin + (end - begin) * rule.point(q)[0];
        const auto at         = line.line.at(position);
        const auto between    = [&](const double(&ends)[2]) {
          return ends[0] + position * (ends[1] - ends[0]);
        };
        points.push_back({between(line.along),
                          between(line.across),
                          between(line.height),
                          rule.weight(q) * (end - begin) * line.line.weight * map.density(at),
                          map.values(at)});
      }
    return points;
  }


  template std::vector<UpliftAssembly<2>::Line>
  UpliftAssembly<2>::make_lines(const bool, const std::vector<WaterLevels> &) const;
  template std::vector<double>
  UpliftAssembly<2>::cuts(const Line &,
                          const WaterAcross &,
                          const std::vector<WaterLevels> &) const;
  template std::vector<UpliftAssembly<2>::QuadraturePoint>
  UpliftAssembly<2>::points_between(const Line &, const double, const double) const;
  template std::vector<UpliftAssembly<3>::Line>
  UpliftAssembly<3>::make_lines(const bool, const std::vector<WaterLevels> &) const;
  template std::vector<double>
  UpliftAssembly<3>::cuts(const Line &,
                          const WaterAcross &,
                          const std::vector<WaterLevels> &) const;
  template std::vector<UpliftAssembly<3>::QuadraturePoint>
  UpliftAssembly<3>::points_between(const Line &, const double, const double) const;
} // namespace fuga
