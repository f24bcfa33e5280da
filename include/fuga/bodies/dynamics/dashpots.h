// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_dynamics_dashpots_h
#define fuga_bodies_dynamics_dashpots_h

#include <deal.II/base/symmetric_tensor.h>

#include <fuga/bodies/condensed/body_model.h>

#include <map>

namespace fuga
{
  /** ρ c_p and ρ c_s: the stress per velocity of plane waves [MPa s/m]. */
  struct Impedances
  {
    double pressure = 0., shear = 0.;
  };

  /** Return the impedances of all bodies. */
  template <int dim>
  std::vector<Impedances>
  impedances(const BodyModel<dim> &model);

  /** Force per velocity of the ground behind a boundary, by node [MN s/m]. */
  template <int dim>
  using Dashpots = std::map<unsigned int, dealii::SymmetricTensor<2, dim>>;

  /**
   * Return dashpots at the nodes of @p boundaries, which absorb plane waves that arrive along the
   * normal n,
   *
   *     ∫ N (ρ c_p n nᵀ + ρ c_s (1 - n nᵀ)) dA,
   *
   * and most of the other waves (J. Lysmer, R. L. Kuhlemeyer, Finite dynamic model for infinite
   * media, J. Eng. Mech. Div. ASCE 95, 1969).
   */
  template <int dim>
  Dashpots<dim>
  make_dashpots(const BodyModel<dim> &model, const std::vector<std::string> &boundaries);

  /** Add the forces of the dashpots at the velocity @p v, times @p factor. Vectors are by nodes. */
  template <int dim>
  void
  add_dashpot_forces(const double factor,
                     const Dashpots<dim> &dashpots,
                     const Vector &v,
                     Vector &forces);
} // namespace fuga

#endif
