// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_layers.h>
#include <fuga/io/parameter_names.h>
#include <fuga/io/parameter_readers.h>
#include <fuga/io/parameter_strength.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    void
    need(const ParameterSection &section, const std::string &entry, const std::string &because)
    {
      if (!section.given(entry) || section.text(entry).empty())
        section.fail(fmt::format("'{}' is missing: {}.", entry, because));
    }


    void
    read_line(const ParameterSection &section,
              const std::vector<std::string> &bodies,
              JointDefinition &joint)
    {
      for (const char *const lip : {"Plus lip", "Minus lip"})
        refuse_both(section, lip, "Line");
      joint.line = section.text("Line");
      for (const char *const side : {"Plus body", "Minus body"})
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
      joint.plus_body  = section.text("Plus body");
      joint.minus_body = section.text("Minus body");
    }


    void
    read_lips(const ParameterSection &section, JointDefinition &joint)
    {
      for (const char *const body : {"Plus body", "Minus body"})
        if (section.given(body))
          section.fail(
            body, "a joint between lips does not name bodies. Remove the entry, or use 'Line'.");
      need(section, "Plus lip", "a joint is either a 'Line' or has 'Plus lip' and 'Minus lip'");
      need(section, "Minus lip", "write the name of the opposite boundary, or the word rigid");
      joint.plus_lip = section.text("Plus lip");
      if (joint.plus_lip == "rigid")
        section.fail(
          "Plus lip",
          "only the minus lip can be rigid. Exchange the lips: the normal points into the "
          "body.");
      const std::string minus_lip = section.text("Minus lip");
      if (minus_lip == joint.plus_lip)
        section.fail(
          "Minus lip",
          fmt::format("this is the plus lip too, see {}. The lips are two boundaries, or "
                      "one boundary and the word rigid.",
                      section.origin("Plus lip")));
      joint.against_rigid = minus_lip == "rigid";
      if (!joint.against_rigid)
        joint.minus_lip = minus_lip;
    }


    JointDefinition
    read_place(const ParameterSection &section, const std::vector<std::string> &bodies)
    {
      JointDefinition joint;
      joint.name = section.name();
      if (section.given("Line"))
        read_line(section, bodies, joint);
      else if (section.given("Plus lip") || section.given("Minus lip"))
        read_lips(section, joint);
      else
        section.fail(
          "it is not said where the joint is. Give 'Line', 'Plus body' and 'Minus body', or "
          "'Plus lip' and 'Minus lip'.");
      joint.corner_angle = section.number("Corner angle");
      return joint;
    }


    /** Laws that section Sweep gives this joint; other words are refused where they are read. */
    std::vector<LayerLaw>
    swept_laws(const ParameterSection &section, const LayerDirection direction)
    {
      std::vector<LayerLaw> laws;
      for (const std::string &word : section.swept(direction_word(direction) + " law"))
        if (const auto law = law_of_word(word, direction))
          laws.push_back(*law);
      return laws;
    }


    /** A hundredth of the softest body's modulus: at higher stresses bodies are not elastic. */
    double
    largest_stress(const ParameterValues &values)
    {
      double softest = std::numeric_limits<double>::infinity();
      for (const ParameterSection &body : values.subsections("Bodies"))
        softest = std::min(softest, body.number("Young modulus"));
      return 0.01 * softest;
    }


    JointParameters
    read_joint(const ParameterSection &section,
               const ParameterValues &values,
               const ModelDefinition &model)
    {
      const std::map<std::string, double> &constants = model.constants;
      JointParameters joint;
      joint.origin     = section.origin();
      joint.definition = read_place(section, values.subsection_names("Bodies"));
      joint.friction   = read_strength(section);
      joint.thickness  = section.given("Thickness") ? section.number("Thickness") : 0.;
      const LayerSurroundings surroundings = {constants,
                                              largest_stress(values),
                                              swept_laws(section, LayerDirection::normal),
                                              swept_laws(section, LayerDirection::shear),
                                              !joint.friction.is_frictionless()};
      read_layer(section, LayerDirection::normal, surroundings, joint);
      read_layer(section, LayerDirection::shear, surroundings, joint);
      joint.shear_growth = read_shear_growth(section);
      check_shear_growth(section, joint);
      joint.initial_gap = section.text("Initial gap");
      check_expression(section,
                       "Initial gap",
                       joint.initial_gap,
                       model.dimension == 2 ? ExpressionArguments::place
                                            : ExpressionArguments::place_in_space,
                       constants);
      return joint;
    }
  } // namespace


  void
  check_expression(const ParameterSection &section,
                   const std::string &entry,
                   const std::string &expression,
                   const ExpressionArguments arguments,
                   const std::map<std::string, double> &constants)
  {
    const std::string problem = expression_problem(expression, arguments, constants);
    if (!problem.empty())
      section.fail(entry, problem);
  }


  std::vector<JointParameters>
  read_joints(const ParameterValues &values, const ModelDefinition &model)
  {
    std::vector<JointParameters> joints;
    for (const ParameterSection &section : values.subsections("Joints"))
      values.attempt(section, [&]() {
        if (!values.is_broken("Bodies"))
          joints.push_back(read_joint(section, values, model));
      });
    return joints;
  }
} // namespace fuga
