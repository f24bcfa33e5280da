// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_loads_water_line_h
#define fuga_bodies_loads_water_line_h

#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/bodies/model_definition.h>
#include <fuga/contact/water_in_joints.h>

namespace fuga
{
  /** A part of the way of the water through a joint that consists of connected open elements. */
  struct WaterReach
  {
    /** Coordinates along the flow [m], and the heights there. */
    double begin = 0., end = 0.;
    double height_at_begin = 0., height_at_end = 0.;
    /** Origin of the water: WaterAccess::upstream or WaterAccess::downstream. */
    WaterAccess source = WaterAccess::upstream;
  };

  /** Both levels at one time. */
  struct WaterLevels
  {
    double reservoir = 0., tailwater = 0.;
  };

  /** The whole way: the coordinates of its upstream and its downstream end along the flow, and the
   * heights there [m]. */
  struct WayOfWater
  {
    double begin = 0., end = 0.;
    double upstream_height = 0., downstream_height = 0.;

    double
    length() const
    {
      return end - begin;
    }
  };

  /**
   * The pressure of the water along one line from the upstream end of a joint to the downstream one
   * (doc/theory.md, section 12). In reaches it is that of still water below the level of the
   * reservoir, or the tailwater, with which they are connected; between them it falls from one to
   * the next, according to the profile and the drain of the uplift. Without reaches this is the
   * pressure in the closed joint.
   */
  class WaterLine
  {
  public:
    /**
     * @p unit_weight [MN/m³]. The @p uplift must outlive this object. The reaches may overlap and be
     * in any order.
     */
    WaterLine(const Uplift &uplift,
              const double unit_weight,
              const WayOfWater &way,
              std::vector<WaterReach> reaches);

    /**
     * Return the coordinates along the flow between which, in a straight part of the joint, the
     * pressure is linear, apart from the water lines; in increasing order.
     */
    std::vector<double>
    corners() const;

    /**
     * Return the pressure at the coordinate @p s along the flow [m] and the @p height there [m].
     */
    double
    pressure(const double s, const double height, const WaterLevels &levels) const;

  private:
    /** A closed part between two reaches or ends. */
    struct Gap
    {
      double begin = 0., end = 0.;
      /** Indices of the reaches before and after the gap; none at the ends of the way. */
      std::size_t before = none, after = none;
    };
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    void
    unite_reaches();
    void
    find_gaps();

    double
    in_reach(const WaterReach &reach,
             const double s,
             const double height,
             const WaterLevels &levels) const;
    double
    in_gap(const Gap &gap, const double s, const WaterLevels &levels) const;

    /**
     * Return whether the drain lowers the pressure in a gap, i.e. between reservoir and tailwater.
     */
    bool
    has_drain(const Gap &gap) const;
    /** Return the coordinate of the drain along the flow. */
    double
    drain() const
    {
      return way.begin + uplift.drain_distance;
    }
    double
    upstream_end(const WaterLevels &levels) const;
    double
    downstream_end(const WaterLevels &levels) const;
    double
    still_water(const double level, const double height) const;

    const Uplift &uplift;
    const double unit_weight;
    const WayOfWater way;
    std::vector<WaterReach> reaches;
    std::vector<Gap> gaps;
  };
} // namespace fuga

#endif
