// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/families.h"

#include <algorithm>
#include <fmt/format.h>

namespace fuga::stress::families
{
  GridModel
  gap(Random &random)
  {
    GridModel model    = draw_stack(random);
    const double width = model.x[model.x.size() - 1];
    const double size  = width * random.power_of_ten(-6., -3.);
    Layer &layer       = model.joints[0].layer;
    if (random.chance(0.4)) // a cylinder on a plane
      layer.initial_gap = fmt::format("{}*(x - {})^2", size / width / width, 0.4 * width);
    else if (random.chance(0.5))
      layer.initial_gap = fmt::format("if(x < {}, 0, {})", random.uniform(0., 1.) * width, size);
    else
      {
        // The whole joint is open until the block is pushed down.
        layer.initial_gap           = fmt::format("{}", size);
        model.supports["block_top"] = "all";
        model.loads                 = {
                          {"displacement", "block_top", fmt::format("0; {}", -2. * size)},
                          {"displacement", "block_top", fmt::format("{}; 0", random.uniform(0., 2.) * size)},
                          {"traction", "block_left", fmt::format("{}; 0", draw_pressure(random, model))}};
      }
    model               = with_stages(random, std::move(model), random.integer(2, 4));
    model.follows_jumps = random.chance(0.5);
    return model;
  }

  GridModel
  settlement(Random &random)
  {
    GridModel model   = draw_stack(random);
    const double size = random.power_of_ten(-5., -2.);
    model.loads.push_back(
      {"displacement", "ground_bottom", fmt::format("0; {}", -size * random.uniform(0., 1.))});
    model.loads.push_back({"displacement",
                           "ground_bottom",
                           fmt::format("0; {}*(x - {})", size / (model.width()), model.x.front())});
    return with_stages(random, std::move(model), random.integer(2, 4));
  }

  // Loads that turn round a hundred times.
  GridModel
  stages(Random &random)
  {
    GridModel model = random.chance(0.3) ? draw_single(random) : draw_anything(random);
    Vector factors(model.loads.size(), 0.);
    const double step           = random.power_of_ten(-2., -0.5);
    const unsigned int n_stages = random.integer(60, 200);
    factors[0]                  = 1.;
    model.stages.push_back(factors);
    for (unsigned int s = 1; s < n_stages; ++s)
      {
        for (std::size_t l = 1; l < factors.size(); ++l)
          factors[l] = 0.9 * factors[l] + random.uniform(-step, step);
        model.stages.push_back(factors);
      }
    return model;
  }

  GridModel
  many_elements(Random &random)
  {
    StackShape shape = draw_stack_shape(random);
    shape.n_along    = random.integer(99, 299);
    shape.n_up       = random.integer(2, 6);
    GridModel model  = make_stack(shape, random.power_of_ten(1., 5.), random.power_of_ten(1., 5.));
    model.join_all([&] { return draw_layer(random); });
    add_block_loads(model, "block", draw_pressure(random, model), random.uniform(0., 1.));
    return with_stages(random, std::move(model), random.integer(1, 2));
  }

  // Friction beyond its critical value on stiff joints.
  GridModel
  high_friction(Random &random)
  {
    GridModel model = random.chance(0.2) ? draw_cross(random) : draw_anything(random);
    set_layers(model, [&] {
      Layer layer    = draw_layer(random, -12., -4., 0.4);
      layer.friction = random.uniform(1., 3.);
      return layer;
    });
    draw_reversals(random, model, random.integer(1, 3));
    return model;
  }

  // Horizontal loads that no friction holds.
  GridModel
  limit(Random &random)
  {
    GridModel model = draw_anything(random);
    set_layers(model, [&] {
      Layer layer    = draw_layer(random);
      layer.friction = random.uniform(0., 0.8);
      return layer;
    });
    draw_stages(random, model, 1);
    Vector factors = model.stages.back();
    for (std::size_t l = 1; l < factors.size(); ++l)
      factors[l] *= 20.;
    model.stages.push_back(factors);
    return model;
  }

  GridModel
  cohesion(Random &random)
  {
    GridModel model = random.chance(0.2) ? draw_cross(random) : draw_anything(random);
    const double p  = draw_pressure(random, model);
    set_layers(model, [&] {
      Layer layer    = draw_layer(random);
      layer.cohesion = p * random.power_of_ten(-2., 1.);
      return layer;
    });
    return with_stages(random, std::move(model), random.integer(2, 4));
  }

  Layer
  cubic_root_layer(Random &random, const double pressure)
  {
    Layer layer             = draw_layer(random, -8., 0., 0.2);
    layer.normal_law        = "cubic root";
    layer.normal_compliance = random.power_of_ten(-8., 0.);
    layer.thickness         = layer.normal_compliance * pressure * random.power_of_ten(-1., 3.);
    return layer;
  }

  GridModel
  cubic_root(Random &random)
  {
    GridModel model = draw_anything(random);
    const double p  = draw_pressure(random, model);
    set_layers(model, [&] { return cubic_root_layer(random, p); });
    if (random.chance(0.5))
      draw_reversals(random, model, random.integer(1, 3));
    else
      draw_stages(random, model, random.integer(1, 3));
    return model;
  }

  GridModel
  cubic_root_crossing(Random &random)
  {
    GridModel model = random.chance(0.5) ? draw_cross(random) : draw_masonry(random);
    const double p  = draw_pressure(random, model);
    set_layers(model, [&] {
      return random.chance(0.5) ? cubic_root_layer(random, p) : draw_layer(random, -8., 0., 0.2);
    });
    return with_stages(random, std::move(model), random.integer(1, 3));
  }
} // namespace fuga::stress::families
