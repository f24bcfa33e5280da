// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Several bodies: towers, crossings, walls, arches, wedges.

#include "stress/draws.h"

#include <algorithm>
#include <fmt/format.h>

namespace fuga::stress
{
  namespace
  {
    GridModel::Body
    draw_body(Random &random, const std::string &name, const double modulus)
    {
      return {name, modulus * random.power_of_ten(-1., 1.), draw_poisson_ratio(random), 0.};
    }

    /** All joints equal, or each with its own layer. */
    void
    draw_layers(Random &random, GridModel &model)
    {
      const bool equal   = random.chance(0.5);
      const Layer common = draw_layer(random);
      model.join_all([&] { return equal ? common : draw_layer(random); });
    }

    void
    stand_on_rigid(Random &random, GridModel &model, const std::string &body)
    {
      GridModel::Joint joint;
      joint.plus  = body + "_bottom";
      joint.layer = draw_layer(random);
      model.joints.push_back(joint);
    }
  } // namespace

  GridModel
  draw_tower(Random &random)
  {
    GridModel model;
    const unsigned int n_bodies = random.integer(2, 5), n_up = random.integer(1, 3);
    const double width   = random.power_of_ten(0., 1.),
                 height  = width * random.power_of_ten(-0.7, 0.3);
    const double modulus = random.power_of_ten(1., 5.);
    Vector levels        = {0.};
    for (unsigned int b = 0; b < n_bodies; ++b)
      {
        levels.push_back(levels.back() + height);
        model.bodies.push_back(draw_body(random, fmt::format("b{}", b), modulus));
      }
    model.x            = grid_lines({0., width}, {random.integer(1, 12)});
    model.y            = grid_lines(levels, std::vector<unsigned int>(n_bodies, n_up));
    model.body_of_cell = [n_up](const std::size_t, const std::size_t j) {
      return static_cast<int>(j / n_up);
    };
    draw_layers(random, model);
    if (random.chance(0.5))
      stand_on_rigid(random, model, "b0");
    else
      model.supports["b0_bottom"] = "all";
    add_block_loads(model,
                    fmt::format("b{}", n_bodies - 1),
                    draw_pressure(random, model),
                    random.uniform(0., 1.));
    return model;
  }

  GridModel
  draw_cross(Random &random)
  {
    GridModel model;
    const unsigned int n = random.integer(1, 5), m = random.integer(1, 5);
    const double width = random.power_of_ten(0., 1.), height = width * random.uniform(0.5, 2.);
    const double modulus = random.power_of_ten(1., 5.);
    for (const char *const name : {"a", "b", "c", "d"})
      model.bodies.push_back(draw_body(random, name, modulus));
    model.x            = grid_lines({0., width, 2. * width}, {n, n});
    model.y            = grid_lines({0., height, 2. * height}, {m, m});
    model.body_of_cell = [n, m](const std::size_t i, const std::size_t j) {
      return (i < n ? 0 : 1) + (j < m ? 0 : 2);
    };
    draw_layers(random, model);
    model.supports        = {{"a_bottom", "all"}, {"b_bottom", random.chance(0.5) ? "all" : "y"}};
    const double pressure = draw_pressure(random, model);
    add_block_loads(model, "c", pressure, random.uniform(0., 2.));
    model.loads.push_back({"pressure", "d_top", fmt::format("{}", pressure)});
    model.loads.push_back({"traction", "d_right", fmt::format("{}; 0", -pressure)});
    return model;
  }

  GridModel
  draw_masonry(Random &random)
  {
    GridModel model;
    const unsigned int n_courses = random.integer(2, 4), n_halves = random.integer(2, 5);
    const unsigned int n = random.integer(1, 3), m = random.integer(1, 2);
    const double modulus = random.power_of_ten(1., 5.);
    Vector xs = {0.}, ys = {0.};
    for (unsigned int i = 0; i < n_halves; ++i)
      xs.push_back(xs.back() + 0.125);
    for (unsigned int j = 0; j < n_courses; ++j)
      ys.push_back(ys.back() + 0.125);
    model.x = grid_lines(xs, std::vector<unsigned int>(n_halves, n));
    model.y = grid_lines(ys, std::vector<unsigned int>(n_courses, m));
    // Course j begins with a half brick if j is odd.
    const unsigned int per_course = n_halves / 2 + 1;
    std::vector<int> number(per_course * n_courses, GridModel::none);
    const auto brick = [=](const std::size_t half, const std::size_t course) {
      return (half + course % 2) / 2 + per_course * course;
    };
    for (unsigned int j = 0; j < n_courses; ++j)
      for (unsigned int i = 0; i < n_halves; ++i)
        if (int &b = number[brick(i, j)]; b == GridModel::none)
          {
            b = static_cast<int>(model.bodies.size());
            model.bodies.push_back(
              draw_body(random, fmt::format("brick{}", model.bodies.size()), modulus));
          }
    model.body_of_cell = [=](const std::size_t i, const std::size_t j) {
      return number[brick(i / n, j / m)];
    };
    draw_layers(random, model);
    for (unsigned int i = 0; i < n_halves; ++i)
      model.supports[model.bodies[static_cast<std::size_t>(number[brick(i, 0)])].name + "_bottom"] =
        "all";
    const double pressure = draw_pressure(random, model);
    std::string last;
    for (unsigned int i = 0; i < n_halves; ++i)
      {
        const std::string name =
          model.bodies[static_cast<std::size_t>(number[brick(i, n_courses - 1)])].name;
        if (name != last)
          model.loads.push_back({"pressure", name + "_top", fmt::format("{}", pressure)});
        last = name;
      }
    const std::string first =
      model.bodies[static_cast<std::size_t>(number[brick(0, n_courses - 1)])].name;
    model.loads.push_back(
      {"traction", first + "_left", fmt::format("{}; 0", pressure * random.uniform(0., 2.))});
    return model;
  }

