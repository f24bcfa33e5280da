// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/cones/cone_rate_problem.h>
#include <fuga/contact/element/mechanism.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace fuga
{
  // A scheme without resistance, or what every sweep adds to the rates that grow beyond bounds. It
  // is a mechanism if the load drives it, nothing resists and no closed element would penetrate or
  // slip against its force; anything else only shows that no solution was found.
  void
  ConeRateProblem::find_mechanism(WorkingScheme &background, ConeContinuation &result)
  {
    constexpr double rounding = 1e-10;
    Drive at_rest;
    at_rest.reactions.assign(system.n_bars(), 0.);
    for (Vector &motion : std::array<std::reference_wrapper<Vector>, 2>{{free_motion, drift}})
      {
        if (motion.empty() || result.has_mechanism)
          continue;
        double size        = 0.;
        const double power = driving_power(motion, size);
        if (power < 0.)
          for (double &rate : motion)
            rate = -rate;
        result.mechanism     = full_rates(background, at_rest, motion);
        result.has_mechanism = is_admissible(motion) && std::abs(power) > rounding * size &&
                               is_free_motion(result.mechanism, system);
      }
  }

  bool
  ConeRateProblem::is_admissible(const Vector &motion) const
  {
    double size = 0.;
    for (std::size_t row = 0; row < motion.size(); ++row)
      size = std::max(size, std::sqrt(diagonal[row]) * std::abs(motion[row]));
    const double none = 1e-6 * size;
    for (const Candidate &candidate : candidates)
      {
        const std::size_t n = candidate.row;
        const double slip =
          candidate.n_tangents == 0 ? 0. : length(tangential_rows(candidate, motion));
        const double normal = std::sqrt(diagonal[n]) * (motion[n] - candidate.rise * slip);
        if (candidate.at_apex || candidate.grazing ? normal < -none : std::abs(normal) > none)
          return false;
        if (candidate.at_apex || candidate.n_tangents == 0)
          continue;
        const double forward = dot(tangential_rows(candidate, motion), candidate.direction);
        if (std::sqrt(shear_stiffness(candidate)) * forward < -none)
          return false;
      }
    return true;
  }

  double
  ConeRateProblem::driving_power(const Vector &motion, double &size) const
  {
    double power = size = 0.;
    const auto add      = [&](const double term) {
      power += term;
      size += std::abs(term);
    };
    for (std::size_t row = 0; row < motion.size(); ++row)
      add(r[row] * motion[row]);
    for (const Candidate &candidate : candidates)
      if (!candidate.at_apex && candidate.n_tangents > 0)
        add(-candidate.strength_rate *
            dot(tangential_rows(candidate, motion), candidate.direction));
    return power;
  }
} // namespace fuga
