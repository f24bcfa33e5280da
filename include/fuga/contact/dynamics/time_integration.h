// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_dynamics_time_integration_h
#define fuga_contact_dynamics_time_integration_h

#include <fuga/contact/dynamics/moving_bodies.h>

#include <functional>

namespace fuga
{
  /**
   * The generalised-α method (J. Chung, G. M. Hulbert, A time integration algorithm for structural
   * dynamics with improved numerical dissipation, J. Appl. Mech. 60, 1993) for
   *
   *     M ü + C u̇ + K u + Gᵀ p = f(t)
   *
   * with a diagonal M, in increments: a step of the length h solves
   *
   *     (K + a1 C + a0 M) (Δu - Δū) + Gᵀ Δp = push,
   *
   * with what Δu would be if bodies went on as they move.
   *
   * With the spectral radius 1 it is the trapezoidal rule, which keeps the energy. Degrees of
   * freedom without mass are in equilibrium at all times.
   */
  class TimeIntegration : private IntegrationMemory
  {
  public:
    /** C times a velocity. */
    using Damping = std::function<Vector(const Vector &)>;

    /** @p mass: diagonal of M [MN s²/m]; @p spectral_radius: ρ∞ from 0 to 1. */
    TimeIntegration(Vector mass, Damping damping, const double spectral_radius);

    /** a0 [1/s²] and a1 [1/s] of a step of the length @p h. */
    double
    mass_factor(const double h) const;
    double
    damping_factor(const double h) const;

    /** With the velocity @p v, where @p net_forces = f - K u - Gᵀ p. */
    void
    begin(const Vector &v, const Vector &net_forces);

    /** What a step changes of displacements and velocities. */
    struct Change
    {
      Vector u, v;
    };

    /** Δū, Δv̄ of a step of the length @p h: accelerations stay what they are, and of degrees of
     * freedom without mass the velocities. */
    Change
    predicted(const double h) const;

    /** Of a step over which f - K Δū - C Δv̄ changes by @p growth. */
    Vector
    push(const Vector &growth) const;

    /** Goes on by a step with the solution @p correction, Δu - Δū, and over which the loads were @p
     * mean in the mean. Counts work, kinetic energy, damping, and what the method takes by itself.
     */
    void
    advance(const double h, const Vector &correction, const Vector &mean, MotionLedger &ledger);

    const Vector &
    displacement() const
    {
      return u;
    }

    const Vector &
    velocity() const
    {
      return v;
    }

    /** Of degrees of freedom without mass the mean one over the last step, about which what the
     * rule has for them alternates from step to step. */
    const Vector &
    steady_velocity() const
    {
      return steady_v;
    }

    /** Where there is no mass, this alternates from step to step: take second differences of the
     * displacement there. */
    const Vector &
    acceleration() const
    {
      return a;
    }

    const Vector &
    mass() const
    {
      return m;
    }

    /** C v; empty without damping. */
    const Vector &
    damping_forces() const
    {
      return damped;
    }

    /** Says what f - K u - Gᵀ p really is: the next step makes up for the rounding errors that have
     * added up. */
    void
    correct(const Vector &net_forces);

    /** Changes accelerations at the end of the step so that inertia takes over @p forces of what the
     * last correct() found out of balance: the elimination has rounded away a share of K, and that
     * of the resultants of bodies which only inertia resists is more of them the stiffer they are.
     */
    void
    accelerate(const Vector &forces);

    /** f - C v - K u - Gᵀ p, which is M a but for what the method damps. */
    const Vector &
    inertia() const
    {
      return out_of_balance;
    }

    double
    kinetic_energy() const;

    const IntegrationMemory &
    memory() const
    {
      return *this;
    }

    void
    restore(const IntegrationMemory &memory)
    {
      static_cast<IntegrationMemory &>(*this) = memory;
    }

  private:
    /** At the end of a step that goes as predicted(). */
    double
    predicted_acceleration(const std::size_t i, const double h) const;

    const Vector m;
    const Damping damping;
    const double alpha_m, alpha_f, gamma, beta;
  };
} // namespace fuga

#endif
