// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_readers.h>

#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    void
    read_drain(const ParameterSection &section, Uplift &uplift)
    {
      if (section.given("Drains after crack"))
        {
          if (!section.given("Drain distance"))
            section.fail("Drains after crack",
                         "there is no drain. Add 'Drain distance' and 'Drain efficiency', or "
                         "remove this line.");
          uplift.drains_after_crack = section.text("Drains after crack") == "kept"
                                        ? Uplift::Drains::kept
                                        : Uplift::Drains::lost;
        }
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


    /** The unit vector from the upstream end to the other one. */
    std::array<double, 3>
    read_flow(const ParameterSection &section, const unsigned int dimension)
    {
      const bool by_name = section.given("Upstream end");
      if (!by_name && !section.given("Flow direction"))
        section.fail("'Upstream end' is missing, which a load of type uplift needs: the end of the "
                     "joint that lies in the reservoir. Write it, or, in space, 'Flow direction'.");
      if (by_name && section.given("Flow direction"))
        section.fail("Flow direction",
                     fmt::format("the direction of the water is known from the upstream end ({}). "
                                 "Remove one of the two.",
                                 section.origin("Upstream end")));
      std::array<double, 3> flow = {{0., 0., 0.}};
      if (!by_name)
        {
          const std::vector<double> given = read_coordinates(section.text("Flow direction"));
          double length                   = 0.;
          for (const double component : given)
            length += component * component;
          if (given.size() != dimension || length == 0.)
            section.fail("Flow direction",
                         fmt::format("'{}' is no direction. Write {} numbers that are not all 0, "
                                     "separated by commas: the vector from the upstream end to the "
                                     "other one.",
                                     section.text("Flow direction"),
                                     dimension));
          for (std::size_t c = 0; c < given.size(); ++c)
            flow[c] = given[c] / std::sqrt(length);
          return flow;
        }
      const std::string end = section.text("Upstream end");
      const bool across     = end == "front" || end == "back";
      if (across && dimension == 2)
        section.fail(
          "Upstream end",
          fmt::format("'{}' is an end in space only. In the plane an end is left, right, "
                      "bottom or top.",
                      end));
      const std::size_t c = end == "left" || end == "right" ? 0 : across ? 1 : dimension - 1;
      flow[c]             = end == "left" || end == "front" || end == "bottom" ? 1. : -1.;
      return flow;
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
  read_uplift(const ParameterSection &section, const ModelDefinition &model)
  {
    Uplift uplift;
    uplift.flow         = read_flow(section, model.dimension);
    uplift.fills_cracks = !section.given("Cracks") || section.text("Cracks") == "reservoir";
    if (section.given("Profile from") && section.text("Profile from") == "joint")
      uplift.profile_from = Uplift::ProfileFrom::joint;
    if (section.given("Tailwater level"))
      {
        uplift.has_tailwater = true;
        uplift.tailwater     = read_level(section, "Tailwater level", model.constants);
      }
    read_drain(section, uplift);
    if (section.given("Pressure profile"))
      read_profile(section, uplift);
    return uplift;
  }
} // namespace fuga
