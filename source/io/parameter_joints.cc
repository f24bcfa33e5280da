// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_names.h>
#include <fuga/io/parameter_readers.h>
#include <fuga/io/parameter_strength.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
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
      return joint;
    }


    LayerLaw
    read_law(const ParameterSection &section, const std::string &entry)
    {
      const std::string word = section.text(entry);
      return word == "rigid"    ? LayerLaw::rigid
             : word == "linear" ? LayerLaw::linear
                                : LayerLaw::cubic_root;
    }


    /** ρ of one direction ("Normal", "Shear"); a linear law without compliance becomes rigid. */
    double
    read_compliance(const ParameterSection &section,
                    const std::string &direction,
                    const bool is_needed,
                    LayerLaw &law)
    {
      const std::string law_entry  = direction + " law";
      const std::string compliance = direction + " compliance";
      const std::string stiffness  = direction + " stiffness";
      refuse_both(section, compliance, stiffness);
      const bool is_given = section.given(compliance) || section.given(stiffness);
      if (law == LayerLaw::rigid)
        {
          for (const std::string &entry : {compliance, stiffness})
            if (section.given(entry))
              section.fail(entry,
                           fmt::format("'{} = rigid' ({}) has neither compliance nor stiffness. "
                                       "Remove this entry, or choose another law.",
                                       law_entry,
                                       section.origin(law_entry)));
          return 0.;
        }
      if (!is_given && (is_needed || section.given(law_entry)))
        section.fail(fmt::format("'{}' or '{}' is missing. Give one of the two; compliance 0, or "
                                 "'{} = rigid', means an exactly rigid joint.",
                                 compliance,
                                 stiffness,
                                 law_entry));
      const double rho = section.given(compliance)  ? section.number(compliance)
                         : section.given(stiffness) ? 1. / section.number(stiffness)
                                                    : 0.;
      if (law == LayerLaw::cubic_root && rho == 0.)
        section.fail(compliance,
                     fmt::format("'{} = cubic root' ({}) needs a compliance > 0. For a rigid joint "
                                 "choose the law rigid.",
                                 law_entry,
                                 section.origin(law_entry)));
      if (rho == 0.)
        law = LayerLaw::rigid;
      return rho;
    }


    double
    read_thickness(const ParameterSection &section)
    {
      if (section.given("Thickness"))
        return section.number("Thickness");
      for (const char *const law : {"Normal law", "Shear law"})
        if (section.text(law) == "cubic root")
          section.fail(
            law, "'Thickness' is missing. The cubic root law needs the thickness of the layer.");
      return 0.;
    }


    JointParameters
    read_joint(const ParameterSection &section,
               const std::vector<std::string> &bodies,
               const std::map<std::string, double> &constants)
    {
      JointParameters joint;
      joint.origin            = section.origin();
      joint.definition        = read_place(section, bodies);
      joint.friction          = read_strength(section);
      joint.thickness         = read_thickness(section);
      joint.normal_law        = read_law(section, "Normal law");
      joint.shear_law         = read_law(section, "Shear law");
      joint.normal_compliance = read_compliance(section, "Normal", true, joint.normal_law);
      joint.shear_compliance =
        read_compliance(section, "Shear", !joint.friction.is_frictionless(), joint.shear_law);
      joint.shear_growth = read_shear_growth(section);
      check_shear_growth(section, joint);
      joint.initial_gap = section.text("Initial gap");
      check_expression(
        section, "Initial gap", joint.initial_gap, ExpressionArguments::place, constants);
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
  read_joints(const ParameterValues &values, const std::map<std::string, double> &constants)
  {
    std::vector<JointParameters> joints;
    for (const ParameterSection &section : values.subsections("Joints"))
      joints.push_back(read_joint(section, values.subsection_names("Bodies"), constants));
    return joints;
  }
} // namespace fuga
