// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_readers.h>

#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    void
    read_drain(const ParameterSection &section, Uplift &uplift)
    {
      const bool distance = section.given("Drain distance");
      if (distance != section.given("Drain efficiency"))
        section.fail(distance ? "Drain distance" : "Drain efficiency",
                     fmt::format("a drain has a distance and an efficiency. Add '{}', or remove "
                                 "this line.",
                                 distance ? "Drain efficiency" : "Drain distance"));
      if (!distance)
        return;
      if (section.given("Pressure profile"))
        section.fail("Pressure profile",
                     fmt::format("the drain ({}) makes the profile. Remove one of the two.",
                                 section.origin("Drain distance")));
      uplift.drain_distance   = section.number("Drain distance");
      uplift.drain_efficiency = section.number("Drain efficiency");
    }


    void
    read_profile(const ParameterSection &section, Uplift &uplift)
    {
      uplift.profile = read_table(section, "Pressure profile", "s: share");
      if (uplift.profile.front()[0] != 0. || uplift.profile.back()[0] != 1.)
        section.fail("Pressure profile",
                     fmt::format("the profile goes from s = {:g} to {:g}, and must go from 0 (the "
                                 "upstream end) to 1 (the other one).",
                                 uplift.profile.front()[0],
                                 uplift.profile.back()[0]));
      for (const auto &[s, share] : uplift.profile)
        if (share < 0. || share > 1.)
          section.fail("Pressure profile",
                       fmt::format("the share {:g} at s = {:g} is not between 0 (pressure of the "
                                   "downstream end) and 1 (of the upstream end).",
                                   share,
                                   s));
    }
  } // namespace


  Uplift
  read_uplift(const ParameterSection &section)
  {
    Uplift uplift;
    const std::string end = section.text("Upstream end");
    uplift.upstream_end   = end == "left"     ? Uplift::End::left
                            : end == "right"  ? Uplift::End::right
                            : end == "bottom" ? Uplift::End::bottom
                                              : Uplift::End::top;
    uplift.fills_cracks   = !section.given("Cracks") || section.text("Cracks") == "reservoir";
    if (section.given("Tailwater level"))
      {
        uplift.has_tailwater = true;
        uplift.tailwater     = section.number("Tailwater level");
      }
    read_drain(section, uplift);
    if (section.given("Pressure profile"))
      read_profile(section, uplift);
    return uplift;
  }
} // namespace fuga
