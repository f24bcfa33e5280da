// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/incoming_wave.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>

namespace fuga::tests
{
  namespace
  {
    constexpr double pi = 3.14159265358979323846;
  } // namespace

  nlohmann::ordered_json
  rock(const double factor)
  {
    return {{"Young modulus", 50. * factor * factor},
            {"Poisson ratio", 0.25},
            {"Weight density", 10. * rock_density}};
  }

  std::string
  write_record(const std::function<double(double)> &acceleration,
               const double step,
               const double end)
  {
    const std::string name = temporary_directory() + "/record.txt";
    std::ofstream file(name);
    for (std::size_t i = 0; static_cast<double>(i) * step <= end; ++i)
      file << fmt::format(
        "{} {:.17g}\n", static_cast<double>(i) * step, acceleration(static_cast<double>(i) * step));
    return name;
  }

  double
  ricker(const double t, const double frequency, const double middle)
  {
    const double x = pi * frequency * (t - middle);
    return (1. - 2. * x * x) * std::exp(-x * x);
  }

  double
  ricker_acceleration(const double t, const double frequency, const double middle)
  {
    const double w = pi * frequency, x = w * (t - middle);
    return w * w * (-6. + 24. * x * x - 8. * x * x * x * x) * std::exp(-x * x);
  }

  std::vector<std::array<double, 2>>
  steps_of_monitor(const SceneRun &run,
                   const std::string &monitor,
                   const std::string &component,
                   const double duration)
  {
    std::vector<std::array<double, 2>> result;
    for (std::size_t row = 0; row < run.monitors.rows.size(); ++row)
      if (run.monitors.text(row, "monitor") == monitor &&
          run.monitors.text(row, "occasion") == "step")
        result.push_back(
          {{run.monitors.number(row, "t") * duration, run.monitors.number(row, component)}});
    return result;
  }
} // namespace fuga::tests
