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
   * with a diagonal M, formulated in increments: a step of the length h solves
   *
   *     (K + a1 C + a0 M) (Δu - Δū) + Gᵀ Δp = push,
   *
   * where Δū is the Δu that would result if the bodies went on as they move.
   *
   * For a spectral radius of 1 it is the trapezoidal rule, which conserves the energy. Degrees of
   * freedom without mass are in equilibrium at all times.
   */
  class TimeIntegration : private IntegrationMemory
  {
  public:
    /** A function that multiplies C by a velocity. */
    using Damping = std::function<Vector(const Vector &)>;

    /** Constructor. @p mass is the diagonal of M [MN s²/m], @p spectral_radius is ρ∞ between 0 and
     * 1. */
    TimeIntegration(Vector mass, Damping damping, const double spectral_radius);

    /** Return a0 [1/s²]; damping_factor() returns a1 [1/s], both for a step of the length @p h. */
    double
    mass_factor(const double h) const;
    double
    damping_factor(const double h) const;

    /** Begin with the velocity @p v, where @p net_forces = f - K u - Gᵀ p. */
    void
    begin(const Vector &v, const Vector &net_forces);

    /** The change of displacements and velocities in a step. */
    struct Change
    {
      Vector u, v;
    };

    /** Return Δū, Δv̄ of a step of the length @p h, for which accelerations remain constant, and so
     * do velocities of degrees of freedom without mass. */
    Change
    predicted(const double h) const;

    /** Return the push of a step over which f - K Δū - C Δv̄ changes by @p growth. */
    Vector
    push(const Vector &growth) const;

    /** Advance by a step with the solution @p correction, Δu - Δū, over which the loads had the
     * mean value @p mean. Add to @p ledger the work, the kinetic energy, the damping, and the
     * energy that the method itself takes. */
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

    /** Return the velocity; for degrees of freedom without mass the mean velocity over the last
     * step, about which the velocity of the rule alternates from step to step. */
    const Vector &
    steady_velocity() const
    {
      return steady_v;
    }

    /** Return the acceleration. Where there is no mass it alternates from step to step; use second
     * differences of the displacement there. */
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

    /** Return C v; empty without damping. */
    const Vector &
    damping_forces() const
    {
      return damped;
    }

    /** Set the true value of f - K u - Gᵀ p; the next step makes up for the rounding errors that
     * have accumulated. */
    void
    correct(const Vector &net_forces);

    /** Change the accelerations at the end of the step so that inertia takes over @p forces, a part
     * of the imbalance that the last correct() found: the elimination has rounded away a share of
     * K, which is larger relative to the resultants of bodies that only inertia resists the stiffer
     * these bodies are. */
    void
    accelerate(const Vector &forces);

    /** Return f - C v - K u - Gᵀ p, which equals M a except for what the method damps. */
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
    /** Return the acceleration at the end of a step that goes as predicted(). */
    double
    predicted_acceleration(const std::size_t i, const double h) const;

    const Vector m;
    const Damping damping;
    const double alpha_m, alpha_f, gamma, beta;
  };
} // namespace fuga

#endif
