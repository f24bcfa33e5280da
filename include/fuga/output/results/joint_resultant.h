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
  /** A shear or an eccentricity below this share of its terms is zero. */
  constexpr double resultant_rounding = 1e-12;

  /**
   * What a joint carries as a whole, at one load. The *mean frame* of a joint has its origin in the
   * area-weighted centroid; n is the area-weighted mean of the normals, t the tangent that goes
   * with it (doc/notation.md, "Resultants of a joint"). A joint that closes in itself has no mean
   * normal: its frame is that of the global axes. s counts along t from the centroid; the *edges*
   * are the smallest and the largest s of the joint's elements, B is the distance between them.
   *
   * What needs a normal force is not a number (NaN) in a joint without any.
   */
  struct JointResultant
  {
    /** Sums of the bar forces along n and t [force]. */
    double N = 0.;
    double T = 0.;
    /** Moment about the centroid, counter-clockwise, of the forces on the plus side. */
    double M = 0.;
    /** e = -M/N [length]: s where the line of action cuts the line through the centroid along t. */
    double eccentricity = 0.;
    /** This point; in space the one in the mean plane where the resultant crosses it. */
    std::array<double, 3> position = {{0., 0., 0.}};
    /** Shares of the area by state, and with pressure. */
    double share_open        = 0.;
    double share_stick       = 0.;
    double share_slip        = 0.;
    double share_compression = 0.;
    /** Length of all open elements, and of those that follow each other from the first and from the
     * last element on [length]. */
    double cracked_length   = 0.;
    double crack_from_first = 0.;
    double crack_from_last  = 0.;
    double largest_pressure = 0.;
    /** Over the whole joint: 0 if any element is open. */
    double smallest_pressure = 0.;
    double largest_gap       = 0.;
    double largest_slip      = 0.;
    /** By area, along the first tangents of the elements and, in space, along the second ones. */
    double mean_slip = 0., mean_slip2 = 0.;
    /** Σ(f|N| + cA) / |T| over closed elements; infinity without shear. */
    double sliding_safety = 0.;
    /** s of the edge on the side of e, divided by e: the factor by which M may grow until the
     * resultant stands on the edge. Infinity if it is central. */
    double overturning_safety = 0.;
    /** 1 if the resultant stands within the middle third of B, else 0. */
    double in_middle_third = 0.;
    /** Force of the water in the joint along n, which presses the lips apart [force]: N is without
     * it. */
    double water = 0.;
    /** Work of friction so far [force length]. */
    double dissipation = 0.;

    /** In space, where the frame is t1, t2, n: the sum of forces along t2. T is that along t1, M
     * the moment about -t2, and e counts along t1, as in the plane of t1 and n. */
    double T2 = 0.;
    /** Moments about t1 and n of the forces on the plus side. */
    double M1 = 0.;
    double Mn = 0.;
    /** -M1/N: the eccentricity along t2. */
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

  /** What lies across the plane. */
  struct AcrossPlane
  {
    double thickness  = 1.;
    bool axisymmetric = false;
  };

  /**
   * The resultants of all joints. @p normals, @p results and @p dissipation: one entry per element.
   * The length of an element is its area over the thickness. In axisymmetry it reaches to the
   * middle between it and its neighbours; the sums are those of the components in the half-plane
   * over the full circle; such forces have no place in the half-plane: moment, eccentricity,
   * position and overturning safety are not a number.
   */
  std::vector<JointResultant>
  joint_resultants(const std::size_t n_joints,
                   const std::vector<ContactElement> &elements,
                   const std::vector<std::array<double, 3>> &normals,
                   const std::vector<ElementResult> &results,
                   const Vector &dissipation,
                   const AcrossPlane &across_plane);
  /**
   * The same in space. What is defined by the line of a joint (cracked lengths, middle third,
   * overturning safety) is not a number: an area has no two ends.
   */
  std::vector<JointResultant>
  joint_resultants_in_space(const std::size_t n_joints,
                            const std::vector<ContactElement> &elements,
                            const std::vector<ElementFrame> &frames,
                            const std::vector<ElementResult> &results,
                            const Vector &dissipation);

  /** Adds the state, pressures, gaps, slips, strength and dissipation of an element that has @p share
   * of the area to what does not depend on frames. */
  void
  add_element(const ElementResult &result,
              const double share,
              const double dissipation,
              JointResultant &resultant);
} // namespace fuga

#endif
