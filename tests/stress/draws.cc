// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/draws.h"

#include <algorithm>
#include <fmt/format.h>

namespace fuga::stress
{
  double
  draw_friction(Random &random)
  {
    if (random.chance(0.1))
      return 0.;
    return random.chance(0.65) ? random.uniform(0.05, 1.) : random.uniform(1., 3.);
  }

  Layer
  draw_layer(Random &random)
  {
    return draw_layer(random, -12., 3., 0.3);
  }

  Layer
  draw_layer(Random &random, const double low, const double high, const double rigid)
  {
    Layer layer;
    const auto draw = [&](std::string &law, double &compliance) {
      compliance = random.power_of_ten(low, high);
      if (random.chance(rigid))
        {
          law        = random.chance(0.5) ? "rigid" : "linear";
          compliance = 0.;
        }
    };
    draw(layer.normal_law, layer.normal_compliance);
    draw(layer.shear_law, layer.shear_compliance);
    if (random.chance(0.3))
      {
        layer.shear_law        = layer.normal_law;
        layer.shear_compliance = layer.normal_compliance;
      }
    layer.friction = draw_friction(random);
    return layer;
  }

  double
  draw_poisson_ratio(Random &random)
  {
    return random.chance(0.15) ? random.one_of<double>({0., 0.49, 0.499, 0.4999})
                               : random.uniform(0., 0.45);
  }

  unsigned int
  draw_cells(Random &random)
  {
    return random.chance(0.75) ? random.integer(1, 10) : random.integer(11, 40);
  }

  StackShape
  draw_stack_shape(Random &random)
  {
    StackShape shape;
    shape.width    = random.power_of_ten(0., 2.);
    shape.height   = shape.width * random.power_of_ten(-1., 0.7);
    shape.depth    = shape.width * random.power_of_ten(-0.5, 0.3);
    shape.margin   = shape.width * random.power_of_ten(-0.5, 0.3);
    shape.n_along  = draw_cells(random);
    shape.n_up     = random.integer(1, 5);
    shape.n_down   = random.integer(1, 4);
    shape.n_margin = random.integer(1, 3);
    return shape;
  }

  GridModel
  make_stack(const StackShape &shape, const double young_modulus, const double ground_modulus)
  {
    GridModel model;
    model.x = grid_lines({-shape.margin, 0., shape.width, shape.width + shape.margin},
                         {shape.n_margin, shape.n_along, shape.n_margin},
                         {1., shape.growth, 1.});
    model.y = grid_lines({-shape.depth, 0., shape.height}, {shape.n_down, shape.n_up});
    const std::size_t first = shape.n_margin, last = first + shape.n_along, up = shape.n_down;
    model.body_of_cell = [=](const std::size_t i, const std::size_t j) {
      return j < up ? 0 : i >= first && i < last ? 1 : GridModel::none;
    };
    model.bodies   = {{"ground", ground_modulus, 0.2, 0.}, {"block", young_modulus, 0.2, 0.}};
    model.supports = {{"ground_bottom", "all"}, {"ground_left", "x"}, {"ground_right", "x"}};
    return model;
  }

  GridModel
  draw_stack(Random &random)
  {
    GridModel model = make_stack(
      draw_stack_shape(random), random.power_of_ten(1., 5.), random.power_of_ten(1., 5.));
    for (GridModel::Body &body : model.bodies)
      body.poisson_ratio = draw_poisson_ratio(random);
    model.triangles    = random.chance(0.2);
    model.degree       = random.chance(0.2) && !model.triangles ? 2 : 1;
    model.plane_stress = random.chance(0.2);
    model.join_all([&] { return draw_layer(random); });
    add_block_loads(
      model, "block", draw_pressure(random, model), random.one_of<double>({0.3, 1., 3.}));
    return model;
  }

  void
  add_block_loads(GridModel &model,
                  const std::string &name,
                  const double pressure,
                  const double horizontal)
  {
    const double width = model.width();
    model.loads.push_back({"pressure", name + "_top", fmt::format("{}", pressure)});
    model.loads.push_back(
      {"traction", name + "_top", fmt::format("{}; 0", 0.5 * horizontal * pressure)});
    model.loads.push_back(
      {"traction", name + "_left", fmt::format("{}; 0", horizontal * pressure)});
    model.loads.push_back(
      {"pressure", name + "_top", fmt::format("{}*(x - {})/{}", pressure, model.x.front(), width)});
  }

  double
  draw_pressure(Random &random, const SceneData &model)
  {
    double softest = model.bodies[0].young_modulus;
    for (const SceneData::Body &body : model.bodies)
      softest = std::min(softest, body.young_modulus);
    return softest * random.power_of_ten(-6., -3.);
  }

  void
  draw_stages(Random &random, SceneData &model, const unsigned int n_stages)
  {
    Vector factors(model.loads.size(), 0.);
    for (unsigned int s = 0; s < n_stages; ++s)
      {
        for (std::size_t l = 0; l < factors.size(); ++l)
          if (s == 0 ? l == 0 || random.chance(0.3) : random.chance(0.6))
            factors[l] = l == 0 ? random.uniform(0.3, 1.5) : random.uniform(-1.5, 1.5);
        model.stages.push_back(factors);
      }
    // Every load has to be used.
    for (std::size_t l = 0; l < factors.size(); ++l)
      if (factors[l] == 0.)
        model.stages.back()[l] = random.uniform(-1., 1.);
  }

  void
  draw_proportional_stage(Random &random, SceneData &model)
  {
    Vector factors(model.loads.size());
    for (std::size_t l = 0; l < factors.size(); ++l)
      factors[l] = l == 0 ? 1. : random.uniform(-1.5, 1.5);
    model.stages.push_back(factors);
  }

  void
  draw_reversals(Random &random, SceneData &model, const unsigned int n_reversals)
  {
    Vector factors(model.loads.size(), 0.);
    factors[0] = 1.;
    model.stages.push_back(factors);
    Vector amplitude(factors);
    for (std::size_t l = 1; l < factors.size(); ++l)
      amplitude[l] = random.uniform(-1., 1.);
    for (unsigned int i = 0; i < n_reversals; ++i)
      {
        // Sometimes back to where it was, sometimes with another size.
        const double size =
          (i % 2 == 0 ? 1. : -1.) * (random.chance(0.6) ? 1. : random.uniform(0.2, 1.3));
        for (std::size_t l = 1; l < factors.size(); ++l)
          factors[l] = amplitude[l] * size;
        model.stages.push_back(factors);
      }
  }

  void
  draw_any_stages(Random &random, SceneData &model)
  {
    switch (random.integer(0, 2))
      {
        case 0:
          draw_proportional_stage(random, model);
          break;
        case 1:
          draw_reversals(random, model, random.integer(1, 3));
          break;
        default:
          draw_stages(random, model, random.integer(2, 4));
      }
  }
} // namespace fuga::stress
