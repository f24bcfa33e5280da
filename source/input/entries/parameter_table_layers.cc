// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>
#include <fuga/laws/power_law.h>

namespace fuga
{
  using namespace parameter_patterns;

  void
  LayerEntries::declare(SectionDeclaration &section, const LayerDirection direction)
  {
    const bool normal         = direction == LayerDirection::normal;
    const std::string word    = normal ? "Normal " : "Shear ";
    const char *const jump    = normal ? "closure" : "jump";
    const char *const measure = normal ? "closure" : "elastic shear jump";

    law = section.defaulted(
      word + "law",
      normal ? &JointParameters::normal_law : &JointParameters::shear_law,
      choice(law_words(direction)),
      normal
        ? "Pressure against closure w. Cubic root: law (9) as a secant, w/(rho (1 - q)) with q = "
          "(w/Thickness)^(1/3). Cubic root tangent: law (9) as a tangent, 1/(rho (1 - q)), "
          "so 3 Thickness/rho (-ln(1 - q) - q - q^2/2). "
          "Hyperbolic: w/(rho (1 - w/limit)). Exponential: p0 exp(-ln(100) (1 - w/c0)), "
          "that of CalculiX; the lips touch, and w begins, at the clearance c0, so the "
          "initial gap is counted from there; a cubic leads from 0 to the formula up to "
          "w = c0/20. Power: stress (w/w_r)^m. Tabular, expression: see the entries."
        : "Shear stress against elastic shear jump.");
    compliance = section.optional(
      word + "compliance",
      number_from(0),
      fmt::format("{} [m/MPa] of a linear{} law, at w = 0; 0 = exactly "
                  "rigid. Either this or {}stiffness; neither for {}.",
                  normal ? "Closure per pressure" : "Shear jump per shear stress",
                  normal ? ", cubic root (tangent) or hyperbolic" : " or cubic root (tangent)",
                  word,
                  normal ? "a rigid law and the other laws"
                         : "a rigid law, the other laws or without friction"),
      {"1.25e-4"});
    stiffness =
      section
        .optional(word + "stiffness",
                  number_above(0),
                  fmt::format("{} [MPa/m], in place of the compliance.",
                              normal ? "Pressure per closure" : "Shear stress per shear jump"))
        .instead_of(compliance);
    if (normal)
      closure_limit =
        section.optional(word + "closure limit",
                         number_above(0),
                         "Closure that no stress reaches [m]: for the hyperbolic law, and for an "
                         "expression that has one.");
    reference_deformation = section.optional(
      fmt::format("{}reference {}", word, jump),
      number_above(0),
      fmt::format("A {} w_r [m] at which the stress is {}reference stress; for the power "
                  "law{}.",
                  jump,
                  word,
                  normal ? ", and c0 of the exponential law" : ""));
    reference_stress = section.optional(
      word + "reference stress",
      number_above(0),
      fmt::format("The stress there [MPa]{}.", normal ? "; p0 of the exponential law" : ""));
    exponent = section.optional(
      word + "exponent",
      number_in(PowerLaw::smallest_exponent, PowerLaw::largest_exponent),
      "m of the power law. Near w = 0 a polynomial leads smoothly to the origin: below "
      "w_r max(10^(-3/|m-1|), 0.001 or for m < 1 0.000001).");
    table = section.optional(
      word + "table",
      text(TextContent::numbers),
      fmt::format("Points of the tabular law, '0: 0; w: stress; ...' [m: MPa], both "
                  "columns growing; beyond the last point a straight line and a "
                  "warning. w is the {}.",
                  measure));
    interpolation = section.optional(
      word + "interpolation",
      choice<TableInterpolation>({{"monotone spline", TableInterpolation::monotone_spline},
                                  {"piecewise linear", TableInterpolation::piecewise_linear}}),
      "Of the table; without this entry monotone spline. Corners of straight lines are "
      "rounded by parabolas over 5 % of the shorter interval.");
    stress_expression = section.optional(
      word + "stress expression",
      text(),
      fmt::format("Expression law: the stress [MPa] as a function of the {} w [m], 0 at "
                  "w = 0 and growing.",
                  measure));
    tangent_expression =
      section.optional(word + "tangent expression",
                       text(),
                       "Expression law: its derivative by w [MPa/m], positive and finite.");
  }
} // namespace fuga
