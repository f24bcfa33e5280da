// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_layers.h>
#include <fuga/io/parameter_names.h>
#include <fuga/io/parameter_readers.h>
#include <fuga/laws/law_check.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace fuga
{
  void
  refuse_both(const ParameterSection &section, const std::string &one, const std::string &other)
  {
    if (section.given(one) && section.given(other))
      section.fail(one,
                   fmt::format("'{}' is given as well, see {}. Keep one of the two.",
                               other,
                               section.origin(other)));
  }

  namespace
  {
    struct OwnedEntry
    {
      const char *name;
      std::vector<LayerLaw> owners;
    };

    /** The entries that only some laws use, without the direction. */
    const std::vector<OwnedEntry> &
    owned_entries()
    {
      using L                                   = LayerLaw;
      static const std::vector<OwnedEntry> list = {
        {"compliance", {L::linear, L::cubic_root, L::cubic_root_tangent, L::hyperbolic}},
        {"stiffness", {L::linear, L::cubic_root, L::cubic_root_tangent, L::hyperbolic}},
        {"closure limit", {L::hyperbolic, L::expression}},
        {"reference closure", {L::exponential, L::power}},
        {"reference jump", {L::power}},
        {"reference stress", {L::exponential, L::power}},
        {"exponent", {L::power}},
        {"table", {L::tabular}},
        {"interpolation", {L::tabular}},
        {"stress expression", {L::expression}},
        {"tangent expression", {L::expression}}};
      return list;
    }

    bool
    contains(const std::vector<LayerLaw> &laws, const LayerLaw law)
    {
      return std::find(laws.begin(), laws.end(), law) != laws.end();
    }

    /** "'Normal law = power' (file:3)", or that the law is the default. */
    std::string
    law_statement(const ParameterSection &section, const std::string &direction)
    {
      const std::string entry = direction + " law";
      return fmt::format("'{} = {}' ({})",
                         entry,
                         section.text(entry),
                         section.given(entry) ? section.origin(entry) : "the default");
    }

    void
    refuse_foreign_entries(const ParameterSection &section,
                           const LayerDirection direction,
                           const std::vector<LayerLaw> &laws)
    {
      const std::string word = direction_word(direction);
      for (const auto &[name, owners] : owned_entries())
        {
          const std::string entry = word + " " + name;
          if (!section.given(entry) ||
              std::any_of(owners.begin(), owners.end(), [&laws = laws](const LayerLaw owner) {
                return contains(laws, owner);
              }))
            continue;
          std::string names;
          for (const std::string &law : law_words(direction))
            if (contains(owners, *law_of_word(law, direction)))
              names += (names.empty() ? "" : ", ") + law;
          section.fail(entry,
                       fmt::format("{} does not use this entry. It belongs to the law{} {}. Remove "
                                   "this entry, or choose another law.",
                                   law_statement(section, word),
                                   names.find(',') == std::string::npos ? "" : "s",
                                   names));
        }
    }

    /** ρ of one direction; a linear law without compliance becomes rigid. */
    double
    read_compliance(const ParameterSection &section,
                    const std::string &direction,
                    const bool is_needed,
                    LayerLaw &law)
    {
      const std::string compliance = direction + " compliance";
      const std::string stiffness  = direction + " stiffness";
      refuse_both(section, compliance, stiffness);
      const bool is_given = section.given(compliance) || section.given(stiffness);
      if (!is_given && has_compliance_entry(law) &&
          (is_needed || section.given(direction + " law")))
        section.fail(fmt::format("'{}' or '{}' is missing. Give one of the two; compliance 0, or "
                                 "'{} law = rigid', means an exactly rigid joint.",
                                 compliance,
                                 stiffness,
                                 direction));
      const double rho = section.given(compliance)  ? section.number(compliance)
                         : section.given(stiffness) ? 1. / section.number(stiffness)
                                                    : 0.;
      if (rho == 0. && needs_compliance(law))
        section.fail(
          compliance,
          fmt::format("{} needs a compliance > 0. For a rigid joint choose the law rigid.",
                      law_statement(section, direction)));
      if (law == LayerLaw::linear && rho == 0.)
        law = LayerLaw::rigid;
      // Entries of other laws of a sweep do not count.
      return has_compliance_entry(law) ? rho : 0.;
    }

    double
    read_number(const ParameterSection &section, const std::string &entry, const std::string &word)
    {
      double value      = 0.;
      const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
      if (result.ec != std::errc() || result.ptr != word.data() + word.size() ||
          !std::isfinite(value))
        section.fail(
          entry,
          fmt::format("'{}' is not a number. A table is written 0: 0; w: stress; ... with "
                      "decimal points and without units.",
                      word));
      return value;
    }

    std::vector<TabularLaw::Point>
    read_table(const ParameterSection &section, const std::string &entry)
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
        section.fail(entry, "a table needs a second point behind 0: 0.");
      return table;
    }

    double
    number_or_none(const ParameterSection &section, const std::string &entry)
    {
      return section.given(entry) ? section.number(entry) : 0.;
    }

    LayerCurve
    read_curve(const ParameterSection &section,
               const LayerDirection direction,
               const std::map<std::string, double> &constants)
    {
      const std::string word = direction_word(direction);
      LayerCurve curve;
      if (direction == LayerDirection::normal)
        curve.closure_limit = number_or_none(section, "Normal closure limit");
      curve.reference_deformation = number_or_none(
        section,
        direction == LayerDirection::normal ? "Normal reference closure" : "Shear reference jump");
      curve.reference_stress = number_or_none(section, word + " reference stress");
      curve.exponent         = number_or_none(section, word + " exponent");
      if (section.given(word + " table"))
        curve.table = read_table(section, word + " table");
      if (section.text(word + " interpolation") == "piecewise linear")
        curve.interpolation = TableInterpolation::piecewise_linear;
      for (const auto &[name, target] :
           {std::pair<std::string, std::string *>(" stress expression", &curve.stress_expression),
            {" tangent expression", &curve.tangent_expression}})
        if (section.given(word + name))
          {
            *target = section.text(word + name);
            check_expression(
              section, word + name, *target, ExpressionArguments::deformation, constants);
          }
      return curve;
    }

    /** The entry to which the message of a refused law points. */
    std::string
    culprit(const LayerLaw law, const std::string &direction)
    {
      return direction + (law == LayerLaw::tabular      ? " table"
                          : law == LayerLaw::expression ? " stress expression"
                                                        : " law");
    }

    void
    check_layer(const ParameterSection &section,
                const LayerDirection direction,
                const LayerSurroundings &surroundings,
                const JointParameters &joint)
    {
      const LayerLaw law = direction == LayerDirection::normal ? joint.normal_law : joint.shear_law;
      const auto curve   = make_layer_law(joint, direction, surroundings.constants);
      const auto problem = check_law(*curve, surroundings.largest_stress);
      if (problem)
        section.fail(culprit(law, direction_word(direction)),
                     fmt::format("at w = {:.6g} {}. A law begins at w = 0 with stress 0 and grows "
                                 "smoothly. Correct the law; fuga --plot-law draws one that is "
                                 "accepted.",
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
    const bool normal      = direction == LayerDirection::normal;
    const std::string word = direction_word(direction);
    LayerLaw &law          = normal ? joint.normal_law : joint.shear_law;
    law                    = *law_of_word(section.text(word + " law"), direction);

    std::vector<LayerLaw> laws =
      normal ? surroundings.swept_normal_laws : surroundings.swept_shear_laws;
    laws.push_back(law);
    refuse_foreign_entries(section, direction, laws);
    (normal ? joint.normal_compliance : joint.shear_compliance) =
      read_compliance(section, word, normal || surroundings.has_shear, law);
    (normal ? joint.normal_curve : joint.shear_curve) =
      read_curve(section, direction, surroundings.constants);
    if (const std::string missing = missing_entry(joint, direction); !missing.empty())
      section.fail(word + " law", missing);

    if (law != LayerLaw::linear)
      check_layer(section, direction, surroundings, joint);
  }
} // namespace fuga
