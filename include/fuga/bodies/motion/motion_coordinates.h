// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_motion_motion_coordinates_h
#define fuga_bodies_motion_motion_coordinates_h

#include <fuga/bodies/elasticity/equilibrium_error.h>
#include <fuga/contact/dynamics/time_integration.h>

#include <string>

namespace fuga
{
  /** α and β of Rayleigh's damping αM + βK [1/s, s]. */
  struct RayleighDamping
  {
    double of_mass = 0., of_stiffness = 0.;
  };

  /** Where bodies in motion have come to. */
  struct MotionState
  {
    const TimeIntegration &integration;
    /** Since the motion began [s]. */
    double time = 0.;
    /** What drives the bodies then, in their coordinates. */
    const Vector &forces;
  };

  /**
   * The coordinates in which bodies move, and in which their mass is diagonal,
   *
   *     M ü + C u̇ + K u + Gᵀ p = f(t),
   *
   * and how steps of time look from the joints: see MovingBodies.
   */
  class MotionCoordinates
  {
  public:
    virtual ~MotionCoordinates() = default;

    /** Diagonal of M. */
    virtual const Vector &
    mass() const = 0;

    /** K u. */
    virtual Vector
    stiffness_times(const Vector &u) const = 0;

    /** C v; empty without damping. */
    virtual Vector
    damping_times(const Vector &v) const = 0;

    /** Of the velocity, the part that a step begins with: rigid motions, which are far ways that no
     * stiffness resists; or all of it where K u costs little. */
    virtual Vector
    head_start(const Vector &velocity) const = 0;

    /** K u + C v of such a head start u. */
    virtual Vector
    resistance(const Vector &u, const Vector &v) const = 0;

    /** The forces of inertia of rigid motions that have the resultants of @p forces on every body that
     * nothing but joints holds; may be empty for zero. */
    virtual Vector
    inertia_of_resultants(const Vector &forces) const = 0;

    /** f, without what goes on beside the bodies. */
    virtual Vector
    driving_forces(const double time) const = 0;

    /** Gᵀ p. */
    virtual Vector
    bar_forces(const Vector &p) const = 0;

    /** Moves forces to where there are coordinates: from hanging nodes to their masters. */
    virtual void
    collect(Vector &forces) const = 0;

    /** Of a velocity by nodes. */
    virtual Vector
    from_nodes(const Vector &velocity) const = 0;

    /** Of the bars, of a displacement. */
    virtual Vector
    jumps(const Vector &u) const = 0;

    /** Ŝ of K + a1 C + a0 M. */
    virtual DenseMatrix
    condensed_stiffness(const unsigned int rung, const double a0, const double a1) = 0;

    /** A push as the interface coordinates feel it, and the change of all coordinates under it
     * where
     * those of the interface have changed by @p x. condensed_stiffness() of the rung came before. */
    virtual Vector
    condense(const unsigned int rung, const Vector &push) = 0;
    virtual Vector
    expand(const unsigned int rung, const Vector &x) = 0;

    /** Displacement since the motion began; entry node * dim + component. */
    virtual Vector
    displacement(const MotionState &state) const = 0;

    /** A velocity or acceleration likewise. */
    virtual Vector
    at_nodes(const Vector &rate) const = 0;

    /** Where the next two functions are right: at these degrees of freedom. */
    virtual void
    watch(const std::vector<unsigned int> &dofs) = 0;
    virtual Vector
    watched_displacement(const MotionState &state) const = 0;
    virtual Vector
    watched(const Vector &rate) const = 0;

    /** Mass by nodes, but zero where accelerations do not follow from forces. */
    virtual const Vector &
    accelerated_mass() const = 0;

    /** Error of the equilibrium of all nodes where bar forces have changed by @p p, with
     * forces that @p act on the nodes. */
    virtual EquilibriumError
    equilibrium_error(const MotionState &state, const Vector &p, const Vector &acting) const = 0;

    /** A line for the log; empty if there is nothing to say. */
    virtual std::string
    description() const = 0;
  };
} // namespace fuga

#endif
