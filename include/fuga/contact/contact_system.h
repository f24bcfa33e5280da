// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_contact_system_h
#define fuga_contact_contact_system_h

#include <fuga/base/numerics/sparse_operator.h>
#include <fuga/contact/water_in_joints.h>

namespace fuga
{
  /**
   * What the contact layer knows of the bodies: a small symmetric system
   *
   *     S x + Bᵀ p = F a(t),      δ = B x + E a(t),                    (doc/theory.md, eq. 2, 2a)
   *
   * with x the interface coordinates (in a finite element model the jumps themselves, B = I, but
   * for the nodes where joints cross and at their corners), p the bar forces (tension positive), δ
   * the jumps (plus minus minus, opening positive) that the joints feel, E the imposed jumps (what
   * is sawn off, or filled in, between the lips) and a(t) the factors of the load patterns at load
   * time t.
   *
   * S is symmetric and positive semidefinite; S + Bᵀ B must be positive definite: the bodies are
   * held when every bar is rigid. Units: forces MN, jumps m (any consistent system).
   */
  class ContactSystem
  {
  public:
    virtual ~ContactSystem() = default;

    /** S, n_coordinates x n_coordinates, both triangles filled. */
    virtual const DenseMatrix &
    stiffness() const = 0;

    /** Whether stiffness() is known; if not, it is empty and S by its products alone. */
    virtual bool
    has_stiffness() const
    {
      return true;
    }

    /** S x where stiffness() is not known. */
    virtual Vector
    resistance(const Vector & /*x*/) const
    {
      return {};
    }

    /** F, n_coordinates x n_patterns: the condensed force of each load pattern at factor one. */
    virtual const DenseMatrix &
    load_patterns() const = 0;

    /** B, n_bars x n_coordinates. */
    virtual const SparseOperator &
    jump_operator() const = 0;

    /** E, n_bars x n_patterns [m]. An empty matrix stands for zero. */
    virtual const DenseMatrix &
    imposed_jumps() const
    {
      static const DenseMatrix none;
      return none;
    }

    /**
     * The condensed force of what earlier phases of construction left, a part of F a that does not
     * change; empty if there is none. The work on it counts as energy of the bodies.
     */
    virtual const Vector &
    carried_load() const
    {
      static const Vector none;
      return none;
    }

    /** Forces [MN] that this problem knows besides F a, to which errors are related. */
    virtual double
    force_scale() const
    {
      return 0.;
    }

    /** The same of energies [MNm]. */
    virtual double
    energy_scale() const
    {
      return 0.;
    }

    /**
     * Rigid motions of the bodies that no support holds: n_bars x n_motions, the jump that a unit
     * motion causes in every bar. Used by the certificate for the equilibrium of each body.
     */
    virtual const DenseMatrix &
    rigid_motions() const = 0;

    /** The coordinates x of those motions, n_coordinates x n_motions; empty if they are not known.
     */
    virtual const DenseMatrix &
    rigid_coordinates() const
    {
      static const DenseMatrix unknown;
      return jump_operator().is_identity() ? rigid_motions() : unknown;
    }

    /**
     * Work of the applied (not condensed) load patterns on those motions: n_motions x n_patterns.
     * Equilibrium of a floating body reads rigid_motions()ᵀ p = rigid_motion_loads() a(t).
     */
    virtual const DenseMatrix &
    rigid_motion_loads() const = 0;

    /** The water in the joints, whose forces ω depend on which elements are open: in equilibrium
     * S x + Bᵀ (p - ω) = F a. nullptr: no joint has water that follows its opening. */
    virtual const WaterInJoints *
    water_in_joints() const
    {
      return nullptr;
    }
  };
} // namespace fuga

#endif
