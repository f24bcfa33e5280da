// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/families.h"

#include <algorithm>
#include <fmt/format.h>

namespace fuga::stress::families
{
  GridModel
  draw_anything(Random &random)
  {
    switch (random.integer(0, 5))
      {
        case 0:
          return draw_tower(random);
        case 1:
          return draw_arch(random);
        case 2:
          return draw_wedge(random);
        default:
          return draw_stack(random);
      }
  }

  GridModel
  with_stages(Random &random, GridModel model, const unsigned int n_stages)
  {
    draw_stages(random, model, n_stages);
    return model;
  }

  void
  set_layers(SceneData &model, const std::function<Layer()> &draw)
  {
    for (SceneData::Joint &joint : model.joints)
      joint.layer = draw();
  }

  GridModel
  single(Random &random)
  {
    return with_stages(random, draw_single(random), random.integer(2, 5));
  }

  GridModel
  stack(Random &random)
  {
    return with_stages(random, draw_stack(random), random.integer(2, 4));
  }

  GridModel
  tower(Random &random)
  {
    return with_stages(random, draw_tower(random), random.integer(2, 4));
  }

  GridModel
  cross(Random &random)
  {
    return with_stages(random, draw_cross(random), random.integer(2, 4));
  }

  GridModel
  masonry(Random &random)
  {
    return with_stages(random, draw_masonry(random), random.integer(2, 3));
  }

  GridModel
  arch(Random &random)
  {
    return with_stages(random, draw_arch(random), random.integer(2, 3));
  }

  GridModel
  wedge(Random &random)
  {
    return with_stages(random, draw_wedge(random), random.integer(2, 4));
  }

  GridModel
  virgin(Random &random)
  {
    GridModel model = draw_anything(random);
    draw_proportional_stage(random, model);
    return model;
  }

  GridModel
  reversal(Random &random)
  {
    GridModel model = draw_anything(random);
    draw_reversals(random, model, random.integer(2, 6));
    return model;
  }

  // Numbers of few binary digits, so that both halves of the structure are exact mirror images.
  GridModel
  symmetric(Random &random)
  {
    StackShape shape;
    shape.width = shape.margin = std::ldexp(1., static_cast<int>(random.integer(0, 3)));
    shape.height               = shape.width * random.one_of<double>({0.25, 0.5, 1., 2.});
    shape.depth                = shape.width;
    shape.n_along              = 1u << random.integer(0, 5);
    shape.n_margin = shape.n_down = 2;
    shape.n_up                    = 1u << random.integer(0, 2);
    GridModel model = make_stack(shape, 1024., random.one_of<double>({1024., 32768.}));
    for (double &x : model.x)
      x -= 0.5 * shape.width;
    model.join_all([&] { return draw_layer(random); });
    const double p                = 1. / 64.;
    model.loads                   = {{"pressure", "block_top", fmt::format("{}", p)},
                                     {"traction", "block_left", fmt::format("{}; 0", p)},
                                     {"traction", "block_right", fmt::format("{}; 0", -p)},
                                     {"pressure", "block_top", fmt::format("{}*x*x", p)}};
    model.bodies[0].poisson_ratio = model.bodies[1].poisson_ratio =
      random.one_of<double>({0., 0.25});
    Vector factors(4, 0.);
    const unsigned int n_stages = random.integer(2, 5);
    for (unsigned int s = 0; s < n_stages; ++s)
      {
        factors[0] = random.one_of<double>({0.5, 1., 1.5});
        factors[1] = factors[2] = random.one_of<double>({-1., -0.5, 0.5, 1.});
        factors[3]              = random.one_of<double>({0.25, 1.});
        model.stages.push_back(factors);
      }
    return model;
  }

  // Elements along one joint whose sizes differ by up to 1e6.
  GridModel
  graded(Random &random)
  {
    StackShape shape;
    const double ratio = random.power_of_ten(3., 6.);
    shape.width        = random.power_of_ten(0., 1.);
    shape.n_along      = random.integer(8, 40);
    shape.growth       = random.chance(0.5) ? ratio : 1. / ratio;
    shape.height = shape.depth = shape.width * random.power_of_ten(-2., -0.5);
    shape.margin               = shape.width;
    shape.n_up = shape.n_down = random.integer(1, 3);
    GridModel model = make_stack(shape, random.power_of_ten(1., 5.), random.power_of_ten(1., 5.));
    model.join_all([&] { return draw_layer(random); });
    add_block_loads(model, "block", draw_pressure(random, model), random.uniform(0., 0.2));
    return with_stages(random, std::move(model), random.integer(1, 3));
  }

