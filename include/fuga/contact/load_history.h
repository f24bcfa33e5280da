// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_load_history_h
#define fuga_contact_load_history_h

#include <fuga/base/numerics/dense_matrix.h>

#include <array>

namespace fuga
{
  /**
   * The factors a(t) of the load patterns. They are piecewise linear in the load time t = stage
   * number + fraction done (stage numbers count from 0 here: the first stage is t ∈ [0, 1]). Loads
   * begin with a(0), which is usually zero.
   */
  class LoadHistory
  {
  public:
    /**
     * Constructor. @p corners are increasing, and the first one is 0; @p factors contains one
     * vector of length n_patterns per corner; @p shares are the shares of the strength that are
     * left at the corners, in ]0, 1]. Without them the share is 1.
     */
    LoadHistory(std::vector<double> corners, std::vector<Vector> factors, Vector shares = {});

    unsigned int
    n_patterns() const;

    /** Return the history up to one of its corners. */
    LoadHistory
    until(const double corner) const;

    /** Return a history with the same loads in which, after the last corner but one, the strength
     * falls to a share at the end. */
    LoadHistory
    reducing_strength(const double share_at_end) const;

    double
    end() const;

    /** Return the first corner after @p t (the end for t ≥ end). */
    double
    next_corner(const double t) const;

    /** Return the last corner at or before @p t at which rates(t) begin to hold. */
    double
    last_corner(const double t) const;

    /** Return the same history with a corner at @p t, which lies between 0 and the end. */
    LoadHistory
    with_corner(const double t) const;

    /** Return this history with two more patterns: a constant one, and one that falls from 1 at
     * load time @p begin to 0 at @p end, both of which are corners. */
    LoadHistory
    with_carried_loads(const double begin, const double end) const;

    /** Return a(t). */
    Vector
    factors(const double t) const;

    /** Return da/dt on the segment that begins at, or contains, @p t. */
    Vector
    rates(const double t) const;

    /** Keep the water in joints from following their opening between @p begin and @p end, both of
     * which are corners. */
    void
    keep_water_still(const double begin, const double end);

    bool
    water_stands_still(const double t) const;

    /** Return the share of the strength that a strength reduction leaves; it is linear between
     * corners. */
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
