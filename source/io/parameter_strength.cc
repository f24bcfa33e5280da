// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_strength.h>

#include <fmt/format.h>

#include <cmath>

namespace fuga
{
  namespace
  {
    constexpr double degree = 0.017453292519943295;

    /** A coefficient, or tan of an angle in degrees; @p otherwise if neither is given. */
    double
    read_coefficient(const ParameterSection &section,
                     const std::string &name,
                     const double otherwise)
    {
      const std::string coefficient = name + " coefficient", angle = name + " angle";
      if (section.given(coefficient) && section.given(angle))
        section.fail(coefficient,
                     fmt::format("'{}' is given as well, see {}. Keep one of the two.",
                                 angle,
                                 section.origin(angle)));
      if (section.given(angle))
        return std::tan(section.number(angle) * degree);
      if (!section.given(coefficient))
        return otherwise;
      const double value               = section.number(coefficient);
      const double looks_like_an_angle = 5.;
      if (value > looks_like_an_angle)
        section.fail(
          coefficient,
          fmt::format("a coefficient > 5 looks like an angle in degrees: use '{}'.", angle));
      return value;
    }

    /** The entry to blame for a problem of the whole law. */
    std::string
    entry_of(const StrengthProblem::Part part)
    {
      switch (part)
        {
          case StrengthProblem::Part::residual:
            return "Residual friction coefficient";
          case StrengthProblem::Part::tension:
            return "Tensile strength";
          case StrengthProblem::Part::dilatancy:
            return "Dilatancy angle";
        }
      return "";
    }
  } // namespace


  std::optional<StrengthProblem>
  find_strength_problem(const FrictionLaw &law)
  {
    using Part = StrengthProblem::Part;
    if (law.friction_loss < 0.)
      return StrengthProblem{
        Part::residual,
        fmt::format("residual friction {:g} is above the friction {:g} before it. "
                    "Friction is lost by slip, not gained.",
                    residual_friction(law),
                    law.coefficient)};
    if (law.tensile_strength * law.coefficient > law.cohesion)
      return StrengthProblem{
        Part::tension,
        fmt::format("a tensile strength of {:g} lies beyond the tip of Coulomb's cone at "
                    "cohesion/friction = {:g}. Lower it, or raise the cohesion.",
                    law.tensile_strength,
                    law.cohesion / law.coefficient)};
    if (law.dilatancy > residual_friction(law))
      return StrengthProblem{
        Part::dilatancy,
        fmt::format(
          "the tangent {:g} of the dilatancy angle is above the (residual) friction {:g}: "
          "sliding would create energy.",
          law.dilatancy,
          residual_friction(law))};
    return {};
  }


  FrictionLaw
  read_strength(const ParameterSection &section)
  {
    FrictionLaw law;
    law.coefficient = read_coefficient(section, "Friction", 0.);
    law.friction_loss =
      law.coefficient - read_coefficient(section, "Residual friction", law.coefficient);
    law.cohesion         = section.number("Cohesion");
    law.tensile_strength = section.number("Tensile strength");
    law.dilatancy        = std::tan(section.number("Dilatancy angle") * degree);
    if (section.text("Bond lost by") == "slip")
      {
        law.bond_loss = FrictionLaw::BondLoss::slip;
        if (law.cohesion == 0. && law.tensile_strength == 0.)
          section.fail("Bond lost by",
                       "there is no bond to lose: give 'Cohesion' or 'Tensile strength'.");
      }
    if (section.given("Dilation limit"))
      {
        law.dilation_limit = section.number("Dilation limit");
        if (law.dilatancy == 0.)
          section.fail("Dilation limit", "there is no dilatancy to limit: 'Dilatancy angle' is 0.");
      }
    for (const char *const entry :
         {"Residual friction coefficient", "Residual friction angle", "Dilatancy angle"})
      if (law.coefficient == 0. && section.given(entry))
        section.fail(entry,
                     "the joint has no friction: give 'Friction coefficient' or 'Friction angle'.");
    if (const std::optional<StrengthProblem> problem = find_strength_problem(law))
      {
        const std::string entry = entry_of(problem->part);
        section.fail(section.given(entry) || problem->part != StrengthProblem::Part::residual
                       ? entry
                       : "Residual friction angle",
                     problem->text);
      }
    return law;
  }


  ShearGrowth
  read_shear_growth(const ParameterSection &section)
  {
    const std::string closure = "Shear growth closure", pressure = "Shear growth pressure",
                      exponent = "Shear growth exponent";
    const std::string word     = section.text("Shear stiffness grows with");
    ShearGrowth growth;
    if (word == "nothing")
      {
        for (const std::string &entry : {closure, pressure, exponent})
          if (section.given(entry))
            section.fail(entry,
                         "'Shear stiffness grows with = nothing': remove this entry, or choose "
                         "closure or pressure.");
        return growth;
      }
    growth.kind = word == "closure" ? ShearGrowth::Kind::closure : ShearGrowth::Kind::pressure;
    const std::string scale  = word == "closure" ? closure : pressure;
    const std::string unused = word == "closure" ? pressure : closure;
    if (section.given(unused))
      section.fail(unused,
                   fmt::format("'Shear stiffness grows with = {}' ({}) does not use this entry.",
                               word,
                               section.origin("Shear stiffness grows with")));
    if (!section.given(scale))
      section.fail("Shear stiffness grows with", fmt::format("'{}' is missing.", scale));
    growth.scale    = section.number(scale);
    growth.exponent = section.given(exponent) ? section.number(exponent) : 1.;
    return growth;
  }


  void
  check_shear_growth(const ParameterSection &section, const JointParameters &joint)
  {
    if (joint.shear_growth.kind == ShearGrowth::Kind::none)
      return;
    const std::string entry = "Shear stiffness grows with";
    if (joint.friction.is_frictionless())
      section.fail(entry, "the joint carries no shear: give friction or cohesion.");
    if (joint.normal_law == LayerLaw::rigid)
      section.fail(entry,
                   "the normal law is rigid: without closure there is nothing to grow with.");
    if (joint.shear_law != LayerLaw::linear)
      section.fail(entry,
                   "'Shear law' must be linear with a compliance > 0: that of the unloaded layer.");
    if (joint.friction.dilatancy > 0.)
      section.fail(entry,
                   "not together with 'Dilatancy angle': the growth widens the layer by itself "
                   "when it is sheared.");
    if (joint.shear_growth.kind == ShearGrowth::Kind::pressure &&
        joint.friction.tensile_strength > 0.5 * joint.shear_growth.scale)
      section.fail("Tensile strength",
                   "more than half of 'Shear growth pressure': the shear stiffness would vanish "
                   "under tension.");
  }

} // namespace fuga
