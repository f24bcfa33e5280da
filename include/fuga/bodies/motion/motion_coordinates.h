// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_motion_motion_coordinates_h
#define fuga_bodies_motion_motion_coordinates_h

#include <fuga/bodies/elasticity/equilibrium_error.h>
#include <fuga/contact/dynamics/time_integration.h>

#include <string>

namespace fuga
{
  /** The coefficients α and β of Rayleigh damping αM + βK [1/s, s]. */
  struct RayleighDamping
  {
    double of_mass = 0., of_stiffness = 0.;
  };

  /** The state that bodies in motion have reached. */
  struct MotionState
  {
    const TimeIntegration &integration;
    /** Time since the motion began [s]. */
    double time = 0.;
    /** The forces that drive the bodies at that time, in their coordinates. */
    const Vector &forces;
  };

  /**
   * The coordinates in which bodies move, and in which their mass is diagonal,
   *
   *     M ü + C u̇ + K u + Gᵀ p = f(t),
   *
   * and time steps as seen from the joints, see MovingBodies.
   */
  class MotionCoordinates
  {
  public:
    virtual ~MotionCoordinates() = default;

    /** Return the diagonal of M. */
    virtual const Vector &
    mass() const = 0;

    /** Return K u. */
    virtual Vector
    stiffness_times(const Vector &u) const = 0;

    /** Return C v; empty without damping. */
    virtual Vector
    damping_times(const Vector &v) const = 0;

    /**
     * Return the part of the velocity with which a step begins: rigid motions, which are large
     * displacements that no stiffness resists; or all of it if K u costs little.
     */
    virtual Vector
    head_start(const Vector &velocity) const = 0;

    /** Return K u + C v of such a head start u. */
    virtual Vector
    resistance(const Vector &u, const Vector &v) const = 0;

    /**
     * Return the inertia forces of rigid motions that have the resultants of @p forces on every
     * body that is held by nothing but joints; may be empty for zero.
     */
    virtual Vector
    inertia_of_resultants(const Vector &forces) const = 0;

    /** Return f, without the forces of the ground beside the bodies. */
    virtual Vector
    driving_forces(const double time) const = 0;

    /** Return Gᵀ p. */
    virtual Vector
    bar_forces(const Vector &p) const = 0;

    /** Move forces to existing coordinates: from hanging nodes to their masters. */
    virtual void
    collect(Vector &forces) const = 0;

    /** Convert a velocity by nodes to the coordinates. */
    virtual Vector
    from_nodes(const Vector &velocity) const = 0;

    /** Return the jumps of the bars for a displacement. */
    virtual Vector
    jumps(const Vector &u) const = 0;

    /** Return Ŝ of K + a1 C + a0 M. */
    virtual DenseMatrix
    condensed_stiffness(const unsigned int rung, const double a0, const double a1) = 0;

    /**
     * Return a push as the interface coordinates feel it, and the change of all coordinates under
     * it if those of the interface have changed by @p x. Both require a previous call of
     * condensed_stiffness() for the rung.
     */
    virtual Vector
    condense(const unsigned int rung, const Vector &push) = 0;
    virtual Vector
    expand(const unsigned int rung, const Vector &x) = 0;

    /** Return the displacement since the motion began; entry node * dim + component. */
    virtual Vector
    displacement(const MotionState &state) const = 0;

    /** Return a velocity or acceleration in the same form. */
    virtual Vector
    at_nodes(const Vector &rate) const = 0;

    /** Set the degrees of freedom at which the next two functions are correct. */
    virtual void
    watch(const std::vector<unsigned int> &dofs) = 0;
    virtual Vector
    watched_displacement(const MotionState &state) const = 0;
    virtual Vector
    watched(const Vector &rate) const = 0;

    /** Return the mass by nodes, but zero where accelerations do not follow from forces. */
    virtual const Vector &
    accelerated_mass() const = 0;

    /**
     * Return the error of the equilibrium of all nodes if bar forces have changed by @p p, where
     * @p acting are forces that act on the nodes.
     */
    virtual EquilibriumError
    equilibrium_error(const MotionState &state, const Vector &p, const Vector &acting) const = 0;

    /** Return a line for the log; empty if there is nothing to say. */
    virtual std::string
    description() const = 0;
  };
} // namespace fuga

#endif
