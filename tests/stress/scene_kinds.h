// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_scene_kinds_h
#define fuga_tests_stress_scene_kinds_h

#include "stress/draws.h"

#include <memory>
#include <set>

namespace fuga::stress
{
  /** A family of scenes. What each is good for: the table in scene_kinds.cc. */
  struct SceneKind
  {
    const char *name;
    /** Which ways to break an event-driven solver it has, in words for the report. */
    const char *purpose;
    std::function<std::unique_ptr<SceneData>(Random &random)> draw;
    /** In the whole campaign. */
    std::uint64_t n_seeds;

    template <typename Scene>
    SceneKind(const char *const kind,
              const char *const breaks,
              Scene (*family)(Random &random),
              const std::uint64_t number_of_seeds = 120)
      : name(kind)
      , purpose(breaks)
      , draw([family](Random &random) { return std::make_unique<Scene>(family(random)); })
      , n_seeds(number_of_seeds)
    {
    }
  };

  const std::vector<SceneKind> &
  scene_kinds();

  /** The scene of a kind and a seed. @throws std::invalid_argument for an unknown kind. */
  std::unique_ptr<SceneData>
  draw_scene(const std::string &kind, const std::uint64_t seed);

  /** Where a scene lies along the axes of the report. */
  struct SceneAxes
  {
    double rho_min = 0., rho_max = 0.;
    double friction = 0., cohesion = 0.;
    double poisson_ratio = 0., stiffness_ratio = 1.;
    double aspect = 1., size_ratio = 1., offset = 0.;
    /** Words: linear, or the nonlinear laws. */
    std::string law      = "linear";
    std::size_t n_bodies = 0, n_joints = 0, n_stages = 0;
    /** Words: cells, degree, loads, laws, strengths, gaps, obstacles. */
    std::set<std::string> features;
  };

  SceneAxes
  axes_of(const SceneData &model);
} // namespace fuga::stress

#endif
