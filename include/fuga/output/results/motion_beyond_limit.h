// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_results_motion_beyond_limit_h
#define fuga_output_results_motion_beyond_limit_h

#include <fuga/contact/dynamics/moving_bodies.h>
#include <fuga/contact/judge/mechanism_certificate.h>
#include <fuga/contact/path/path_result.h>

namespace fuga
{
  /** The motion of bodies that lost their equilibrium. */
  struct MotionBeyondLimit
  {
    /** The result of the slow path, and its proof if it ended at a limit load. */
    PathResult loss;
    MechanismCertificate proof;
    /** Load time of the loads under which the bodies move, and at which the slow path goes on. */
    double t = 0.;
    /** Whether the bodies have come to rest. */
    bool rests = false;
    /** Duration of the motion [s]. */
    double duration = 0.;
    /** Largest velocity of a node at the end [m/s]. */
    double velocity = 0.;
    /** Largest slip of an element, and largest change of the distance of its lips [m]. */
    double slip = 0., opening = 0.;
    /** Work of friction [MNm]. */
    double friction = 0.;
    MotionLedger energies;
  };

  template <typename Motion, typename Visitor, only_for<Motion, MotionBeyondLimit> = 0>
  void
  for_each_field(Motion &motion, Visitor &&visit)
  {
    auto &[loss, proof, t, rests, duration, velocity, slip, opening, friction, energies] = motion;
    visit("loss", loss);
    visit("proof", proof);
    visit("t", t);
    visit("rests", rests);
    visit("duration", duration);
    visit("velocity", velocity);
    visit("slip", slip);
    visit("opening", opening);
    visit("friction", friction);
    visit("energies", energies);
  }
} // namespace fuga

#endif