  GridModel
  draw_arch(Random &random)
  {
    GridModel model;
    const unsigned int n_stones = random.integer(2, 7), n_along = random.integer(1, 3);
    const double thickness = random.uniform(0.1, 0.5);
    const double modulus   = random.power_of_ten(1., 5.);
    const double pi        = 3.14159265358979323846;
    Vector angles          = {0.};
    for (unsigned int s = 0; s < n_stones; ++s)
      {
        angles.push_back(pi * (s + 1.) / n_stones);
        model.bodies.push_back(draw_body(random, fmt::format("s{}", s), modulus));
      }
    model.x            = grid_lines(angles, std::vector<unsigned int>(n_stones, n_along));
    model.y            = grid_lines({1. - thickness, 1.}, {random.integer(1, 6)});
    model.body_of_cell = [n_along](const std::size_t i, const std::size_t) {
      return static_cast<int>(i / n_along);
    };
    model.map = [](const double angle, const double radius) {
      return std::array<double, 2>{{-radius * std::cos(angle), radius * std::sin(angle)}};
    };
    draw_layers(random, model);
    const std::string last = fmt::format("s{}", n_stones - 1);
    model.supports         = {{"s0_left", "all"}, {last + "_right", "all"}};
    const double pressure  = draw_pressure(random, model);
    for (unsigned int s = 0; s < n_stones; ++s)
      model.loads.push_back(
        {"traction", fmt::format("s{}_top", s), fmt::format("0; {}", -pressure)});
    model.loads.push_back(
      {"traction", fmt::format("s{}_top", n_stones / 2), fmt::format("{}; 0", pressure)});
    if (n_stones > 2 && random.chance(0.3)) // the abutments give way
      model.loads.push_back({"displacement",
                             last + "_right",
                             fmt::format("{}; 0", random.sign() * random.power_of_ten(-5., -3.))});
    return model;
  }

  GridModel
  draw_wedge(Random &random)
  {
    GridModel model;
    const double modulus = random.power_of_ten(1., 5.);
    const double bottom = random.uniform(0.3, 1.), top = bottom + random.uniform(-0.2, 1.5);
    model.bodies.push_back(draw_body(random, "wedge", modulus));
    model.x            = grid_lines({-0.5, 0.5}, {random.integer(1, 6)});
    model.y            = grid_lines({0., 1.}, {random.integer(1, 10)});
    model.body_of_cell = [](const std::size_t, const std::size_t) { return 0; };
    model.map          = [bottom, top](const double s, const double r) {
      return std::array<double, 2>{{s * (bottom + (top - bottom) * r), r}};
    };
    for (const char *const side : {"wedge_left", "wedge_right"})
      {
        GridModel::Joint joint;
        joint.plus  = side;
        joint.layer = draw_layer(random);
        model.joints.push_back(joint);
      }
    if (random.chance(0.4))
      stand_on_rigid(random, model, "wedge");
    const double pressure = draw_pressure(random, model);
    model.loads           = {
                {"pressure", "wedge_top", fmt::format("{}", pressure)},
                {"traction", "wedge_top", fmt::format("{}; 0", pressure * random.uniform(0., 0.5))}};
    return model;
  }

  GridModel
  draw_single(Random &random)
  {
    GridModel model;
    model.bodies.push_back(draw_body(random, "block", random.power_of_ten(1., 5.)));
    model.x            = grid_lines({0., random.power_of_ten(-1., 1.)}, {random.integer(1, 2)});
    model.y            = grid_lines({0., random.power_of_ten(-1., 1.)}, {random.integer(1, 2)});
    model.body_of_cell = [](const std::size_t, const std::size_t) { return 0; };
    stand_on_rigid(random, model, "block");
    // A held node has no contact element: 1 + 1 - 1 = 1 of them on one cell.
    if (random.chance(0.6))
      {
        model.points["corner"]   = {{0, 0}};
        model.supports["corner"] = random.one_of<std::string>({"all", "x", "y"});
      }
    if (random.chance(0.3))
      model.supports["block_right"] = "x";
    add_block_loads(model, "block", draw_pressure(random, model), random.uniform(0.2, 2.));
    return model;
  }
} // namespace fuga::stress
