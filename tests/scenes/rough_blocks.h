// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_scenes_rough_blocks_h
#define fuga_tests_scenes_rough_blocks_h

#include "scenes/scene_run.h"

#include <nlohmann/json.hpp>

#include <string>

namespace fuga::tests
{
  /** The bodies of two_blocks_mesh(), held at the bottom, with a linear layer and friction 0.5
   * between them. */
  nlohmann::ordered_json
  rough_blocks();

  /** The same in space, with what is @p held at the ends of the extrusion. */
  nlohmann::ordered_json
  in_space(nlohmann::ordered_json scene, const std::string &held);

  void
  add_load(nlohmann::ordered_json &scene,
           const std::string &name,
           const std::string &type,
           const std::string &boundaries,
           const std::string &value);

  /**
   * Largest difference of a column between a scene in space, extruded by @p n_nodes nodes of equal
   * distances, and the plane one at load time @p t, where each node has its share of the force;
   * relative to the largest value in the plane, or to @p least. The end of one run is that of the
   * other.
   */
  double
  difference_from_plane(const SceneRun &deep,
                        const std::size_t n_nodes,
                        const SceneRun &flat,
                        const std::string &column,
                        const double t,
                        const double least);
} // namespace fuga::tests

#endif
