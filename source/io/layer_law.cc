// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/expression_law.h>
#include <fuga/io/layer_law.h>
#include <fuga/laws/exponential_law.h>
#include <fuga/laws/hyperbolic_law.h>
#include <fuga/laws/power_law.h>

#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    struct LawWord
    {
      LayerLaw law;
      const char *word;
      bool in_shear;
    };

    constexpr LawWord known_words[] = {{LayerLaw::rigid, "rigid", true},
                                 {LayerLaw::linear, "linear", true},
                                 {LayerLaw::cubic_root, "cubic root", true},
                                 {LayerLaw::hyperbolic, "hyperbolic", false},
                                 {LayerLaw::exponential, "exponential", false},
                                 {LayerLaw::power, "power", true},
                                 {LayerLaw::tabular, "tabular", true},
                                 {LayerLaw::expression, "expression", true}};

    /** The layer of a joint as one direction sees it. */
    struct View
    {
      LayerLaw law;
      double compliance;
      const LayerCurve &curve;
    };

    View
    view(const JointParameters &joint, const LayerDirection direction)
    {
      if (direction == LayerDirection::normal)
        return {joint.normal_law, joint.normal_compliance, joint.normal_curve};
      return {joint.shear_law, joint.shear_compliance, joint.shear_curve};
    }
  } // namespace

  std::string
  direction_word(const LayerDirection direction)
  {
    return direction == LayerDirection::normal ? "Normal" : "Shear";
  }

  std::string
  law_word(const LayerLaw law)
  {
    for (const LawWord &known : known_words)
      if (known.law == law)
        return known.word;
    return "";
  }

  std::vector<std::string>
  law_words(const LayerDirection direction)
  {
    std::vector<std::string> result;
    for (const LawWord &known : known_words)
      if (known.in_shear || direction == LayerDirection::normal)
        result.emplace_back(known.word);
    return result;
  }

  std::optional<LayerLaw>
  law_of_word(const std::string &word, const LayerDirection direction)
  {
    for (const LawWord &known : known_words)
      if (known.word == word && (known.in_shear || direction == LayerDirection::normal))
        return known.law;
    return {};
  }

  bool
  has_compliance_entry(const LayerLaw law)
  {
    return law == LayerLaw::linear || law == LayerLaw::cubic_root || law == LayerLaw::hyperbolic;
  }

  std::string
  missing_entry(const JointParameters &joint, const LayerDirection direction)
  {
    const auto [law, compliance, curve] = view(joint, direction);
    const bool normal                   = direction == LayerDirection::normal;
    const std::string start             = "'" + direction_word(direction) + " ";
    if (law == LayerLaw::cubic_root && joint.thickness == 0.)
      return "'Thickness' is missing. The cubic root law needs the thickness of the layer.";
    if ((law == LayerLaw::cubic_root || law == LayerLaw::hyperbolic) && compliance == 0.)
      return start + fmt::format("compliance' is missing: the {} law needs a compliance > 0. For a "
                                 "rigid joint choose the law rigid.",
                                 law_word(law));
    if (law == LayerLaw::hyperbolic && curve.closure_limit == 0.)
      return start + "closure limit' is missing. The hyperbolic law needs the closure that no "
                     "stress reaches.";
    if (law == LayerLaw::exponential || law == LayerLaw::power)
      {
        if (curve.reference_deformation == 0.)
          return start + (normal ? "reference closure" : "reference jump") +
                 fmt::format("' is missing. The {} law needs a point of the curve.", law_word(law));
        if (curve.reference_stress == 0.)
          return start +
                 fmt::format("reference stress' is missing. The {} law needs a point of the "
                             "curve.",
                             law_word(law));
      }
    if (law == LayerLaw::power && curve.exponent == 0.)
      return start + "exponent' is missing. The power law needs it; 1 is a straight line.";
    if (law == LayerLaw::tabular && curve.table.empty())
      return start + "table' is missing. Give the points of the curve: 0: 0; w: stress; ...";
    if (law == LayerLaw::expression && curve.stress_expression.empty())
      return start + "stress expression' is missing. Give the stress as an expression of w.";
    if (law == LayerLaw::expression && curve.tangent_expression.empty())
      return start + "tangent expression' is missing. Give the derivative of the stress by w.";
    return "";
  }

  std::unique_ptr<ComplianceLaw>
  make_layer_law(const JointParameters &joint,
                 const LayerDirection direction,
                 const std::map<std::string, double> &constants)
  {
    const auto [law, compliance, curve] = view(joint, direction);
    switch (law)
      {
        case LayerLaw::rigid:
          return make_rigid_law();
        case LayerLaw::linear:
          return make_linear_law(compliance);
        case LayerLaw::cubic_root:
          return make_cubic_root_law(compliance, joint.thickness);
        case LayerLaw::hyperbolic:
          return std::make_unique<HyperbolicLaw>(compliance, curve.closure_limit);
        case LayerLaw::exponential:
          return std::make_unique<ExponentialLaw>(curve.reference_deformation,
                                                  curve.reference_stress);
        case LayerLaw::power:
          return std::make_unique<PowerLaw>(
            curve.reference_deformation, curve.reference_stress, curve.exponent);
        case LayerLaw::tabular:
          return std::make_unique<TabularLaw>(curve.table, curve.interpolation);
        case LayerLaw::expression:
          return std::make_unique<ExpressionLaw>(curve.stress_expression,
                                                 curve.tangent_expression,
                                                 curve.closure_limit > 0.
                                                   ? curve.closure_limit
                                                   : std::numeric_limits<double>::infinity(),
                                                 constants,
                                                 fmt::format("{}: {} law of joint '{}'",
                                                             joint.origin,
                                                             direction_word(direction),
                                                             joint.definition.name));
      }
    return nullptr;
  }
} // namespace fuga
