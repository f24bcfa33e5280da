// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_dynamics_ground_motion_h
#define fuga_bodies_dynamics_ground_motion_h

#include <fuga/bodies/dynamics_definition.h>

namespace fuga
{
  /**
   * Return the acceleration @p t seconds after the beginning [m/s²]: 0 before it and after the end.
   */
  double
  acceleration_at(const GroundMotion &motion, const double t);

  /** Return the time from the first sample to the last one [s]. */
  double
  duration_of(const GroundMotion &motion);

  /**
   * Velocities [m/s] and displacements [m] at the samples, starting from rest, exact for
   * accelerations that are linear in between.
   */
  struct IntegratedMotion
  {
    Vector velocities, displacements;
  };

  IntegratedMotion
  integrated(const GroundMotion &motion);

  /**
   * Return the velocity @p t seconds after the beginning [m/s], from the velocities of
   * integrated(); after the end it remains constant.
   */
  double
  velocity_at(const GroundMotion &motion, const Vector &velocities, const double t);

  /**
   * Return 2π √(∫a² dt / ∫ȧ² dt) [s]: the mean period of the zero crossings of a stationary random
   * motion (S. O. Rice, Mathematical analysis of random noise, Bell System Tech. J. 24, 1945, eq.
   * 3.3-11); for a harmonic motion, its period. Infinite if the acceleration does not change.
   */
  double
  mean_period(const GroundMotion &motion);

  /**
   * Return the motion minus c₀ + c₁ t + c₂ t², with the coefficients that minimise the integral of
   * the square of its velocity (G. V. Berg, G. W. Housner, Integrated velocity and displacement of
   * strong earthquake ground motion, Bull. Seism. Soc. Am. 51, 1961).
   */
  GroundMotion
  without_parabola(const GroundMotion &motion);
} // namespace fuga

#endif
