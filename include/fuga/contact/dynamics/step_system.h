// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_dynamics_step_system_h
#define fuga_contact_dynamics_step_system_h

#include <fuga/contact/contact_element.h>
#include <fuga/contact/contact_system.h>
#include <fuga/contact/dynamics/moving_bodies.h>
#include <fuga/contact/joint_state.h>
#include <fuga/contact/load_history.h>
#include <fuga/contact/system/layered_system.h>

#include <optional>

namespace fuga
{
  /**
   * A step of bodies in motion as a static problem. It has the condensed stiffness Ŝ of a rung, see
   * MovingBodies, and three patterns that change from step to step: the forces on the coordinates
   * at its beginning; those at its end, with δ̄; and, always with the factor 1, the jumps δ_n with
   * which it begins.
   */
  class StepSystem : public ContactSystem
  {
  public:
    /** Constructor. @p rung is that of @p stiffness. @p jump_operator and @p elements must live as
     * long as this object. */
    StepSystem(DenseMatrix &&stiffness,
               const unsigned int rung,
               const SparseOperator &jump_operator,
               const std::vector<ContactElement> &elements);

    /** Begin a step from @p state. @p energy is the largest energy of the motion so far [MNm]. */
    void
    begin(const JointState &state, const MovingBodies::Step &step, const double energy);

    /** Return the factors of the patterns; the time is the part of the step that is done. */
    static LoadHistory
    history();

    const LayeredSystem &
    layered() const
    {
      return *layered_system;
    }

    /** Return x at the end of the step, where the bars have these jumps and forces. */
    Vector
    coordinates(const Vector &jumps, const Vector &forces);

    const DenseMatrix &
    stiffness() const override
    {
      return S;
    }

    const DenseMatrix &
    load_patterns() const override
    {
      return F;
    }

    const SparseOperator &
    jump_operator() const override
    {
      return B;
    }

    /** Return the size of the push, including the momentum of the bodies, over a whole step of the
     * grid. Over a short one, after a flight, the push is the only force, and smaller than the
     * effect of rounding in the displacements so far. */
    double
    force_scale() const override
    {
      return pushed;
    }

    /** Return the largest energy: joints that stay closed take and store nothing of the moving
     * energy. */
    double
    energy_scale() const override
    {
      return energy;
    }

    const DenseMatrix &
    imposed_jumps() const override
    {
      return E;
    }

    /** Return an empty matrix: inertia resists every motion. */
    const DenseMatrix &
    rigid_motions() const override
    {
      return no_motions;
    }

    const DenseMatrix &
    rigid_motion_loads() const override
    {
      return no_loads;
    }

  private:
    /** Return Ŝ x̄ + g with B x̄ = δ̄, i.e. the push that would act if the bodies did not go on as
     * they move. */
    Vector
    whole_push(const MovingBodies::Step &step) const;

    DenseMatrix S;
    const unsigned int rung;
    const SparseOperator &B;
    /** The dual D of the jump operator, Dᵀ B = 1. */
    SparseOperator dual;
    DenseMatrix no_motions, no_loads, F, E;
    std::optional<LayeredSystem> layered_system;
    /** Forces of the closed joint per unit of force on the coordinates, stored by columns. */
    DenseMatrix reactions_to_units;
    /** Factors of S, computed when first needed. */
    std::optional<LuFactors> factors;
    double pushed = 0., energy = 0.;
  };
} // namespace fuga

#endif
