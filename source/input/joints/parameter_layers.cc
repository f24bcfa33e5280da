// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/joints/joint_readers.h>
#include <fuga/input/syntax/parameter_names.h>
#include <fuga/input/values/value_readers.h>
#include <fuga/laws/law_check.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    struct OwnedEntry
    {
      AnyEntry entry;
      std::vector<LayerLaw> owners;
    };

    /** Return the entries that only some laws use. */
    std::vector<OwnedEntry>
    owned_entries(const LayerEntries &e)
    {
      using L                      = LayerLaw;
      std::vector<OwnedEntry> list = {
        {e.compliance, {L::linear, L::cubic_root, L::cubic_root_tangent, L::hyperbolic}},
        {e.stiffness, {L::linear, L::cubic_root, L::cubic_root_tangent, L::hyperbolic}},
        {e.reference_deformation, {L::exponential, L::power}},
        {e.reference_stress, {L::exponential, L::power}},
        {e.exponent, {L::power}},
        {e.table, {L::tabular}},
        {e.interpolation, {L::tabular}},
        {e.stress_expression, {L::expression}},
        {e.tangent_expression, {L::expression}}};
      if (e.closure_limit.declaration != nullptr)
        list.insert(list.begin() + 2, {e.closure_limit, {L::hyperbolic, L::expression}});
      return list;
    }


    bool
    contains(const std::vector<LayerLaw> &laws, const LayerLaw law)
    {
      return std::find(laws.begin(), laws.end(), law) != laws.end();
    }

    /** Return "'Normal law = power' (file:3)", or the statement that the law is the default. */
    std::string
    law_statement(const ParameterSection &section, const Entry<LayerLaw> &law)
    {
      return fmt::format("'{} = {}' ({})",
                         law.name(),
                         section.text(law),
                         section.given(law) ? section.origin(law) : "the default");
    }


    void
    refuse_foreign_entries(const ParameterSection &section,
                           const LayerEntries &e,
                           const std::vector<LayerLaw> &laws)
    {
      for (const auto &[entry, owners] : owned_entries(e))
        {
          if (!section.given(entry) ||
              std::any_of(owners.begin(), owners.end(), [&laws = laws](const LayerLaw owner) {
                return contains(laws, owner);
              }))
            continue;
          std::string names;
          for (const auto &[word, law] : e.law.words)
            if (contains(owners, law))
              names += (names.empty() ? "" : ", ") + word;
          section.fail(entry,
                       fmt::format("{} does not use this entry. It belongs to the law{} {}. Remove "
                                   "this entry, or choose another law.",
                                   law_statement(section, e.law),
                                   names.find(',') == std::string::npos ? "" : "s",
                                   names));
        }
    }


    /** Read ρ of one direction; a linear law without compliance becomes rigid. */
    double
    read_compliance(const ParameterSection &section,
                    const LayerEntries &e,
                    const bool is_needed,
                    LayerLaw &law)
    {
      refuse_both(section, e.compliance, e.stiffness);
      const bool is_given = section.given(e.compliance) || section.given(e.stiffness);
      if (!is_given && has_compliance_entry(law) && (is_needed || section.given(e.law)))
        section.fail(fmt::format("'{}' or '{}' is missing. Give one of the two; compliance 0, or "
                                 "'{} = rigid', means an exactly rigid joint.",
                                 e.compliance.name(),
                                 e.stiffness.name(),
                                 e.law.name()));
      const double rho = section.given(e.stiffness) ? 1. / section.value(e.stiffness)
                                                    : section.value_or(e.compliance, 0.);
      if (rho == 0. && needs_compliance(law))
        section.fail(
          e.compliance,
          fmt::format("{} needs a compliance > 0. For a rigid joint choose the law rigid.",
                      law_statement(section, e.law)));
      if (law == LayerLaw::linear && rho == 0.)
        law = LayerLaw::rigid;
      // Entries of other laws of a sweep are ignored.
      return has_compliance_entry(law) ? rho : 0.;
    }


    double
    read_number(const ParameterSection &section, const AnyEntry &entry, const std::string &word)
    {
      const std::optional<double> value = number_of_text(word);
      if (!value)
        section.fail(
          entry,
          fmt::format("'{}' is not a number. A table is written 0: 0; w: stress; ... with "
                      "decimal points and without units.",
                      word));
      return *value;
    }

    std::vector<TabularLaw::Point>
    read_table(const ParameterSection &section, const AnyEntry &entry)
    {
      std::vector<TabularLaw::Point> table;
      for (const std::string &pair : split_pieces(section.text(entry), ';'))
        {
          const std::vector<std::string> words = split_pieces(pair, ':');
          if (words.size() != 2)
            section.fail(
              entry,
              fmt::format("'{}' is not a point. A table is written 0: 0; w: stress; ... ", pair));
          const TabularLaw::Point point = {read_number(section, entry, words[0]),
                                           read_number(section, entry, words[1])};
          if (table.empty() && (point.deformation != 0. || point.stress != 0.))
            section.fail(entry, fmt::format("the first point is '{}'. Begin with 0: 0.", pair));
          if (!table.empty() && (point.deformation <= table.back().deformation ||
                                 point.stress <= table.back().stress))
            section.fail(
              entry,
              fmt::format("at w = {:g} the point '{}' is not above the one before, {:g}: "
                          "{:g}. Both columns must grow from point to point.",
                          point.deformation,
                          pair,
                          table.back().deformation,
                          table.back().stress));
          table.push_back(point);
        }
      if (table.size() < 2)
        section.fail(entry, "a table needs a second point after 0: 0.");
      return table;
    }

    /** Return what the law needs besides the entries that are given: "" or a sentence. */
    std::string
    missing_entry(const LayerEntries &e,
                  const LayerLaw law,
                  const double thickness,
                  const double compliance,
                  const LayerCurve &curve)
    {
      const std::string word = law_word(law);
      const auto missing     = [](const AnyEntry &entry, const std::string &why) {
        return fmt::format("'{}' is missing{}", entry.name(), why);
      };
      if ((law == LayerLaw::cubic_root || law == LayerLaw::cubic_root_tangent) && thickness == 0.)
        return missing(entries_of<JointEntries>().thickness,
                       fmt::format(". The {} law needs the thickness of the layer.", word));
      if (needs_compliance(law) && compliance == 0.)
        return missing(e.compliance,
                       fmt::format(": the {} law needs a compliance > 0. For a rigid joint choose "
                                   "the law rigid.",
                                   word));
      if (law == LayerLaw::hyperbolic && curve.closure_limit == 0.)
        return missing(e.closure_limit,
                       ". The hyperbolic law needs the closure that no stress reaches.");
      if (law == LayerLaw::exponential || law == LayerLaw::power)
        for (const AnyEntry &entry : {e.reference_deformation, e.reference_stress})
          if ((entry == e.reference_stress ? curve.reference_stress
                                           : curve.reference_deformation) == 0.)
            return missing(entry, fmt::format(". The {} law needs a point of the curve.", word));
      if (law == LayerLaw::power && curve.exponent == 0.)
        return missing(e.exponent, ". The power law needs it; 1 is a straight line.");
      if (law == LayerLaw::tabular && curve.table.empty())
        return missing(e.table, ". Give the points of the curve: 0: 0; w: stress; ...");
      if (law == LayerLaw::expression && curve.stress_expression.empty())
        return missing(e.stress_expression, ". Give the stress as an expression of w.");
      if (law == LayerLaw::expression && curve.tangent_expression.empty())
        return missing(e.tangent_expression, ". Give the derivative of the stress by w.");
      return "";
    }


    LayerCurve
    read_curve(const ParameterSection &section,
               const LayerEntries &e,
               const std::map<std::string, double> &constants)
    {
      LayerCurve curve;
      if (e.closure_limit.declaration != nullptr)
        curve.closure_limit = section.value_or(e.closure_limit, 0.);
      curve.reference_deformation = section.value_or(e.reference_deformation, 0.);
      curve.reference_stress      = section.value_or(e.reference_stress, 0.);
      curve.exponent              = section.value_or(e.exponent, 0.);
      if (section.given(e.table))
        curve.table = read_table(section, e.table);
      curve.interpolation      = section.value(e.interpolation);
      curve.stress_expression  = section.value_or(e.stress_expression, {});
      curve.tangent_expression = section.value_or(e.tangent_expression, {});
      for (const Text &entry : {e.stress_expression, e.tangent_expression})
        if (section.given(entry))
          check_expression(
            section, entry, section.value(entry), ExpressionArguments::deformation, constants);
      return curve;
    }


    void
    check_layer(const ParameterSection &section,
                const LayerEntries &e,
                const LayerDirection direction,
                const LayerSurroundings &surroundings,
                const JointParameters &joint)
    {
      const LayerLaw law = direction == LayerDirection::normal ? joint.normal_law : joint.shear_law;
      const auto curve   = make_layer_law(joint, direction, surroundings.constants);
      const auto problem = check_law(*curve, surroundings.largest_stress);
      const AnyEntry &culprit = law == LayerLaw::tabular      ? AnyEntry(e.table)
                                : law == LayerLaw::expression ? AnyEntry(e.stress_expression)
                                                              : AnyEntry(e.law);
      if (problem)
        section.fail(culprit,
                     fmt::format("at w = {:.6g} {}. A law begins at w = 0 with stress 0 and grows "
                                 "smoothly. Correct the law; fuga --plot-law shows one that "
                                 "is accepted.",
                                 problem->deformation,
                                 problem->text));
    }
  } // namespace


  void
  read_layer(const ParameterSection &section,
             const LayerDirection direction,
             const LayerSurroundings &surroundings,
             JointParameters &joint)
  {
    const bool normal     = direction == LayerDirection::normal;
    const LayerEntries &e = entries_of<JointEntries>().layer(direction);
    LayerLaw &law         = normal ? joint.normal_law : joint.shear_law;
    double &compliance    = normal ? joint.normal_compliance : joint.shear_compliance;
    LayerCurve &curve     = normal ? joint.normal_curve : joint.shear_curve;
    std::vector<LayerLaw> laws =
      normal ? surroundings.swept_normal_laws : surroundings.swept_shear_laws;
    laws.push_back(law);
    refuse_foreign_entries(section, e, laws);
    compliance = read_compliance(section, e, normal || surroundings.has_shear, law);
    curve      = read_curve(section, e, surroundings.constants);
    if (const std::string missing = missing_entry(e, law, joint.thickness, compliance, curve);
        !missing.empty())
      section.fail(e.law, missing);
    if (law != LayerLaw::linear)
      check_layer(section, e, direction, surroundings, joint);
  }
} // namespace fuga
