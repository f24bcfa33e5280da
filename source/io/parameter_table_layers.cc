// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/layer_law.h>
#include <fuga/io/parameter_entries.h>
#include <fuga/laws/power_law.h>

#include <fmt/format.h>

namespace fuga
{
  using namespace parameter_entries;

  namespace
  {
    Pattern
    law_choice(const LayerDirection direction)
    {
      std::string words;
      for (const std::string &word : law_words(direction))
        words += (words.empty() ? "" : "|") + word;
      return choice(words);
    }

    /** The entries that both directions have; @p deformation is "closure" or "jump". */
    std::vector<EntryDeclaration>
    curve_entries(const LayerDirection direction, const std::string &deformation)
    {
      const std::string word = direction_word(direction);
      const bool normal      = direction == LayerDirection::normal;
      return {
        optional(
          fmt::format("{} reference {}", word, deformation),
          number_above(0),
          fmt::format("A {} w_r [m] at which the stress is {} reference stress; for the power "
                      "law{}.",
                      deformation,
                      word,
                      normal ? ", and c0 of the exponential law" : "")),
        optional(
          word + " reference stress",
          number_above(0),
          fmt::format("The stress there [MPa]{}.", normal ? "; p0 of the exponential law" : "")),
        optional(word + " exponent",
                 number_in(PowerLaw::smallest_exponent, PowerLaw::largest_exponent),
                 "m of the power law. Near w = 0 a polynomial leads smoothly to the origin: below "
                 "w_r max(10^(-3/|m-1|), 0.001 or for m < 1 0.000001)."),
        optional(word + " table",
                 text(),
                 fmt::format("Points of the tabular law, '0: 0; w: stress; ...' [m: MPa], both "
                             "columns growing; beyond the last point a straight line and a "
                             "warning. w is the {}.",
                             normal ? "closure" : "elastic shear jump")),
        optional(word + " interpolation",
                 choice("monotone spline|piecewise linear"),
                 "Of the table; without this entry monotone spline. Corners of straight lines are "
                 "rounded by parabolas over 5 % of the shorter interval."),
        optional(word + " stress expression",
                 text(),
                 fmt::format("Expression law: the stress [MPa] as a function of the {} w [m], 0 at "
                             "w = 0 and growing.",
                             normal ? "closure" : "elastic shear jump")),
        optional(word + " tangent expression",
                 text(),
                 "Expression law: its derivative by w [MPa/m], positive and finite.")};
    }

    std::vector<EntryDeclaration>
    compliance_entries(const LayerDirection direction,
                       const std::string &first,
                       const std::string &rigid)
    {
      const std::string word = direction_word(direction);
      return {
        optional(word + " compliance",
                 number_from(0),
                 fmt::format("{} [m/MPa] of a linear{} law, at w = 0; 0 = exactly "
                             "rigid. Either this or {} stiffness; neither for {}.",
                             first,
                             direction == LayerDirection::normal
                               ? ", cubic root (tangent) or hyperbolic"
                               : " or cubic root (tangent)",
                             word,
                             rigid),
                 {"1.25e-4"}),
        optional(word + " stiffness",
                 number_above(0),
                 fmt::format("{} [MPa/m], in place of the compliance.",
                             direction == LayerDirection::normal ? "Pressure per closure"
                                                                 : "Shear stress per shear jump"))};
    }
  } // namespace

  std::vector<EntryDeclaration>
  parameter_entries::layer_entries()
  {
    std::vector<EntryDeclaration> result;
    const auto add = [&result](const std::vector<EntryDeclaration> &entries) {
      result.insert(result.end(), entries.begin(), entries.end());
    };
    add({defaulted(
      "Normal law",
      "linear",
      law_choice(LayerDirection::normal),
      "Pressure against closure w. Cubic root: law (9) as a secant, w/(rho (1 - q)) with q = "
      "(w/Thickness)^(1/3). Cubic root tangent: law (9) as a tangent, 1/(rho (1 - q)), "
      "so 3 Thickness/rho (-ln(1 - q) - q - q^2/2). "
      "Hyperbolic: w/(rho (1 - w/limit)). Exponential: p0 exp(-ln(100) (1 - w/c0)), "
      "that of CalculiX; the lips touch, and w begins, at the clearance c0, so the "
      "initial gap is counted from there; a cubic leads from 0 to the formula up to "
      "w = c0/20. Power: stress (w/w_r)^m. Tabular, expression: see the entries.")});
    add(compliance_entries(
      LayerDirection::normal, "Closure per pressure", "a rigid law and the other laws"));
    add({optional("Normal closure limit",
                  number_above(0),
                  "Closure that no stress reaches [m]: for the hyperbolic law, and for an "
                  "expression that has one.")});
    add(curve_entries(LayerDirection::normal, "closure"));
    add({defaulted("Shear law",
                   "linear",
                   law_choice(LayerDirection::shear),
                   "Shear stress against elastic shear jump.")});
    add(compliance_entries(LayerDirection::shear,
                           "Shear jump per shear stress",
                           "a rigid law, the other laws or without friction"));
    add(curve_entries(LayerDirection::shear, "jump"));
    add({optional("Thickness",
                  number_above(0),
                  "Thickness of the layer [m]; the cubic root laws need it, the output shows "
                  "Thickness/compliance with it.",
                  {"0.002"})});
    return result;
  }
} // namespace fuga
