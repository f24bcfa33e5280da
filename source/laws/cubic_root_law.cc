// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/laws/cubic_root_law.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  LawNine::LawNine(const double rho, const double zeta) : compliance(rho), thickness(zeta)
  {
  }

  double
  LawNine::initial_compliance() const
  {
    return compliance;
  }

  double
  LawNine::deformation_limit() const
  {
    return thickness;
  }

  double
  LawNine::deformation_scale() const
  {
    return thickness;
  }

  double
  LawNine::root(const double w) const
  {
    return std::cbrt(w / thickness);
  }

  double
  LawNine::stiffness(const double w) const
  {
    return 1. / (compliance * (1. - root(w)));
  }

  CubicRootLaw::CubicRootLaw(const double rho, const double zeta) : LawNine(rho, zeta)
  {
  }

  double
  CubicRootLaw::stress(const double w) const
  {
    return w * secant(w);
  }

  double
  CubicRootLaw::tangent(const double w) const
  {
    const double q = root(w);
    return (1. - 2. / 3. * q) / (compliance * (1. - q) * (1. - q));
  }

  double
  CubicRootLaw::secant(const double w) const
  {
    return stiffness(w);
  }

  // With w = ζq³, ∫σ dw is (3ζ²/ρ)∫q⁵/(1-q) dq.
  double
  CubicRootLaw::energy(const double w) const
  {
    return 3. * thickness * thickness / compliance * rest_of_logarithm(root(w), 6);
  }

  // σρ/ζ = q³/(1-q) is increasing and convex in q, so that Newton's method converges monotonically
  // from the right.
  double
  CubicRootLaw::deformation(const double sigma) const
  {
    if (sigma <= 0.)
      return 0.;
    const double s           = sigma * compliance / thickness;
    const int max_iterations = 100;
    double q                 = std::min(std::cbrt(s), 1.);
    for (int i = 0; i < max_iterations; ++i)
      {
        const double residual = q * q * q + s * q - s;
        const double next     = q - residual / (3. * q * q + s);
        if (std::abs(next - q) <= std::numeric_limits<double>::epsilon() * q)
          break;
        q = next;
      }
    return thickness * q * q * q;
  }

  std::string
  CubicRootLaw::description() const
  {
    return fmt::format(
      "cubic root law (9), initial compliance {:g}, thickness {:g}", compliance, thickness);
  }

  CubicRootTangentLaw::CubicRootTangentLaw(const double rho, const double zeta) : LawNine(rho, zeta)
  {
  }

  // With w = ζq³, ∫dw/(1-q) is 3ζ∫q²/(1-q) dq.
  double
  CubicRootTangentLaw::stress(const double w) const
  {
    return 3. * thickness / compliance * rest_of_logarithm(root(w), 3);
  }

  double
  CubicRootTangentLaw::tangent(const double w) const
  {
    return stiffness(w);
  }

  // Integration by parts gives ∫σ dw = σw - ∫w dσ, where ∫w dσ = (3ζ²/ρ)∫q⁵/(1-q) dq.
  double
  CubicRootTangentLaw::energy(const double w) const
  {
    const double q = root(w);
    return 3. * thickness * thickness / compliance *
           (q * q * q * rest_of_logarithm(q, 3) - rest_of_logarithm(q, 6));
  }

  // The stress is increasing and convex in q, so that Newton's method converges monotonically from
  // the right. Both bounds of q follow from dropping all terms of the series but the first, and
  // from q + q²/2 < 3/2.
  double
  CubicRootTangentLaw::deformation(const double sigma) const
  {
    if (sigma <= 0.)
      return 0.;
    const double s           = sigma * compliance / (3. * thickness);
    const int max_iterations = 100;
    double q                 = std::min(std::cbrt(3. * s), -std::expm1(-s - 1.5));
    for (int i = 0; i < max_iterations && q < 1.; ++i)
      {
        const double step = (rest_of_logarithm(q, 3) - s) * (1. - q) / (q * q);
        q -= step;
        if (std::abs(step) <= std::numeric_limits<double>::epsilon() * q)
          break;
      }
    return thickness * q * q * q;
  }

  std::string
  CubicRootTangentLaw::description() const
  {
    return fmt::format("cubic root law (9) as a tangent, initial compliance {:g}, thickness {:g}",
                       compliance,
                       thickness);
  }
} // namespace fuga
