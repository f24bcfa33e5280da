// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/scene_kinds.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>

namespace fuga::stress
{
  namespace
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
    set_layers(GridModel &model, const std::function<Layer()> &draw)
    {
      for (GridModel::Joint &joint : model.joints)
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
      return with_stages(random, std::move(model), random.integer(2, 4));
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
                             fmt::format("0; {}*(x - {})",
                                         size / (model.x.back() - model.x.front()),
                                         model.x.front())});
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
      GridModel model = make_stack(shape, random.power_of_ten(1., 5.), random.power_of_ten(1., 5.));
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
  } // namespace

  const std::vector<SceneKind> &
  scene_kinds()
  {
    static const std::vector<SceneKind> kinds = {
      {"single", "one to five contact elements", single},
      {"stack", "anything of a block on a foundation", stack},
      {"tower", "floating bodies on floating bodies", tower},
      {"cross", "four joints that cross", cross},
      {"masonry", "a wall of bricks: joints that meet in T", masonry},
      {"arch", "voussoirs between abutments that may give way", arch},
      {"wedge", "a block between inclined rigid planes", wedge},
      {"virgin", "proportional load from the apex: all events at t = 0+", virgin},
      {"reversal", "simultaneous re-stick at every load reversal", reversal},
      {"symmetric", "exact symmetry: simultaneous events", symmetric},
      {"graded", "elements of size ratio 1e6 along one joint", graded},
      {"slender", "element aspect to 1e4", slender},
      {"offset", "coordinates up to 1e6 m from the origin", offset},
      {"stiff", "compliances 0 and 1e-12 to 1e-7, mixed within a joint", stiff},
      {"soft", "joints softer than the bodies by up to 1e10, near collapse", soft},
      {"contrast", "moduli of ratio 1e-6 to 1e6, Poisson's ratio 0.4999", contrast},
      {"rigid bodies", "rigid bodies on rigid joints", rigid_bodies},
      {"gap", "initial gaps that close", gap},
      {"settlement", "prescribed displacements", settlement},
      {"stages", "60 to 200 small stages", stages},
      {"many elements", "100 to 300 contact elements", many_elements},
      {"high friction", "f from 1 to 3 on stiff joints, reversals", high_friction},
      {"limit", "pushed beyond the limit load", limit},
      {"cohesion", "bonds that break", cohesion},
      {"cubic root", "law (9), to the closure limit", cubic_root},
      {"cubic root crossing", "law (9) and linear joints that cross or meet", cubic_root_crossing},
    };
    return kinds;
  }

  GridModel
  draw_scene(const std::string &kind, const std::uint64_t seed)
  {
    for (const SceneKind &candidate : scene_kinds())
      if (kind == candidate.name)
        {
          Random random(kind, seed);
          return candidate.draw(random);
        }
    throw std::invalid_argument("unknown kind of scene: " + kind);
  }

  SceneAxes
  axes_of(const GridModel &model)
  {
    SceneAxes axes;
    axes.rho_min   = std::numeric_limits<double>::infinity();
    double softest = std::numeric_limits<double>::infinity(), stiffest = 0.;
    for (const GridModel::Body &body : model.bodies)
      {
        softest            = std::min(softest, body.young_modulus);
        stiffest           = std::max(stiffest, body.young_modulus);
        axes.poisson_ratio = std::max(axes.poisson_ratio, body.poisson_ratio);
      }
    axes.stiffness_ratio = stiffest / softest;
    for (const GridModel::Joint &joint : model.joints)
      {
        const Layer &layer = joint.layer;
        for (const auto &[law, rho] : {std::make_pair(layer.normal_law, layer.normal_compliance),
                                       std::make_pair(layer.shear_law, layer.shear_compliance)})
          {
            const double size = law == "rigid" ? 0. : rho;
            axes.rho_min      = std::min(axes.rho_min, size);
            axes.rho_max      = std::max(axes.rho_max, size);
            if (law != "rigid" && law != "linear" && axes.law.find(law) == axes.law.npos)
              axes.law = axes.law == "linear" ? law : axes.law + ", " + law;
          }
        axes.friction = std::max(axes.friction, layer.friction);
        axes.cohesion = std::max(axes.cohesion, layer.cohesion);
      }
    axes.aspect     = model.largest_aspect();
    axes.size_ratio = model.size_ratio();
    const auto at   = model.map ? model.map(model.x[0], model.y[0])
                                : std::array<double, 2>{{model.x[0], model.y[0]}};
    axes.offset     = std::max(std::abs(at[0]), std::abs(at[1]));
    axes.n_bodies   = model.bodies.size();
    axes.n_joints   = model.joints.size();
    axes.n_stages   = model.stages.size();
    return axes;
  }
} // namespace fuga::stress
