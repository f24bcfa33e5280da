// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_scenes_known_scenes_h
#define fuga_tests_scenes_known_scenes_h

#include <nlohmann/json.hpp>

namespace fuga::tests
{
  /** V7, sphere: a quarter of a block with @p young_modulus and @p poisson_ratio on a rigid plane, with
   * the roundness of a sphere of radius 50 between them, under @p pressure from above. */
  nlohmann::ordered_json
  pressed_sphere(const double young_modulus,
                 const double poisson_ratio,
                 const unsigned int degree,
                 const double pressure);

  /** V9, the block of Raous et al.: both pressures at once, on a rigid rough plane. */
  nlohmann::ordered_json
  raous_block();
} // namespace fuga::tests

#endif
