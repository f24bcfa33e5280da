// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Scenes that begin slowly, or not, and end as motions: loads that come at once or shake, bodies
// that arrive with a velocity.

#include "stress/families.h"
#include "stress/families_in_space.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga::stress::families
{
  namespace
  {
    constexpr double gravity = 10.;

    /** Masses by which waves travel to and fro along @p length in times of the size of a second;
     * a weight that is there already gives a mass itself. Returns the longest such time [s]. */
    double
    draw_masses(Random &random, SceneData &scene, const double length)
    {
      const double usual = random.power_of_ten(-2., 1.);
      double longest     = 0.;
      for (SceneData::Body &body : scene.bodies)
        {
          if (body.weight == 0.)
            body.weight = body.young_modulus * gravity *
                          std::pow(usual * random.power_of_ten(-0.5, 0.5) / (4. * length), 2);
          longest = std::max(longest,
                             4. * length * std::sqrt(body.weight / (gravity * body.young_modulus)));
        }
      return longest;
    }

    std::string
    draw_share(Random &random)
    {
      switch (random.integer(0, 3))
        {
          case 0:
            return "1"; // at once
          case 1:
            return "t";
          case 2:
            return "t^2*(3-2*t)";
          default:
            return fmt::format(
              "(t + {}*sin({}*pi*t))", random.uniform(-2., 2.), 2 * random.integer(1, 6));
        }
    }

    /** Deformations of @p strain at the speed of sound. */
    void
    draw_velocities(Random &random, SceneData &scene, const double length, const double period)
    {
      const double velocity = random.power_of_ten(-7., -4.) * 4. * length / period;
      for (const SceneData::Body &body : scene.bodies)
        if (random.chance(0.5))
          {
            std::string &value = scene.initial_velocities[body.name];
            for (unsigned int d = 0; d < scene.dimension(); ++d)
              value += fmt::format("{}{}", d == 0 ? "" : "; ", velocity * random.uniform(-1., 1.));
          }
    }

    /** The last stages, or all of them, become motions; prescribed displacements stay as they are
     * in these. */
    void
    set_in_motion(Random &random, SceneData &scene, const double length)
    {
      const double period      = draw_masses(random, scene, length);
      const std::size_t n      = scene.stages.size();
      const std::size_t n_slow = random.chance(0.2) ? 0 : n - 1;
      scene.courses.resize(n);
      double shortest = period * 100.;
      for (std::size_t s = n_slow; s < n; ++s)
        {
          scene.courses[s] = {period * random.power_of_ten(-0.5, 0.5), draw_share(random)};
          shortest         = std::min(shortest, scene.courses[s].duration);
          for (std::size_t l = 0; l < scene.loads.size(); ++l)
            if (scene.loads[l].type == "displacement")
              scene.stages[s][l] = s > 0 ? scene.stages[s - 1][l] : 0.;
        }
      if (random.chance(0.4))
        draw_velocities(random, scene, length, period);
      scene.dynamics = {
        {"Gravity", fmt::format("{}", gravity)},
        {"Time step", fmt::format("{}", shortest / random.integer(6, 20))},
        {"Halvings", fmt::format("{}", random.integer(8, 10))},
        {"Event tolerance", fmt::format("{}", random.one_of<double>({1e-4, 1e-5}))}};
      if (random.chance(0.2))
        scene.dynamics.emplace_back("Spectral radius", fmt::format("{}", random.uniform(0.5, 1.)));
      if (random.chance(0.3))
        {
          scene.dynamics.emplace_back("Damping ratio",
                                      fmt::format("{}", random.uniform(0.01, 0.2)));
          scene.dynamics.emplace_back("Damping frequencies",
                                      fmt::format("{}; {}", 1. / period, 10. / period));
        }
    }

    /** The program wants every load to be used. */
    void
    remove_unused_loads(SceneData &scene)
    {
      for (std::size_t l = scene.loads.size(); l-- > 0;)
        if (std::all_of(scene.stages.begin(), scene.stages.end(), [l](const Vector &factors) {
              return factors[l] == 0.;
            }))
          {
            scene.loads.erase(scene.loads.begin() + l);
            for (Vector &factors : scene.stages)
              factors.erase(factors.begin() + l);
          }
    }

    GridModel
    moving(Random &random, GridModel model)
    {
      constexpr std::size_t many_stages = 3;
      if (model.stages.size() > many_stages)
        model.stages.resize(many_stages);
      set_in_motion(random, model, model.width());
      remove_unused_loads(model);
      return model;
    }
  } // namespace

  GridModel
  motion(Random &random)
  {
    GridModel model = random.chance(0.2) ? draw_cross(random) : draw_anything(random);
    set_layers(model, [&] {
      Layer layer = draw_layer(random, -8., 0., 0.2);
      if (random.chance(0.2))
        layer.initial_gap = fmt::format("{}", random.power_of_ten(-8., -4.));
      return layer;
    });
    draw_stages(random, model, random.integer(1, 3));
    return moving(random, std::move(model));
  }

  GridModel
  motion_with_laws(Random &random)
  {
    return moving(random, random.chance(0.2) ? all_laws_crossing(random) : all_laws(random));
  }

  SpatialGrid
  motion_in_space(Random &random)
  {
    SpatialGrid model = random.one_of<SpatialGrid (*)(Random &)>(
      {blocks_in_space, pair_in_space, wedge_in_space})(random);
    for (Vector &lines : model.lines)
      lines = grid_lines(lines, std::vector<unsigned int>(lines.size() - 1, 2));
    const auto body    = model.body_of_cell;
    model.body_of_cell = [body](const SpatialGrid::Index &cell) {
      return body({{cell[0] / 2, cell[1] / 2, cell[2] / 2}});
    };
    set_in_motion(random, model, model.lines[0].back() - model.lines[0].front());
    return model;
  }
} // namespace fuga::stress::families
