// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

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
  std::vector<WaterReach>
  UpliftAssembly<dim>::reaches(const std::vector<WaterAccess> &access,
                               const std::size_t way,
                               const double across) const
  {
    std::vector<WaterReach> result;
    // A line on the border of two elements runs through both of them, whatever rounding says.
    constexpr double on_border = 2e-12;
    const auto &width          = its_way.ways()[way].outline.width();
    const double tolerance     = on_border * (width[1] - width[0]);
    if (!access.empty())
      for (const Extent &extent : extents)
        if (extent.way == way && (access[extent.element] == WaterAccess::upstream ||
                                  access[extent.element] == WaterAccess::downstream))
          {
            const auto &[least, most] = extent.outline.width();
            if (across < least - tolerance || across > most + tolerance)
              continue;
            const double margin = std::min(tolerance, (most - least) / 2.);
            const auto ends =
              extent.outline.slice(std::clamp(across, least + margin, most - margin)).value();
            result.push_back({ends[0].along,
                              ends[1].along,
                              ends[0].height,
                              ends[1].height,
                              access[extent.element]});
          }
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
        auto &known             = line.is_along_flow() ? along_flow : of_oblique_line;
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
