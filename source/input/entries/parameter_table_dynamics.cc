// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>

namespace fuga
{
  using namespace parameter_patterns;

  DynamicsEntries::DynamicsEntries()
    : SectionDeclaration(
        "Dynamics",
        "How stages with a Duration, and motions beyond a limit load, go on in time: by steps of "
        "the generalised-alpha method, which "
        "are halved where joints change their state (doc/dynamics.md).")
  {
    time_step = optional(
      "Time step",
      &DynamicsDefinition::time_step,
      number_above(0),
      "Largest length of a step [s]; steps are a little shorter where the levels of a "
      "stage ask for it. Without this entry the step of the record of section Earthquake.");
    defaulted(
      "Halvings",
      &DynamicsDefinition::halvings,
      integer(0, 20),
      "How often a step may be halved to find the time of an event; 0: all steps are whole.");
    defaulted("Event tolerance",
              &DynamicsDefinition::event_tolerance,
              number_above(0),
              "A step is halved if its events cost more than this share of the largest energy so "
              "far.");
    defaulted(
      "Spectral radius",
      &DynamicsDefinition::spectral_radius,
      number_in(0, 1),
      "Of the method at high frequencies: 1 keeps the energy (trapezoidal rule), less damps "
      "what the steps do not resolve.");
    bodies = defaulted(
      "Bodies",
      &DynamicsDefinition::bodies,
      choice<MotionBodies>(
        {{"finite elements", MotionBodies::finite_elements}, {"modes", MotionBodies::modes}}),
      "Finite elements: every step solves for all nodes. Modes: the bodies move in their normal "
      "modes below the Highest frequency, found with the joints bonded, and follow the joints and "
      "the loads as in statics for the rest; a step costs little then, whatever the mesh. Not with "
      "Absorbing boundaries, Compliant base, Free field or Second order.");
    highest_frequency = optional("Highest frequency",
                                 &DynamicsDefinition::highest_frequency,
                                 number_above(0),
                                 "Of the modes of Bodies = modes [Hz]. Without this entry that of "
                                 "which a Time step is half a period.");
    gravity =
      optional("Gravity",
               &DynamicsDefinition::gravity,
               number_above(0),
               "g [m/s^2], by which the weight densities of the bodies are divided, and of which "
               "records in g are multiples; 9.81 m/s^2 in Output/Length unit without this entry.");
    massless_bodies = optional(
      "Massless bodies",
      text(),
      "List of bodies without inertia: a foundation through which the motion of the ground "
      "arrives at once.");
    absorbing = optional(
      "Absorbing boundaries",
      text(),
      "List of boundaries behind which the bodies go on: dashpots take the waves that leave there, "
      "rho c_p and rho c_s per area and velocity (Lysmer and Kuhlemeyer 1969). Their supports are "
      "released in stages with a Duration, and what these carry then acts on; after such a stage "
      "they hold where they are by then.");
    damping_ratio =
      defaulted("Damping ratio",
                &DynamicsDefinition::damping_ratio,
                number_in(0, 1),
                "Share of the critical damping that the bodies have at both Damping frequencies "
                "(Rayleigh); joints dissipate by themselves.");
    damping_frequencies = optional("Damping frequencies",
                                   text(TextContent::numbers),
                                   "'f1; f2' [Hz]: between them the damping is less than the "
                                   "Damping ratio, outside it is more.");
    second_order        = defaulted(
      "Second order",
      &DynamicsDefinition::second_order,
      choice<SecondOrder>({{"none", SecondOrder::none}, {"weight", SecondOrder::weight}}),
      "Weight: what the weight, and whatever else stresses the bodies when a motion begins, gains "
             "or loses of its arms as the bodies turn acts on them (geometric stiffness): a block that "
             "rocks comes back later, or not at all. Slow stages do not know it.");
    longest_continuation = defaulted(
      "Longest continuation",
      &DynamicsDefinition::longest_continuation,
      number_above(0),
      "For Solver/Beyond limit load = dynamic: bodies that move longer than this [s] have "
      "no new equilibrium, and the run ends with the limit load.");
    defaulted("Excess load",
              &DynamicsDefinition::excess,
              number_between(0, false, 1),
              "For the same: the bodies move under the loads that act this part of a stage after "
              "the limit load, but before the middle between it and the end of its stage.");
  }


