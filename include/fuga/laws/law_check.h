// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_laws_law_check_h
#define fuga_laws_law_check_h

#include <fuga/laws/compliance_law.h>

#include <optional>

namespace fuga
{
  /** A property that a law does not have. */
  struct LawProblem
  {
    /** Deformation where it fails. */
    double deformation = 0.;
    /** What fails there, with numbers. */
    std::string text;
  };

  /**
   * What the path and the judge rely on: σ(0) = 0, a finite positive tangent that is the derivative
   * of the stress, no jumps, secant = σ/w, dE/dw = σ, an inverse that gives the deformation back,
   * and stresses without bound before a deformation limit. Tested at some hundred deformations up
   * to the one that @p largest_stress > 0 causes, or to the last point of the law's own data.
   */
  std::optional<LawProblem>
  check_law(const ComplianceLaw &law, const double largest_stress);

  /**
   * A deformation up to which the curve is worth looking at: nine tenths of the limit, else beyond
   * the law's own data, else that of @p typical_stress.
   */
  double
  range_of_interest(const ComplianceLaw &law, const double typical_stress);
} // namespace fuga

#endif
