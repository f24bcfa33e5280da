// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>

namespace fuga
{
  using namespace parameter_patterns;

  TopLevel::TopLevel() : SectionDeclaration("", "")
  {
    title = defaulted("Title", "", text(), "One line for the output.").deciding(Decides::nothing);
    dimension = defaulted("Dimension",
                          &ModelDefinition::dimension,
                          integer(2, 3),
                          "2 = plane problems (and bodies of revolution), y upwards; 3 = space, z "
                          "upwards. That of the mesh.");
    output_directory =
      defaulted("Output directory",
                "",
                text(),
                "Relative to this file; empty: results/NAME-OF-THIS-FILE in the current "
                "directory.")
        .deciding(Decides::nothing);
  }


  MeshEntries::MeshEntries()
    : SectionDeclaration(
        "Mesh",
        "The mesh. Units are free, but must be the same everywhere (for example MN, m, MPa).")
  {
    file = required("File",
                    text(),
                    "Gmsh .msh file (2.2 or 4.1, text, named physical groups), relative to this "
                    "file.",
                    {"mesh.msh"})
             .deciding(Decides::nothing);
    defaulted("Polynomial degree",
              &ModelDefinition::polynomial_degree,
              integer(1, 3),
              "Degree of the elements: 1 or 2 on triangles, 1 on tetrahedra.");
    defaulted("Refinements",
              &ModelDefinition::refinements,
              integer(0, 8),
              "Global refinements of the mesh.");
    assumption =
      defaulted("Assumption",
                &ModelDefinition::assumption,
                choice<PlaneAssumption>({{"plane strain", PlaneAssumption::plane_strain},
                                         {"plane stress", PlaneAssumption::plane_stress},
                                         {"axisymmetric", PlaneAssumption::axisymmetric}}),
                "What is assumed across the plane. Axisymmetric: x is the radius, y the axis; "
                "areas, forces and resultants are those of the full circle, and the axis is held "
                "in x. Not in space.");
    thickness = defaulted("Thickness",
                          &ModelDefinition::thickness,
                          number_above(0),
                          "Extent across the plane [m]; not for axisymmetric, not in space.");
  }


  BodyEntries::BodyEntries()
    : SectionDeclaration("Bodies",
                         "One subsection per body: the name of a physical group of cells.",
                         {"structure", "foundation"})
  {
    young_modulus = required("Young modulus",
                             &Material::young_modulus,
                             number_above(0),
                             "E of the body [MPa].",
                             {"3060", "30600"});
    poisson_ratio = required("Poisson ratio",
                             &Material::poisson_ratio,
                             number_between(-1, false, 0.5),
                             "Lateral contraction; nearly incompressible: 0.49, not 0.5.",
                             {"0.2", "0.2"});
    weight_density =
      defaulted("Weight density",
                &Material::weight_density,
                number_from(0),
                "Weight per volume [MN/m^3]; acts only through a load of type weight or "
                "seismic.",
                {"0.024", "0"});
    thermal_expansion =
      defaulted("Thermal expansion",
                &Material::thermal_expansion,
                number_from(0),
                "Strain per change of temperature [1/K]; acts only through a load of type "
                "temperature.");
    built_at =
      optional("Built at stage",
               text(),
               "Stage at whose beginning the body is put, free of stress, where the mesh has it, "
               "upon what is there by then; without this entry it is there from the start. What "
               "acts on it already rises from nothing in this stage.");
    removed_at =
      optional("Removed at stage",
               text(),
               "Stage at whose beginning the body is taken away; what it carried falls to "
               "nothing in this stage.");
    initial_velocity = optional(
      "Initial velocity",
      text(TextContent::numbers),
      "Velocity 'vx; vy' (in space 'vx; vy; vz') [m/s] with which the body begins the first "
      "stage that has a Duration; without this entry none.");
  }


  BoundaryEntries::BoundaryEntries()
    : SectionDeclaration(
        "Boundaries",
        "One subsection per boundary that is held: the name of a physical group of faces (or of "
        "a point).",
        {"bottom", "sides", "crest"})
  {
    fixed = required("Fixed",
                     text(),
                     "Components held at zero: x or y or all; or the word free: neither support "
                     "nor load.",
                     {"all", "x", "free"});
  }


  StageEntries::StageEntries()
    : SectionDeclaration("Stages",
                         "One subsection per load stage, in the order in which they happen.",
                         {"weight", "push"})
  {
    loads = required("Loads",
                     text(),
                     "List 'LOAD: FACTOR; ...', each factor an expression of the stage fraction t "
                     "from 0 to 1. A load that a stage does not name keeps its last factor.",
                     {"weight: t", "water: t"});
    defaulted("Levels",
              &StageDefinition::levels,
              integer(1, 1e6),
              "Number of equal steps after which results are written; no influence on "
              "them.",
              {"1", "10"});
    duration =
      optional("Duration",
               &StageDefinition::duration,
               number_above(0),
               "Time that the stage takes [s], t being the fraction of it: inertia acts, by the "
               "weights of the bodies, and the stage is followed as section Dynamics says. Without "
               "this entry loads are slow.");
    water =
      optional("Water in joints",
               &StageDefinition::keeps_water,
               choice<bool>({{"follows opening", false}, {"unchanged", true}}),
               "Whether water comes into joints that open in this stage, and goes where they "
               "close (without this entry), or keeps its pressure, as is usual for "
               "earthquakes. It follows what has opened meanwhile when the next stage begins. "
               "Always unchanged in a stage with a Duration.");
    grouted_joints =
      optional("Grouted joints",
               text(),
               "List of joints whose open parts are filled at the beginning of the stage: they "
               "have no gap then, no stress, and all of their strength.");
  }


  ConstantEntries::ConstantEntries()
    : SectionDeclaration(
        "Constants",
        "Named numbers: set NAME = NUMBER, or an expression of the constants above it. Where "
        "a number "
        "stands in this file, also in tables and coordinates, an expression of constants may "
        "stand, "
        "for example 0.9*H; the name pi is known.",
        {},
        true)
  {
  }


  const std::vector<std::reference_wrapper<const SectionDeclaration>> &
  parameter_declarations()
  {
    static const std::vector<std::reference_wrapper<const SectionDeclaration>> sections = {
      entries_of<TopLevel>(),
      entries_of<MeshEntries>(),
      entries_of<BodyEntries>(),
      entries_of<JointEntries>(),
      entries_of<BoundaryEntries>(),
      entries_of<LoadEntries>(),
      entries_of<StageEntries>(),
      entries_of<DynamicsEntries>(),
      entries_of<EarthquakeEntries>(),
      entries_of<ConstantEntries>(),
      entries_of<SolverEntries>(),
      entries_of<SafetyEntries>(),
      entries_of<SweepEntries>(),
      entries_of<AccuracyEntries>(),
      entries_of<MonitorEntries>(),
      entries_of<OutputEntries>()};
    return sections;
  }
} // namespace fuga
