// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/joints/joint_readers.h>
#include <fuga/input/values/value_readers.h>

#include <fmt/format.h>

#include <cmath>

namespace fuga
{
  namespace
  {
    constexpr double degree = 0.017453292519943295;

    /** Read a coefficient, or the tangent of an angle in degrees; return @p otherwise if neither is
     * given. */
    double
    read_coefficient(const ParameterSection &section,
                     const Number &coefficient,
                     const Number &angle,
                     const double otherwise)
    {
      refuse_both(section, coefficient, angle);
      if (section.given(angle))
        return std::tan(section.value(angle) * degree);
      const double value               = section.value_or(coefficient, otherwise);
      const double looks_like_an_angle = 5.;
      if (section.given(coefficient) && value > looks_like_an_angle)
        section.fail(
          coefficient,
          fmt::format("a coefficient > 5 looks like an angle in degrees: use '{}'.", angle.name()));
      return value;
    }

    StrengthEnvelope
    read_envelope(const ParameterSection &section)
    {
      const JointEntries &e = entries_of<JointEntries>();
      for (const auto &[given, missing] : {std::pair(e.envelope_exponent, e.envelope_pressure),
                                           std::pair(e.envelope_pressure, e.envelope_exponent)})
        if (section.given(given) && !section.given(missing))
          section.fail(given, fmt::format("'{}' is missing.", missing.name()));
      if (!section.given(e.envelope_exponent))
        return {};
      return {section.value(e.envelope_exponent), section.value(e.envelope_pressure)};
    }

    /** Check that friction is lost and not gained, that the tip of the cone carries the tension,
     * and that sliding creates no energy. */
    void
    check_strength(const ParameterSection &section, const FrictionLaw &law)
    {
      const JointEntries &e = entries_of<JointEntries>();
      if (law.friction_loss < 0.)
        section.fail(section.given(e.residual_angle) ? e.residual_angle : e.residual_coefficient,
                     fmt::format("residual friction {:g} is above the friction {:g} before it. "
                                 "Friction is lost by slip, not gained.",
                                 residual_friction(law),
                                 law.coefficient));
      if (law.tensile_strength * law.coefficient > law.cohesion)
        section.fail(
          e.tensile_strength,
          fmt::format("a tensile strength of {:g} lies beyond the tip of Coulomb's cone at "
                      "cohesion/friction = {:g}. Lower it, or raise the cohesion.",
                      law.tensile_strength,
                      law.cohesion / law.coefficient));
      if (law.dilatancy > residual_friction(law))
        section.fail(
          e.dilatancy_angle,
          fmt::format(
            "the tangent {:g} of the dilatancy angle is above the (residual) friction {:g}: "
            "sliding would create energy.",
            law.dilatancy,
            residual_friction(law)));
    }
  } // namespace


  FrictionLaw
  read_strength(const ParameterSection &section)
  {
    const JointEntries &e = entries_of<JointEntries>();
    FrictionLaw law;
    section.read(law);
    law.coefficient = read_coefficient(section, e.friction_coefficient, e.friction_angle, 0.);
    law.friction_loss =
      law.coefficient -
      read_coefficient(section, e.residual_coefficient, e.residual_angle, law.coefficient);
    law.dilatancy = std::tan(section.value(e.dilatancy_angle) * degree);
    law.envelope  = read_envelope(section);
    if (law.bond_loss == FrictionLaw::BondLoss::slip && law.cohesion == 0. &&
        law.tensile_strength == 0.)
      section.fail(e.bond_loss, "there is no bond to lose: give 'Cohesion' or 'Tensile strength'.");
    if (section.given(e.dilation_limit) && law.dilatancy == 0.)
      section.fail(e.dilation_limit, "there is no dilatancy to limit: 'Dilatancy angle' is 0.");
    for (const AnyEntry &entry :
         {e.residual_coefficient, e.residual_angle, e.envelope_exponent, e.dilatancy_angle})
      if (law.coefficient == 0. && section.given(entry))
        section.fail(entry,
                     "the joint has no friction: give 'Friction coefficient' or 'Friction angle'.");
    check_strength(section, law);
    return law;
  }


  ShearGrowth
  read_shear_growth(const ParameterSection &section)
  {
    const JointEntries &e = entries_of<JointEntries>();
    ShearGrowth growth;
    section.read(growth);
    const std::string word = section.text(e.shear_growth);
    if (growth.kind == ShearGrowth::Kind::none)
      {
        for (const AnyEntry &entry : {e.growth_closure, e.growth_pressure, e.growth_exponent})
          if (section.given(entry))
            section.fail(entry,
                         fmt::format("'{} = {}': remove this entry, or choose closure or pressure.",
                                     e.shear_growth.name(),
                                     word));
        return growth;
      }
    const bool by_closure = growth.kind == ShearGrowth::Kind::closure;
    const Number &scale   = by_closure ? e.growth_closure : e.growth_pressure;
    const Number &unused  = by_closure ? e.growth_pressure : e.growth_closure;
    if (section.given(unused))
      section.fail(unused,
                   fmt::format("'{} = {}' ({}) does not use this entry.",
                               e.shear_growth.name(),
                               word,
                               section.origin(e.shear_growth)));
    if (!section.given(scale))
      section.fail(e.shear_growth, fmt::format("'{}' is missing.", scale.name()));
    growth.scale = section.value(scale);
    return growth;
  }


  void
  check_shear_growth(const ParameterSection &section, const JointParameters &joint)
  {
    const JointEntries &e = entries_of<JointEntries>();
    if (joint.shear_growth.kind == ShearGrowth::Kind::none)
      return;
    const AnyEntry &entry = e.shear_growth;
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
      section.fail(e.tensile_strength,
                   "more than half of 'Shear growth pressure': the shear stiffness would vanish "
                   "under tension.");
  }

} // namespace fuga
