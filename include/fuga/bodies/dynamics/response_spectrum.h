// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_dynamics_response_spectrum_h
#define fuga_bodies_dynamics_response_spectrum_h

#include <fuga/bodies/dynamics_definition.h>

namespace fuga
{
  /** The largest motions of an oscillator relative to the ground. */
  struct SpectralResponse
  {
    /** Period of the undamped oscillator [s]. */
    double period = 0.;
    /** Largest displacement [m]. */
    double displacement = 0.;
    /** Largest velocity [m/s]. */
    double velocity = 0.;
    /** Pseudo-acceleration: (2π/period)² times the displacement [m/s²]. */
    double pseudo_acceleration = 0.;
  };

  /**
   * Return the responses of oscillators that are at rest when the ground begins to move, including
   * the time after its end: the exact recursion for accelerations that are linear between samples
   * (N. C. Nigam, P. C. Jennings, Calculation of response spectra from strong-motion earthquake
   * records, Bull. Seism. Soc. Am. 59, 1969), with maxima between the samples. @p periods > 0; 0 ≤
   * @p damping < 1.
   */
  std::vector<SpectralResponse>
  response_spectrum(const GroundMotion &motion, const Vector &periods, const double damping = 0.05);
} // namespace fuga

#endif
