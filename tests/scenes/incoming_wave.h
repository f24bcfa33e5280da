// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_scenes_incoming_wave_h
#define fuga_tests_scenes_incoming_wave_h

#include "scenes/scene_run.h"

#include <array>
#include <functional>

namespace fuga::tests
{
  /** Rock with ρ = 0.002 MN s²/m⁴, c_s = 100 m/s and c_p = 100 √3 m/s. */
  constexpr double rock_density = 0.002, shear_speed = 100., impedance = rock_density * shear_speed;

  /** Where the waves are @p factor times as fast. */
  nlohmann::ordered_json
  rock(const double factor = 1.);

  /** A record of an acceleration a(t) [m/s²] up to the time @p end. Returns its name. */
  std::string
  write_record(const std::function<double(double)> &acceleration,
               const double step,
               const double end);

  /** Ricker's wavelet as a displacement of the size one at the time @p middle. */
  double
  ricker(const double t, const double frequency, const double middle);

  double
  ricker_acceleration(const double t, const double frequency, const double middle);

  /** Rows of a monitor within the steps: time and displacement. */
  std::vector<std::array<double, 2>>
  steps_of_monitor(const SceneRun &run,
                   const std::string &monitor,
                   const std::string &component,
                   const double duration);
} // namespace fuga::tests

#endif
