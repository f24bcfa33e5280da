// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_entries.h>

namespace fuga
{
  using namespace parameter_entries;

  SectionDeclaration
  parameter_entries::accuracy_section()
  {
    return {
      "Target accuracy",
      "The program refines the mesh where it matters until an estimate of the error is small "
      "enough: "
      "every mesh is compared with the same one refined once more (doc/theory.md, section 14). The "
      "results are those of the last mesh; the log, summary.json and refinement.csv give the "
      "estimates.",
      {defaulted("Quantity",
                 "none",
                 choice("none|contact pressure|resultant|monitor"),
                 "What is to be accurate; none: the mesh remains as it is."),
       defaulted("Relative error",
                 "0.01",
                 number_between(0, false, 1),
                 "The target: largest error at any load level (of a pressure: root of its mean "
                 "square over the area) relative to the largest value at any."),
       optional(
         "Joints",
         text(),
         "For contact pressure and resultant: list of the joints that count; without it all."),
       optional("Where",
                text(),
                "For contact pressure: expression of x, y (in space x, y, z); only places count "
                "where it is not 0. "
                "Without it all; but at the edge of a stiff body the pressure has no limit, and no "
                "mesh gives it accurately. For example abs(x) <= 0.9."),
       optional(
         "Monitors", text(), "For monitor: list of the monitors that count; without it all."),
       optional(
         "Components",
         text(),
         "For resultant: list out of N, T, M, in space T2, M1, Mn too; without it N, T, T2. For "
         "monitor: list out of x, y, z; without it all."),
       defaulted(
         "Largest number of unknowns",
         "1000000",
         number_from(1),
         "No mesh with more degrees of freedom is computed; those that are refined once more "
         "count."),
       defaulted("Largest number of rounds",
                 "20",
                 integer(1, 1000),
                 "Of estimating, with refinements between.")},
      {}};
  }
} // namespace fuga
