// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_laws_law_check_h
#define fuga_laws_law_check_h

#include <fuga/laws/compliance_law.h>

#include <optional>

namespace fuga
{
  /** A required property that a law does not have. */
  struct LawProblem
  {
    /** Deformation where the property fails. */
    double deformation = 0.;
    /** Description of the failure, with numbers. */
    std::string text;
  };

  /**
   * Check the properties on which the path and the judge rely: σ(0) = 0, a finite positive tangent
   * that is the derivative of the stress, no jumps, secant = σ/w, dE/dw = σ, an inverse that
   * returns the deformation, and stresses without bound before a deformation limit. They are tested
   * at some hundred deformations up to the one that @p largest_stress > 0 causes, or to the last
   * point of the law's own data.
   */
  std::optional<LawProblem>
  check_law(const ComplianceLaw &law, const double largest_stress);

  /**
   * Return the largest deformation of a plot of the curve: nine tenths of the limit if there is
   * one, otherwise somewhat more than the scale of the law's data, otherwise the deformation at
   * @p typical_stress.
   */
  double
  range_of_interest(const ComplianceLaw &law, const double typical_stress);
} // namespace fuga

#endif