  EarthquakeEntries::EarthquakeEntries()
    : SectionDeclaration(
        "Earthquake",
        "The ground moves as accelerograms say from the beginning of a stage with a "
        "Duration. Displacements are relative to the ground.")
  {
    stage =
      optional("Stage", text(), "Name of the stage; without it the only one with a Duration.");
    decided = Decides::path;
    for (const char axis : {'x', 'y', 'z'})
      records[static_cast<std::size_t>(axis - 'x')] = optional(
        fmt::format("Record {}", axis),
        text(),
        fmt::format("File with the acceleration of the ground along {}, relative to this file.",
                    axis));
    format = optional(
      "Record format",
      choice<RecordFormat>({{"columns", RecordFormat::columns}, {"at2", RecordFormat::at2}}),
      "Columns of numbers, with comments from # on; or a file .AT2 of the PEER data base. Without "
      "this entry by the end of the name.");
    time_column = defaulted(
      "Time column",
      "1",
      integer(0, 1000),
      "Number of the column with the times, which go in equal steps; the first one is the "
      "beginning of the stage. 0: there is none.");
    acceleration_column =
      defaulted("Acceleration column", "2", integer(1, 1000), "Number of the column.");
    record_step = optional(
      "Record step", number_above(0), "Step of the samples [s] where there is no column of times.");
    unit     = defaulted("Record unit",
                     "g",
                     choice<RecordUnit>({{"g", RecordUnit::g}, {"length/s^2", RecordUnit::length}}),
                     "Length/s^2: in the unit of length of this file, [m/s^2].");
    scale    = defaulted("Scale", "1", any_number(), "Factor of the records.");
    baseline = defaulted(
      "Baseline",
      &DynamicsDefinition::baseline,
      choice<Baseline>(
        {{"warn", Baseline::warn}, {"keep", Baseline::keep}, {"parabolic", Baseline::parabolic}}),
      "What to do about a record that ends with a velocity or far from where it began: a warning; "
      "nothing; or a parabola in time is taken off the acceleration, so that the integral of the "
      "square of the velocity is smallest.");
    decided        = Decides::condensation;
    compliant_base = optional(
      "Compliant base",
      text(),
      "List of horizontal boundaries through which the record comes up as a wave, "
      "while waves from above leave there: they are absorbing. Displacements are absolute then. "
      "Without this entry the base is rigid: supports move with the ground, and displacements are "
      "relative to it.");
    motion =
      optional("Record motion",
               choice<RecordMotion>(
                 {{"outcrop", RecordMotion::outcrop}, {"upward wave", RecordMotion::upward_wave}}),
               "Needed for a Compliant base: whether the record is the motion of a free surface of "
               "the rock that begins there, which is twice the wave that comes up, or that wave.");
    free_field = optional("Free field",
                          text(),
                          "List of vertical boundaries, the sides of the model, beside which "
                          "horizontally layered ground moves as a column without the structure: "
                          "they are absorbing for what differs from that.");
    added_mass = optional("Added mass boundaries",
                          text(),
                          "List of boundaries with which water moves: 7/8 (Added mass unit "
                          "weight)/g sqrt(H d) per area along the normal at the depth d, H that of "
                          "the bottom (Westergaard).");
    level =
      optional("Added mass level", any_number(), "y (in space z) of the surface of the water [m].");
    bottom      = optional("Added mass bottom", any_number(), "y (in space z) of the bottom [m].");
    unit_weight = optional("Added mass unit weight", number_above(0), "Of the water [MN/m^3].");
  }
} // namespace fuga
