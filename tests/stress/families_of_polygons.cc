// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Polygons and polyhedra that random joints cut into bodies, unlike everything that grids give.

#include "stress/families.h"
#include "stress/families_in_space.h"
#include "stress/law_draws.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga::stress::families
{
  namespace
  {
    constexpr double pi = 3.14159265358979323846;

    CutPolygon
    draw_outline(Random &random)
    {
      const bool convex    = random.chance(0.6);
      const double radius  = random.power_of_ten(-0.5, 1.5);
      const double flat    = random.uniform(0.4, 1.);
      const double turn    = random.uniform(0., 2. * pi);
      const unsigned int n = random.integer(convex ? 3 : 5, 8);
      std::vector<CutPolygon::Point> outline;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double angle = turn + 2. * pi / n * (i + random.uniform(-0.3, 0.3));
          const double r     = convex ? radius : radius * random.uniform(0.5, 1.);
          outline.push_back({{r * std::cos(angle), flat * r * std::sin(angle)}});
        }
      return {outline, convex};
    }

    template <typename Bodies>
    void
    draw_moduli(Random &random, const double modulus, Bodies &model)
    {
      for (std::size_t b = 0; b < model.n_bodies(); ++b)
        model.bodies.push_back({fmt::format("b{}", b),
                                modulus * random.power_of_ten(-1., 1.),
                                draw_poisson_ratio(random),
                                0.});
    }

    // A line that cuts only some of the bodies meets another one in a T.
    CutPolygon
    draw_cut_polygon(Random &random)
    {
      constexpr double smallest     = 0.03;
      constexpr unsigned int trials = 30;
      CutPolygon polygon            = draw_outline(random);
      const double width            = polygon.width();
      const unsigned int n_lines    = random.integer(1, 5);
      unsigned int n_cuts           = 0;
      for (unsigned int i = 0; n_cuts < n_lines && (n_cuts == 0 || i < trials); ++i)
        {
          const double angle  = random.uniform(0., 2. * pi);
          const double offset = width * random.uniform(-0.3, 0.3);
          const bool through  = random.chance(0.5);
          std::vector<bool> which;
          for (std::size_t b = 0; b < polygon.n_bodies(); ++b)
            which.push_back(through || random.chance(0.5));
          if (polygon.cut({{std::cos(angle), std::sin(angle)}}, offset, which, smallest))
            ++n_cuts;
        }
      polygon.triangulate(random.integer(0, n_cuts > 2 ? 1 : 2));
      draw_moduli(random, random.power_of_ten(1., 5.), polygon);
      return polygon;
    }

    /** Adds a random number between -1 and 1 per direction, in proportion to @p size. */
    std::string
    draw_traction(Random &random, const unsigned int dimension, const double size)
    {
      std::string text;
      for (unsigned int d = 0; d < dimension; ++d)
        text = fmt::format("{}{}", size * random.uniform(-1., 1.), d == 0 ? "" : "; ") + text;
      return text;
    }

    // What looks down or aside is held, often or rarely, or stands on a rigid obstacle; the rest is
    // pressed and pushed.
    template <typename Bodies>
    void
    hold_and_load(Random &random, Bodies &polygon)
    {
      const double pressure = draw_pressure(random, polygon);
      std::string all;
      for (SceneData::Body &body : polygon.bodies)
        {
          body.weight = pressure / polygon.width() * random.uniform(0., 2.);
          all += (all.empty() ? "" : ", ") + body.name;
        }
      polygon.loads.push_back({"weight", all, ""});
      const double held = random.uniform(0.3, 1.);
      std::string lowest;
      double most = 0.;
      for (const auto &[name, normal] : polygon.outer_groups())
        {
          const double up = normal.back();
          if (up < most)
            {
              most   = up;
              lowest = name;
            }
          if (up < 0.2 && random.chance(held))
            polygon.supports[name] = "all";
          else if (up < -0.3 && random.chance(0.4))
            {
              SceneData::Joint joint;
              joint.plus = name;
              polygon.joints.push_back(joint);
            }
          else if (random.chance(0.4))
            polygon.loads.push_back(
              {"pressure", name, fmt::format("{}", pressure * random.uniform(0., 2.))});
          else if (random.chance(0.4))
            polygon.loads.push_back(
              {"traction", name, draw_traction(random, polygon.dimension(), pressure)});
        }
      const auto is_lowest = [&](const auto &item) {
        if constexpr (std::is_same_v<std::decay_t<decltype(item)>, SceneData::Load>)
          return item.target == lowest;
        else
          return item.plus == lowest;
      };
      const auto drop = [&](auto &items) {
        items.erase(std::remove_if(items.begin(), items.end(), is_lowest), items.end());
      };
      drop(polygon.loads);
      drop(polygon.joints);
      polygon.supports[lowest] = "all";
      // A settlement would tear a joint that the support shares with another one or an obstacle.
      if (polygon.supports.size() == 1 && random.chance(0.5) && polygon.joints.empty())
        polygon.loads.push_back(
          {"displacement",
           lowest,
           fmt::format("{0}; {2}{0}*(x - {1})",
                       polygon.width() * random.sign() * random.power_of_ten(-6., -3.),
                       random.uniform(-1., 1.),
                       polygon.dimension() == 3 ? "0; " : "")});
    }

    CutPolygon
    draw_polygons(Random &random, const std::function<Layer(const Scales &)> &draw)
    {
      CutPolygon polygon = draw_cut_polygon(random);
      hold_and_load(random, polygon);
      polygon.join_all([] { return Layer(); });
      const Scales scales = scales_of(random, polygon);
      set_layers(polygon, [&] { return draw(scales); });
      draw_any_stages(random, polygon);
      return polygon;
    }
  } // namespace

  CutPolygon
  polygons(Random &random)
  {
    const bool bonded = random.chance(0.3);
    return draw_polygons(random, [&](const Scales &scales) {
      Layer layer = draw_layer(random);
      if (bonded)
        layer.cohesion = scales.pressure * random.power_of_ten(-2., 1.);
      return layer;
    });
  }

  CutPolygon
  polygons_with_laws(Random &random)
  {
    return draw_polygons(random, [&](const Scales &scales) { return any_layer(random, scales); });
  }

  namespace
  {
    CutPolyhedron::Point
    draw_direction(Random &random)
    {
      const double z = random.uniform(-1., 1.), angle = random.uniform(0., 2. * pi);
      const double r = std::sqrt(1. - z * z);
      return {{r * std::cos(angle), r * std::sin(angle), z}};
    }

    // A box some corners and edges of which are cut off, then cut by planes through its middle.
    CutPolyhedron
    draw_cut_polyhedron(Random &random)
    {
      constexpr double smallest     = 0.03;
      constexpr unsigned int trials = 30;
      const double radius           = random.power_of_ten(-0.5, 1.);
      CutPolyhedron::Point half;
      for (double &side : half)
        side = radius * random.uniform(0.5, 1.);
      CutPolyhedron polyhedron(half);
      for (unsigned int i = random.integer(0, 4); i > 0; --i)
        {
          const CutPolyhedron::Point normal = draw_direction(random);
          polyhedron.cut_off(normal, radius * random.uniform(0.5, 1.), smallest);
        }
      const unsigned int n_planes = random.integer(1, 3);
      unsigned int n_cuts         = 0;
      for (unsigned int i = 0; n_cuts < n_planes && (n_cuts == 0 || i < trials); ++i)
        {
          const CutPolyhedron::Point normal = draw_direction(random);
          const double offset               = radius * random.uniform(-0.3, 0.3);
          const bool through                = random.chance(0.5);
          std::vector<bool> which;
          for (std::size_t b = 0; b < polyhedron.n_bodies(); ++b)
            which.push_back(through || random.chance(0.5));
          constexpr std::size_t most_bodies = 6;
          const CutPolyhedron before        = polyhedron;
          if (!polyhedron.cut(normal, offset, which, smallest))
            continue;
          if (polyhedron.n_bodies() <= most_bodies)
            ++n_cuts;
          else
            polyhedron = before;
        }
      polyhedron.make_tetrahedra();
      return polyhedron;
    }
  } // namespace

  CutPolyhedron
  polyhedra(Random &random)
  {
    CutPolyhedron polyhedron = draw_cut_polyhedron(random);
    draw_moduli(random, random.power_of_ten(3., 5.), polyhedron);
    hold_and_load(random, polyhedron);
    polyhedron.join_all([] { return Layer(); });
    set_layers(polyhedron, [&] { return draw_layer_in_space(random); });
    draw_any_stages(random, polyhedron);
    return polyhedron;
  }
} // namespace fuga::stress::families
