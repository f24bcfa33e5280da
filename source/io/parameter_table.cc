// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_entries.h>

namespace fuga
{
  using namespace parameter_entries;

  namespace
  {
    SectionDeclaration
    top_level()
    {
      return {"",
              "",
              {defaulted("Title", "", text(), "One line for the output."),
               defaulted("Dimension",
                         "2",
                         integer(2, 3),
                         "2 = plane problems (and bodies of revolution), y upwards; 3 = space, z "
                         "upwards. That of the mesh."),
               defaulted("Output directory",
                         "",
                         text(),
                         "Relative to this file; empty: results/NAME-OF-THIS-FILE in the current "
                         "directory.")},
              {}};
    }

    SectionDeclaration
    mesh_section()
    {
      return {
        "Mesh",
        "The mesh. Units are free, but must be the same everywhere (for example MN, m, MPa).",
        {required("File",
                  text(),
                  "Gmsh .msh file (2.2 or 4.1, text, named physical groups), relative to this "
                  "file.",
                  {"mesh.msh"}),
         defaulted("Polynomial degree",
                   "1",
                   integer(1, 3),
                   "Degree of the elements: 1 or 2 on triangles, 1 on tetrahedra."),
         defaulted("Refinements", "0", integer(0, 8), "Global refinements of the mesh."),
         defaulted(
           "Assumption",
           "plane strain",
           choice("plane strain|plane stress|axisymmetric"),
           "What is assumed across the plane. Axisymmetric: x is the radius, y the axis; "
           "areas, forces and resultants are those of the full circle, and the axis is held "
           "in x. Not in space."),
         defaulted("Thickness",
                   "1",
                   number_above(0),
                   "Extent across the plane [m]; not for axisymmetric, not in space.")},
        {}};
    }

    SectionDeclaration
    bodies_section()
    {
      return {
        "Bodies",
        "One subsection per body: the name of a physical group of cells.",
        {required("Young modulus", number_above(0), "E of the body [MPa].", {"3060", "30600"}),
         required("Poisson ratio",
                  number_between(-1, false, 0.5),
                  "Lateral contraction; nearly incompressible: 0.49, not 0.5.",
                  {"0.2", "0.2"}),
         defaulted("Weight density",
                   "0",
                   number_from(0),
                   "Weight per volume [MN/m^3]; acts only through a load of type weight or "
                   "seismic.",
                   {"0.024", "0"}),
         defaulted("Thermal expansion",
                   "0",
                   number_from(0),
                   "Strain per change of temperature [1/K]; acts only through a load of type "
                   "temperature."),
         optional(
           "Built at stage",
           text(),
           "Stage at whose beginning the body is put, free of stress, where the mesh has it, "
           "upon what is there by then; without this entry it is there from the start. What "
           "acts on it already rises from nothing in this stage."),
         optional("Removed at stage",
                  text(),
                  "Stage at whose beginning the body is taken away; what it carried falls to "
                  "nothing in this stage.")},
        {"structure", "foundation"}};
    }

    std::vector<EntryDeclaration>
    joint_place()
    {
      return {
        optional("Line",
                 text(),
                 "Named line (in space: surface) inside a conforming mesh, along which the mesh is "
                 "opened. Either Line with its two bodies or the two lips.",
                 {"base"}),
        optional("Plus body", text(), "Body into which the normal points.", {"structure"}),
        optional("Minus body", text(), "Body at the other side of Line.", {"foundation"}),
        optional("Plus lip", text(), "Boundary of a mesh which is already open."),
        optional("Minus lip",
                 text(),
                 "Boundary opposite to Plus lip, or the word rigid: a fixed rigid obstacle."),
        defaulted(
          "Corner angle",
          "30",
          number_in(1, 180),
          "Neighbouring faces that meet at more than this [degrees] belong to different "
          "straight parts of the joint (a key, a step): where parts meet, each has an "
          "element of its own, with its own normal and area. 180: no such corners; elements "
          "have the average normal of their faces.")};
    }

    SectionDeclaration
    joints_section()
    {
      SectionDeclaration section{
        "Joints", "One subsection per joint, with a name of your choice.", {}, {"base"}};
      for (const auto &part :
           {joint_place(), layer_entries(), joint_shear_growth_entries(), joint_strength_entries()})
        section.entries.insert(section.entries.end(), part.begin(), part.end());
      return section;
    }

