// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/load_assembly.h>
#include <fuga/io/layer_law.h>
#include <fuga/io/parameter_names.h>
#include <fuga/io/parameter_readers.h>
#include <fuga/io/parameter_strength.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** More variants than this are a slip of the pen. */
    constexpr std::size_t max_variants = 100000;

    std::string
    trimmed(const std::string &text)
    {
      const char *const blank = " \t";
      const std::size_t begin = text.find_first_not_of(blank);
      return begin == std::string::npos
               ? ""
               : text.substr(begin, text.find_last_not_of(blank) - begin + 1);
    }

    std::vector<std::string>
    split(const std::string &text, const char separator)
    {
      std::vector<std::string> pieces;
      std::size_t begin = 0;
      while (true)
        {
          const std::size_t end = text.find(separator, begin);
          pieces.push_back(trimmed(text.substr(begin, end - begin)));
          if (end == std::string::npos)
            return pieces;
          begin = end + 1;
        }
    }

    double
    parse_number(const ParameterSection &section, const std::string &entry, const std::string &word)
    {
      double value      = 0.;
      const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
      if (result.ec != std::errc() || result.ptr != word.data() + word.size() ||
          !std::isfinite(value))
        section.fail(entry,
                     fmt::format("'{}' is not a number. Write numbers a, b, c or a range "
                                 "first : step : last.",
                                 word));
      if (value < 0.)
        section.fail(entry,
                     fmt::format("{} is negative; values from 0 upwards are allowed.", word));
      return value;
    }

    std::vector<double>
    parse_range(const ParameterSection &section, const std::string &entry)
    {
      const std::vector<std::string> words = split(section.text(entry), ':');
      if (words.size() != 3)
        section.fail(entry, "a range is written first : step : last.");
      const double first = parse_number(section, entry, words[0]);
      const double step  = parse_number(section, entry, words[1]);
      const double last  = parse_number(section, entry, words[2]);
      if (step == 0. || last < first || (last - first) / step > static_cast<double>(max_variants))
        section.fail(entry, "a range needs a step > 0 and a last value not below the first.");
      std::vector<double> values;
      const double rounding = 1e-9;
      for (int i = 0; first + i * step <= last + rounding * step; ++i)
        values.push_back(first + i * step);
      return values;
    }

    std::vector<double>
    parse_values(const ParameterSection &section, const std::string &entry)
    {
      if (section.text(entry).find(':') != std::string::npos)
        return parse_range(section, entry);
      std::vector<double> values;
      for (const std::string &word : section.list(entry))
        values.push_back(parse_number(section, entry, word));
      return values;
    }

    /** Which joints are varied. */
    std::vector<bool>
    varied_joints(const ParameterSection &section, const std::vector<JointParameters> &joints)
    {
      std::vector<bool> varied(joints.size(), !section.given("Joints"));
      if (!section.given("Joints"))
        return varied;
      std::vector<std::string> names;
      for (const JointParameters &joint : joints)
        names.push_back(joint.definition.name);
      for (const std::string &name : section.list("Joints"))
        {
          const auto place = std::find(names.begin(), names.end(), name);
          if (place == names.end())
            section.fail("Joints", "there is no such joint. " + name_hint(name, names, "joints"));
          varied[static_cast<std::size_t>(place - names.begin())] = true;
        }
      return varied;
    }

    LayerLaw
    law_named(const ParameterSection &section, const std::string &word)
    {
      const auto law = law_of_word(word, LayerDirection::normal);
      if (!law)
        section.fail("Normal law",
                     fmt::format("there is no law '{}'. Known are {}.",
                                 word,
                                 quoted_list(law_words(LayerDirection::normal))));
      return *law;
    }

    /** Makes laws and compliances of a combination agree, or says why they cannot. */
    void
    reconcile(const ParameterSection &section, JointParameters &joint)
    {
      if (joint.normal_law == LayerLaw::linear && joint.normal_compliance == 0.)
        joint.normal_law = LayerLaw::rigid;
      if (joint.normal_law == LayerLaw::rigid)
        joint.normal_compliance = 0.;
      else if (section.given("Normal compliance") && !has_compliance_entry(joint.normal_law))
        section.fail("Normal compliance",
                     fmt::format("the {} law of joint '{}' has no compliance that could be varied. "
                                 "Take the law or the joint out of the sweep, or this entry.",
                                 law_word(joint.normal_law),
                                 joint.definition.name));
      if (const std::string missing = missing_entry(joint, LayerDirection::normal);
          !missing.empty())
        section.fail(
          section.given("Normal law") ? "Normal law" : "Normal compliance",
          fmt::format("for joint '{}' ({}) {}", joint.definition.name, joint.origin, missing));
      if (joint.shear_law == LayerLaw::linear && joint.shear_compliance == 0.)
        joint.shear_law = LayerLaw::rigid;
    }

    /** Multiplies the variants by the values of one entry; @p set puts value i into a joint. */
    template <typename Set>
    void
    multiply(std::vector<Variant> &variants,
             const std::string &entry,
             const std::vector<std::string> &words,
             const std::vector<bool> &varied,
             const Set &set)
    {
      std::vector<Variant> result;
      for (const Variant &variant : variants)
        for (std::size_t i = 0; i < words.size(); ++i)
          {
            result.push_back(variant);
            result.back().settings.emplace_back(entry, words[i]);
            for (std::size_t j = 0; j < varied.size(); ++j)
              if (varied[j])
                set(result.back().joints[j], i);
          }
      variants = std::move(result);
    }

    void
    vary_numbers(std::vector<Variant> &variants,
                 const ParameterSection &section,
                 const std::string &entry,
                 const std::vector<bool> &varied,
                 void (*set)(JointParameters &, const double))
    {
      if (!section.given(entry))
        return;
      const std::vector<double> values = parse_values(section, entry);
      if (variants.size() * values.size() > max_variants)
        section.fail(entry, fmt::format("that makes more than {} variants.", max_variants));
      std::vector<std::string> words;
      for (const double value : values)
        words.push_back(fmt::format("{:.12g}", value));
      multiply(variants, entry, words, varied, [&](JointParameters &joint, const std::size_t i) {
        set(joint, values[i]);
      });
    }

    void
    vary_law(std::vector<Variant> &variants,
             const ParameterSection &section,
             const std::vector<bool> &varied)
    {
      if (!section.given("Normal law"))
        return;
      const std::vector<std::string> words = section.list("Normal law");
      std::vector<LayerLaw> laws;
      for (const std::string &word : words)
        laws.push_back(law_named(section, word));
      multiply(
        variants, "Normal law", words, varied, [&](JointParameters &joint, const std::size_t i) {
          joint.normal_law = laws[i];
        });
    }

    void
    vary_sequence(std::vector<Variant> &variants,
                  const ParameterSection &section,
                  const ModelDefinition &model)
    {
      if (!section.given("Load sequences"))
        return;
      for (const LoadDefinition &load : model.loads)
        if (depends_on_time(load))
          section.fail(
            "Load sequences",
            fmt::format(
              "the load '{}' ({}) depends on the load time t, which a new order of the stages "
              "would change. Put its growth into the histories of the stages.",
              load.name,
              load.origin));
      std::vector<std::string> names;
      for (const StageDefinition &stage : model.stages)
        names.push_back(stage.name);
      std::vector<Variant> result;
      for (const Variant &variant : variants)
        for (const std::string &sequence : split(section.text("Load sequences"), ';'))
          {
            result.push_back(variant);
            result.back().settings.emplace_back("Load sequence", sequence);
            result.back().stages.clear();
            for (const std::string &name : split(sequence, ','))
              {
                const auto place = std::find(names.begin(), names.end(), name);
                if (place == names.end())
                  section.fail("Load sequences",
                               "there is no such stage. " + name_hint(name, names, "stages"));
                result.back().stages.push_back(static_cast<unsigned int>(place - names.begin()));
              }
          }
      variants = std::move(result);
    }
  } // namespace

  std::vector<Variant>
  read_variants(const ParameterValues &values,
                const std::vector<JointParameters> &joints,
                const ModelDefinition &model)
  {
    const ParameterSection section = values.section("Sweep");
    const auto entries             = {"Friction coefficient",
                                      "Cohesion",
                                      "Normal compliance",
                                      "Shear compliance",
                                      "Normal law",
                                      "Load sequences"};
    if (std::none_of(
          entries.begin(), entries.end(), [&](const char *entry) { return section.given(entry); }))
      return {};

    const std::vector<bool> varied = varied_joints(section, joints);
    std::vector<Variant> variants(1);
    variants[0].joints = joints;
    for (unsigned int s = 0; s < model.stages.size(); ++s)
      variants[0].stages.push_back(s);
    // Friction varies fastest: neighbours in the table then share the layered system.
    vary_sequence(variants, section, model);
    vary_law(variants, section, varied);
    vary_numbers(
      variants, section, "Normal compliance", varied, [](JointParameters &joint, const double v) {
        joint.normal_compliance = v;
      });
    vary_numbers(
      variants, section, "Shear compliance", varied, [](JointParameters &joint, const double v) {
        joint.shear_compliance = v;
        joint.shear_law        = LayerLaw::linear;
      });
    vary_numbers(variants, section, "Cohesion", varied, [](JointParameters &joint, const double v) {
      joint.friction.cohesion = v;
    });
    vary_numbers(variants,
                 section,
                 "Friction coefficient",
                 varied,
                 [](JointParameters &joint, const double v) {
                   // What is lost by slip is lost from the new value; residual friction stays.
                   const double residual = residual_friction(joint.friction);
                   joint.friction.friction_loss =
                     joint.friction.friction_loss > 0. ? v - residual : 0.;
                   joint.friction.coefficient = v;
                 });
    const bool law_given = section.given("Normal law");
    for (Variant &variant : variants)
      for (JointParameters &joint : variant.joints)
        {
          // Without a list of laws a compliance above zero makes a rigid joint linear.
          if (!law_given && joint.normal_law == LayerLaw::rigid && joint.normal_compliance > 0.)
            joint.normal_law = LayerLaw::linear;
          reconcile(section, joint);
          if (const std::optional<StrengthProblem> problem = find_strength_problem(joint.friction))
            section.fail(fmt::format("joint '{}' at friction {:g}, cohesion {:g}: {}",
                                     joint.definition.name,
                                     joint.friction.coefficient,
                                     joint.friction.cohesion,
                                     problem->text));
          if (joint.shear_growth.kind != ShearGrowth::Kind::none &&
              (joint.normal_law == LayerLaw::rigid || joint.shear_law != LayerLaw::linear))
            section.fail(
              fmt::format("joint '{}' has a shear stiffness that grows: neither its normal "
                          "nor its shear law may become rigid.",
                          joint.definition.name));
        }
    return variants;
  }
} // namespace fuga
