// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_entries.h>

namespace fuga
{
  using namespace parameter_entries;

  SectionDeclaration
  parameter_entries::solver_section()
  {
    return {
      "Solver",
      "Rigid and linear laws need no iteration: the entries on iterations are for other laws.",
      {defaulted(
         "Follow",
         "events",
         choice("events|stage ends"),
         "Stage ends: one implicit step per stage without the events between, where layers are "
         "linear and nothing can break. The same end state if what slips or opens in a stage "
         "keeps "
         "doing so; energies and events are not known then."),
       defaulted(
         "Bodies",
         "automatic",
         choice("automatic|direct|direct on disk|iterative|iterative matrix-free"),
         "How the bodies are eliminated. Direct: one factorisation. On disk: its factor lies in "
         "temporary files (TMPDIR) and takes half of the memory. Iterative: conjugate gradients "
         "with "
         "algebraic multigrid, for models whose factor does not fit into memory. Matrix-free: "
         "without the stiffness of the interface as well, for Follow = stage ends and linear "
         "layers. Automatic: by an estimate of time, and of memory against that of the machine, "
         "free or not."),
       defaulted(
         "Non-unique",
         "stop",
         choice("stop|first|largest dissipation"),
         "What to do where friction is beyond its critical value and the joints can go on in "
         "several ways: stop with a verdict that says where, or follow the first "
         "continuation found, or the one that dissipates most."),
       defaulted("Beyond limit load",
                 "stop",
                 choice("stop|arc length"),
                 "Arc length: goes on beyond a limit load, where the load stays or falls while the "
                 "mechanism moves. For rigid and linear layers."),
       defaulted("Largest jump beyond limit",
                 "0",
                 number_from(0),
                 "Growth of the largest jump beyond the limit load at which the run ends. 0: ten "
                 "times the largest jump at the limit load."),
       defaulted("Iteration",
                 "newton",
                 choice("newton|constant stiffness"),
                 "Constant stiffness is the iteration of the paper; it can diverge."),
       defaulted("Iteration tolerance",
                 "1e-12",
                 number_above(0),
                 "Relative change at which an iteration ends."),
       defaulted("Maximum iterations", "200", integer(1, 1e6), "Of one step."),
       defaulted(
         "Load knots",
         "20",
         integer(1, 1e6),
         "Linear pieces per stage for factors and loads that are not linear in t. Between knots "
         "loads are interpolated; the log says how well. Corners of a level, and levels at "
         "which horizontal boundaries get wet, are knots as well."),
       defaulted("Certificate bound",
                 "1e-9",
                 number_above(0),
                 "A larger certificate ends the run with exit code 4.")},
      {}};
  }

  SectionDeclaration
  parameter_entries::safety_section()
  {
    return {
      "Safety",
      "Factors of safety, found exactly by events, each from the state at the end of the stages. "
      "Without an entry nothing is computed.",
      {defaulted(
         "Strength reduction",
         "no",
         choice("no|yes"),
         "Friction, cohesion and tensile strength are divided by a factor that grows from 1 "
         "until equilibrium is lost; loads stand still."),
       optional("Joints", text(), "List of the joints that are reduced; without it all."),
       optional("Load factor",
                text(),
                "List of loads, or of stages whose loads are meant: they grow in proportion, by a "
                "factor from 1 on, until equilibrium is lost; the other loads stand still."),
       defaulted("Largest factor", "10", number_above(1), "Where a search ends without result.")},
      {}};
  }

  SectionDeclaration
  parameter_entries::sweep_section()
  {
    const auto older = [](const std::string &name) {
      return optional(name,
                      text(),
                      "Older form of the line Joints/*/" + name + ", or Joints/NAMES/" + name +
                        " with the NAMES of the entry Joints.");
    };
    return {
      "Sweep",
      "Runs variants of the file and writes one table of them, sweep.csv (doc/sweeps.md). A line "
      "'set SECTION/ENTRY = values' or 'set SECTION/NAME/ENTRY = values' varies any entry of the "
      "file; several NAMES are separated by commas, and * stands for all. Values are a, b, c, or "
      "a | b | c where they contain commas, or a range first : step : last; numbers may be "
      "expressions of constants. For example: set Joints/base/Friction angle = 30, 35, 40.",
      {defaulted(
         "Combination",
         "all",
         choice("all|in step"),
         "Of several lines: all combinations of their values, the first line varying slowest; "
         "or the first values of all lines, the second ones and so on."),
       optional(
         "Stages",
         text(),
         "Varies the order of the stages: sequences of their names, separated by '|', such as "
         "weight, push | weight, push, back."),
       optional("Joints", text(), "For the older forms below: list of the joints; without it all."),
       older("Friction coefficient"),
       older("Cohesion"),
       older("Normal compliance"),
       older("Shear compliance"),
       older("Normal law"),
       optional("Load sequences", text(), "Older form of Stages, separated by ';'.")},
      {}};
  }

  SectionDeclaration
  parameter_entries::monitors_section()
  {
    return {"Monitors",
            "One subsection per point whose displacement (and stress) is written to monitors.csv, "
            "with a name of your choice.",
            {required("Point",
                      text(),
                      "Coordinates x, y of a point in a body, or the name of a point of the mesh.",
                      {"0, 12"}),
             optional(
               "Body", text(), "For a point on a joint or between bodies: the body that is meant."),
             defaulted("Stress",
                       "false",
                       choice("true|false"),
                       "True: the stress too; at nodes and faces the mean of the cells of the body "
                       "around the point.")},
            {"crest"}};
  }

  SectionDeclaration
  parameter_entries::output_section()
  {
    return {
      "Output",
      "",
      {defaulted("Fields", "levels", choice("levels|end|never"), "When VTU files are written."),
       defaulted("Monitors",
                 "levels",
                 choice("levels|events"),
                 "When the displacements of the monitors are written; events: at levels and at "
                 "every event."),
       defaulted("Checkpoint",
                 "levels",
                 choice("levels|events|every event|never"),
                 "When the file is written from which --restart continues. Events: levels, and "
                 "events as often as a hundredth of the run time allows."),
       defaulted("Log",
                 "events",
                 choice("events|levels|quiet"),
                 "What gets a line on the screen; quiet: nothing."),
       defaulted("Report",
                 "false",
                 choice("true|false"),
                 "True: at the end report.html and report_short.html are made, as by "
                 "'fuga report DIR'."),
       defaulted("Force unit",
                 "MN",
                 text(),
                 "Name of the unit of force, for the headers of the results only."),
       defaulted("Length unit",
                 "m",
                 text(),
                 "Name of the unit of length, for the headers of the results only.")},
      {}};
  }
} // namespace fuga
