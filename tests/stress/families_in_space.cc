// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/families_in_space.h"

#include "stress/families.h"
#include "stress/law_draws.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>

namespace fuga::stress::families
{
  Layer
  draw_layer_in_space(Random &random)
  {
    Layer layer    = draw_layer(random, -8., -3., 0.15);
    layer.friction = random.uniform(0.2, 1.);
    return layer;
  }

  namespace
  {
    /** A plane scene with few contact elements and without points, in which the first load presses
     * all bodies together: how bodies without load lie is not unique. */
    GridModel
    draw_section(Random &random)
    {
      constexpr std::size_t many_faces = 12;
      const auto draw =
        random.one_of<GridModel (*)(Random &)>({draw_tower, draw_wedge, draw_stack, draw_stack});
      GridModel model = draw(random);
      while (model.n_joint_faces() > many_faces)
        model = draw(random);
      model.triangles    = false;
      model.plane_stress = false;
      model.load_levels  = 3;
      set_layers(model, [&] { return draw_layer_in_space(random); });
      return model;
    }

    /** Often what presses the joints together comes first. */
    void
    draw_pressing_stages(Random &random, GridModel &section)
    {
      if (random.chance(0.6))
        {
          section.stages.emplace_back(section.loads.size(), 0.);
          section.stages[0][0] = 1.;
        }
      draw_stages(random, section, random.integer(1, 2));
    }

    SpatialGrid
    extruded_anyhow(Random &random, const GridModel &section)
    {
      const double length = random.power_of_ten(-0.5, 0.5);
      return extrude(section, grid_lines({0., length}, {2}, {random.power_of_ten(-0.5, 0.5)}));
    }
  } // namespace

  SpatialGrid
  extruded(Random &random)
  {
    GridModel section = draw_section(random);
    draw_pressing_stages(random, section);
    return extruded_anyhow(random, section);
  }

  SpatialGrid
  extruded_reversal(Random &random)
  {
    GridModel section = draw_section(random);
    draw_reversals(random, section, random.integer(1, 4));
    return extruded_anyhow(random, section);
  }

  SpatialGrid
  extruded_with_laws(Random &random)
  {
    GridModel section   = draw_section(random);
    const Scales scales = scales_of(random, section);
    set_layers(section, [&] { return any_layer_or_bond(random, scales); });
    if (random.chance(0.5))
      draw_pressing_stages(random, section);
    else
      draw_reversals(random, section, random.integer(1, 4));
    return extruded_anyhow(random, section);
  }

  namespace
  {
    constexpr double weight_density = 0.024;

    SceneData::Body
    draw_heavy_body(Random &random, const std::string &name)
    {
      return {name, random.power_of_ten(3., 5.), random.uniform(0., 0.4), weight_density};
    }

    /** Adds all weights, and two pushes in any horizontal direction on the boundaries @p tops, in
     * proportion to the weight of a height @p height above them. */
    void
    add_weight_and_pushes(Random &random,
                          SpatialGrid &model,
                          const std::vector<std::string> &tops,
                          const double height)
    {
      for (const SceneData::Body &body : model.bodies)
        model.loads.push_back({"weight", body.name, ""});
      const std::size_t n_weights = model.loads.size();
      for (const std::string &top : tops)
        for (unsigned int i = 0; i < 2; ++i)
          {
            const double size  = weight_density * height * random.power_of_ten(-1., 0.3);
            const double angle = random.uniform(0., 6.283185307179586);
            model.loads.push_back(
              {"traction",
               top,
               fmt::format("{}; {}; 0", size * std::cos(angle), size * std::sin(angle))});
          }
      // Weight first or everything at once; then the pushes, to and fro or turning.
      Vector factors(model.loads.size(), 0.);
      std::fill_n(factors.begin(), n_weights, 1.);
      if (random.chance(0.8))
        model.stages.push_back(factors);
      for (unsigned int s = random.integer(1, 3); s > 0; --s)
        {
          for (std::size_t l = n_weights; l < factors.size(); ++l)
            factors[l] =
              factors[l] != 0. && random.chance(0.3) ? -factors[l] : random.uniform(-1., 1.);
          model.stages.push_back(factors);
        }
      model.load_levels = 2;
    }

    void
    stand_on_rigid_plane(SpatialGrid &model, const std::string &boundary)
    {
      SceneData::Joint joint;
      joint.plus = boundary;
      model.joints.push_back(joint);
    }

    void
    draw_all_layers(Random &random, SpatialGrid &model)
    {
      const bool equal   = random.chance(0.5);
      const Layer common = draw_layer_in_space(random);
      for (SceneData::Joint &joint : model.joints)
        joint.layer = equal ? common : draw_layer_in_space(random);
    }
  } // namespace

