// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_entries.h>

namespace fuga
{
  using namespace parameter_entries;

  std::vector<EntryDeclaration>
  parameter_entries::joint_strength_entries()
  {
    return {
      optional("Friction coefficient",
               number_from(0),
               "Limit of shear/pressure. Either this or Friction angle; neither = 0.",
               {"0.2"}),
      optional(
        "Friction angle", number_between(0, true, 90), "In place of the coefficient [degrees]."),
      optional("Residual friction coefficient",
               number_from(0),
               "Friction after the first slip or opening. Either this or Residual friction angle; "
               "neither: nothing is lost."),
      optional("Residual friction angle",
               number_between(0, true, 90),
               "In place of the residual coefficient [degrees]."),
      defaulted("Cohesion", "0", number_from(0), "Shear strength without pressure [MPa]."),
      defaulted("Tensile strength",
                "0",
                number_from(0),
                "Tension that the bond of the lips carries [MPa]; at most cohesion/friction."),
      defaulted("Bond lost by",
                "opening",
                choice("opening|slip"),
                "When cohesion and tensile strength are lost for good: at the first opening, or "
                "(brittle) at the first slip as well."),
      defaulted("Dilatancy angle",
                "0",
                number_between(0, true, 90),
                "Lips that slide rise by its tangent [degrees]; at most the (residual) angle of "
                "friction."),
      optional("Dilation limit", number_above(0), "Largest rise [m]; without this entry none."),
      defaulted(
        "Initial gap", "0", text(), "Gap of the undeformed joint [m]: expression of x, y.")};
  }

  std::vector<EntryDeclaration>
  parameter_entries::joint_shear_growth_entries()
  {
    return {
      defaulted("Shear stiffness grows with",
                "nothing",
                choice("nothing|closure|pressure"),
                "The compliance of a linear shear law then belongs to the unloaded layer. Shear "
                "widens such a layer: both stresses derive from one potential, so closed loops "
                "without slip keep the energy."),
      optional("Shear growth closure",
               number_above(0),
               "w_c [m] in: shear compliance x (1 - closure/w_c)^exponent; the layer closes no "
               "further."),
      optional("Shear growth pressure",
               number_above(0),
               "p_r [MPa] in: shear compliance / (1 + pressure/p_r)^exponent."),
      optional("Shear growth exponent",
               number_in(0.01, 1),
               "1 without this entry; not above 1, so that the layer is stable.")};
  }
} // namespace fuga
