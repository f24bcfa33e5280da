// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_dynamics_bodies_in_motion_h
#define fuga_bodies_dynamics_bodies_in_motion_h

#include <fuga/bodies/dynamics/free_field.h>
#include <fuga/bodies/dynamics/geometric_stiffness.h>
#include <fuga/bodies/dynamics/step_solvers.h>
#include <fuga/bodies/elasticity/free_motions.h>
#include <fuga/contact/dynamics/time_integration.h>
#include <fuga/contact/load_history.h>

#include <memory>
#include <optional>

namespace fuga
{
  /**
   * The finite element model in a stage with a duration, or in the motion that follows the loss of
   * an equilibrium: displacements from where the motion begins, relative to the ground, under what
   * the loads change since then and the inertia of the moving ground. Each length of step has a
   * factorisation of its own, made when first needed; a step is one solution with it.
   * (doc/theory.md, section 19)
   */
  template <int dim>
  class BodiesInMotion : public MovingBodies
  {
  public:
    /**
     * @p bodies: the model at rest, with its load patterns; @p dynamics: its own, but for the motion
     * of the ground; @p history: factors of the patterns up to the end of the motion. All must live
     * as long as this object. @p begin: of the phase, with the @p temperature then. @p
     * massless_joints: see lumped_mass(). @p steps: of another motion of these bodies, used if they
     * fit.
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

    const DenseMatrix &
    jump_operator() const override
    {
      return model.jump_operator();
    }

    Vector
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

    /** Since the motion began [s]. */
    double
    time() const
    {
      return present_time;
    }

    /** Acceleration of the ground at the present time, by axes [m/s²]. */
    std::array<double, 3>
    ground_acceleration() const
    {
      return driving->ground_acceleration(present_time);
    }

    /** Displacement since the motion began; entry node * dim + component. */
    const Vector &
    displacement() const
    {
      return integration->displacement();
    }

    /** [m/s] */
    const Vector &
    velocity() const
    {
      return integration->velocity();
    }

    /** To be looked at: see TimeIntegration [m/s]. */
    const Vector &
    steady_velocity() const
    {
      return integration->steady_velocity();
    }

    /** That of the integration in time, without that of the frame; see TimeIntegration [m/s²]. */
    const Vector &
    acceleration() const
    {
      return integration->acceleration();
    }

    /** Of the frame in which displacements are measured, by axes [m/s²]: that of the ground, but
     * over a compliant base, where they are absolute. */
    std::array<double, 3>
    acceleration_of_frame() const;

    /** Diagonal of the mass matrix. */
    const Vector &
    mass() const
    {
      return integration->mass();
    }

    /** Of any node [m/s]. */
    double
    largest_velocity() const;

    /** Error of the equilibrium M ü + C u̇ + K u + Gᵀ(p - p_0) = f of all nodes for bar forces @p p. */
    EquilibriumError
    equilibrium_error(const Vector &p) const;

    const std::shared_ptr<StepSolvers> &
    step_solvers() const
    {
      return steps;
    }

  private:
    /** K u + K_g u. */
    Vector
    restoring_forces(const Vector &u) const;

    Vector
    damping_times(const Vector &v) const;

    /** By nodes: what the phase begins with, or those of the bodies in the first dynamic stage. */
    Vector
    initial_velocity() const;

    /** f - K u - K_g u - Gᵀ(p - p_0) for bar forces p and restoring forces (empty: zero). */
    Vector
    net_forces(const Vector &bar_forces, const Vector &restoring) const;

    const CondensedSystem<dim> &model;
    const DynamicsDefinition dynamics;
    const ConstructionState &construction;
    const TimeGrid grid;
    /** α and β of Rayleigh's damping αM + βK [1/s, s]. */
    double mass_damping = 0., stiffness_damping = 0.;
    /** Of the absorbing boundaries. */
    const Dashpots<dim> dashpots;
    const FreeMotions free_motions;
    dealii::SparsityPattern pattern;
    /** K, and K_g if it is wanted; by nodes, of the own cells. */
    dealii::SparseMatrix<double> stiffness, geometric;
    std::unique_ptr<TimeIntegration> integration;
    std::shared_ptr<StepSolvers> steps;
    std::optional<DrivingForces<dim>> driving;
    std::optional<FreeField<dim>> free_field;
    /** Bar forces at the beginning, and what they are at the nodes. */
    Vector first_forces, first_forces_at_nodes;
    /** Forces now and at the end of the step. */
    Vector forces, forces_at_end;
    double present_time       = 0.;
    unsigned int rung_of_step = 0;
  };
} // namespace fuga

#endif