    SectionDeclaration
    boundaries_section()
    {
      return {
        "Boundaries",
        "One subsection per boundary that is held: the name of a physical group of faces (or of "
        "a point).",
        {required("Fixed",
                  text(),
                  "Components held at zero: x or y or all; or the word free: neither support "
                  "nor load.",
                  {"all", "x", "free"})},
        {"bottom", "sides", "crest"}};
    }

    std::vector<EntryDeclaration>
    load_place()
    {
      return {
        required(
          "Type",
          choice("weight|seismic|temperature|pressure|hydrostatic|earth pressure|westergaard|"
                 "uplift|traction|point force|displacement|imposed gap"),
          "Weight of bodies, weight times seismic coefficients, change of temperature, "
          "pressure towards the body, pressure of still water, of earth, of water moved by "
          "an earthquake, of water in a joint, traction vector, force at a point, displacement of "
          "fixed "
          "components, change of the gap of joints by a saw or a jack.",
          {"weight", "pressure"}),
        optional("Bodies",
                 text(),
                 "For weight, seismic, temperature: list of bodies; without it all of them."),
        optional("Boundaries",
                 text(),
                 "For all other types but point force, uplift and imposed gap: list of boundaries.",
                 {"", "upstream"}),
        optional("Point", text(), "For a point force: named point, or coordinates: x, y."),
        optional("Value",
                 text(),
                 "For weight, temperature, pressure, traction, point force, displacement, imposed "
                 "gap: expressions of x, y and the load time t, separated by ';': one for a "
                 "pressure [MPa], temperature [K] or gap [m], else one per component [MPa, MN, m] "
                 "(an empty one leaves a displacement free); the direction of a weight is 0; -1 "
                 "without this entry. A positive gap is sawn off between the lips, a negative one "
                 "is filled in.",
                 {"0; -1", "0.0144"})};
    }

    SectionDeclaration
    loads_section()
    {
      SectionDeclaration section{
        "Loads",
        "One subsection per load pattern, with a name of your choice; stages make it act.",
        load_place(),
        {"weight", "water"}};
      for (const auto &part : {load_depth_and_shaking(), load_uplift()})
        section.entries.insert(section.entries.end(), part.begin(), part.end());
      return section;
    }

    SectionDeclaration
    stages_section()
    {
      return {
        "Stages",
        "One subsection per load stage, in the order in which they happen.",
        {required("Loads",
                  text(),
                  "List 'LOAD: FACTOR; ...', each factor an expression of the stage fraction t "
                  "from 0 to 1. A load that a stage does not name keeps its last factor.",
                  {"weight: t", "water: t"}),
         defaulted("Levels",
                   "1",
                   integer(1, 1e6),
                   "Number of equal steps after which results are written; no influence on "
                   "them.",
                   {"1", "10"}),
         optional("Water in joints",
                  choice("follows opening|unchanged"),
                  "Whether water comes into joints that open in this stage, and goes where they "
                  "close (without this entry), or keeps its pressure, as is usual for "
                  "earthquakes. It follows what has opened meanwhile when the next stage begins."),
         optional("Grouted joints",
                  text(),
                  "List of joints whose open parts are filled at the beginning of the stage: they "
                  "have no gap then, no stress, and all of their strength.")},
        {"weight", "push"}};
    }

    SectionDeclaration
    constants_section()
    {
      return {"Constants",
              "Named numbers: set NAME = NUMBER, or an expression of the constants above it. Where "
              "a number "
              "stands in this file, also in tables and coordinates, an expression of constants may "
              "stand, "
              "for example 0.9*H; the name pi is known.",
              {},
              {},
              true};
    }
  } // namespace


  const std::vector<SectionDeclaration> &
  parameter_declarations()
  {
    static const std::vector<SectionDeclaration> sections = {top_level(),
                                                             mesh_section(),
                                                             bodies_section(),
                                                             joints_section(),
                                                             boundaries_section(),
                                                             loads_section(),
                                                             stages_section(),
                                                             constants_section(),
                                                             solver_section(),
                                                             safety_section(),
                                                             sweep_section(),
                                                             accuracy_section(),
                                                             monitors_section(),
                                                             output_section()};
    return sections;
  }
} // namespace fuga
