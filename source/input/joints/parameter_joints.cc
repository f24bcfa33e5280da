// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/joints/joint_readers.h>
#include <fuga/input/syntax/parameter_names.h>
#include <fuga/input/values/value_readers.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    void
    need(const ParameterSection &section, const Text &entry, const std::string &because)
    {
      if (section.value_or(entry, {}).empty())
        section.fail(fmt::format("'{}' is missing: {}.", entry.name(), because));
    }


    void
    read_line(const ParameterSection &section,
              const std::vector<std::string> &bodies,
              JointDefinition &joint)
    {
      const JointEntries &e = entries_of<JointEntries>();
      for (const Text &lip : {e.plus_lip, e.minus_lip})
        refuse_both(section, lip, e.line);
      joint.line = section.text(e.line);
      for (const Text &side : {e.plus_body, e.minus_body})
        {
          need(section, side, "a joint with 'Line' names the bodies on both sides of it");
          const std::string body = section.text(side);
          if (std::find(bodies.begin(), bodies.end(), body) == bodies.end())
            section.fail(side,
                         fmt::format("there is no such body in section Bodies. {}{}",
                                     name_hint(body, bodies, "bodies"),
                                     body == "rigid" ? " A rigid obstacle needs 'Plus lip' and "
                                                       "'Minus lip = rigid' instead of 'Line'."
                                                     : ""));
        }
      joint.plus_body  = section.text(e.plus_body);
      joint.minus_body = section.text(e.minus_body);
    }


    void
    read_lips(const ParameterSection &section, JointDefinition &joint)
    {
      const JointEntries &e = entries_of<JointEntries>();
      for (const Text &body : {e.plus_body, e.minus_body})
        if (section.given(body))
          section.fail(
            body, "a joint between lips does not name bodies. Remove the entry, or use 'Line'.");
      need(section, e.plus_lip, "a joint is either a 'Line' or has 'Plus lip' and 'Minus lip'");
      need(section, e.minus_lip, "write the name of the opposite boundary, or the word rigid");
      joint.plus_lip = section.text(e.plus_lip);
      if (joint.plus_lip == "rigid")
        section.fail(
          e.plus_lip,
          "only the minus lip can be rigid. Exchange the lips: the normal points into the "
          "body.");
      const std::string minus_lip = section.text(e.minus_lip);
      if (minus_lip == joint.plus_lip)
        section.fail(
          e.minus_lip,
          fmt::format("this is the plus lip too, see {}. The lips are two boundaries, or "
                      "one boundary and the word rigid.",
                      section.origin(e.plus_lip)));
      joint.against_rigid = minus_lip == "rigid";
      if (!joint.against_rigid)
        joint.minus_lip = minus_lip;
    }


    JointDefinition
    read_place(const ParameterSection &section, const std::vector<std::string> &bodies)
    {
      const JointEntries &e = entries_of<JointEntries>();
      JointDefinition joint;
      joint.name = section.name();
      if (section.given(e.line))
        read_line(section, bodies, joint);
      else if (section.given(e.plus_lip) || section.given(e.minus_lip))
        read_lips(section, joint);
      else
        section.fail(
          "it is not said where the joint is. Give 'Line', 'Plus body' and 'Minus body', or "
          "'Plus lip' and 'Minus lip'.");
      section.read(joint);
      return joint;
    }


    /** Return the laws that section Sweep gives this joint; other words are rejected where they are
     * read. */
    std::vector<LayerLaw>
    swept_laws(const ParameterSection &section, const Entry<LayerLaw> &entry)
    {
      std::vector<LayerLaw> laws;
      for (const std::string &swept : section.swept(entry))
        for (const auto &[word, law] : entry.words)
          if (word == swept)
            laws.push_back(law);
      return laws;
    }


    /** Return a hundredth of the modulus of the softest body: at higher stresses bodies are not
     * elastic. */
    double
    largest_stress(const ParameterValues &values)
    {
      const BodyEntries &e = entries_of<BodyEntries>();
      double softest       = std::numeric_limits<double>::infinity();
      for (const ParameterSection &body : values.subsections<BodyEntries>())
        softest = std::min(softest, body.value(e.young_modulus));
      return 0.01 * softest;
    }


    JointParameters
    read_joint(const ParameterSection &section,
               const ParameterValues &values,
               const ModelDefinition &model)
    {
      const JointEntries &e                          = entries_of<JointEntries>();
      const std::map<std::string, double> &constants = model.constants;
      JointParameters joint;
      joint.origin     = section.origin();
      joint.definition = read_place(section, values.subsection_names<BodyEntries>());
      joint.friction   = read_strength(section);
      section.read(joint);
      const LayerSurroundings surroundings = {constants,
                                              largest_stress(values),
                                              swept_laws(section, e.normal.law),
                                              swept_laws(section, e.shear.law),
                                              !joint.friction.is_frictionless()};
      read_layer(section, LayerDirection::normal, surroundings, joint);
      read_layer(section, LayerDirection::shear, surroundings, joint);
      joint.shear_growth = read_shear_growth(section);
      check_shear_growth(section, joint);
      check_expression(section,
                       e.initial_gap,
                       joint.initial_gap,
                       model.dimension == 2 ? ExpressionArguments::place
                                            : ExpressionArguments::place_in_space,
                       constants);
      return joint;
    }
  } // namespace


  std::vector<JointParameters>
  read_joints(const ParameterValues &values, const ModelDefinition &model)
  {
    std::vector<JointParameters> joints;
    for (const ParameterSection &section : values.subsections<JointEntries>())
      values.attempt(section, [&]() {
        if (!values.is_broken<BodyEntries>())
          joints.push_back(read_joint(section, values, model));
      });
    return joints;
  }
} // namespace fuga
