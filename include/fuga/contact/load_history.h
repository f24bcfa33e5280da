// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_load_history_h
#define fuga_contact_load_history_h

#include <fuga/base/numerics/dense_matrix.h>

#include <array>

namespace fuga
{
  /**
   * The factors a(t) of the load patterns, piecewise linear in the load time t = stage number +
   * fraction done (stage numbers count from 0 here: the first stage is t ∈ [0, 1]). Loads begin
   * from a(0), usually zero.
   */
  class LoadHistory
  {
  public:
    /**
     * @p corners increasing, first 0; @p factors one vector per corner, n_patterns long; @p shares
     * of the strength that are left at the corners, ]0, 1], without them 1.
     */
    LoadHistory(std::vector<double> corners, std::vector<Vector> factors, Vector shares = {});

    unsigned int
    n_patterns() const;

    /** The history up to one of its corners. */
    LoadHistory
    until(const double corner) const;

    /** The same loads; behind the last corner but one the strength falls to a share at the end. */
    LoadHistory
    reducing_strength(const double share_at_end) const;

    double
    end() const;

    /** The first corner behind @p t (the end for t ≥ end). */
    double
    next_corner(const double t) const;

    /** The last corner at or before @p t at which rates(t) begin to hold. */
    double
    last_corner(const double t) const;

    /** The same history with a corner at @p t, between 0 and its end. */
    LoadHistory
    with_corner(const double t) const;

    /** This history with two patterns more: one that is constant, and one that falls from 1 at load
     *  time @p begin, a corner, to 0 at @p end, another one. */
    LoadHistory
    with_carried_loads(const double begin, const double end) const;

    /** a(t). */
    Vector
    factors(const double t) const;

    /** da/dt on the segment that begins at, or contains, @p t. */
    Vector
    rates(const double t) const;

    /** From @p begin to @p end, both corners, the water in joints does not follow their opening. */
    void
    keep_water_still(const double begin, const double end);

    bool
    water_stands_still(const double t) const;

    /** Share of strength that a strength reduction leaves: linear between corners. */
    double
    strength_share(const double t) const;

    double
    strength_share_rate(const double t) const;

  private:
    std::size_t
    segment_after(const double t) const;

    std::vector<double> corners;
    std::vector<Vector> values;
    Vector shares;
    std::vector<std::array<double, 2>> times_of_still_water;
  };
} // namespace fuga

#endif
