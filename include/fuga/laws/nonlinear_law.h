// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_laws_nonlinear_law_h
#define fuga_laws_nonlinear_law_h

#include <fuga/laws/compliance_law.h>

namespace fuga
{
  /** Base class of all laws whose stress is a curve σ(w) with a finite tangent at w = 0. */
  class NonlinearLaw : public ComplianceLaw
  {
  public:
    ComplianceKind
    kind() const override;

    /** Return 1/σ'(0). */
    double
    initial_compliance() const override;

    double
    secant(const double w) const override;

  protected:
    /**
     * Return the reference_compliance() of a law with this secant compliance at the deformation it
     * is made for: the geometric mean with the initial compliance, or the given value itself if it
     * is smaller.
     */
    double
    compliance_towards(const double secant_compliance) const;

    /**
     * Return the deformation in [@p lower, @p upper] whose stress is @p sigma, by Newton's method
     * within a shrinking bracket: exact up to rounding wherever the stress is monotone.
     */
    double
    deformation_between(const double sigma, double lower, double upper) const;

    /** Return -ln(1-q) without its first terms, i.e. Σ q^k/k beginning with k = @p first, to all
     * digits. */
    static double
    rest_of_logarithm(const double q, const int first);
  };
} // namespace fuga

#endif
