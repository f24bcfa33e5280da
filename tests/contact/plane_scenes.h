// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_contact_plane_scenes_h
#define fuga_tests_contact_plane_scenes_h

#include "contact/toy_system.h"

#include <functional>
#include <gtest/gtest.h>

namespace fuga::tests
{
  /** A plane problem with all that its path needs. */
  struct PlaneScene
  {
    ToySystem system;
    std::unique_ptr<ComplianceLaw> normal, shear;
    std::unique_ptr<ShearCoupling> coupling;
    std::vector<ContactElement> elements;
    LoadHistory history;
    std::vector<double> levels;
    PathOptions options;
  };

  /** One law, or procedure, and what it changes in a scene of linear layers, Coulomb friction 0.5,
   * random elastic bodies and loads that press, go round about and reverse. */
  struct SceneCase
  {
    std::string name;
    std::function<void(PlaneScene &)> change;
  };

  /** Every law and every procedure of the plane. */
  const std::vector<SceneCase> &
  scene_cases();

  PlaneScene
  make_scene(const SceneCase &scene_case, const unsigned int seed);

  /** Three elements with two tangents and the laws of a case, between random bodies, under loads
   * whose directions turn. */
  PlaneScene
  oblique_scene(const SceneCase &scene_case, const unsigned int seed);

  inline std::string
  name_of_case(const testing::TestParamInfo<SceneCase> &info)
  {
    return info.param.name;
  }

  inline void
  PrintTo(const SceneCase &scene_case, std::ostream *stream)
  {
    *stream << scene_case.name;
  }
} // namespace fuga::tests

#endif
