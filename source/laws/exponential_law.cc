// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/laws/exponential_law.h>

#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** The value of β c0: a hundredth of the reference stress remains where contact begins. */
    const double decay = std::log(100.);
    /** Length of the foot as a share of c0. */
    constexpr double foot_share = 0.05;

    LawFoot
    make_foot(const double closure, const double pressure)
    {
      const double slope = decay * foot_share;
      return {foot_share * closure,
              pressure * std::exp(decay * (foot_share - 1.)),
              slope,
              slope * slope,
              LawFoot::cubic_slope(slope, slope * slope)};
    }
  } // namespace

  ExponentialLaw::ExponentialLaw(const double reference_closure, const double reference_stress)
    : closure(reference_closure)
    , pressure(reference_stress)
    , beta(decay / closure)
    , foot(make_foot(closure, pressure))
  {
  }

  double
  ExponentialLaw::reference_compliance() const
  {
    return compliance_towards(closure / pressure);
  }

  double
  ExponentialLaw::stress(const double w) const
  {
    return w < foot.length ? foot.stress(w) : pressure * std::exp(beta * (w - closure));
  }

  double
  ExponentialLaw::tangent(const double w) const
  {
    return w < foot.length ? foot.tangent(w) : beta * pressure * std::exp(beta * (w - closure));
  }

  double
  ExponentialLaw::energy(const double w) const
  {
    return w < foot.length ? foot.energy(w)
                           : foot.energy(foot.length) +
                               foot.end_stress / beta * std::expm1(beta * (w - foot.length));
  }

  double
  ExponentialLaw::deformation(const double sigma) const
  {
    if (sigma <= 0.)
      return 0.;
    return sigma < foot.end_stress ? deformation_between(sigma, 0., foot.length)
                                   : closure + std::log(sigma / pressure) / beta;
  }

  double
  ExponentialLaw::deformation_scale() const
  {
    return closure;
  }

  std::vector<double>
  ExponentialLaw::knots() const
  {
    return {foot.length};
  }

  std::string
  ExponentialLaw::description() const
  {
    return fmt::format("exponential law, stress {:g} at a closure of {:g}", pressure, closure);
  }
} // namespace fuga
