// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_entries.h>

namespace fuga
{
  namespace parameter_entries
  {
    std::vector<EntryDeclaration>
    load_depth_and_shaking()
    {
      return {
        optional(
          "Level",
          text(),
          "For hydrostatic, earth pressure, westergaard, uplift: y (in space z) of the surface of "
          "the water or the ground [m]. A number, an expression of the load time t, or a table "
          "'t: level; t: level', linear in between and constant outside. Nothing above the "
          "level is loaded."),
        optional(
          "Unit weight",
          number_above(0),
          "For hydrostatic, earth pressure, westergaard, uplift: weight per volume of the water or "
          "the ground [MN/m^3]; the pressure of still water is this times the depth."),
        optional("Earth pressure coefficient",
                 number_above(0),
                 "For earth pressure: K0, Ka or Kp; the pressure, normal to the boundary, is K "
                 "(unit weight times depth + surcharge)."),
        optional("Surcharge",
                 number_from(0),
                 "For earth pressure: load on the surface of the ground [MPa]; 0 without this "
                 "entry."),
        optional("Horizontal coefficient",
                 any_number(),
                 "For seismic: force per weight of the bodies in x, negative against x, or, in "
                 "space, in 'Horizontal direction'. For "
                 "westergaard: the pressure is 7/8 of this times unit weight times sqrt(depth of "
                 "the water at its bottom times depth), positive towards the body."),
        optional("Horizontal direction",
                 text(),
                 "For seismic in space: the direction of 'Horizontal coefficient', two numbers "
                 "'x; y' whose common length does not count; x without this entry. The pressure "
                 "of westergaard has no direction of its own: it acts along the normal of its "
                 "boundaries."),
        optional("Vertical coefficient",
                 any_number(),
                 "For seismic: force per weight of the bodies in y (in space z), upwards "
                 "positive."),
        optional("Bottom level",
                 any_number(),
                 "For westergaard: y (in space z) of the bottom of the water [m].")};
    }


    std::vector<EntryDeclaration>
    load_uplift()
    {
      return {
        optional("Joints",
                 text(),
                 "For uplift and imposed gap: list of joints. Uplift: open elements that are "
                 "connected with the reservoir by open elements have its pressure, those connected "
                 "with the tailwater only that one, others keep what they had; water comes in and "
                 "goes by events."),
        optional(
          "Upstream end",
          choice("left|right|front|back|bottom|top"),
          "For uplift: the end of the joint that lies in the reservoir: the one with the "
          "smallest or largest x (left, right), in space also y (front, back), or height "
          "(bottom, top). Joints that meet are one way of the water, whose length is "
          "measured along them; in space in the direction of flow, between horizontal ends."),
        optional("Flow direction",
                 text(),
                 "For uplift in space, instead of the upstream end: 'x, y, z', a vector from the "
                 "upstream end to the other one."),
        optional(
          "Profile from",
          choice("crack tip|joint"),
          "For uplift: from where the pressure falls. From the tip of the crack that is "
          "connected with the reservoir (without this entry; codes of practice), or from the "
          "upstream end of the joint, however long the crack is."),
        optional(
          "Cracks",
          choice("reservoir|unchanged"),
          "For uplift: pressure where the joint is open. That of the reservoir (without this "
          "entry), or the same as where it is closed."),
        optional("Tailwater level",
                 text(),
                 "For uplift: y (in space z) of the surface of the water at the other end [m]: a "
                 "number, an expression of the load time t, or a table as for Level; without this "
                 "entry there is none."),
        optional("Drain distance",
                 number_above(0),
                 "For uplift: distance of a line of drains from the upstream end [m], at which the "
                 "linear pressure of the closed joint is lowered."),
        optional("Drain efficiency",
                 number_in(0, 1),
                 "For uplift: there the share by which the pressure above that of the tailwater is "
                 "lowered."),
        optional("Drains after crack",
                 choice("lost|kept"),
                 "For uplift with drain: what the drain does when the crack has passed it: nothing "
                 "(without this entry), or lowers the pressure in the crack from there on."),
        optional("Pressure profile",
                 text(),
                 "For uplift: pressure where the joint is closed, as a table 's: share; s: share', "
                 "with s = 0 at the upstream end and 1 at the other one, share 1 for the pressure "
                 "of the reservoir and 0 for that of the tailwater; 0: 1; 1: 0 without this entry "
                 "and without drain.")};
    }
  } // namespace parameter_entries
} // namespace fuga
