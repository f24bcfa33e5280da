// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/quadrature_lib.h>

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/boundary_conditions.h>
#include <fuga/bodies/face_map.h>
#include <fuga/bodies/uplift_assembly.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    using Profile = std::vector<std::array<double, 2>>;

    /** φ(s), linear between its points and constant outside. */
    double
    share_of_head(const Profile &profile, const double s)
    {
      const auto after = std::upper_bound(
        profile.begin(), profile.end(), s, [](const double x, const auto &p) { return x < p[0]; });
      if (after == profile.begin())
        return profile.front()[1];
      if (after == profile.end())
        return profile.back()[1];
      const auto &[s0, phi0] = *(after - 1);
      const auto &[s1, phi1] = *after;
      return phi0 + (phi1 - phi0) * (s - s0) / (s1 - s0);
    }

    double
    pressure_below(const double level, const double y, const double unit_weight)
    {
      return unit_weight * std::max(level - y, 0.);
    }
  } // namespace


  template <int dim>
  UpliftAssembly<dim>::UpliftAssembly(const Discretization<dim> &space,
                                      const JointGeometry<dim> &joint_geometry,
                                      const ContactBars<dim> &contact_bars,
                                      const JointedMesh &jointed)
    : discretization(space), geometry(joint_geometry), bars(contact_bars), mesh(jointed)
  {
  }


  template <int dim>
  auto
  UpliftAssembly<dim>::water_of(const LoadDefinition &load, const unsigned int joint) const -> Water
  {
    using End            = Uplift::End;
    const Uplift &uplift = load.uplift;
    const bool vertical  = uplift.upstream_end == End::bottom || uplift.upstream_end == End::top;
    const unsigned int c = vertical ? dim - 1 : 0;
    const bool first     = uplift.upstream_end == End::left || uplift.upstream_end == End::bottom;
    if (dim == 3 && vertical)
      throw InputError(fmt::format(
        "{}: in space the water of a joint comes from the left or from the right (the end with the "
        "smallest or the largest x); write one of them as upstream end.",
        load_title(load)));
    bool any = false;
    Water water;
    for (const auto &pair : geometry.pairs())
      if (pair.joint == joint)
        {
          if (!any || (pair.position[c] < water.upstream[c]) == first)
            water.upstream = pair.position;
          if (!any || (pair.position[c] > water.downstream[c]) == first)
            water.downstream = pair.position;
          any = true;
        }
    if constexpr (dim == 3)
      {
        require_level_end(load, joint, water.upstream);
        require_level_end(load, joint, water.downstream);
        water.downstream[1] = water.upstream[1];
      }
    const double length = water.upstream.distance(water.downstream);
    if (length == 0.)
      throw InputError(fmt::format(
        "{}: joint '{}' does not extend in {}, so that it has no upstream end there. Name another "
        "upstream end.",
        load_title(load),
        mesh.joints[joint].name,
        "xyz"[c]));
    water.profile = uplift.profile;
    if (uplift.drain_distance > 0.)
      {
        const double s = uplift.drain_distance / length;
        if (s >= 1.)
          throw InputError(fmt::format(
            "{}: the drain at the distance {:g} lies outside the joint '{}', whose ends are {:g} "
            "apart. Correct the distance.",
            load_title(load),
            uplift.drain_distance,
            mesh.joints[joint].name,
            length));
        water.profile = {{{0., 1.}}, {{s, (1. - uplift.drain_efficiency) * (1. - s)}}, {{1., 0.}}};
      }
    return water;
  }


  // The pressure at an end of the joint is that of one depth.
  template <int dim>
  void
  UpliftAssembly<dim>::require_level_end(const LoadDefinition &load,
                                         const unsigned int joint,
                                         const dealii::Point<dim> &end) const
  {
    double extent = 0.;
    for (const auto &pair : geometry.pairs())
      if (pair.joint == joint)
        extent = std::max(extent, pair.position.distance(end));
    for (const auto &pair : geometry.pairs())
      if (pair.joint == joint && std::abs(pair.position[0] - end[0]) <= 1e-6 * extent &&
          std::abs(pair.position[dim - 1] - end[dim - 1]) > 1e-6 * extent)
        throw InputError(fmt::format("{}: the end of joint '{}' at x = {:g} is not horizontal: it "
                                     "has nodes at the heights {:g} "
                                     "and {:g}. In space uplift needs horizontal upstream and "
                                     "downstream ends; divide the joint "
                                     "into several with such ends.",
                                     load_title(load),
                                     mesh.joints[joint].name,
                                     end[0],
                                     end[dim - 1],
                                     pair.position[dim - 1]));
  }


  // Cut where a pressure has a corner, the integrand is a polynomial: degree p of the shape
  // function, one of the pressure, one of a radius or of the density of the area.
  template <int dim>
  void
  UpliftAssembly<dim>::add_face(const typename JointGeometry<dim>::Face &face,
                                const LoadDefinition &load,
                                const Water &water,
                                const double level,
                                Vector &closed,
                                Vector &full) const
  {
    const double gamma   = load.depth.gradient;
    const Uplift &uplift = load.uplift;
    const auto way       = water.downstream - water.upstream;
    const FaceMap<dim> map(discretization, face.boundary);
    const Vector heights = map.heights();
    Vector shares;
    for (const auto &corner : map.corners())
      shares.push_back((corner - water.upstream) * way / way.norm_square());
    std::vector<Vector> kinks(water.profile.size() + 1, Vector(shares.size()));
    for (std::size_t v = 0; v < shares.size(); ++v)
      {
        for (std::size_t k = 0; k < water.profile.size(); ++k)
          kinks[k][v] = shares[v] - water.profile[k][0];
        kinks.back()[v] = level - heights[v];
      }

    const double u_upstream = pressure_below(level, water.upstream[dim - 1], gamma);
    const double u_downstream =
      uplift.has_tailwater ? pressure_below(uplift.tailwater, water.downstream[dim - 1], gamma)
                           : 0.;
    std::vector<typename ContactBars<dim>::Shares> elements(map.n_nodes());
    for (std::size_t k = 0; k < elements.size(); ++k)
      elements[k] = bars.shares_of_pair(face.pair_of_node(k));

    const unsigned int n_points = discretization.reference_element().scalar_element().degree + 2;
    const dealii::QGauss<1> rule(n_points);
    for (const auto &line : map.lines(kinks, n_points))
      {
        std::vector<double> cuts = {0., 1.};
        for (const Vector &kink : kinks)
          {
            const double begin = map.interpolate(kink, line.begin),
                         end   = map.interpolate(kink, line.end);
            if (begin * end < 0.)
              cuts.push_back(begin / (begin - end));
          }
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t part = 0; part + 1 < cuts.size(); ++part)
          for (unsigned int q = 0; q < rule.size(); ++q)
            {
              const double width    = cuts[part + 1] - cuts[part];
              const auto at         = line.at(cuts[part] + width * rule.point(q)[0]);
              const double area     = rule.weight(q) * width * line.weight * map.density(at);
              const double phi      = share_of_head(water.profile, map.interpolate(shares, at));
              const double u_closed = u_downstream + phi * (u_upstream - u_downstream);
              const double u_full   = pressure_below(level, map.interpolate(heights, at), gamma);
              const auto values     = map.values(at);
              for (std::size_t k = 0; k < values.size(); ++k)
                for (const auto &[element, weight] : elements[k])
                  {
                    const unsigned int bar = bars.elements()[element].normal_bar;
                    closed[bar] += area * weight * values[k] * u_closed;
                    full[bar] += area * weight * values[k] * u_full;
                  }
            }
      }
  }


  // Water presses the plus lip along the normal: as a bar force -u A does. What comes in by opening
  // never pulls.
  template <int dim>
  LoadPattern
  UpliftAssembly<dim>::assemble(const LoadDefinition &load, const double level) const
  {
    LoadPattern pattern;
    pattern.closed_water.assign(bars.bars().size(), 0.);
    Vector full(bars.bars().size(), 0.);
    for (unsigned int joint = 0; joint < mesh.joints.size(); ++joint)
      if (index_of(load.targets, mesh.joints[joint].name) < load.targets.size())
        {
          const Water water = water_of(load, joint);
          for (const auto &face : geometry.faces())
            if (face.joint == joint)
              add_face(face, load, water, level, pattern.closed_water, full);
        }
    pattern.forces.assign(discretization.n_dofs(), 0.);
    bars.add_forces(1., pattern.closed_water, pattern.forces);
    if (!load.uplift.fills_cracks)
      return pattern;
    pattern.opening_water.assign(full.size(), 0.);
    for (std::size_t i = 0; i < full.size(); ++i)
      pattern.opening_water[i] = std::max(full[i] - pattern.closed_water[i], 0.);
    return pattern;
  }


  template <int dim>
  std::vector<double>
  UpliftAssembly<dim>::levels_of_kinks(const LoadDefinition &load) const
  {
    std::vector<double> kinks;
    for (unsigned int joint = 0; joint < mesh.joints.size(); ++joint)
      if (index_of(load.targets, mesh.joints[joint].name) < load.targets.size())
        {
          double lowest = 0., highest = 0.;
          bool any = false;
          for (const auto &face : geometry.faces())
            if (face.joint == joint)
              {
                const Vector y         = FaceMap<dim>(discretization, face.boundary).heights();
                const auto [low, high] = std::minmax_element(y.begin(), y.end());
                if (*high - *low <= 1e-9 * discretization.face_length(face.boundary))
                  kinks.push_back(*low);
                lowest  = any ? std::min(lowest, *low) : *low;
                highest = any ? std::max(highest, *high) : *high;
                any     = true;
              }
          kinks.insert(kinks.end(), {lowest, highest, water_of(load, joint).upstream[dim - 1]});
        }
    std::sort(kinks.begin(), kinks.end());
    kinks.erase(
      std::unique(kinks.begin(),
                  kinks.end(),
                  [](const double a, const double b) { return b - a <= 1e-12 * std::abs(b); }),
      kinks.end());
    return kinks;
  }


  DenseMatrix
  columns_of(const std::vector<LoadPattern> &patterns, const Vector LoadPattern::*part)
  {
    std::size_t n_rows = 0;
    for (const LoadPattern &pattern : patterns)
      n_rows = std::max(n_rows, (pattern.*part).size());
    if (n_rows == 0)
      return {};
    DenseMatrix matrix(n_rows, patterns.size());
    for (std::size_t j = 0; j < patterns.size(); ++j)
      std::copy((patterns[j].*part).begin(), (patterns[j].*part).end(), matrix.column(j));
    return matrix;
  }


  template class UpliftAssembly<2>;
  template class UpliftAssembly<3>;
} // namespace fuga
