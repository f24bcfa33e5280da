// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>

namespace fuga
{
  using namespace parameter_patterns;

  namespace
  {
    Pattern<BodySolver>
    body_solvers()
    {
      Words<BodySolver> words;
      for (const BodySolver solver : {BodySolver::automatic,
                                      BodySolver::direct,
                                      BodySolver::direct_on_disk,
                                      BodySolver::iterative,
                                      BodySolver::matrix_free})
        words.emplace_back(name_of(solver), solver);
      return choice(words);
    }
  } // namespace


  SolverEntries::SolverEntries()
    : SectionDeclaration(
        "Solver",
        "Rigid and linear laws need no iteration: the entries on iterations are for other laws.")
  {
    follow = defaulted(
      "Follow",
      &SolverSettings::follow_events,
      choice<bool>({{"events", true}, {"stage ends", false}}),
      "Stage ends: one implicit step per stage without the events between. The same end state if "
      "what slips or opens in a stage keeps doing so, in one direction; energies and events are "
      "not known then.");
    bodies = defaulted(
      "Bodies",
      &ModelDefinition::body_solver,
      body_solvers(),
      "How the bodies are eliminated. Direct: one factorisation. On disk: its factor lies in "
      "temporary files (TMPDIR) and takes half of the memory. Iterative: conjugate gradients with "
      "algebraic multigrid, for models whose factor does not fit into memory. Matrix-free: "
      "without the stiffness of the interface as well, for Follow = stage ends. Automatic: by an "
      "estimate of time, and of memory against that of the "
      "machine, free or not.");
    defaulted(
      "Non-unique",
      &SolverSettings::non_unique,
      choice<NonUniqueChoice>({{"stop", NonUniqueChoice::stop},
                               {"first", NonUniqueChoice::first},
                               {"largest dissipation", NonUniqueChoice::largest_dissipation}}),
      "What to do where friction is beyond its critical value and the joints can go on in "
      "several ways: stop with a verdict that says where, or follow the first "
      "continuation found, or the one that dissipates most.");
    defaulted(
      "No continuation",
      &SolverSettings::follow_jumps,
      choice<bool>({{"stop", false}, {"jump", true}}),
      "What to do where no continuous path goes on although there is an equilibrium near by: "
      "stop with a verdict that names it, or jump there and go on, also where a path cannot be "
      "computed any further. Energies are not known after a jump. A limit load, where no "
      "equilibrium is near, ends the run anyway.");
    beyond_limit = defaulted(
      "Beyond limit load",
      &SolverSettings::beyond_limit,
      choice<LimitLoadChoice>({{"stop", LimitLoadChoice::stop},
                               {"arc length", LimitLoadChoice::arc_length},
                               {"dynamic", LimitLoadChoice::dynamic}}),
      "Arc length: goes on beyond a limit load, where the load stays or falls while the "
      "mechanism moves. For rigid and linear layers of straight strength. Dynamic: beyond a limit "
      "load, and "
      "where there is no continuation, the bodies move with their inertia under loads that "
      "stand still; where they come to rest the loads go on (doc/dynamics.md).");
    defaulted("Largest jump beyond limit",
              &SolverSettings::beyond_jump,
              number_from(0),
              "Growth of the largest jump beyond the limit load at which the run ends. 0: ten "
              "times the largest jump at the limit load.");
    defaulted("Iteration",
              &SolverSettings::iteration,
              choice<IterationKind>({{"newton", IterationKind::newton},
                                     {"constant stiffness", IterationKind::constant_stiffness}}),
              "Constant stiffness is the iteration of the paper; it can diverge.");
    defaulted("Iteration tolerance",
              &SolverSettings::iteration_tolerance,
              number_above(0),
              "Relative change at which an iteration ends.");
    defaulted(
      "Maximum iterations", &SolverSettings::maximum_iterations, integer(1, 1e6), "Of one step.");
    defaulted(
      "Load knots",
      &ModelDefinition::load_knots,
      integer(1, 1e6),
      "Linear pieces per stage for factors and loads that are not linear in t; a stage with a "
      "Duration has its time steps instead. Between knots "
      "loads are interpolated; the log says how well. Corners of a level, and levels at "
      "which horizontal boundaries get wet, are knots as well.");
    defaulted("Certificate bound",
              &SolverSettings::certificate_bound,
              number_above(0),
              "A larger certificate ends the run with exit code 4.")
      .deciding(Decides::nothing);
  }


