// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/laws/shear_coupling.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** Tension, as a share of σ_r, below which the stiffness falls no further. */
    constexpr double largest_tension = 0.9;
    /** Stress beyond which no bracket is looked for. */
    constexpr double largest_stress = 1e200;
  } // namespace

  ShearCoupling::ShearCoupling(const Kind coupling_kind,
                               const ComplianceLaw &normal_law,
                               const double shear_compliance,
                               const double coupling_scale,
                               const double coupling_exponent)
    : kind(coupling_kind)
    , normal(normal_law)
    , compliance(shear_compliance)
    , scale(coupling_scale)
    , exponent(coupling_exponent)
  {
  }

  ShearCoupling::Stiffness
  ShearCoupling::stiffness(const double at) const
  {
    const double m = exponent;
    if (kind == Kind::closure)
      {
        const double rest  = scale - at;
        const double value = std::pow(rest / scale, -m) / compliance;
        return {value, m * value / rest, m * (m + 1.) * value / (rest * rest)};
      }
    if (at <= -largest_tension * scale)
      return {std::pow(1. - largest_tension, m) / compliance, 0., 0.};
    const double sum   = scale + at;
    const double value = std::pow(sum / scale, m) / compliance;
    return {value, m * value / sum, m * (m - 1.) * value / (sum * sum)};
  }

  // A layer under tension (a bond) keeps the stiffness it has at zero closure.
  double
  ShearCoupling::normal_stress(const double w) const
  {
    return w < 0. ? w / normal.initial_compliance() : normal.stress(w);
  }

  double
  ShearCoupling::normal_tangent(const double w) const
  {
    return w < 0. ? 1. / normal.initial_compliance() : normal.tangent(w);
  }

  double
  ShearCoupling::normal_deformation(const double sigma) const
  {
    return sigma < 0. ? sigma * normal.initial_compliance() : normal.deformation(sigma);
  }

  // Solve w_n(σ) - widening(σ) = w. The widening is ≥ 0 and decreases with σ, so the left side
  // increases and the root lies between σ_n(w) and σ_n(w + widening there), or below any
  // sufficiently large stress where the latter is beyond the closure limit.
  template <typename Widening>
  double
  ShearCoupling::pressure_at(const double w, const Widening &widening) const
  {
    const double limit = normal.deformation_limit();
    const auto stress  = [&](const double closure) {
      return closure < limit ? normal_stress(closure) : std::numeric_limits<double>::infinity();
    };
    double low = normal_stress(w);
    // Where the stiffness stops falling the widening is lost at once, so that a layer which is kept
    // pressed by shear alone could be under that tension as well; it stays pressed.
    if (low <= -largest_tension * scale)
      {
        const double above = std::nextafter(-largest_tension * scale, 0.);
        if (normal_deformation(above) - widening(above) > w)
          return low;
        low = above;
      }
    double high = stress(w + widening(low));
    if (std::isinf(high))
      for (high = std::max(2. * low, scale);
           high < largest_stress && normal_deformation(high) - widening(high) < w;)
        high *= 2.;
    double s = high;
    for (int i = 0; i < 200 && high - low > 2. * std::numeric_limits<double>::epsilon() *
                                              std::max(std::abs(low), std::abs(high));
         ++i)
      {
        // The iteration σ ← σ_n(w + widening(σ)) is a contraction when the widening is small;
        // otherwise the bracket is halved.
        const double next = stress(w + widening(s));
        if (next < s)
          high = s;
        else
          low = s;
        if (next == s)
          break;
        const bool inside = next > low && next < high;
        s                 = inside && i % 3 != 2 ? next : 0.5 * (low + high);
      }
    return s;
  }

  ShearCoupling::Response
  ShearCoupling::response(const double w, const double e) const
  {
    if (kind == Kind::closure)
      {
        const Stiffness k = stiffness(w);
        return {normal_stress(w) + 0.5 * k.first * e * e,
                k.value * e,
                normal_tangent(w) + 0.5 * k.second * e * e,
                k.first * e,
                k.value};
      }
    const double sigma =
      pressure_at(w, [&](const double s) { return 0.5 * stiffness(s).first * e * e; });
    const Stiffness k = stiffness(sigma);
    const double slope =
      1. / (1. / normal_tangent(normal_deformation(sigma)) - 0.5 * k.second * e * e);
    const double shear_slope = k.first * e * slope;
    return {sigma, k.value * e, slope, shear_slope, k.value + k.first * e * shear_slope};
  }

  // With a closure the equation is σ_n(w) + ½τ²k_t'/k_t² = σ, whose second term is ≥ 0 and grows
  // with w, for m < 1 beyond bounds at w_c: sheared lips stay below w_c where the normal law alone
  // passes it.
  ShearCoupling::Deformation
  ShearCoupling::deformation(const double sigma, const double tau) const
  {
    const auto widening_stress = [&](const Stiffness &k) {
      return 0.5 * k.first * tau * tau / (k.value * k.value);
    };
    if (kind == Kind::pressure)
      {
        const Stiffness k = stiffness(sigma);
        return {normal_deformation(sigma) - widening_stress(k), tau / k.value};
      }
    double high = std::min(normal_deformation(sigma), std::nextafter(scale, 0.));
    double low  = sigma >= widening_stress(stiffness(0.))
                    ? std::min(0., high)
                    : normal_deformation(sigma - widening_stress(stiffness(high)));
    double w    = low;
    for (int i = 0; i < 200 && high - low > 2. * std::numeric_limits<double>::epsilon() *
                                              std::max(std::abs(low), std::abs(high));
         ++i)
      {
        const double next = normal_deformation(sigma - widening_stress(stiffness(w)));
        if (next == w)
          break;
        (next > w ? low : high) = w;
        w = next > low && next < high && i % 3 != 2 ? next : 0.5 * (low + high);
      }
    return {w, tau / stiffness(w).value};
  }

  double
  ShearCoupling::shear_deformation(const double w, const double tau) const
  {
    if (kind == Kind::closure)
      return tau / stiffness(w).value;
    const double sigma = pressure_at(w, [&](const double s) {
      const Stiffness k = stiffness(s);
      return 0.5 * k.first * tau * tau / (k.value * k.value);
    });
    return tau / stiffness(sigma).value;
  }

  double
  ShearCoupling::energy(const double w, const double e) const
  {
    const auto normal_energy = [&](const double closure) {
      return closure < 0. ? 0.5 * closure * closure / normal.initial_compliance()
                          : normal.energy(closure);
    };
    if (kind == Kind::closure)
      return normal_energy(w) + 0.5 * stiffness(w).value * e * e;
    const double sigma = response(w, e).sigma;
    const Stiffness k  = stiffness(sigma);
    return normal_energy(normal_deformation(sigma)) + 0.5 * e * e * (k.value - k.first * sigma);
  }

  double
  ShearCoupling::closure_limit() const
  {
    const double limit = normal.deformation_limit();
    return kind == Kind::closure ? std::min(limit, scale) : limit;
  }

  std::string
  ShearCoupling::description() const
  {
    return fmt::format("compliance {:g} falling with {} (scale {:g}, exponent {:g})",
                       compliance,
                       kind == Kind::closure ? "closure" : "pressure",
                       scale,
                       exponent);
  }
} // namespace fuga
