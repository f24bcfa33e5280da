// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_results_joint_resultant_h
#define fuga_output_results_joint_resultant_h

#include <fuga/output/results/joint_results.h>

#include <limits>

namespace fuga
{
  constexpr double infinity     = std::numeric_limits<double>::infinity();
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  /** A shear or an eccentricity below this fraction of its terms counts as zero. */
  constexpr double resultant_rounding = 1e-12;

  /**
   * The resultant of a whole joint at one load. The *mean frame* of a joint has its origin in the
   * area-weighted centroid; n is the area-weighted mean of the normals, t the tangent that belongs
   * to it (doc/notation.md, "Resultants of a joint"). A joint that closes on itself has no mean
   * normal: its frame is that of the global axes. s is measured along t from the centroid; the
   * *edges* are the smallest and the largest s of the joint's elements, B is the distance between
   * them.
   *
   * Values that require a normal force are not a number (NaN) in a joint without any.
   */
  struct JointResultant
  {
    /** Sums of the bar forces along n and t [force]. */
    double N = 0.;
    double T = 0.;
    /** Moment about the centroid, counter-clockwise, of the forces on the plus side. */
    double M = 0.;
    /**
     * Eccentricity e = -M/N [length]: the s at which the line of action cuts the line through the
     * centroid along t.
     */
    double eccentricity = 0.;
    /**
     * The position of this point; in space, the point where the resultant crosses the mean plane.
     */
    std::array<double, 3> position = {{0., 0., 0.}};
    /** Fractions of the area by state, and under pressure. */
    double share_open        = 0.;
    double share_stick       = 0.;
    double share_slip        = 0.;
    double share_compression = 0.;
    /**
     * Length of all open elements, and of those that follow each other starting from the first and
     * from the last element [length].
     */
    double cracked_length   = 0.;
    double crack_from_first = 0.;
    double crack_from_last  = 0.;
    double largest_pressure = 0.;
    /** Minimum over the whole joint: 0 if any element is open. */
    double smallest_pressure = 0.;
    double largest_gap       = 0.;
    double largest_slip      = 0.;
    /**
     * Area-weighted mean slips along the first tangents of the elements and, in space, along the
     * second ones.
     */
    double mean_slip = 0., mean_slip2 = 0.;
    /**
     * Factor of safety against sliding: Σ(f|N| + cA) / |T| over closed elements; infinity without
     * shear.
     */
    double sliding_safety = 0.;
    /**
     * s of the edge on the side of e, divided by e: the factor by which M may grow until the
     * resultant acts at the edge. Infinity if it is central.
     */
    double overturning_safety = 0.;
    /** 1 if the resultant acts within the middle third of B, otherwise 0. */
    double in_middle_third = 0.;
    /**
     * Force of the water in the joint along n, which presses the lips apart [force]; not contained
     * in N.
     */
    double water = 0.;
    /** Work of friction so far [force length]. */
    double dissipation = 0.;

    /**
     * In space, where the frame is t1, t2, n: the sum of forces along t2. T is the sum along t1, M
     * the moment about -t2, and e is measured along t1, as in the plane of t1 and n.
     */
    double T2 = 0.;
    /** Moments about t1 and n of the forces on the plus side. */
    double M1 = 0.;
    double Mn = 0.;
    /** Eccentricity along t2: -M1/N. */
    double eccentricity2 = 0.;
    /** The mean frame: n and t1. */
    std::array<double, 3> normal = {{0., 0., 0.}}, first_tangent = {{0., 0., 0.}};
  };

  /** Local frame of a contact element in space. */
  struct ElementFrame
  {
    std::array<double, 3> normal;
    std::array<std::array<double, 3>, 2> tangents;
  };

  /** Properties of the model across its plane. */
  struct AcrossPlane
  {
    double thickness  = 1.;
    bool axisymmetric = false;
  };

  /**
   * Return the resultants of all joints. @p normals, @p results and @p dissipation have one entry
   * per element. The length of an element is its area divided by the thickness. In axisymmetry it
   * extends to the middle between the element and its neighbours; the sums are those of the
   * components in the half-plane over the full circle. Such forces have no place in the half-plane:
   * moment, eccentricity, position and overturning safety are not a number.
   */
  std::vector<JointResultant>
  joint_resultants(const std::size_t n_joints,
                   const std::vector<ContactElement> &elements,
                   const std::vector<std::array<double, 3>> &normals,
                   const std::vector<ElementResult> &results,
                   const Vector &dissipation,
                   const AcrossPlane &across_plane);
  /**
   * Return the resultants of all joints in space. Quantities defined by the line of a joint
   * (cracked lengths, middle third, overturning safety) are not a number: an area does not have two
   * ends.
   */
  std::vector<JointResultant>
  joint_resultants_in_space(const std::size_t n_joints,
                            const std::vector<ContactElement> &elements,
                            const std::vector<ElementFrame> &frames,
                            const std::vector<ElementResult> &results,
                            const Vector &dissipation);

  /**
   * Add the state, pressures, gaps, slips, strength and dissipation of an element that has @p share
   * of the area to the quantities that do not depend on frames.
   */
  void
  add_element(const ElementResult &result,
              const double share,
              const double dissipation,
              JointResultant &resultant);
} // namespace fuga

#endif
