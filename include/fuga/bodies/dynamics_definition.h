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
  /** Acceleration of the ground along one axis: samples from time 0 at equal steps, linear in
   * between, and zero behind the last of them. */
  struct GroundMotion
  {
    /** [s] */
    double step = 0.;
    /** [m/s²]; empty: the ground does not move along this axis. */
    Vector accelerations;
  };

  /**
   * Water that moves with a boundary (H. M. Westergaard, Water pressures on dams during
   * earthquakes, Trans. ASCE 98, 1933): the mass 7/8 (γ/g) √(H d) per area at the depth d below the
   * level, H the depth of the bottom, along the normal of the boundary.
   */
  struct AddedMass
  {
    std::vector<std::string> boundaries;
    /** Heights of surface and bottom of the water [m]. */
    double level = 0., bottom = 0.;
    /** γ [MN/m³]. */
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

  /** What is done about a record that does not end at rest. */
  enum class Baseline
  {
    /** A warning. */
    warn,
    /** Nothing: it is meant. */
    keep,
    /** See without_parabola(). */
    parabolic
  };

  /** What of second order in the displacements a motion knows. */
  enum class SecondOrder
  {
    none,
    /** See add_geometric_stiffness(). */
    weight
  };

  /** In what coordinates bodies move. */
  enum class MotionBodies
  {
    finite_elements,
    /** See ModalBasis. */
    modes
  };

  /** How stages with a duration go on in time. */
  struct DynamicsDefinition
  {
    /** Length of a step [s]; steps are a little shorter where levels of a stage ask for it. */
    double time_step = 0.;
    /** How often a step may be halved to find an event; 0: events are found within whole steps. */
    unsigned int halvings = 10;
    /** A step is halved if its events cost more than this share of the largest energy so far. */
    double event_tolerance = 1e-4;
    /** ρ∞ of the generalised-α method: 1 keeps the energy (trapezoidal rule), less of it damps what
     * the steps do not resolve. */
    double spectral_radius = 1.;
    /** g, which makes masses of weight densities [m/s²]. */
    double gravity           = 9.81;
    SecondOrder second_order = SecondOrder::none;
    MotionBodies bodies      = MotionBodies::finite_elements;
    /** Modes below it are taken [Hz]; 0: see BodiesInMotion. */
    double highest_frequency = 0.;
    /** Bodies without inertia: a foundation through which the ground motion arrives at once. */
    std::vector<std::string> massless_bodies;
    /** Rayleigh damping of the bodies has this ratio at both frequencies [Hz]; 0: none. */
    double damping_ratio                      = 0.;
    std::array<double, 2> damping_frequencies = {{0., 0.}};
    /** By axis, from the beginning of the stage with the number @p earthquake_stage. */
    std::array<GroundMotion, 3> ground;
    unsigned int earthquake_stage = 0;
    Baseline baseline             = Baseline::warn;
    std::vector<AddedMass> added_masses;
    /** Behind them the bodies go on: dashpots take the waves that leave there. Supports on them
     * hold in slow stages only; what they carry when a dynamic stage begins acts on. */
    NamedBoundaries absorbing;
    /** Those of them through which the motion of the ground comes up as a wave. Where there are
     * none, the ground moves as a whole, and displacements are relative to it. */
    NamedBoundaries compliant_base;
    /** What of the motion of the ground the wave that comes up is. */
    double upward_share = 1.;
    /** Those of them beside which the bodies move as they would without all that is between. */
    NamedBoundaries free_field;
    /** Where equilibrium was lost the bodies move for so long at most [s], under the loads that act
     * this part of a stage later. */
    double longest_continuation = 10.;
    double excess               = 0.01;

    /** Load time of the loads under which bodies move that have lost their equilibrium at @p t, and
     * at which the slow path goes on behind; half of what is left of the stage at least is for
     * that.
     */
    double
    end_of_continuation(const double t) const
    {
      return t + std::min(excess, 0.5 * (std::floor(t) + 1. - t));
    }

    /** Whether massless_bodies name the body. */
    bool
    is_massless(const std::string &body) const
    {
      return std::find(massless_bodies.begin(), massless_bodies.end(), body) !=
             massless_bodies.end();
    }
  };
} // namespace fuga

#endif
