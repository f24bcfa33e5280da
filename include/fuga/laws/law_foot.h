// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_laws_law_foot_h
#define fuga_laws_law_foot_h

namespace fuga
{
  /**
   * The beginning of a curve that does not itself start at the origin with a finite tangent: a
   * polynomial from (0, 0) to the curve, which it meets with equal value, slope and curvature.
   * With ξ = w/w1, 0 ≤ ξ ≤ 1,
   *     σ = σ1 (a ξ + b ξ² + c ξ³ + d ξ⁴).
   * The initial slope a is free; the one that makes d = 0 gives a cubic.
   */
  class LawFoot
  {
  public:
    /**
     * @p length w1 and @p stress σ1 where the foot ends; the slope and the curvature of the curve
     * there in units of σ1/w1 and σ1/w1²; the initial slope a in units of σ1/w1.
     */
    LawFoot(const double length,
            const double stress,
            const double slope,
            const double curvature,
            const double initial_slope);

    /** Return the initial slope a of the cubic. */
    static double
    cubic_slope(const double slope, const double curvature);

    double
    stress(const double w) const;
    double
    tangent(const double w) const;
    double
    energy(const double w) const;

    /** Length w1 of the foot. */
    const double length;
    /** Stress σ1 at the end of the foot. */
    const double end_stress;

  private:
    const double a, d, c, b;
  };
} // namespace fuga

#endif
