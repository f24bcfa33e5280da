// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_contact_system_h
#define fuga_contact_contact_system_h

#include <fuga/base/numerics/sparse_operator.h>
#include <fuga/contact/water_in_joints.h>

namespace fuga
{
  /**
   * The bodies as the contact layer knows them: a small symmetric system
   *
   *     S x + Bᵀ p = F a(t),      δ = B x + E a(t),                    (doc/theory.md, eq. 2, 2a)
   *
   * where x are the interface coordinates (in a finite element model the jumps themselves, B = I,
   * except at the nodes where joints cross and at their corners), p the bar forces (tension
   * positive), δ the jumps (plus minus minus, opening positive) that the joints feel, E the imposed
   * jumps (the material that is sawn off, or filled in, between the lips) and a(t) the factors of
   * the load patterns at load time t.
   *
   * S is symmetric and positive semidefinite; S + Bᵀ B must be positive definite, i.e. the bodies
   * are held when every bar is rigid. Units: forces MN, jumps m (any consistent system).
   */
  class ContactSystem
  {
  public:
    virtual ~ContactSystem() = default;

    /** Return S, n_coordinates x n_coordinates, with both triangles filled. */
    virtual const DenseMatrix &
    stiffness() const = 0;

    /** Return whether stiffness() is known. If not, it is empty and S is known only through its
     * products. */
    virtual bool
    has_stiffness() const
    {
      return true;
    }

    /** Return S x where stiffness() is not known. */
    virtual Vector
    resistance(const Vector & /*x*/) const
    {
      return {};
    }

    /** Return F, n_coordinates x n_patterns: the condensed force of each load pattern at factor
     * one. */
    virtual const DenseMatrix &
    load_patterns() const = 0;

    /** Return B, n_bars x n_coordinates. */
    virtual const SparseOperator &
    jump_operator() const = 0;

    /** Return E, n_bars x n_patterns [m]. An empty matrix stands for zero. */
    virtual const DenseMatrix &
    imposed_jumps() const
    {
      static const DenseMatrix none;
      return none;
    }

    /**
     * Return the condensed force that earlier phases of construction have left, a constant part of
     * F a; empty if there is none. Its work counts as energy of the bodies.
     */
    virtual const Vector &
    carried_load() const
    {
      static const Vector none;
      return none;
    }

    /** Return the size of the forces [MN] that occur in this problem besides F a; errors are
     * related to it. */
    virtual double
    force_scale() const
    {
      return 0.;
    }

    /** Return the corresponding size of energies [MNm]. */
    virtual double
    energy_scale() const
    {
      return 0.;
    }

    /**
     * Return the rigid motions of the bodies that no support holds, n_bars x n_motions: the jump
     * that a unit motion causes in every bar. The certificate uses them for the equilibrium of each
     * body.
     */
    virtual const DenseMatrix &
    rigid_motions() const = 0;

    /** Return the coordinates x of those motions, n_coordinates x n_motions; empty if they are not
     * known. */
    virtual const DenseMatrix &
    rigid_coordinates() const
    {
      static const DenseMatrix unknown;
      return jump_operator().is_identity() ? rigid_motions() : unknown;
    }

    /**
     * Return the work of the applied (not condensed) load patterns on those motions, n_motions x
     * n_patterns. Equilibrium of a floating body reads rigid_motions()ᵀ p = rigid_motion_loads()
     * a(t).
     */
    virtual const DenseMatrix &
    rigid_motion_loads() const = 0;

    /** Return the water in the joints, whose forces ω depend on which elements are open;
     * equilibrium then reads S x + Bᵀ (p - ω) = F a. A nullptr means that no joint has water that
     * follows its opening. */
    virtual const WaterInJoints *
    water_in_joints() const
    {
      return nullptr;
    }
  };
} // namespace fuga

#endif
