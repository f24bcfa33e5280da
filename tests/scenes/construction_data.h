// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_scenes_construction_data_h
#define fuga_tests_scenes_construction_data_h

#include <nlohmann/json.hpp>

/** Sections of the parameters of blocks that are built in stages. */
namespace fuga::tests
{
  using Json = nlohmann::ordered_json;

  constexpr double E = 1000., weight = 2., rho = 1e-3;

  inline Json
  body(const char *stage = nullptr, const double nu = 0.)
  {
    Json result = {{"Young modulus", E}, {"Poisson ratio", nu}, {"Weight density", weight}};
    if (stage)
      result["Built at stage"] = stage;
    return result;
  }

  inline Json
  joint(const char *name, const char *plus, const char *minus, const double f = 0.5)
  {
    return {{"Line", name},
            {"Plus body", plus},
            {"Minus body", minus},
            {"Normal compliance", rho},
            {"Shear compliance", rho},
            {"Friction coefficient", f}};
  }

  inline Json
  common()
  {
    Json p;
    p["Boundaries"]["bottom"] = {{"Fixed", "all"}};
    for (const char *name : {"top", "left", "right"})
      p["Boundaries"][name] = {{"Fixed", "free"}};
    p["Loads"]["weight"] = {{"Type", "weight"}};
    p["Output"]          = {{"Log", "quiet"}, {"Fields", "never"}};
    return p;
  }
} // namespace fuga::tests

#endif
