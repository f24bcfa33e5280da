// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/rough_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga::tests
{
  using Json = nlohmann::ordered_json;

  Json
  rough_blocks()
  {
    Json scene;
    scene["Bodies"]["upper"]               = {{"Young modulus", 1000.}, {"Poisson ratio", 0.2}};
    scene["Bodies"]["lower"]               = {{"Young modulus", 500.}, {"Poisson ratio", 0.3}};
    scene["Joints"]["joint"]               = {{"Line", "joint"},
                                              {"Plus body", "upper"},
                                              {"Minus body", "lower"},
                                              {"Normal compliance", 1e-4},
                                              {"Shear compliance", 2e-4},
                                              {"Friction coefficient", 0.5}};
    scene["Boundaries"]["bottom"]["Fixed"] = "all";
    for (const char *side : {"left", "right"})
      scene["Boundaries"][side]["Fixed"] = "free";
    return scene;
  }

  Json
  in_space(Json scene, const std::string &held)
  {
    scene["Dimension"] = 3;
    for (const char *end : {"front", "back"})
      scene["Boundaries"][end]["Fixed"] = held;
    return scene;
  }

  void
  add_load(Json &scene,
           const std::string &name,
           const std::string &type,
           const std::string &boundaries,
           const std::string &value)
  {
    scene["Loads"][name] = {{"Type", type}, {"Boundaries", boundaries}, {"Value", value}};
  }

  double
  difference_from_plane(const SceneRun &deep,
                        const std::size_t n_nodes,
                        const SceneRun &flat,
                        const std::string &column,
                        const double t,
                        const double least)
  {
    const bool is_force = column[0] == 'N' || column[0] == 'T';
    const Vector plane  = flat.values(column, t),
                 values = deep.values(column, t == flat.last_t() ? deep.last_t() : t);
    if (values.size() != n_nodes * plane.size())
      return std::numeric_limits<double>::infinity();
    double largest = least, worst = 0.;
    for (const double value : plane)
      largest = std::max(largest, std::abs(value));
    for (std::size_t k = 0; k < values.size(); ++k)
      {
        const bool is_end  = k % n_nodes == 0 || k % n_nodes == n_nodes - 1;
        const double share = (is_end ? 0.5 : 1.) / static_cast<double>(n_nodes - 1);
        const double error =
          std::abs(values[k] - (is_force ? share : 1.) * plane[k / n_nodes]) / largest;
        worst =
          std::isnan(error) ? std::numeric_limits<double>::infinity() : std::max(worst, error);
      }
    return worst;
  }
} // namespace fuga::tests
