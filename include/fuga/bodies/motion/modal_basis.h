// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_motion_modal_basis_h
#define fuga_bodies_motion_modal_basis_h

#include <fuga/bodies/condensed/condensed_system.h>

#include <string>

namespace fuga
{
  /**
   * Displacements of bodies as the sum of static ones, caused by the interface coordinates x, and
   * of normal modes with the joints bonded (R. R. Craig, M. C. C. Bampton, Coupling of
   * substructures for dynamic analyses, AIAA J. 6, 1968),
   *
   *     u = Ψ x + Φ η,     K_ii Φ = M_ii Φ Ω²,     Φᵀ M Φ = 1,     L = Φᵀ M Ψ,
   *
   * with the momenta ξ = Φᵀ M u = η + L x of the modes in place of η, so that the kinetic energies
   * of ξ and of x are decoupled,
   *
   *     ½ ξ̇ᵀ ξ̇ + ½ ẋᵀ R ẋ,     R = (Ψ - ΦL)ᵀ M (Ψ - ΦL).     (doc/theory.md, section 19)
   */
  struct ModalBasis
  {
    /** Mass of the nodes. */
    Vector mass;
    /** Frequency below which all modes are included [Hz]. */
    double highest_frequency = 0.;
    /** Squares Ω² of the frequencies [1/s²], in increasing order. */
    Vector squares;
    /** Shapes Φ of the modes, by nodes. */
    DenseMatrix shapes;
    DenseMatrix coupling;
    /** R, and its eigenvectors and eigenvalues. */
    DenseMatrix residual_mass, axes;
    Vector masses_along_axes;
  };

  /**
   * Compute the modal basis with the @p mass by nodes. All modes below @p highest_frequency [Hz]
   * are included, but at least one.
   * @throws InputError if there are too many, NumericalFailure
   */
  template <int dim>
  ModalBasis
  make_modal_basis(const CondensedSystem<dim> &model,
                   const Vector &mass,
                   const double highest_frequency);

  /**
   * Describe the number of modes, their frequencies, and the fraction of the mass that moves in
   * them if the ground moves along an axis.
   */
  std::string
  describe(const ModalBasis &basis, const unsigned int dim);
} // namespace fuga

#endif
