// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_segments_course_h
#define fuga_contact_segments_course_h

#include <fuga/contact/element/contact_boundary.h>
#include <fuga/contact/joint_state.h>
#include <fuga/contact/scheme/working_scheme.h>

#include <optional>

namespace fuga
{
  /** References to everything that the segments share. */
  struct PathContext
  {
    const std::vector<ContactElement> &elements;
    const LayeredSystem &system;
    const ContactBoundary &boundary;
    WorkingScheme &scheme;
  };

  /**
   * A load that gives way to the motion it causes, beyond its limit: the load time is t + τ ṫ + κ
   * (τ - Σ c (d - d0)), where the bracket is zero if c measures the motion exactly. The stiffness κ
   * [1/m] does not affect the path, only its parameter.
   */
  struct YieldingLoad
  {
    double stiffness = 0.;
    /** c and d0, per bar. */
    Vector weights, dislocations;
    /** Factors and drive per unit of the load time. */
    Vector factor_rates;
    Drive drive;
    /** Load times between which the segment lies. */
    double first_t = 0., last_t = 0.;
  };

  /**
   * The quantities that change along a segment: the load factors a(τ) = factors + τ rates while the
   * load time t + τ passes; or, at a fixed load, the shear that broken elements release as τ goes
   * from 0 to 1; or, beyond a limit load, the load that belongs to the growth τ of the largest
   * jump.
   */
  struct Course
  {
    enum class Kind
    {
      loading,
      release,
      beyond_limit
    };

    Kind kind    = Kind::loading;
    double t     = 0.;
    double t_end = 0.;
    Vector factors;
    Vector factor_rates;
    /** Drive at τ = 0; see drive_at(). */
    Drive drive;
    /** The share 1/F of strength that a strength reduction leaves is share + τ share_rate. */
    double share      = 1.;
    double share_rate = 0.;
    /** Range of τ. */
    double length = 0.;
    /** Set beyond a limit load where directions of slip turn; the rates above are then those at
     * τ = 0. */
    std::optional<YieldingLoad> yielding = {};

    /** Return the load time at @p tau; the end of the course is met exactly. */
    double
    time_at(const double tau) const;
    Vector
    factors_at(const double tau) const;
  };

  /**
   * Return the quantities that drive the joints at a point of a course: Course::drive, and the
   * rates of strength that belong to the pressures there during a strength reduction
   * (doc/theory.md, section 7).
   */
  Drive
  drive_at(const std::vector<ContactElement> &elements,
           const Course &course,
           const JointState &state);

  /** Reduce @p strengths to what a strength reduction leaves of them at @p tau. */
  void
  reduce_strengths(const std::vector<ContactElement> &elements,
                   const Course &course,
                   const double tau,
                   std::vector<Strength> &strengths);

  /**
   * Return whether a reduction bends the path of a scheme: where something slides, the equations
   * themselves change with the strength. Otherwise only the boundaries move.
   */
  bool
  is_bent_by_reduction(const std::vector<ContactElement> &elements,
                       const Course &course,
                       const JointState &state);

  /** Return the boundary with the values that count as zero in a state at @p tau, without the
   * widening due to steps of zero length, which applies only to the point where they ended. */
  ContactBoundary
  boundary_at(const PathContext &context,
              const Course &course,
              const double tau,
              const JointState &state);

  /** Release, from a state at the beginning of a course, what fades until @p tau. */
  void
  release(const Drive &drive, const double tau, JointState &state);

  /** Set load time and water of a state; return the factors of the loads. */
  Vector
  set_loads(const PathContext &context, const Course &course, const double tau, JointState &state);

  /** Set the parts of a state that follow from dislocations, forces and τ: slips, dilations,
   * strengths. */
  void
  set_slips(const PathContext &context, const Course &course, const double tau, JointState &state);

  /** Set the parts of a state that follow from dislocations and τ alone: forces p = R a - W d, see
   * LayeredSystem::forces() for @p known, time, slips, water, reduced strengths. */
  void
  complete_state(const PathContext &context,
                 const Course &course,
                 const double tau,
                 JointState &state,
                 const KnownForces *known = nullptr);

  /** Return the forces of a state that complete_state() has completed. */
  KnownForces
  known_forces(const PathContext &context,
               const Course &course,
               const double tau,
               JointState state);
} // namespace fuga

#endif