  // Elements a thousand to ten thousand times longer than high, or higher than long.
  GridModel
  slender(Random &random)
  {
    StackShape shape   = draw_stack_shape(random);
    const double ratio = random.power_of_ten(2., 4.);
    if (random.chance(0.5))
      shape.height = shape.depth = shape.width / shape.n_along / ratio * shape.n_up;
    else
      shape.height = shape.depth = shape.width / shape.n_along * ratio * shape.n_up;
    shape.n_down    = shape.n_up;
    GridModel model = make_stack(shape, random.power_of_ten(1., 5.), random.power_of_ten(1., 5.));
    model.join_all([&] { return draw_layer(random); });
    add_block_loads(model,
                    "block",
                    draw_pressure(random, model),
                    random.uniform(0., 1.) * std::min(1., shape.width / shape.height));
    return with_stages(random, std::move(model), random.integer(1, 3));
  }

  // A site in the coordinates of a national grid.
  GridModel
  offset(Random &random)
  {
    GridModel model = with_stages(random, draw_anything(random), random.integer(1, 3));
    const std::array<double, 2> shift{
      {random.sign() * random.power_of_ten(4., 6.), random.sign() * random.power_of_ten(4., 6.)}};
    const auto before = model.map;
    model.map         = [=](const double x, const double y) {
      const auto at = before ? before(x, y) : std::array<double, 2>{{x, y}};
      return std::array<double, 2>{{at[0] + shift[0], at[1] + shift[1]}};
    };
    for (GridModel::Load &load : model.loads)
      if (load.value.find('x') != load.value.npos)
        load.value.replace(load.value.find('x'), 1, fmt::format("x - ({})", shift[0]));
    return model;
  }

  GridModel
  stiff(Random &random)
  {
    GridModel model = draw_anything(random);
    set_layers(model, [&] { return draw_layer(random, -12., -7., 0.4); });
    return with_stages(random, std::move(model), random.integer(1, 3));
  }

  // Joints softer than the bodies by 1e4 to 1e10, floating bodies, loads up to the collapse.
  GridModel
  soft(Random &random)
  {
    GridModel model = random.chance(0.5) ? draw_tower(random) : draw_stack(random);
    for (GridModel::Body &body : model.bodies)
      body.young_modulus = random.power_of_ten(3., 7.);
    set_layers(model, [&] { return draw_layer(random, 0., 3., 0.1); });
    return with_stages(random, std::move(model), random.integer(1, 3));
  }

  // Bodies whose moduli differ by 1e6, and nearly incompressible ones.
  GridModel
  contrast(Random &random)
  {
    GridModel model               = draw_stack(random);
    const double ratio            = random.power_of_ten(-6., 6.);
    model.bodies[0].young_modulus = model.bodies[1].young_modulus * ratio;
    model.bodies[0].poisson_ratio = random.one_of<double>({0.2, 0.499, 0.4999});
    model.bodies[1].poisson_ratio = random.one_of<double>({0.2, 0.499, 0.4999});
    model.loads.clear();
    add_block_loads(model, "block", draw_pressure(random, model), random.uniform(0., 1.));
    return with_stages(random, std::move(model), random.integer(1, 3));
  }

  // Bodies so stiff that they are rigid, on rigid joints: only resultants would be unique.
  GridModel
  rigid_bodies(Random &random)
  {
    GridModel model = random.chance(0.5) ? draw_tower(random) : draw_masonry(random);
    for (GridModel::Body &body : model.bodies)
      body.young_modulus *= 1e6;
    set_layers(model, [&] { return draw_layer(random, -12., -6., 0.8); });
    return with_stages(random, std::move(model), random.integer(1, 2));
  }
} // namespace fuga::stress::families
