// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_numerics_cubic_h
#define fuga_base_numerics_cubic_h

#include <array>

namespace fuga
{
  /** The cubic on [0, 1] with given values and derivatives at both ends (Hermite). */
  class CubicOnUnitInterval
  {
  public:
    CubicOnUnitInterval(const double value_0,
                        const double slope_0,
                        const double value_1,
                        const double slope_1);

    double
    value(const double x) const;

    double
    slope(const double x) const;

    /** Return the smallest value on [0, 1]. */
    double
    minimum() const;

    /**
     * Return the first x in [0, 1] where the cubic changes from positive (or zero) to negative; 1
     * if there is none.
     */
    double
    first_descending_root() const;

  private:
    double
    inner_minimiser() const;

    /** Coefficients of 1, x, x², x³. */
    double c0, c1, c2, c3;
  };

  /** Return ∫ force d(jump), exact for cubics. */
  double
  work_of(const CubicOnUnitInterval &force, const CubicOnUnitInterval &jump);

  /**
   * Return |f × s'| at @p x: how far a slip s, given by its two tangential components, leads across
   * the force f.
   */
  double
  work_across(const std::array<CubicOnUnitInterval, 2> &force,
              const std::array<CubicOnUnitInterval, 2> &slip,
              const double x);

  /**
   * Return by how much the path along two cubics is longer than the chord between its ends, by
   * Gauss's rule with three points: ∫ |s'| - e·s' with e along the chord. Without a turn it is
   * exactly zero, despite rounding.
   */
  double
  detour(const CubicOnUnitInterval &first, const CubicOnUnitInterval &second);
} // namespace fuga

#endif
