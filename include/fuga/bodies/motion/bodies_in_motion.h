// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_motion_bodies_in_motion_h
#define fuga_bodies_motion_bodies_in_motion_h

#include <fuga/bodies/dynamics/free_field.h>
#include <fuga/bodies/loads/temperature_field.h>
#include <fuga/bodies/motion/motion_coordinates.h>
#include <fuga/bodies/motion/step_solvers.h>
#include <fuga/contact/load_history.h>

#include <memory>
#include <optional>

namespace fuga
{
  /**
   * The finite element model in a stage with a duration, or in the motion that follows the loss of
   * an equilibrium: displacements since the motion began, relative to the ground, under the changes
   * of the loads since then and the inertia of the moving ground. If no highest frequency is given,
   * modes are used up to the frequency for which a whole step is half a period. (doc/theory.md,
   * section 19)
   */
  template <int dim>
  class BodiesInMotion : public MovingBodies
  {
  public:
    /**
     * @p bodies is the model at rest, with its load patterns; @p dynamics is its own definition,
     * except for the motion of the ground; @p history contains the factors of the patterns up to
     * the end of the motion. All of them must live as long as this object. @p begin is the state at
     * the beginning of the phase, with the @p temperature at that time. For @p massless_joints, see
     * lumped_mass(). @p steps are those of another motion of these bodies, used if they fit.
     */
    BodiesInMotion(const CondensedSystem<dim> &bodies,
                   const DynamicsDefinition &dynamics,
                   const LoadHistory &history,
                   const ConstructionState &begin,
                   const TemperatureField<dim> &temperature,
                   const std::vector<bool> &massless_joints,
                   std::shared_ptr<StepSolvers> steps = nullptr);

    ~BodiesInMotion() override;

    void
    begin(const Vector &bar_forces, MotionLedger &ledger) override;

    DenseMatrix
    condensed_stiffness(const unsigned int rung) override;

    const SparseOperator &
    jump_operator() const override
    {
      return model.jump_operator();
    }

    Step
    begin_step(const unsigned int rung) override;

    void
    finish_step(const Vector &x, const Vector &bar_forces, MotionLedger &ledger) override;
    MotionMemory
    memory() const override;
    void
    restore(const MotionMemory &memory) override;

    const TimeGrid &
    time_grid() const
    {
      return grid;
    }

    /** Return the time since the motion began [s]. */
    double
    time() const
    {
      return present_time;
    }

    /** Return the acceleration of the ground at the present time, by axes [m/s²]. */
    std::array<double, 3>
    ground_acceleration() const
    {
      return driving->ground_acceleration(present_time);
    }

    /** Return the displacement since the motion began; entry node * dim + component. */
    Vector
    displacement() const
    {
      return coordinates->displacement(now());
    }

    /** Return the velocity [m/s]. */
    Vector
    velocity() const
    {
      return coordinates->at_nodes(integration->velocity());
    }

    /** Return the velocity for output, see TimeIntegration [m/s]. */
    Vector
    steady_velocity() const
    {
      return coordinates->at_nodes(integration->steady_velocity());
    }

    /**
     * Ensure that from now on the next two functions are correct at these degrees of freedom (entry
     * node * dim + component), at little cost.
     */
    void
    watch(const std::vector<unsigned int> &dofs)
    {
      coordinates->watch(dofs);
    }

    Vector
    watched_displacement() const
    {
      return coordinates->watched_displacement(now());
    }

    /**
     * Return the acceleration of the integration in time, without that of the frame, see
     * TimeIntegration [m/s²].
     */
    Vector
    watched_acceleration() const
    {
      return coordinates->watched(integration->acceleration());
    }

    /**
     * Return the acceleration of the frame in which displacements are measured, by axes [m/s²]:
     * that of the ground, except over a compliant base, where displacements are absolute.
     */
    std::array<double, 3>
    acceleration_of_frame() const;

    /** Return the mass by nodes, but zero where accelerations do not follow from forces. */
    const Vector &
    accelerated_mass() const
    {
      return coordinates->accelerated_mass();
    }

    /** Return a line for the log about the coordinates; empty if there is nothing to say. */
    std::string
    description() const
    {
      return coordinates->description();
    }

    /** Return the largest velocity of any node [m/s]. */
    double
    largest_velocity() const;

    /**
     * Return the error of the equilibrium M ü + C u̇ + K u + Gᵀ(p - p_0) = f of all nodes for bar
     * forces @p p.
     */
    EquilibriumError
    equilibrium_error(const Vector &p) const;

    const std::shared_ptr<StepSolvers> &
    step_solvers() const
    {
      return steps;
    }

  private:
    std::unique_ptr<MotionCoordinates>
    make_coordinates(const TemperatureField<dim> &temperature) const;

    MotionState
    now() const
    {
      return {*integration, present_time, forces};
    }

    /**
     * Return the initial velocity by nodes: that at the beginning of the phase, or those of the
     * bodies in the first dynamic stage.
     */
    Vector
    initial_velocity() const;

    /** Return f - K u - Gᵀ(p - p_0) for bar forces p and restoring forces K u (empty: zero). */
    Vector
    net_forces(const Vector &bar_forces, const Vector &restoring) const;

    const CondensedSystem<dim> &model;
    const DynamicsDefinition dynamics;
    const ConstructionState &construction;
    const TimeGrid grid;
    const RayleighDamping damping;
    std::shared_ptr<StepSolvers> steps;
    std::optional<DrivingForces<dim>> driving;
    std::optional<FreeField<dim>> free_field;
    std::unique_ptr<MotionCoordinates> coordinates;
    std::unique_ptr<TimeIntegration> integration;
    /** Bar forces at the beginning, and the corresponding forces on the coordinates. */
    Vector first_forces, first_forces_on_coordinates;
    /** Forces now and at the end of the step. */
    Vector forces, forces_at_end;
    /** Displacement beyond the head start of the step if the bodies continue to move as they do. */
    Vector beyond_start;
    double present_time       = 0.;
    unsigned int rung_of_step = 0;
  };
} // namespace fuga

#endif
