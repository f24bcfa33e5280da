// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/quadrature_lib.h>

#include <fuga/bodies/loads/depth_pressure.h>
#include <fuga/bodies/loads/uplift_assembly.h>
#include <fuga/bodies/space/node_cells_on_face.h>

#include <algorithm>
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
    plain_lines = make_lines({}, {});
    for (Line &line : plain_lines)
      line.points = points_between(line, 0., 1.);
  }


  template <int dim>
  void
  UpliftAssembly<dim>::find_extents()
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::size_t none    = bars.elements().size();
    std::vector<std::size_t> number(none, none);
    const unsigned int degree = discretization.reference_element().scalar_element().degree;
    for (std::size_t f = 0; f < maps.size(); ++f)
      {
        const auto &face     = its_way.faces()[f];
        const Vector heights = maps[f].heights();
        const auto cells     = node_cells_on_face<dim>(maps[f].corners().size(), degree);
        for (std::size_t k = 0; k < cells.size(); ++k)
          for (const auto &share : elements[f][k])
            {
              std::size_t &i = number[share.first];
              if (i == none)
                {
                  i = extents.size();
                  extents.push_back(
                    {share.first, face.way, {infinity, -infinity}, infinity, -infinity});
                }
              Extent &extent = extents[i];
              for (const FacePoint &at : cells[k])
                {
                  const double s = maps[f].interpolate(face.along, at),
                               c = maps[f].interpolate(face.across, at),
                               y = maps[f].interpolate(heights, at);
                  if (s < extent.reach.begin)
                    {
                      extent.reach.begin           = s;
                      extent.reach.height_at_begin = y;
                    }
                  if (s > extent.reach.end)
                    {
                      extent.reach.end           = s;
                      extent.reach.height_at_end = y;
                    }
                  extent.across_begin = std::min(extent.across_begin, c);
                  extent.across_end   = std::max(extent.across_end, c);
                }
            }
      }
  }


  template <int dim>
  auto
  UpliftAssembly<dim>::make_lines(const std::vector<double> &corners,
                                  const std::vector<WaterLevels> &levels) const -> std::vector<Line>
  {
    std::vector<Line> lines;
    const unsigned int n_points = discretization.reference_element().scalar_element().degree + 2;
    for (std::size_t f = 0; f < maps.size(); ++f)
      {
        const auto &face     = its_way.faces()[f];
        const Vector heights = maps[f].heights();
        const auto shifted   = [](Vector values, const double by) {
          for (double &value : values)
            value -= by;
          return values;
        };
        std::vector<Vector> functions = {face.along};
        for (const double corner : corners)
          functions.push_back(shifted(face.along, corner));
        for (const WaterLevels &level : levels)
          {
            functions.push_back(shifted(heights, level.reservoir));
            functions.push_back(shifted(heights, level.tailwater));
          }
        for (const auto &line : maps[f].lines(functions, n_points))
          {
            Line result{f, line};
            result.along[0]  = maps[f].interpolate(face.along, line.begin);
            result.along[1]  = maps[f].interpolate(face.along, line.end);
            result.height[0] = maps[f].interpolate(heights, line.begin);
            result.height[1] = maps[f].interpolate(heights, line.end);
            result.across    = maps[f].interpolate(face.across, line.at(0.5));
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
    for (const Extent &extent : extents)
      if (extent.way == way && !access.empty() &&
          (access[extent.element] == WaterAccess::upstream ||
           access[extent.element] == WaterAccess::downstream) &&
          (dim == 2 || (across >= extent.across_begin && across <= extent.across_end)))
        {
          result.push_back(extent.reach);
          result.back().source = access[extent.element];
        }
    return result;
  }


  template <int dim>
  WaterLine
  UpliftAssembly<dim>::water_line(const std::size_t way, std::vector<WaterReach> open) const
  {
    return {load.uplift, load.depth.gradient, its_way.ways()[way], std::move(open)};
  }


  template <int dim>
  std::vector<double>
  UpliftAssembly<dim>::cuts(const Line &line,
                            const WaterLine &water,
                            const std::vector<WaterLevels> &levels) const
  {
    std::vector<double> result = {0., 1.};
    const auto cut             = [&](const double(&values)[2], const double at) {
      const double begin = values[0] - at, end = values[1] - at;
      if (begin * end < 0.)
        result.push_back(begin / (begin - end));
    };
    for (const double corner : water.corners())
      cut(line.along, corner);
    for (const WaterLevels &level : levels)
      {
        cut(line.height, level.reservoir);
        cut(line.height, level.tailwater);
      }
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
        points.push_back({line.along[0] + position * (line.along[1] - line.along[0]),
                          line.height[0] + position * (line.height[1] - line.height[0]),
                          rule.weight(q) * (end - begin) * line.line.weight * map.density(at),
                          map.values(at)});
      }
    return points;
  }


  template <int dim>
  void
  UpliftAssembly<dim>::add_points(const Line &line,
                                  const std::vector<QuadraturePoint> &points,
                                  const WaterLine &water,
                                  const std::vector<WaterLevels> &levels,
                                  std::vector<Vector> &forces) const
  {
    for (const QuadraturePoint &point : points)
      for (std::size_t j = 0; j < levels.size(); ++j)
        {
          const double u = point.area * water.pressure(point.along, point.height, levels[j]);
          for (std::size_t k = 0; u != 0. && k < point.values.size(); ++k)
            for (const auto &[element, weight] : elements[line.face][k])
              forces[j][bars.elements()[element].normal_bar] += weight * point.values[k] * u;
        }
  }


  template <int dim>
  void
  UpliftAssembly<dim>::add_line(const Line &line,
                                const WaterLine &water,
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
    std::map<std::pair<std::size_t, double>, WaterLine> known;
    for (const Line &line : lines)
      {
        const std::size_t way = its_way.faces()[line.face].way;
        const auto key        = std::make_pair(way, access.empty() ? 0. : line.across);
        auto water            = known.find(key);
        if (water == known.end())
          water = known.emplace(key, water_line(way, reaches(access, way, line.across))).first;
        add_line(line, water->second, levels, result);
      }
    return result;
  }


  template <int dim>
  std::vector<Vector>
  UpliftAssembly<dim>::forces(const std::vector<WaterAccess> &access,
                              const std::vector<WaterLevels> &levels) const
  {
    if (!access.empty())
      return load.uplift.profile_from == Uplift::ProfileFrom::joint
               ? forces_by_elements(access, levels)
               : integrate(plain_lines, access, levels);
    std::vector<double> corners;
    for (std::size_t way = 0; way < its_way.ways().size(); ++way)
      for (const double corner : water_line(way, {}).corners())
        corners.push_back(corner);
    return integrate(make_lines(corners, levels), {}, levels);
  }


  template <int dim>
  std::vector<Vector>
  UpliftAssembly<dim>::still_water(const std::vector<WaterLevels> &levels,
                                   double WaterLevels::*level) const
  {
    std::vector<Vector> result(levels.size(), Vector(bars.bars().size(), 0.));
    std::vector<WaterLevels> of_one_water;
    for (const WaterLevels &both : levels)
      of_one_water.push_back({both.*level, both.*level});
    for (const Line &line : make_lines({}, of_one_water))
      {
        const std::size_t way = its_way.faces()[line.face].way;
        const WaterReach whole{0., its_way.ways()[way].length, 0., 0., WaterAccess::downstream};
        add_line(line, water_line(way, {whole}), of_one_water, result);
      }
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
    std::vector<double> upstream_heights;
    for (const auto &way : its_way.ways())
      upstream_heights.push_back(way.upstream_height);
    return fuga::levels_of_kinks(discretization, faces, std::move(upstream_heights));
  }


  template class UpliftAssembly<2>;
  template class UpliftAssembly<3>;
} // namespace fuga
