// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/loads/water_line.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    using Profile = std::vector<std::array<double, 2>>;

    /** Gaps shorter than this share of the way are ignored. */
    constexpr double shortest_gap = 1e-9;

    /** Return φ(s), which is linear between its points and constant outside. */
    double
    share_of_head(const Profile &profile, const double s)
    {
      const auto after = std::upper_bound(
        profile.begin(), profile.end(), s, [](const double x, const auto &p) { return x < p[0]; });
      if (after == profile.begin())
        return profile.front()[1];
      if (after == profile.end())
        return profile.back()[1];
      const auto &[s0, phi0] = *(after - 1);
      const auto &[s1, phi1] = *after;
      return phi0 + (phi1 - phi0) * (s - s0) / (s1 - s0);
    }
  } // namespace

  WaterLine::WaterLine(const Uplift &its_uplift,
                       const double gamma,
                       const WayOfWater &its_way,
                       std::vector<WaterReach> its_reaches)
    : uplift(its_uplift), unit_weight(gamma), way(its_way), reaches(std::move(its_reaches))
  {
    unite_reaches();
    find_gaps();
  }

  // Where reaches of both kinds overlap, the water is that of the reservoir.
  void
  WaterLine::unite_reaches()
  {
    const double tolerance = shortest_gap * way.length();
    std::stable_sort(reaches.begin(), reaches.end(), [](const auto &a, const auto &b) {
      return a.begin < b.begin;
    });
    std::vector<WaterReach> united;
    for (WaterReach reach : reaches)
      {
        if (!united.empty() && reach.begin < united.back().end + tolerance)
          {
            WaterReach &last = united.back();
            if (reach.source == last.source)
              {
                if (reach.end > last.end)
                  {
                    last.end           = reach.end;
                    last.height_at_end = reach.height_at_end;
                  }
                continue;
              }
            if (last.source == WaterAccess::upstream)
              {
                if (reach.end <= last.end + tolerance)
                  continue;
                reach.begin           = last.end;
                reach.height_at_begin = last.height_at_end;
              }
            else
              {
                last.end           = reach.begin;
                last.height_at_end = reach.height_at_begin;
              }
          }
        united.push_back(reach);
      }
    reaches = std::move(united);
  }

  void
  WaterLine::find_gaps()
  {
    const double tolerance = shortest_gap * way.length();
    Gap gap;
    gap.begin = way.begin;
    for (std::size_t i = 0; i < reaches.size(); ++i)
      {
        gap.end   = reaches[i].begin;
        gap.after = i;
        if (gap.end - gap.begin > tolerance)
          gaps.push_back(gap);
        gap.begin  = reaches[i].end;
        gap.before = i;
      }
    gap.end   = way.end;
    gap.after = none;
    if (gap.end - gap.begin > tolerance)
      gaps.push_back(gap);
  }

  bool
  WaterLine::has_drain(const Gap &gap) const
  {
    return uplift.drain_distance > 0. && drain() > gap.begin && drain() < gap.end &&
           (gap.before == none || reaches[gap.before].source == WaterAccess::upstream) &&
           (gap.after == none || reaches[gap.after].source == WaterAccess::downstream);
  }

  std::vector<double>
  WaterLine::corners() const
  {
    std::vector<double> result;
    for (const WaterReach &reach : reaches)
      result.insert(result.end(), {reach.begin, reach.end});
    if (uplift.drain_distance > 0.)
      result.push_back(drain());
    else
      for (const Gap &gap : gaps)
        for (const auto &point : uplift.profile)
          result.push_back(gap.begin + point[0] * (gap.end - gap.begin));
    std::sort(result.begin(), result.end());
    return result;
  }

  double
  WaterLine::pressure(const double s, const double height, const WaterLevels &levels) const
  {
    for (const Gap &gap : gaps)
      if (s >= gap.begin && s <= gap.end)
        return in_gap(gap, s, levels);
    for (const WaterReach &reach : reaches)
      if (s <= reach.end)
        return in_reach(reach, s, height, levels);
    return reaches.empty() ? 0. : in_reach(reaches.back(), s, height, levels);
  }

  // A drain that the crack has passed, and that still works, lowers the pressure in the crack from
  // there on.
  double
  WaterLine::in_reach(const WaterReach &reach,
                      const double s,
                      const double height,
                      const WaterLevels &levels) const
  {
    if (reach.source == WaterAccess::downstream)
      return still_water(levels.tailwater, height);
    const double full = still_water(levels.reservoir, height);
    if (uplift.drains_after_crack == Uplift::Drains::lost || uplift.drain_distance == 0. ||
        s <= drain())
      return full;
    const double down = downstream_end(levels);
    return down + (1. - uplift.drain_efficiency) * (full - down);
  }

  double
  WaterLine::in_gap(const Gap &gap, const double s, const WaterLevels &levels) const
  {
    const auto end_of = [&](const std::size_t i) {
      return in_reach(reaches[i], reaches[i].end, reaches[i].height_at_end, levels);
    };
    const auto begin_of = [&](const std::size_t i) {
      return in_reach(reaches[i], reaches[i].begin, reaches[i].height_at_begin, levels);
    };
    const double from   = gap.before == none ? upstream_end(levels) : end_of(gap.before);
    const double to     = gap.after == none ? downstream_end(levels) : begin_of(gap.after);
    const double length = gap.end - gap.begin;
    const double share  = (s - gap.begin) / length;
    double phi          = 1. - share;
    if (has_drain(gap))
      {
        const double at     = (drain() - gap.begin) / length;
        const double inside = (1. - uplift.drain_efficiency) * (1. - at);
        phi = share < at ? 1. + (inside - 1.) * share / at : inside * (1. - share) / (1. - at);
      }
    else if (gap.after == none || reaches[gap.after].source == WaterAccess::downstream)
      phi = share_of_head(uplift.profile, share);
    return to + phi * (from - to);
  }

  double
  WaterLine::still_water(const double level, const double height) const
  {
    return unit_weight * std::max(level - height, 0.);
  }

  double
  WaterLine::upstream_end(const WaterLevels &levels) const
  {
    return still_water(levels.reservoir, way.upstream_height);
  }

  double
  WaterLine::downstream_end(const WaterLevels &levels) const
  {
    return uplift.has_tailwater ? still_water(levels.tailwater, way.downstream_height) : 0.;
  }
} // namespace fuga
