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
  /**
   * The relation between the force of a bar and its deformation; it decides which solution path is
   * needed.
   */
  enum class ComplianceKind
  {
    /** ρ = 0: the deformation vanishes and the force is a reaction. */
    rigid,
    /** Stress = deformation / ρ. */
    linear,
    /** Stress is a nonlinear function of the deformation. */
    nonlinear
  };

  /**
   * The material law of the layer in one direction: the stress σ(w) ≥ 0 that a deformation w ≥ 0 (a
   * closure in the normal direction, the size of the elastic shear jump in the tangential one)
   * causes. It is passive and increasing, σ(0) = 0. Units are m and MPa in the examples.
   */
  class ComplianceLaw
  {
  public:
    virtual ~ComplianceLaw() = default;

    virtual ComplianceKind
    kind() const = 0;

    /** Return ρ = dw/dσ at w = 0 [m/MPa]; 0 for a rigid law. */
    virtual double
    initial_compliance() const = 0;

    /**
     * Return the compliance ρ of the layer in the linear system of the bodies and their joints
     * [m/MPa]; the dislocation d is the rest of the jump ρσ + d. Any value would do, but if ρ is
     * softer than the layer, digits of the jump are lost, and if it is stiffer, digits of the
     * force. Laws that know a deformation they are made for use the geometric mean of the
     * compliance at w = 0 and the secant compliance at that deformation.
     */
    virtual double
    reference_compliance() const
    {
      return initial_compliance();
    }

    /** Return σ(w). Neither this function nor the four below may be called for a rigid law. */
    virtual double
    stress(const double w) const = 0;

    /** Return dσ/dw. */
    virtual double
    tangent(const double w) const = 0;

    /** Return σ(w)/w, the secant stiffness C(u) of the paper's equations (5)-(9) per area. */
    virtual double
    secant(const double w) const = 0;

    /** Return the stored energy per area, ∫σ dw. */
    virtual double
    energy(const double w) const = 0;

    /** Return the deformation w at a stress σ ≥ 0, the inverse of stress(). */
    virtual double
    deformation(const double sigma) const = 0;

    /** Return the deformation that no finite stress reaches. */
    virtual double
    deformation_limit() const
    {
      return std::numeric_limits<double>::infinity();
    }

    /**
     * Return a deformation typical of those the law is made for, from its own data; 0 if they do
     * not contain one.
     */
    virtual double
    deformation_scale() const
    {
      return 0.;
    }

    /**
     * Return the deformation where the data of the law end and a continuation begins; infinite if
     * they do not end.
     */
    virtual double
    data_limit() const
    {
      return std::numeric_limits<double>::infinity();
    }

    /**
     * Return the deformations at which the curve is smooth only on either side, in increasing
     * order.
     */
    virtual std::vector<double>
    knots() const
    {
      return {};
    }

    /** Return one phrase for the log, with numbers. */
    virtual std::string
    description() const = 0;
  };

  std::unique_ptr<ComplianceLaw>
  make_rigid_law();

  /** Create a linear law with @p compliance > 0 [m/MPa]. */
  std::unique_ptr<ComplianceLaw>
  make_linear_law(const double compliance);
} // namespace fuga

#endif
