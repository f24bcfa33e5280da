// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_judges_envelope_h
#define fuga_tests_judges_envelope_h

#include <cmath>

namespace fuga::judges
{
  /** The shape of the shear strength over the pressure, r = f A G(P/A) + c A with
   * G(σ) = σ_r/b [(1 + σ/σ_r)^b - 1]; Coulomb's line for b = 1. */
  struct Envelope
  {
    double exponent = 1., pressure = 1.;

    /** A G(P/A), P ≥ 0. */
    double
    force(const double area, const double P) const
    {
      return exponent == 1.
               ? P
               : area * pressure / exponent * (std::pow(1. + P / (area * pressure), exponent) - 1.);
    }

    /** Its derivative by P. */
    double
    slope(const double area, const double P) const
    {
      return std::pow(1. + std::fmax(P, 0.) / (area * pressure), exponent - 1.);
    }
  };
} // namespace fuga::judges

#endif
