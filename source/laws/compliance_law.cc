// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/laws/compliance_law.h>

#include <fmt/format.h>
#include <stdexcept>

namespace fuga
{
  namespace
  {
    /** The law ρ = 0. The stress is a reaction, so the four functions of the deformation have no
     * meaning. */
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
} // namespace fuga
