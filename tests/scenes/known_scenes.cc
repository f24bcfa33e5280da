// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/known_scenes.h"

namespace fuga::tests
{
  using Json = nlohmann::ordered_json;

  Json
  pressed_sphere(const double young_modulus,
                 const double poisson_ratio,
                 const unsigned int degree,
                 const double pressure)
  {
    Json scene;
    scene["Dimension"]                 = 3;
    scene["Mesh"]["Polynomial degree"] = degree;
    scene["Bodies"]["block"] = {{"Young modulus", young_modulus}, {"Poisson ratio", poisson_ratio}};
    scene["Joints"]["sphere"]             = {{"Plus lip", "contact"},
                                             {"Minus lip", "rigid"},
                                             {"Normal law", "rigid"},
                                             {"Initial gap", "(x^2 + z^2)/100"}};
    scene["Boundaries"]["left"]["Fixed"]  = "x";
    scene["Boundaries"]["front"]["Fixed"] = "z";
    for (const char *side : {"right", "back"})
      scene["Boundaries"][side]["Fixed"] = "free";
    scene["Loads"]["press"] = {{"Type", "pressure"}, {"Boundaries", "top"}, {"Value", pressure}};
    scene["Stages"]["press"]["Loads"] = "press: t";
    return scene;
  }

  Json
  raous_block()
  {
    Json scene;
    scene["Bodies"]["block"]              = {{"Young modulus", 130000.}, {"Poisson ratio", 0.2}};
    scene["Joints"]["base"]               = {{"Plus lip", "contact"},
                                             {"Minus lip", "rigid"},
                                             {"Normal law", "rigid"},
                                             {"Shear law", "rigid"},
                                             {"Friction coefficient", 1.}};
    scene["Boundaries"]["right"]["Fixed"] = "x";
    scene["Loads"]["side"] = {{"Type", "pressure"}, {"Boundaries", "left"}, {"Value", 150.}};
    scene["Loads"]["top"]  = {{"Type", "pressure"}, {"Boundaries", "top"}, {"Value", 50.}};
    scene["Stages"]["press"]["Loads"] = "side: t; top: t";
    return scene;
  }
} // namespace fuga::tests