  SafetyEntries::SafetyEntries()
    : SectionDeclaration(
        "Safety",
        "Factors of safety, found exactly by events, each from the state at the end of the stages. "
        "Without an entry nothing is computed.")
  {
    strength_reduction =
      defaulted("Strength reduction",
                "no",
                choice<bool>({{"no", false}, {"yes", true}}),
                "Friction, cohesion and tensile strength are divided by a factor that grows from 1 "
                "until equilibrium is lost; loads stand still.");
    joints = optional("Joints", text(), "List of the joints that are reduced; without it all.");
    load_factor =
      optional("Load factor",
               text(),
               "List of loads, or of stages whose loads are meant: they grow in proportion, by a "
               "factor from 1 on, until equilibrium is lost; the other loads stand still.");
    largest_factor =
      defaulted("Largest factor", "10", number_above(1), "Where a search ends without result.");
  }


  SweepEntries::SweepEntries()
    : SectionDeclaration(
        "Sweep",
        "Runs variants of the file and writes one table of them, sweep.csv (doc/sweeps.md). A line "
        "'set SECTION/ENTRY = values' or 'set SECTION/NAME/ENTRY = values' varies any entry of the "
        "file; several NAMES are separated by commas, and * stands for all. Values are a, b, c, or "
        "a | b | c where they contain commas, or a range first : step : last; numbers may be "
        "expressions of constants. For example: set Joints/base/Friction angle = 30, 35, 40.")
  {
    combination = defaulted(
      "Combination",
      "all",
      choice<bool>({{"all", false}, {"in step", true}}),
      "Of several lines: all combinations of their values, the first line varying slowest; "
      "or the first values of all lines, the second ones and so on.");
    stages = optional(
      "Stages",
      text(),
      "Varies the order of the stages: sequences of their names, separated by '|', such as "
      "weight, push | weight, push, back.");
    joints =
      optional("Joints", text(), "For the older forms below: list of the joints; without it all.");
    const JointEntries &joint = entries_of<JointEntries>();
    for (const AnyEntry &entry : std::vector<AnyEntry>{joint.friction_coefficient,
                                                       joint.cohesion,
                                                       joint.normal.compliance,
                                                       joint.shear.compliance,
                                                       joint.normal.law})
      older.push_back(optional(
        entry.name(),
        text(),
        fmt::format(
          "Older form of the line {0}/*/{1}, or {0}/NAMES/{1} with the NAMES of the entry {2}.",
          joint.name,
          entry.name(),
          joints.name())));
    load_sequences = optional("Load sequences", text(), "Older form of Stages, separated by ';'.");
  }


  AccuracyEntries::AccuracyEntries()
    : SectionDeclaration(
        "Target accuracy",
        "The program refines the mesh where it matters until an estimate of the error is small "
        "enough: "
        "every mesh is compared with the same one refined once more (doc/theory.md, section 14). "
        "The "
        "results are those of the last mesh; the log, summary.json and refinement.csv give the "
        "estimates.")
  {
    quantity = defaulted(
      "Quantity",
      &AccuracyTarget::quantity,
      choice<AccuracyTarget::Quantity>({{"none", AccuracyTarget::Quantity::none},
                                        {"contact pressure", AccuracyTarget::Quantity::pressure},
                                        {"resultant", AccuracyTarget::Quantity::resultant},
                                        {"monitor", AccuracyTarget::Quantity::monitor}}),
      "What is to be accurate; none: the mesh remains as it is.");
    defaulted("Relative error",
              &AccuracyTarget::relative_error,
              number_between(0, false, 1),
              "The target: largest error at any load level (of a pressure: root of its mean "
              "square over the area) relative to the largest value at any.");
    joints = optional(
      "Joints",
      text(),
      "For contact pressure and resultant: list of the joints that count; without it all.");
    where =
      optional("Where",
               text(),
               "For contact pressure: expression of x, y (in space x, y, z); only places count "
               "where it is not 0. "
               "Without it all; but at the edge of a stiff body the pressure has no limit, and no "
               "mesh gives it accurately. For example abs(x) <= 0.9.");
    monitors =
      optional("Monitors", text(), "For monitor: list of the monitors that count; without it all.");
    components = optional(
      "Components",
      text(),
      "For resultant: list out of N, T, M, in space T2, M1, Mn too; without it N, T, T2. For "
      "monitor: list out of x, y, z; without it all.");
    defaulted("Largest number of unknowns",
              &AccuracyTarget::max_unknowns,
              number_from(1),
              "No mesh with more degrees of freedom is computed; those that are refined once more "
              "count.");
    defaulted("Largest number of rounds",
              &AccuracyTarget::max_rounds,
              integer(1, 1000),
              "Of estimating, with refinements between.");
  }


