// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/laws/compliance_law.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace fuga
{
  namespace
  {
    /** ρ = 0. The stress is a reaction, so the four functions of the deformation have no meaning.
     */
    class RigidLaw : public ComplianceLaw
    {
    public:
      ComplianceKind
      kind() const override
      {
        return ComplianceKind::rigid;
      }

      double
      initial_compliance() const override
      {
        return 0.;
      }

      double
      stress(const double) const override
      {
        return no_curve();
      }

      double
      tangent(const double) const override
      {
        return no_curve();
      }

      double
      secant(const double) const override
      {
        return no_curve();
      }

      double
      energy(const double) const override
      {
        return 0.;
      }

      double
      deformation(const double) const override
      {
        return 0.;
      }

      std::string
      description() const override
      {
        return "rigid";
      }

    private:
      [[noreturn]] static double
      no_curve()
      {
        throw std::logic_error("A rigid layer has no stress-deformation curve.");
      }
    };


    class LinearLaw : public ComplianceLaw
    {
    public:
      explicit LinearLaw(const double rho) : compliance(rho)
      {
      }

      ComplianceKind
      kind() const override
      {
        return ComplianceKind::linear;
      }

      double
      initial_compliance() const override
      {
        return compliance;
      }

      double
      stress(const double w) const override
      {
        return w / compliance;
      }

      double
      tangent(const double) const override
      {
        return 1. / compliance;
      }

      double
      secant(const double) const override
      {
        return 1. / compliance;
      }

      double
      energy(const double w) const override
      {
        return 0.5 * w * w / compliance;
      }

      double
      deformation(const double sigma) const override
      {
        return sigma * compliance;
      }

      std::string
      description() const override
      {
        return fmt::format("linear, compliance {:g}", compliance);
      }

    private:
      const double compliance;
    };


    class CubicRootLaw : public ComplianceLaw
    {
    public:
      CubicRootLaw(const double rho, const double zeta) : compliance(rho), thickness(zeta)
      {
      }

      ComplianceKind
      kind() const override
      {
        return ComplianceKind::nonlinear;
      }

      double
      initial_compliance() const override
      {
        return compliance;
      }

      double
      stress(const double w) const override
      {
        return w * secant(w);
      }

      double
      tangent(const double w) const override
      {
        const double q = std::cbrt(w / thickness);
        return (1. - 2. / 3. * q) / (compliance * (1. - q) * (1. - q));
      }

      double
      secant(const double w) const override
      {
        return 1. / (compliance * (1. - std::cbrt(w / thickness)));
      }

      // ∫σ dw with w = ζq³ is (3ζ²/ρ)∫q⁵/(1-q) dq. The closed form cancels for small q, its series
      // Σ q^k/k from k = 6 on does not.
      double
      energy(const double w) const override
      {
        const double q            = std::cbrt(w / thickness);
        const double series_limit = 0.3;
        const double scale        = 3. * thickness * thickness / compliance;
        if (q > series_limit)
          return scale * (-std::log1p(-q) -
                          q * (1. + q * (1. / 2. + q * (1. / 3. + q * (1. / 4. + q / 5.)))));
        double sum   = 0.;
        double power = q * q * q * q * q * q;
        for (int k = 6; power > 1e-18 * sum && k < 100; ++k, power *= q)
          sum += power / k;
        return scale * sum;
      }

      // σρ/ζ = q³/(1-q) is increasing and convex in q: Newton from the right converges
      // monotonically.
      double
      deformation(const double sigma) const override
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

      double
      deformation_limit() const override
      {
        return thickness;
      }

      double
      deformation_scale() const override
      {
        return thickness;
      }

      std::string
      description() const override
      {
        return fmt::format(
          "cubic root law (9), initial compliance {:g}, thickness {:g}", compliance, thickness);
      }

    private:
      const double compliance;
      const double thickness;
    };
  } // namespace

  std::unique_ptr<ComplianceLaw>
  make_rigid_law()
  {
    return std::make_unique<RigidLaw>();
  }

  std::unique_ptr<ComplianceLaw>
  make_linear_law(const double compliance)
  {
    return std::make_unique<LinearLaw>(compliance);
  }

  std::unique_ptr<ComplianceLaw>
  make_cubic_root_law(const double initial_compliance, const double thickness)
  {
    return std::make_unique<CubicRootLaw>(initial_compliance, thickness);
  }
} // namespace fuga
