// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/expression_law.h>
#include <fuga/input/layer_law.h>
#include <fuga/laws/cubic_root_law.h>
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

    constexpr LawWord known_laws[] = {{LayerLaw::rigid, "rigid", true},
                                      {LayerLaw::linear, "linear", true},
                                      {LayerLaw::cubic_root, "cubic root", true},
                                      {LayerLaw::cubic_root_tangent, "cubic root tangent", true},
                                      {LayerLaw::hyperbolic, "hyperbolic", false},
                                      {LayerLaw::exponential, "exponential", false},
                                      {LayerLaw::power, "power", true},
                                      {LayerLaw::tabular, "tabular", true},
                                      {LayerLaw::expression, "expression", true}};

    /** The layer of a joint as seen in one direction. */
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
  law_word(const LayerLaw law)
  {
    for (const LawWord &known : known_laws)
      if (known.law == law)
        return known.word;
    return "";
  }

  std::vector<std::pair<std::string, LayerLaw>>
  law_words(const LayerDirection direction)
  {
    std::vector<std::pair<std::string, LayerLaw>> result;
    for (const LawWord &known : known_laws)
      if (known.in_shear || direction == LayerDirection::normal)
        result.emplace_back(known.word, known.law);
    return result;
  }


  bool
  has_compliance_entry(const LayerLaw law)
  {
    return law == LayerLaw::linear || needs_compliance(law);
  }

  bool
  needs_compliance(const LayerLaw law)
  {
    return law == LayerLaw::cubic_root || law == LayerLaw::cubic_root_tangent ||
           law == LayerLaw::hyperbolic;
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
          return std::make_unique<CubicRootLaw>(compliance, joint.thickness);
        case LayerLaw::cubic_root_tangent:
          return std::make_unique<CubicRootTangentLaw>(compliance, joint.thickness);
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
          return std::make_unique<ExpressionLaw>(
            curve.stress_expression,
            curve.tangent_expression,
            curve.closure_limit > 0. ? curve.closure_limit
                                     : std::numeric_limits<double>::infinity(),
            constants,
            fmt::format("{}: {} law of joint '{}'",
                        joint.origin,
                        direction == LayerDirection::normal ? "Normal" : "Shear",
                        joint.definition.name));
      }
    return nullptr;
  }
} // namespace fuga
