// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/keyed_blocks.h"

#include "scenes/blocks_mesh.h"

#include <fmt/format.h>

#include <cmath>

namespace fuga::tests
{
  namespace
  {
    std::string
    turned_vector(const std::array<double, 2> &v, const double angle)
    {
      const double c = std::cos(angle), s = std::sin(angle);
      return fmt::format("{:.17g}; {:.17g}", c * v[0] - s * v[1], s * v[0] + c * v[1]);
    }
  } // namespace

  GmshMesh
  keyed_mesh(const Profile profile, const std::size_t n)
  {
    // Borders of squares of 1/2: x = 0, 1/2 ... 3 and y = 0, 1/2 ... 5/2.
    const bool is_key            = profile == Profile::key;
    std::vector<InnerLine> lines = {
      {"joint", true, 3, 0, 2}, {"joint", false, 2, 2, 3}, {"joint", true, 2, 2, is_key ? 4u : 6u}};
    if (is_key)
      {
        lines.push_back({"joint", false, 4, 2, 3});
        lines.push_back({"joint", true, 3, 4, 6});
      }
    const Axis xs = uniform(0., 3., 6), ys = uniform(0., 2.5, 5);
    const std::vector<std::string> low(6, "lower"), high(6, "upper");
    const std::vector<std::string> middle = {
      "lower", "lower", "upper", "upper", is_key ? "lower" : "upper", is_key ? "lower" : "upper"};
    return blocks_mesh(xs, ys, n, {low, low, middle, high, high}, lines);
  }

  GmshMesh
  turned(GmshMesh mesh, const double angle)
  {
    const double c = std::cos(angle), s = std::sin(angle);
    for (auto &v : mesh.vertices)
      v = {{c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]}};
    return mesh;
  }

  nlohmann::ordered_json
  keyed_blocks(const std::array<double, 2> &traction, const double angle)
  {
    nlohmann::ordered_json scene               = rough_blocks();
    scene["Bodies"]["upper"]["Weight density"] = 0.02;
    scene["Loads"]["weight"]                   = {
                        {"Type", "weight"}, {"Bodies", "upper"}, {"Value", turned_vector({{0., -1.}}, angle)}};
    add_load(scene, "push", "traction", "top", turned_vector(traction, angle));
    scene["Stages"]["weight"] = {{"Loads", "weight: t"}};
    scene["Stages"]["push"]   = {{"Loads", "push: t"}};
    return scene;
  }

  nlohmann::ordered_json
  deep_blocks(const std::array<double, 2> &traction)
  {
    nlohmann::ordered_json scene = in_space(keyed_blocks(traction), "free");
    for (const char *load : {"weight", "push"})
      scene["Loads"][load]["Value"] = scene["Loads"][load]["Value"].get<std::string>() + "; 0";
    return scene;
  }
} // namespace fuga::tests
