// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/results/monitored_motion.h>

#include <algorithm>

namespace fuga
{
  MonitoredMotion::MonitoredMotion(const std::vector<Monitor> &of_model,
                                   const double length_of_step,
                                   const Vector &mass)
    : monitors(of_model), step(length_of_step)
  {
    samples.of_monitors.resize(monitors.size());
    Vector massless(mass.size());
    for (std::size_t dof = 0; dof < mass.size(); ++dof)
      massless[dof] = mass[dof] > 0. ? 0. : 1.;
    for (const Monitor &monitor : monitors)
      {
        const std::array<double, 3> shares = monitor.value_of(massless);
        is_massless.push_back({{shares[0] != 0., shares[1] != 0., shares[2] != 0.}});
      }
  }

  void
  MonitoredMotion::add(const Vector &displacement,
                       const Vector &acceleration,
                       const std::array<double, 3> &of_frame)
  {
    for (std::size_t i = 0; i < monitors.size(); ++i)
      samples.of_monitors[i].push_back(
        {monitors[i].value_of(displacement), monitors[i].value_of(acceleration)});
    samples.of_frame.push_back(of_frame);
  }

  // There is no second difference at the first and at the last step, where that of the neighbouring
  // step is used.
  std::vector<std::array<GroundMotion, 3>>
  MonitoredMotion::accelerations() const
  {
    std::vector<std::array<GroundMotion, 3>> result(monitors.size());
    for (std::size_t i = 0; i < monitors.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c)
        {
          const std::vector<MotionSample> &s = samples.of_monitors[i];
          const auto second_difference       = [&](std::size_t n) {
            if (s.size() < 3)
              return 0.;
            n = std::clamp(n, std::size_t{1}, s.size() - 2);
            return (s[n + 1].displacement[c] - 2. * s[n].displacement[c] +
                    s[n - 1].displacement[c]) /
                   (step * step);
          };
          result[i][c].step = step;
          for (std::size_t n = 0; n < s.size(); ++n)
            result[i][c].accelerations.push_back(
              samples.of_frame[n][c] +
              (is_massless[i][c] ? second_difference(n) : s[n].acceleration[c]));
        }
    return result;
  }
} // namespace fuga
