// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>

namespace fuga
{
  using namespace parameter_patterns;

  LoadEntries::LoadEntries()
    : SectionDeclaration(
        "Loads",
        "One subsection per load pattern, with a name of your choice; stages make it act.",
        {"weight", "water"})
  {
    type = required(
      "Type",
      choice<LoadType>({{"weight", LoadType::weight},
                        {"seismic", LoadType::seismic},
                        {"temperature", LoadType::temperature},
                        {"pressure", LoadType::pressure},
                        {"hydrostatic", LoadType::hydrostatic},
                        {"earth pressure", LoadType::earth_pressure},
                        {"westergaard", LoadType::westergaard},
                        {"uplift", LoadType::uplift},
                        {"traction", LoadType::traction},
                        {"point force", LoadType::point_force},
                        {"displacement", LoadType::displacement},
                        {"imposed gap", LoadType::imposed_gap}}),
      "Weight of bodies, weight times seismic coefficients, change of temperature, "
      "pressure towards the body, pressure of still water, of earth, of water moved by "
      "an earthquake, of water in a joint, traction vector, force at a point, displacement of "
      "fixed "
      "components, change of the gap of joints by a saw or a jack.",
      {"weight", "pressure"});
    bodies = optional("Bodies",
                      text(),
                      "For weight, seismic, temperature: list of bodies; without it all of them.");
    boundaries =
      optional("Boundaries",
               text(),
               "For all other types but point force, uplift and imposed gap: list of boundaries.",
               {"", "upstream"});
    point = optional(
      "Point", text(TextContent::numbers), "For a point force: named point, or coordinates: x, y.");
    value =
      optional("Value",
               text(),
               "For weight, temperature, pressure, traction, point force, displacement, imposed "
               "gap: expressions of x, y and the load time t, separated by ';': one for a "
               "pressure [MPa], temperature [K] or gap [m], else one per component [MPa, MN, m] "
               "(an empty one leaves a displacement free); the direction of a weight is 0; -1 "
               "without this entry. A positive gap is sawn off between the lips, a negative one "
               "is filled in.",
               {"0; -1", "0.0144"});
    declare_depth_and_shaking();
    declare_uplift();
  }


  void
  LoadEntries::declare_depth_and_shaking()
  {
    level = optional(
      "Level",
      text(TextContent::level),
      "For hydrostatic, earth pressure, westergaard, uplift: y (in space z) of the surface of "
      "the water or the ground [m]. A number, an expression of the load time t, or a table "
      "'t: level; t: level', linear in between and constant outside. Nothing above the "
      "level is loaded.");
    unit_weight = optional(
      "Unit weight",
      number_above(0),
      "For hydrostatic, earth pressure, westergaard, uplift: weight per volume of the water or "
      "the ground [MN/m^3]; the pressure of still water is this times the depth.");
    earth_coefficient =
      optional("Earth pressure coefficient",
               number_above(0),
               "For earth pressure: K0, Ka or Kp; the pressure, normal to the boundary, is K "
               "(unit weight times depth + surcharge).");
    surcharge =
      optional("Surcharge",
               number_from(0),
               "For earth pressure: load on the surface of the ground [MPa]; 0 without this "
               "entry.");
    horizontal_coefficient =
      optional("Horizontal coefficient",
               any_number(),
               "For seismic: force per weight of the bodies in x, negative against x, or, in "
               "space, in 'Horizontal direction'. For "
               "westergaard: the pressure is 7/8 of this times unit weight times sqrt(depth of "
               "the water at its bottom times depth), positive towards the body.");
    horizontal_direction =
      optional("Horizontal direction",
               text(TextContent::numbers),
               "For seismic in space: the direction of 'Horizontal coefficient', two numbers "
               "'x; y' whose common length does not count; x without this entry. The pressure "
               "of westergaard has no direction of its own: it acts along the normal of its "
               "boundaries.");
    vertical_coefficient =
      optional("Vertical coefficient",
               any_number(),
               "For seismic: force per weight of the bodies in y (in space z), upwards "
               "positive.");
    bottom_level = optional("Bottom level",
                            any_number(),
                            "For westergaard: y (in space z) of the bottom of the water [m].");
  }


  void
  LoadEntries::declare_uplift()
  {
    joints =
      optional("Joints",
               text(),
               "For uplift and imposed gap: list of joints. Uplift: open elements that are "
               "connected with the reservoir by open elements have its pressure, those connected "
               "with the tailwater only that one, others keep what they had; water comes in and "
               "goes by events.");
    upstream_end =
      optional("Upstream end",
               choice<JointEnd>({{"left", JointEnd::left},
                                 {"right", JointEnd::right},
                                 {"front", JointEnd::front},
                                 {"back", JointEnd::back},
                                 {"bottom", JointEnd::bottom},
                                 {"top", JointEnd::top}}),
               "For uplift: the end of the joint that lies in the reservoir: the one with the "
               "smallest or largest x (left, right), in space also y (front, back), or height "
               "(bottom, top). Joints that meet are one way of the water, whose length is "
               "measured along them; in space every line in the direction of flow is one, from "
               "where it enters the joints to where it leaves them.");
    flow_direction =
      optional("Flow direction",
               text(TextContent::numbers),
               "For uplift in space, instead of the upstream end: 'x, y, z', a vector from the "
               "upstream end to the other one.");
    profile_from =
      optional("Profile from",
               &Uplift::profile_from,
               choice<Uplift::ProfileFrom>({{"crack tip", Uplift::ProfileFrom::crack_tip},
                                            {"joint", Uplift::ProfileFrom::joint}}),
               "For uplift: from where the pressure falls. From the tip of the crack that is "
               "connected with the reservoir (without this entry; codes of practice), or from the "
               "upstream end of the joint, however long the crack is.");
    cracks =
      optional("Cracks",
               &Uplift::fills_cracks,
               choice<bool>({{"reservoir", true}, {"unchanged", false}}),
               "For uplift: pressure where the joint is open. That of the reservoir (without this "
               "entry), or the same as where it is closed.");
    tailwater_level =
      optional("Tailwater level",
               text(TextContent::level),
               "For uplift: y (in space z) of the surface of the water at the other end [m]: a "
               "number, an expression of the load time t, or a table as for Level; without this "
               "entry there is none.");
    drain_distance =
      optional("Drain distance",
               &Uplift::drain_distance,
               number_above(0),
               "For uplift: distance of a line of drains from the upstream end [m], at which the "
               "linear pressure of the closed joint is lowered.");
    drain_efficiency =
      optional("Drain efficiency",
               &Uplift::drain_efficiency,
               number_in(0, 1),
               "For uplift: there the share by which the pressure above that of the tailwater is "
               "lowered.");
    drains_after_crack = optional(
      "Drains after crack",
      &Uplift::drains_after_crack,
      choice<Uplift::Drains>({{"lost", Uplift::Drains::lost}, {"kept", Uplift::Drains::kept}}),
      "For uplift with drain: what the drain does when the crack has passed it: nothing "
      "(without this entry), or lowers the pressure in the crack from there on.");
    pressure_profile =
      optional("Pressure profile",
               text(TextContent::numbers),
               "For uplift: pressure where the joint is closed, as a table 's: share; s: share', "
               "with s = 0 at the upstream end and 1 at the other one, share 1 for the pressure "
               "of the reservoir and 0 for that of the tailwater; 0: 1; 1: 0 without this entry "
               "and without drain.");
  }
} // namespace fuga
