// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>

namespace fuga
{
  using namespace parameter_patterns;

  JointEntries::JointEntries()
    : SectionDeclaration(
        "Joints", "One subsection per joint, with a name of your choice.", {"base"})
  {
    declare_place();
    decided = Decides::layers;
    normal.declare(*this, LayerDirection::normal);
    shear.declare(*this, LayerDirection::shear);
    thickness =
      optional("Thickness",
               &JointParameters::thickness,
               number_above(0),
               "Thickness of the layer [m]; the cubic root laws need it, the output shows "
               "Thickness/compliance with it.",
               {"0.002"});
    declare_shear_growth();
    decided = Decides::path;
    declare_strength();
  }


  void
  JointEntries::declare_place()
  {
    line =
      optional("Line",
               text(),
               "Named line (in space: surface) inside a conforming mesh, along which the mesh is "
               "opened. Either Line with its two bodies or the two lips.",
               {"base"});
    plus_body  = optional("Plus body", text(), "Body into which the normal points.", {"structure"});
    minus_body = optional("Minus body", text(), "Body at the other side of Line.", {"foundation"});
    plus_lip   = optional("Plus lip", text(), "Boundary of a mesh which is already open.");
    minus_lip =
      optional("Minus lip",
               text(),
               "Boundary opposite to Plus lip, or the word rigid: a fixed rigid obstacle.");
    defaulted("Corner angle",
              &JointDefinition::corner_angle,
              number_in(1, 180),
              "Neighbouring faces that meet at more than this [degrees] belong to different "
              "straight parts of the joint (a key, a step): where parts meet, each has an "
              "element of its own, with its own normal and area. 180: no such corners; elements "
              "have the average normal of their faces.");
  }


  void
  JointEntries::declare_shear_growth()
  {
    shear_growth =
      defaulted("Shear stiffness grows with",
                &ShearGrowth::kind,
                choice<ShearGrowth::Kind>({{"nothing", ShearGrowth::Kind::none},
                                           {"closure", ShearGrowth::Kind::closure},
                                           {"pressure", ShearGrowth::Kind::pressure}}),
                "The compliance of a linear shear law then belongs to the unloaded layer. Shear "
                "widens such a layer: both stresses derive from one potential, so closed loops "
                "without slip keep the energy.");
    growth_closure =
      optional("Shear growth closure",
               number_above(0),
               "w_c [m] in: shear compliance x (1 - closure/w_c)^exponent; the layer closes no "
               "further.");
    growth_pressure = optional("Shear growth pressure",
                               number_above(0),
                               "p_r [MPa] in: shear compliance / (1 + pressure/p_r)^exponent.");
    growth_exponent = optional("Shear growth exponent",
                               &ShearGrowth::exponent,
                               number_in(0.01, 1),
                               "1 without this entry; not above 1, so that the layer is stable.");
  }


  void
  JointEntries::declare_strength()
  {
    friction_coefficient =
      optional("Friction coefficient",
               number_from(0),
               "Limit of shear/pressure. Either this or Friction angle; neither = 0.",
               {"0.2"});
    friction_angle = optional("Friction angle",
                              number_between(0, true, 90),
                              "In place of the coefficient [degrees].")
                       .instead_of(friction_coefficient);
    residual_coefficient =
      optional("Residual friction coefficient",
               number_from(0),
               "Friction after the first slip or opening. Either this or Residual friction angle; "
               "neither: nothing is lost.");
    residual_angle = optional("Residual friction angle",
                              number_between(0, true, 90),
                              "In place of the residual coefficient [degrees].")
                       .instead_of(residual_coefficient);
    envelope_exponent = optional(
      "Envelope exponent",
      number_in(0.1, 1),
      "b in: shear strength = cohesion + friction x p_r/b [(1 + pressure/p_r)^b - 1], a curve "
      "whose "
      "slope falls from the friction coefficient at zero pressure. Without this entry 1: Coulomb's "
      "straight line.",
      {"0.7"});
    envelope_pressure = optional("Envelope pressure", number_above(0), "p_r [MPa].", {"0.5"});
    cohesion          = defaulted(
      "Cohesion", &FrictionLaw::cohesion, number_from(0), "Shear strength without pressure [MPa].");
    tensile_strength =
      defaulted("Tensile strength",
                &FrictionLaw::tensile_strength,
                number_from(0),
                "Tension that the bond of the lips carries [MPa]; at most cohesion/friction.");
    bond_loss =
      defaulted("Bond lost by",
                &FrictionLaw::bond_loss,
                choice<FrictionLaw::BondLoss>({{"opening", FrictionLaw::BondLoss::opening},
                                               {"slip", FrictionLaw::BondLoss::slip}}),
                "When cohesion and tensile strength are lost for good: at the first opening, or "
                "(brittle) at the first slip as well.");
    dilatancy_angle =
      defaulted("Dilatancy angle",
                "0",
                number_between(0, true, 90),
                "Lips that slide rise by its tangent [degrees]; at most the (residual) angle of "
                "friction.");
    dilation_limit = optional("Dilation limit",
                              &FrictionLaw::dilation_limit,
                              number_above(0),
                              "Largest rise [m]; without this entry none.");
    initial_gap    = defaulted("Initial gap",
                            &JointParameters::initial_gap,
                            text(),
                            "Gap of the undeformed joint [m]: expression of x, y.");
  }
} // namespace fuga
