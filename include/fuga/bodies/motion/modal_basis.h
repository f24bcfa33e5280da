// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_motion_modal_basis_h
#define fuga_bodies_motion_modal_basis_h

#include <fuga/bodies/condensed/condensed_system.h>

#include <string>

namespace fuga
{
  /**
   * Displacements of bodies as the sum of static ones, which the interface coordinates x make, and
   * of normal modes with the joints bonded (R. R. Craig, M. C. C. Bampton, Coupling of
   * substructures for dynamic analyses, AIAA J. 6, 1968),
   *
   *     u = Ψ x + Φ η,     K_ii Φ = M_ii Φ Ω²,     Φᵀ M Φ = 1,     L = Φᵀ M Ψ,
   *
   * with the momenta ξ = Φᵀ M u = η + L x of the modes in the place of η, so that the kinetic
   * energy is that of ξ and of x apart,
   *
   *     ½ ξ̇ᵀ ξ̇ + ½ ẋᵀ R ẋ,     R = (Ψ - ΦL)ᵀ M (Ψ - ΦL).     (doc/theory.md, section 19)
   */
  struct ModalBasis
  {
    /** Of the nodes. */
    Vector mass;
    /** Below it all modes are there [Hz]. */
    double highest_frequency = 0.;
    /** Ω² [1/s²], increasing. */
    Vector squares;
    /** Φ by nodes. */
    DenseMatrix shapes;
    DenseMatrix coupling;
    /** R, and its eigenvectors and eigenvalues. */
    DenseMatrix residual_mass, axes;
    Vector masses_along_axes;
  };

  /** @p mass: by nodes; @p highest_frequency: all modes below it are taken, but one at least [Hz].
   * @throws InputError if they are too many, NumericalFailure */
  template <int dim>
  ModalBasis
  make_modal_basis(const CondensedSystem<dim> &model,
                   const Vector &mass,
                   const double highest_frequency);

  /** How many modes there are, their frequencies, and which share of the mass moves in them where
   * the ground moves along an axis. */
  std::string
  describe(const ModalBasis &basis, const unsigned int dim);
} // namespace fuga

#endif
