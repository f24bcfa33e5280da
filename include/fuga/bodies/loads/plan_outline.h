// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_loads_plan_outline_h
#define fuga_bodies_loads_plan_outline_h

#include <array>
#include <optional>
#include <vector>

namespace fuga
{
  /** A point of a joint in the coordinates along and across a flow of water, and its height [m]. */
  struct PlanPoint
  {
    double along = 0., across = 0., height = 0.;
  };

  /** Return a coordinate hardly away from @p at, on the side of @p middle: where lines border on each
   * other at @p at, it lies on one of them. */
  inline double
  just_inside(const double at, const double middle)
  {
    constexpr double inwards = 1e-9;
    return at + inwards * (middle - at);
  }

  /**
   * The outline of a part of a joint in the coordinates along and across the flow of the water. In
   * the plane it is a single edge along the flow.
   */
  class PlanOutline
  {
  public:
    using Edge = std::array<PlanPoint, 2>;

    PlanOutline() = default;

    /** Create the outline of the convex figure with these corners, which may be in any order. */
    explicit PlanOutline(const std::vector<PlanPoint> &corners);

    void
    add(const Edge &edge);

    const std::vector<Edge> &
    edges() const
    {
      return all_edges;
    }

    /**
     * Return the first and the last point of the outline on the line along the flow at the
     * coordinate @p across; nothing if that line misses it.
     */
    std::optional<Edge>
    slice(const double across) const;

    /** Return the smallest and the largest coordinate across the flow. */
    const std::array<double, 2> &
    width() const
    {
      return its_width;
    }

  private:
    std::vector<Edge> all_edges;
    std::array<double, 2> its_width = {};
  };
} // namespace fuga

#endif
