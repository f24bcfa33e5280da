// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/laws/power_law.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** Secant stiffness at the end of the foot relative to σ_r/w_r, or its inverse for m < 1. */
    constexpr double stiffness_share = 1e-3;
    /** Shortest foot for m > 1 and for m < 1, as a share of w_r. */
    constexpr double shortest_hard = 1e-3;
    constexpr double shortest_soft = 1e-6;
    /** For larger exponents the cubic foot starts with less than this slope, which then falls. */
    constexpr double steepest_cubic = 1.6;
    constexpr double quartic_slope  = 0.28;

    LawFoot
    make_foot(const double w_r, const double sigma_r, const double m)
    {
      const double share     = std::max(std::pow(stiffness_share, 1. / std::abs(m - 1.)),
                                    m > 1. ? shortest_hard : shortest_soft);
      const double curvature = m * (m - 1.);
      return {w_r * share,
              sigma_r * std::pow(share, m),
              m,
              curvature,
              m < steepest_cubic ? LawFoot::cubic_slope(m, curvature) : quartic_slope};
    }
  } // namespace

  PowerLaw::PowerLaw(const double reference_deformation,
                     const double reference_stress,
                     const double power)
    : scale(reference_deformation)
    , reference(reference_stress)
    , exponent(power)
    , foot(make_foot(scale, reference, exponent))
  {
  }

  double
  PowerLaw::reference_compliance() const
  {
    return compliance_towards(scale / reference);
  }

  double
  PowerLaw::stress(const double w) const
  {
    return w < foot.length ? foot.stress(w) : reference * std::pow(w / scale, exponent);
  }

  double
  PowerLaw::tangent(const double w) const
  {
    return w < foot.length ? foot.tangent(w)
                           : reference * exponent / scale * std::pow(w / scale, exponent - 1.);
  }

  double
  PowerLaw::energy(const double w) const
  {
    if (w < foot.length)
      return foot.energy(w);
    return foot.energy(foot.length) + foot.end_stress * foot.length / (exponent + 1.) *
                                        (std::pow(w / foot.length, exponent + 1.) - 1.);
  }

  double
  PowerLaw::deformation(const double sigma) const
  {
    if (sigma <= 0.)
      return 0.;
    return sigma < foot.end_stress ? deformation_between(sigma, 0., foot.length)
                                   : scale * std::pow(sigma / reference, 1. / exponent);
  }

  double
  PowerLaw::deformation_scale() const
  {
    return scale;
  }

  std::vector<double>
  PowerLaw::knots() const
  {
    return {foot.length};
  }

  std::string
  PowerLaw::description() const
  {
    return fmt::format("power law, stress {:g} at {:g}, exponent {:g}", reference, scale, exponent);
  }
} // namespace fuga
