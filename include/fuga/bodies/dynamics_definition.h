// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_dynamics_definition_h
#define fuga_bodies_dynamics_definition_h

#include <fuga/base/numerics/dense_matrix.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace fuga
{
  /**
   * Acceleration of the ground along one axis: samples at equal steps starting at time 0, linear in
   * between, and zero after the last of them.
   */
  struct GroundMotion
  {
    /** Time between samples [s]. */
    double step = 0.;
    /** Samples of the acceleration [m/s²]; empty: the ground does not move along this axis. */
    Vector accelerations;
  };

  /**
   * Water that moves with a boundary (H. M. Westergaard, Water pressures on dams during
   * earthquakes, Trans. ASCE 98, 1933): the mass 7/8 (γ/g) √(H d) per area at the depth d below the
   * level, where H is the depth of the bottom, along the normal of the boundary.
   */
  struct AddedMass
  {
    std::vector<std::string> boundaries;
    /** Heights of surface and bottom of the water [m]. */
    double level = 0., bottom = 0.;
    /** Unit weight γ [MN/m³]. */
    double unit_weight = 0.;
    /** file:line of the entry, for messages. */
    std::string origin;
  };

  struct NamedBoundaries
  {
    std::vector<std::string> names;
    /** file:line of the entry, for messages. */
    std::string origin;
  };

  /** The treatment of a record that does not end at rest. */
  enum class Baseline
  {
    /** Give a warning. */
    warn,
    /** Do nothing: it is intended. */
    keep,
    /** Subtract a parabola, see without_parabola(). */
    parabolic
  };

  /** The effects of second order in the displacements that a motion includes. */
  enum class SecondOrder
  {
    none,
    /** The weight acts on the displaced bodies, see add_geometric_stiffness(). */
    weight
  };

  /** The coordinates in which bodies move. */
  enum class MotionBodies
  {
    finite_elements,
    /** Modes of the bodies, see ModalBasis. */
    modes
  };

  /** Parameters of the motion in stages with a duration. */
  struct DynamicsDefinition
  {
    /** Length of a step [s]; steps are a little shorter if levels of a stage require it. */
    double time_step = 0.;
    /**
     * Number of times that a step may be halved to find an event; 0: events are found within whole
     * steps.
     */
    unsigned int halvings = 10;
    /** A step is halved if its events cost more than this fraction of the largest energy so far. */
    double event_tolerance = 1e-4;
    /**
     * ρ∞ of the generalised-α method: 1 conserves the energy (trapezoidal rule), a smaller value
     * damps motions that the steps do not resolve.
     */
    double spectral_radius = 1.;
    /** g, which converts weight densities to masses [m/s²]. */
    double gravity           = 9.81;
    SecondOrder second_order = SecondOrder::none;
    MotionBodies bodies      = MotionBodies::finite_elements;
    /** Modes below this frequency are used [Hz]; 0: see BodiesInMotion. */
    double highest_frequency = 0.;
    /**
     * Bodies without inertia, e.g. a foundation through which the ground motion arrives at once.
     */
    std::vector<std::string> massless_bodies;
    /** Rayleigh damping of the bodies has this ratio at both frequencies [Hz]; 0: none. */
    double damping_ratio                      = 0.;
    std::array<double, 2> damping_frequencies = {{0., 0.}};
    /**
     * Motion of the ground by axis, from the beginning of the stage with the number
     * @p earthquake_stage.
     */
    std::array<GroundMotion, 3> ground;
    unsigned int earthquake_stage = 0;
    Baseline baseline             = Baseline::warn;
    std::vector<AddedMass> added_masses;
    /**
     * Boundaries beyond which the bodies continue: dashpots absorb the waves that leave there.
     * Supports on them hold only in slow stages; the forces that they carry when a dynamic stage
     * begins continue to act.
     */
    NamedBoundaries absorbing;
    /**
     * The absorbing boundaries through which the motion of the ground arrives as an upward wave. If
     * there are none, the ground moves as a whole, and displacements are relative to it.
     */
    NamedBoundaries compliant_base;
    /** The share of the motion of the ground that is in the upward wave. */
    double upward_share = 1.;
    /**
     * The absorbing boundaries outside of which the bodies move as they would without everything in
     * between.
     */
    NamedBoundaries free_field;
    /**
     * Longest motion of bodies that lost their equilibrium [s], and the part of a stage by which
     * the loads under which they move are later.
     */
    double longest_continuation = 10.;
    double excess               = 0.01;

    /**
     * Return the load time of the loads under which bodies move that have lost their equilibrium at
     * @p t, and at which the slow path continues afterwards; at least half of the rest of the stage
     * is left for that.
     */
    double
    end_of_continuation(const double t) const
    {
      return t + std::min(excess, 0.5 * (std::floor(t) + 1. - t));
    }

    /** Return whether massless_bodies contain the body. */
    bool
    is_massless(const std::string &body) const
    {
      return std::find(massless_bodies.begin(), massless_bodies.end(), body) !=
             massless_bodies.end();
    }
  };
} // namespace fuga

#endif
