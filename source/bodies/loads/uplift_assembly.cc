// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/quadrature_lib.h>

#include <fuga/bodies/loads/depth_pressure.h>
#include <fuga/bodies/loads/uplift_assembly.h>
#include <fuga/bodies/space/node_cells_on_face.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  template <int dim>
  UpliftAssembly<dim>::UpliftAssembly(const LoadDefinition &its_load,
                                      const Discretization<dim> &space,
                                      const JointGeometry<dim> &joint_geometry,
                                      const ContactBars<dim> &contact_bars,
                                      const JointedMesh &jointed)
    : load(its_load)
    , discretization(space)
    , bars(contact_bars)
    , its_way(load, space, joint_geometry, jointed)
  {
    for (const auto &face : its_way.faces())
      {
        maps.emplace_back(discretization, face.face->boundary);
        elements.emplace_back();
        for (std::size_t k = 0; k < maps.back().n_nodes(); ++k)
          elements.back().push_back(bars.shares_of_pair(face.face->pair_of_node(k)));
      }
    find_extents();
    plain_lines = make_lines(false, {});
    for (Line &line : plain_lines)
      line.points = points_between(line, 0., 1.);
  }


  template <int dim>
  void
  UpliftAssembly<dim>::find_extents()
  {
    const unsigned int degree = discretization.reference_element().scalar_element().degree;
    for (std::size_t f = 0; f < maps.size(); ++f)
      {
        const auto &face = its_way.faces()[f];
        const auto cells = node_cells_on_face<dim>(maps[f].corners().size(), degree);
        for (std::size_t k = 0; k < cells.size(); ++k)
          for (const auto &share : elements[f][k])
            extents.push_back(
              {share.first, face.way, PlanOutline(its_way.points(face, maps[f], cells[k]))});
      }
  }


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
    for (const auto &edge : its_way.ways()[face.way].outline.edges())
      if (edge[0].across > *least && edge[0].across < *most)
        functions.push_back(difference_to(face.across, edge[0].across));
    if (!for_closed_joint)
      return functions;
    const auto lines = its_way.lines_through(
      face.way,
      its_way.points(
        face,
        maps[f],
        discretization.reference_element().face(face.face->boundary.number).corner_points));
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
    constexpr double rounding = 1e-12;
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
            if (const double step = rounding * (width[1] - width[0]); step > 0.)
              for (double &across : result.across)
                across = step * std::round(across / step);
            fill(heights, result.height);
            lines.push_back(result);
          }
      }
    return lines;
  }


  template <int dim>
  std::vector<WaterReach>
  UpliftAssembly<dim>::reaches(const std::vector<WaterAccess> &access,
                               const std::size_t way,
                               const double across) const
  {
    std::vector<WaterReach> result;
    if (!access.empty())
      for (const Extent &extent : extents)
        if (extent.way == way && (access[extent.element] == WaterAccess::upstream ||
                                  access[extent.element] == WaterAccess::downstream))
          if (const auto ends = extent.outline.slice(across))
            result.push_back({(*ends)[0].along,
                              (*ends)[1].along,
                              (*ends)[0].height,
                              (*ends)[1].height,
                              access[extent.element]});
    return result;
  }


  template <int dim>
  WaterLine
  UpliftAssembly<dim>::water_line(const std::size_t way,
                                  const double across,
                                  std::vector<WaterReach> open) const
  {
    return {load.uplift, load.depth.gradient, its_way.line(way, across), std::move(open)};
  }


  // A line across the face that is oblique to the flow meets the water of different lines of flow.
  // Their corners lie on straight lines between those at its two ends.
  template <int dim>
  std::vector<double>
  UpliftAssembly<dim>::cuts(const Line &line,
                            const WaterAcross &water,
                            const std::vector<WaterLevels> &levels) const
  {
    constexpr double inwards   = 1e-9;
    std::vector<double> result = {0., 1.};
    const auto cut             = [&](const double begin, const double end) {
      if (begin * end < 0.)
        result.push_back(begin / (begin - end));
    };
    const double middle = (line.across[0] + line.across[1]) / 2.;
    const auto corners  = [&](const unsigned int end) {
      return water(line.across[end] + inwards * (middle - line.across[end])).corners();
    };
    const std::vector<double> first = corners(0), last = corners(1);
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


  template <int dim>
  void
  UpliftAssembly<dim>::add_points(const Line &line,
                                  const std::vector<QuadraturePoint> &points,
                                  const WaterAcross &water,
                                  const std::vector<WaterLevels> &levels,
                                  std::vector<Vector> &forces) const
  {
    for (const QuadraturePoint &point : points)
      {
        const WaterLine &here = water(point.across);
        for (std::size_t j = 0; j < levels.size(); ++j)
          {
            const double u = point.area * here.pressure(point.along, point.height, levels[j]);
            for (std::size_t k = 0; u != 0. && k < point.values.size(); ++k)
              for (const auto &[element, weight] : elements[line.face][k])
                forces[j][bars.elements()[element].normal_bar] += weight * point.values[k] * u;
          }
      }
  }


  template <int dim>
  void
  UpliftAssembly<dim>::add_line(const Line &line,
                                const WaterAcross &water,
                                const std::vector<WaterLevels> &levels,
                                std::vector<Vector> &forces) const
  {
    const std::vector<double> ends = cuts(line, water, levels);
    if (ends.size() == 2 && !line.points.empty())
      add_points(line, line.points, water, levels, forces);
    else
      for (std::size_t part = 0; part + 1 < ends.size(); ++part)
        add_points(line, points_between(line, ends[part], ends[part + 1]), water, levels, forces);
  }


  template <int dim>
  std::vector<Vector>
  UpliftAssembly<dim>::integrate(const std::vector<Line> &lines,
                                 const std::vector<WaterAccess> &access,
                                 const std::vector<WaterLevels> &levels) const
  {
    std::vector<Vector> result(levels.size(), Vector(bars.bars().size(), 0.));
    std::map<std::pair<std::size_t, double>, WaterLine> along_flow, of_oblique_line;
    for (const Line &line : lines)
      {
        of_oblique_line.clear();
        auto &known             = line.across[0] == line.across[1] ? along_flow : of_oblique_line;
        const std::size_t way   = its_way.faces()[line.face].way;
        const WaterAcross water = [&](const double across) -> const WaterLine & {
          const auto key = std::make_pair(way, across);
          auto found     = known.find(key);
          if (found == known.end())
            found = known.emplace(key, water_line(way, across, reaches(access, way, across))).first;
          return found->second;
        };
        add_line(line, water, levels, result);
      }
    return result;
  }


  template <int dim>
  std::vector<Vector>
  UpliftAssembly<dim>::forces(const std::vector<WaterAccess> &access,
                              const std::vector<WaterLevels> &levels) const
  {
    if (access.empty())
      return integrate(make_lines(true, levels), {}, levels);
    return load.uplift.profile_from == Uplift::ProfileFrom::joint
             ? forces_by_elements(access, levels)
             : integrate(plain_lines, access, levels);
  }


  template <int dim>
  std::vector<Vector>
  UpliftAssembly<dim>::still_water(const std::vector<WaterLevels> &levels,
                                   double WaterLevels::*level) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<Vector> result(levels.size(), Vector(bars.bars().size(), 0.));
    std::vector<WaterLevels> of_one_water;
    for (const WaterLevels &both : levels)
      of_one_water.push_back({both.*level, both.*level});
    const WaterReach everywhere{-infinity, infinity, 0., 0., WaterAccess::downstream};
    const WaterLine water(load.uplift, load.depth.gradient, {}, {everywhere});
    for (const Line &line : make_lines(false, of_one_water))
      add_line(
        line, [&](const double) -> const WaterLine & { return water; }, of_one_water, result);
    return result;
  }


  template <int dim>
  std::vector<Vector>
  UpliftAssembly<dim>::forces_by_elements(const std::vector<WaterAccess> &access,
                                          const std::vector<WaterLevels> &levels) const
  {
    std::vector<Vector> result               = forces({}, levels);
    const std::vector<Vector> from_reservoir = still_water(levels, &WaterLevels::reservoir),
                              from_tailwater = still_water(levels, &WaterLevels::tailwater);
    for (const Extent &extent : extents)
      {
        const unsigned int n = bars.elements()[extent.element].normal_bar;
        for (std::size_t j = 0; j < levels.size(); ++j)
          if (access[extent.element] == WaterAccess::upstream)
            result[j][n] = std::max(result[j][n], from_reservoir[j][n]);
          else if (access[extent.element] == WaterAccess::downstream)
            result[j][n] = load.uplift.has_tailwater ? from_tailwater[j][n] : 0.;
      }
    return result;
  }


  // Water presses the plus side along the normal, as a bar force -u A does.
  template <int dim>
  LoadPattern
  UpliftAssembly<dim>::assemble(const WaterLevels &levels) const
  {
    LoadPattern pattern;
    pattern.levels       = levels;
    pattern.closed_water = forces({}, {levels}).front();
    pattern.forces.assign(discretization.n_dofs(), 0.);
    bars.add_forces(1., pattern.closed_water, pattern.forces);
    if (!load.uplift.fills_cracks)
      return pattern;
    pattern.opening_water = still_water({levels}, &WaterLevels::reservoir).front();
    for (std::size_t i = 0; i < pattern.opening_water.size(); ++i)
      pattern.opening_water[i] = std::max(pattern.opening_water[i] - pattern.closed_water[i], 0.);
    return pattern;
  }


  template <int dim>
  std::vector<double>
  UpliftAssembly<dim>::levels_of_kinks() const
  {
    std::vector<typename Discretization<dim>::BoundaryFace> faces;
    for (const auto &face : its_way.faces())
      faces.push_back(face.face->boundary);
    std::vector<double> ends;
    for (const auto &way : its_way.ways())
      for (const auto &edge : way.outline.edges())
        if (dim == 2 || edge[0].height == edge[1].height)
          ends.push_back(edge[0].height);
    return fuga::levels_of_kinks(discretization, faces, std::move(ends));
  }


  template class UpliftAssembly<2>;
  template class UpliftAssembly<3>;
} // namespace fuga
