// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_segments_layer_work_h
#define fuga_contact_segments_layer_work_h

#include <fuga/contact/segments/path_options.h>
#include <fuga/contact/segments/path_segment.h>

namespace fuga
{
  /** Energy that a step along a curve loses by interpolation, and the energy of the path to which
   * it is compared [MN m]. */
  struct StepEnergy
  {
    double lost = 0., scale = 0.;
  };

  /**
   * Return the energy that the nonlinear layers store between two points of a path, @p length
   * apart, and that the cubics between them miss. The step ends at the place @p tau of @p course;
   * @p here tells which forces count as zero there.
   */
  StepEnergy
  energy_of_step(const PathContext &context,
                 const Course &course,
                 const ContactBoundary &here,
                 const PathPoint &from,
                 const PathPoint &to,
                 const double length,
                 const double tau,
                 IterationCount &count);

  /** Return the energy that a step loses, relative to what it may lose of the allowance that the
   * path has left, or to @p least_loss of the work; at most 1 for a step that is short enough. */
  double
  energy_defect(const StepEnergy &energy, const double least_loss, const IterationCount &count);

  /** Count the energy that the steps of @p segment have lost; the following steps may lose
   * correspondingly less. */
  void
  note_segment(const PathContext &context,
               const Course &course,
               PathSegment &segment,
               IterationCount &count);

  /** Return the speed of slip of an element that slips, in the direction in which its strength acts
   * [m per unit of the path]; negative if the slip turns back. */
  double
  slip_speed(const PathContext &context, const PathPoint &point, const std::size_t k);
} // namespace fuga

#endif