  MonitorEntries::MonitorEntries()
    : SectionDeclaration(
        "Monitors",
        "One subsection per point whose displacement (and stress) is written to monitors.csv, "
        "with a name of your choice.",
        {"crest"})
  {
    point = required("Point",
                     text(TextContent::numbers),
                     "Coordinates x, y of a point in a body, or the name of a point of the mesh.",
                     {"0, 12"});
    body  = optional("Body",
                    &MonitorDefinition::body,
                    text(),
                    "For a point on a joint or between bodies: the body that is meant.");
    defaulted("Stress",
              &MonitorDefinition::stress,
              choice<bool>({{"true", true}, {"false", false}}),
              "True: the stress too; at nodes and faces the mean of the cells of the body "
              "around the point.");
  }


  OutputEntries::OutputEntries() : SectionDeclaration("Output", "")
  {
    defaulted("Fields",
              &OutputSettings::fields,
              choice<FieldOutput>({{"levels", FieldOutput::levels},
                                   {"end", FieldOutput::end},
                                   {"never", FieldOutput::never}}),
              "When VTU files are written.")
      .deciding(Decides::nothing);
    field_interval =
      optional(
        "Field interval",
        &OutputSettings::field_interval,
        number_above(0),
        "Time between two VTU files of bodies in motion [s], besides those of the levels: in "
        "stages with a Duration, and in motions beyond a limit load; they have velocities, and the "
        "end of the motion is among them.")
        .deciding(Decides::nothing);
    defaulted(
      "Monitors",
      &OutputSettings::monitors,
      choice<MonitorOutput>({{"levels", MonitorOutput::levels}, {"events", MonitorOutput::events}}),
      "When the displacements of the monitors are written; events: at levels and at "
      "every event.");
    spectra = defaulted(
      "Response spectra",
      &SpectrumSettings::wanted,
      choice<bool>({{"true", true}, {"false", false}}),
      "True: of every stage with a Duration accelerations.csv has the absolute accelerations of "
      "the monitors, with that of the ground, and spectra.csv the response spectra of these.");
    defaulted("Spectrum damping",
              &SpectrumSettings::damping,
              number_between(0, true, 1),
              "Share of the critical damping of the oscillators.");
    spectrum_periods = optional("Spectrum periods",
                                text(TextContent::numbers),
                                "List 'T1, T2, ...' of the periods of the oscillators [s]; without "
                                "it 100 from 0.02 s to 5 s in equal ratios.");
    defaulted("Checkpoint",
              &OutputSettings::checkpoint,
              choice<CheckpointOutput>({{"levels", CheckpointOutput::levels},
                                        {"events", CheckpointOutput::events},
                                        {"every event", CheckpointOutput::every_event},
                                        {"never", CheckpointOutput::never}}),
              "When the file is written from which --restart continues. Events: levels, and "
              "events as often as a hundredth of the run time allows.")
      .deciding(Decides::nothing);
    defaulted("Log",
              &OutputSettings::log,
              choice<LogDetail>({{"events", LogDetail::events},
                                 {"levels", LogDetail::levels},
                                 {"quiet", LogDetail::quiet}}),
              "What gets a line on the screen; quiet: nothing.")
      .deciding(Decides::nothing);
    defaulted("Report",
              &OutputSettings::report,
              choice<bool>({{"true", true}, {"false", false}}),
              "True: at the end report.html and report_short.html are made, as by "
              "'fuga report DIR'.")
      .deciding(Decides::nothing);
    force_unit = defaulted("Force unit",
                           &Units::force,
                           text(),
                           "Name of the unit of force, for the headers of the results only.");
    length_unit =
      defaulted("Length unit",
                &Units::length,
                text(),
                "Name of the unit of length, for the headers of the results and for g.");
  }
} // namespace fuga
