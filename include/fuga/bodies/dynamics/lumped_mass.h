// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_dynamics_lumped_mass_h
#define fuga_bodies_dynamics_lumped_mass_h

#include <fuga/bodies/condensed/body_model.h>

namespace fuga
{
  /**
   * Return the masses of the nodes [MN s²/m]: those of the cells in proportion to the diagonal of
   * their consistent mass matrix (E. Hinton, T. Rock, O. C. Zienkiewicz, A note on mass lumping and
   * related processes in the finite element method, Earthquake Eng. Struct. Dyn. 4, 1976), positive
   * for all elements, and on quadrilaterals and hexahedra equal to those of the Gauss–Lobatto rule.
   * The components along the axes of the mass of water that moves with boundaries are added. Entry
   * node * dim + component; zero where a support holds.
   *
   * The lips of @p massless_joints, which are rigid, have no mass: their contact is then static in
   * the displacements of the lips, so that it conserves energy and its pressure does not oscillate
   * (H. B. Khenous, P. Laborde, Y. Renard, Mass redistribution method for finite element contact
   * problems in elastodynamics, Eur. J. Mech. A/Solids 27, 2008). Their mass is given to the other
   * nodes of their cells. Lips of a body that could then turn without inertia keep their mass.
   */
  template <int dim>
  Vector
  lumped_mass(const BodyModel<dim> &model, const std::vector<bool> &massless_joints);
} // namespace fuga

#endif
