// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_laws_compliance_law_h
#define fuga_laws_compliance_law_h

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace fuga
{
  /** How the force of a bar follows from its deformation; decides which solution path is needed. */
  enum class ComplianceKind
  {
    /** ρ = 0: the deformation vanishes, the force is a reaction. */
    rigid,
    /** Stress = deformation / ρ. */
    linear,
    /** Stress is a curve of the deformation. */
    nonlinear
  };

  /**
   * The material law of the layer in one direction: the stress σ(w) ≥ 0 that a deformation w ≥ 0 (a
   * closure in the normal direction, the size of the elastic shear jump in the tangential one)
   * causes. Passive and increasing, σ(0) = 0. Units: m and MPa in the examples.
   */
  class ComplianceLaw
  {
  public:
    virtual ~ComplianceLaw() = default;

    virtual ComplianceKind
    kind() const = 0;

    /** ρ = dw/dσ at w = 0 [m/MPa]; 0 for a rigid law. */
    virtual double
    initial_compliance() const = 0;

    /** ρ with which the linear system of the bodies and their joints knows the layer [m/MPa]; the
     * dislocation d is the rest of the jump ρσ + d. Any would do, but if ρ is too soft where the
     * layer is digits of the jump are lost, and if it is too stiff those of the force: laws that
     * know a deformation they are made for have the geometric mean of the compliance at w = 0 and
     * the secant one there. */
    virtual double
    reference_compliance() const
    {
      return initial_compliance();
    }

    /** σ(w). Not to be called for a rigid law, nor the four functions below. */
    virtual double
    stress(const double w) const = 0;

    /** dσ/dw. */
    virtual double
    tangent(const double w) const = 0;

    /** σ(w)/w, the secant stiffness C(u) of the paper's equations (5)-(9) per area. */
    virtual double
    secant(const double w) const = 0;

    /** Stored energy per area, ∫σ dw. */
    virtual double
    energy(const double w) const = 0;

    /** The inverse: w of a stress σ ≥ 0. */
    virtual double
    deformation(const double sigma) const = 0;

    /** Deformation that no finite stress reaches. */
    virtual double
    deformation_limit() const
    {
      return std::numeric_limits<double>::infinity();
    }

    /** A deformation of the size the law is made for, from its own data; 0 if these tell none. */
    virtual double
    deformation_scale() const
    {
      return 0.;
    }

    /** Where the data of the law end and a continuation begins; infinite if they do not end. */
    virtual double
    data_limit() const
    {
      return std::numeric_limits<double>::infinity();
    }

    /** Deformations where the curve is smooth on both sides only, in increasing order. */
    virtual std::vector<double>
    knots() const
    {
      return {};
    }

    /** One phrase for the log, with numbers. */
    virtual std::string
    description() const = 0;
  };

  std::unique_ptr<ComplianceLaw>
  make_rigid_law();

  /** @p compliance > 0 [m/MPa]. */
  std::unique_ptr<ComplianceLaw>
  make_linear_law(const double compliance);
} // namespace fuga

#endif