  SpatialGrid
  blocks_in_space(Random &random)
  {
    SpatialGrid model;
    const unsigned int n_blocks = random.integer(1, 3), nx = random.integer(1, 2),
                       ny = random.integer(1, 2);
    const double width = random.power_of_ten(-0.3, 0.5), depth = random.power_of_ten(-0.3, 0.5);
    const double height   = random.power_of_ten(-0.5, 0.3);
    const bool has_ground = random.chance(0.5);
    Vector levels;
    if (has_ground)
      {
        const double margin = random.uniform(0.3, 1.);
        model.bodies.push_back(draw_heavy_body(random, "ground"));
        model.supports["ground_bottom"] = "all";
        levels.push_back(-random.uniform(0.3, 1.));
        model.lines[0] = grid_lines({-margin, 0., width, width + margin}, {1, nx, 1});
        model.lines[1] = grid_lines({-margin, 0., depth, depth + margin}, {1, ny, 1});
      }
    else
      {
        model.lines[0] = grid_lines({0., width}, {nx});
        model.lines[1] = grid_lines({0., depth}, {ny});
      }
    levels.push_back(0.);
    for (unsigned int b = 0; b < n_blocks; ++b)
      {
        model.bodies.push_back(draw_heavy_body(random, fmt::format("b{}", b)));
        levels.push_back((b + 1) * height);
      }
    model.lines[2]     = levels;
    model.body_of_cell = [=](const SpatialGrid::Index &cell) {
      const auto is_inside = [&](const std::size_t i, const unsigned int n) {
        return !has_ground || (i >= 1 && i <= n);
      };
      return (has_ground && cell[2] == 0) || (is_inside(cell[0], nx) && is_inside(cell[1], ny))
               ? static_cast<int>(cell[2])
               : SpatialGrid::none;
    };
    if (!has_ground)
      stand_on_rigid_plane(model, "b0_bottom");
    model.tetrahedra = random.chance(0.3);
    model.join_all([] { return Layer(); });
    draw_all_layers(random, model);
    add_weight_and_pushes(random, model, {fmt::format("b{}_top", n_blocks - 1)}, n_blocks * height);
    return model;
  }

  SpatialGrid
  pair_in_space(Random &random)
  {
    SpatialGrid model;
    const double first = random.power_of_ten(-0.3, 0.3), second = random.power_of_ten(-0.3, 0.3);
    const double height  = random.power_of_ten(-0.3, 0.3);
    const unsigned int n = random.integer(1, 2);
    for (const char *const name : {"ground", "a", "b"})
      model.bodies.push_back(draw_heavy_body(random, name));
    model.lines        = {{grid_lines({0., first, first + second}, {n, n}),
                           grid_lines({0., random.power_of_ten(-0.3, 0.3)}, {random.integer(1, 2)}),
                           grid_lines({-random.uniform(0.3, 1.), 0., height}, {1, n})}};
    model.body_of_cell = [n](const SpatialGrid::Index &cell) {
      return cell[2] == 0 ? 0 : cell[0] < n ? 1 : 2;
    };
    model.supports["ground_bottom"] = "all";
    model.tetrahedra                = random.chance(0.3);
    model.join_all([] { return Layer(); });
    draw_all_layers(random, model);
    add_weight_and_pushes(random, model, {"a_top", "b_top"}, height);
    return model;
  }

  SpatialGrid
  wedge_in_space(Random &random)
  {
    SpatialGrid model;
    const double bottom = random.uniform(0.1, 1.), top = bottom + random.uniform(0.2, 2.);
    const double length = random.power_of_ten(-0.3, 0.5), slope = random.uniform(-0.2, 0.2);
    model.bodies.push_back(draw_heavy_body(random, "wedge"));
    model.lines        = {{grid_lines({-0.5, 0.5}, {random.integer(1, 2)}),
                           grid_lines({0., length}, {random.integer(1, 2)}),
                           grid_lines({0., 1.}, {random.integer(1, 2)})}};
    model.body_of_cell = [](const SpatialGrid::Index &) { return 0; };
    model.map          = [=](const std::array<double, 3> &at) {
      return std::array<double, 3>{
        {at[0] * (bottom + (top - bottom) * at[2]), at[1], at[2] + slope * at[1]}};
    };
    for (const char *const side : {"wedge_left", "wedge_right"})
      stand_on_rigid_plane(model, side);
    model.tetrahedra = random.chance(0.5);
    draw_all_layers(random, model);
    add_weight_and_pushes(random, model, {"wedge_top"}, 1.);
    return model;
  }

  namespace
  {
    /** In place of the layers of a scene under its weight: any strength on any layer. */
    template <typename Scene>
    Scene
    with_any_layers(Random &random,
                    Scene scene,
                    const std::function<void(Random &, Layer &, const Scales &)> &change = {})
    {
      double heaviest = 0.;
      for (const SceneData::Body &body : scene.bodies)
        heaviest = std::max(heaviest, body.weight);
      const Scales scales = scales_of(scene, heaviest * scene.width());
      set_layers(scene, [&] {
        Layer layer = any_layer_or_bond(random, scales);
        if (change)
          change(random, layer, scales);
        return layer;
      });
      return scene;
    }

    SpatialGrid
    blocks_or_wedge(Random &random)
    {
      return random.one_of<SpatialGrid (*)(Random &)>(
        {blocks_in_space, pair_in_space, wedge_in_space})(random);
    }
  } // namespace

  SpatialGrid
  blocks_with_laws(Random &random)
  {
    return with_any_layers(random, blocks_or_wedge(random));
  }

  SpatialGrid
  envelopes_in_space(Random &random)
  {
    return with_any_layers(random, blocks_or_wedge(random), bend);
  }

  CutPolyhedron
  polyhedra_with_laws(Random &random)
  {
    return with_any_layers(random, polyhedra(random));
  }

  SpatialGrid
  motion_in_space_with_laws(Random &random)
  {
    return with_any_layers(random, motion_in_space(random));
  }
} // namespace fuga::stress::families
