// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/loads/load_readers.h>
#include <fuga/input/values/value_readers.h>

#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    void
    check_drain(const ParameterSection &section)
    {
      const LoadEntries &e = entries_of<LoadEntries>();
      if (section.given(e.drains_after_crack) && !section.given(e.drain_distance))
        section.fail(e.drains_after_crack,
                     "there is no drain. Add 'Drain distance' and 'Drain efficiency', or "
                     "remove this line.");
      const bool distance = section.given(e.drain_distance);
      if (distance != section.given(e.drain_efficiency))
        section.fail(distance ? e.drain_distance : e.drain_efficiency,
                     fmt::format("a drain has a distance and an efficiency. Add '{}', or remove "
                                 "this line.",
                                 (distance ? e.drain_efficiency : e.drain_distance).name()));
      if (distance && section.given(e.pressure_profile))
        section.fail(e.pressure_profile,
                     fmt::format("the drain ({}) makes the profile. Remove one of the two.",
                                 section.origin(e.drain_distance)));
    }


    /** Return the unit vector from the upstream end to the other one. */
    std::array<double, 3>
    read_flow(const ParameterSection &section, const unsigned int dimension)
    {
      const LoadEntries &e = entries_of<LoadEntries>();
      const bool by_name   = section.given(e.upstream_end);
      if (!by_name && !section.given(e.flow_direction))
        section.fail("'Upstream end' is missing, which a load of type uplift needs: the end of the "
                     "joint that lies in the reservoir. Write it, or, in space, 'Flow direction'.");
      if (by_name && section.given(e.flow_direction))
        section.fail(e.flow_direction,
                     fmt::format("the direction of the water is known from the upstream end ({}). "
                                 "Remove one of the two.",
                                 section.origin(e.upstream_end)));
      std::array<double, 3> flow = {{0., 0., 0.}};
      if (!by_name)
        {
          const std::vector<double> given = read_coordinates(section.text(e.flow_direction));
          double length                   = 0.;
          for (const double component : given)
            length += component * component;
          if (given.size() != dimension || length == 0.)
            section.fail(e.flow_direction,
                         fmt::format("'{}' is no direction. Write {} numbers that are not all 0, "
                                     "separated by commas: the vector from the upstream end to the "
                                     "other one.",
                                     section.text(e.flow_direction),
                                     dimension));
          for (std::size_t c = 0; c < given.size(); ++c)
            flow[c] = given[c] / std::sqrt(length);
          return flow;
        }
      const JointEnd end = section.value(e.upstream_end);
      const bool across  = end == JointEnd::front || end == JointEnd::back;
      if (across && dimension == 2)
        section.fail(
          e.upstream_end,
          fmt::format("'{}' is an end in space only. In the plane an end is left, right, "
                      "bottom or top.",
                      section.text(e.upstream_end)));
      const bool along = end == JointEnd::left || end == JointEnd::right;
      const bool low   = end == JointEnd::left || end == JointEnd::front || end == JointEnd::bottom;
      flow[along ? 0 : across ? 1 : dimension - 1] = low ? 1. : -1.;
      return flow;
    }


    void
    read_profile(const ParameterSection &section, Uplift &uplift)
    {
      const LoadEntries &e = entries_of<LoadEntries>();
      uplift.profile       = read_table(section, e.pressure_profile, "s: share");
      if (uplift.profile.front()[0] != 0. || uplift.profile.back()[0] != 1.)
        section.fail(e.pressure_profile,
                     fmt::format("the profile goes from s = {:g} to {:g}, and must go from 0 (the "
                                 "upstream end) to 1 (the other one).",
                                 uplift.profile.front()[0],
                                 uplift.profile.back()[0]));
      for (const auto &[s, share] : uplift.profile)
        if (share < 0. || share > 1.)
          section.fail(e.pressure_profile,
                       fmt::format("the share {:g} at s = {:g} is not between 0 (pressure of the "
                                   "downstream end) and 1 (of the upstream end).",
                                   share,
                                   s));
    }
  } // namespace


  Uplift
  read_uplift(const ParameterSection &section, const ModelDefinition &model)
  {
    const LoadEntries &e = entries_of<LoadEntries>();
    Uplift uplift;
    uplift.flow = read_flow(section, model.dimension);
    section.read(uplift);
    if (section.given(e.tailwater_level))
      {
        uplift.has_tailwater = true;
        uplift.tailwater     = read_level(section, e.tailwater_level, model.constants);
      }
    check_drain(section);
    if (section.given(e.pressure_profile))
      read_profile(section, uplift);
    return uplift;
  }
} // namespace fuga
