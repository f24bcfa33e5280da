// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_dynamics_driving_forces_h
#define fuga_bodies_dynamics_driving_forces_h

#include <fuga/bodies/condensed/condensed_system.h>
#include <fuga/bodies/construction.h>
#include <fuga/bodies/dynamics/dashpots.h>
#include <fuga/contact/load_history.h>

namespace fuga
{
  /**
   * The forces that drive the bodies in motion, in addition to those that acted on them before:
   * changes of the loads, which assume their final values at once if the stage has no duration, and
   * the ground. With a rigid base it is the inertia of the moving ground, with a compliant one the
   * force 2 C_b v of an upward wave with the velocity v that arrives through dashpots C_b: half of
   * it moves the ground behind them (W. B. Joyner, A. T. F. Chen, Calculation of nonlinear ground
   * response in earthquakes, Bull. Seism. Soc. Am. 65, 1975).
   */
  template <int dim>
  class DrivingForces
  {
  public:
    /**
     * @p history extends to the end of the motion, @p begin is the state at the beginning of its
     * phase, @p mass that of the degrees of freedom, as in lumped_mass(). Model, definition and
     * history must live as long as this object.
     */
    DrivingForces(const CondensedSystem<dim> &model,
                  const DynamicsDefinition &dynamics,
                  const LoadHistory &history,
                  const ConstructionState &begin,
                  const Vector &mass);

    /** Return the forces by nodes [MN] at @p time since the beginning of the motion [s]. */
    Vector
    at(const double time) const;

    /** Return the factors of the load patterns, minus those with which the motion began. */
    Vector
    load_factors(const double time) const;

    /** Return the acceleration of the ground as recorded, by axes [m/s²]. */
    std::array<double, 3>
    ground_acceleration(const double time) const;

    /** Return the velocity of the upward wave through a compliant base, by axes [m/s]. */
    std::array<double, dim>
    upward_wave(const double time) const;

    /** Return the dashpots of the compliant base. */
    const Dashpots<dim> &
    base() const
    {
      return base_dashpots;
    }

  private:
    const CondensedSystem<dim> &model;
    const DynamicsDefinition &dynamics;
    const LoadHistory &history;
    /** Load time at the beginning of the motion. */
    const double begin;
    const bool is_first;
    /** Duration of the stage [s]. */
    const double duration;
    /** Whether the ground moves in this stage. */
    const bool shakes;
    const Vector mass;
    const Dashpots<dim> base_dashpots;
    std::array<Vector, dim> ground_velocities;
  };
} // namespace fuga

#endif
