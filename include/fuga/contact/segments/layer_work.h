// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_segments_layer_work_h
#define fuga_contact_segments_layer_work_h

#include <fuga/contact/segments/path_options.h>
#include <fuga/contact/segments/path_segment.h>

namespace fuga
{
  /**
   * What the cubics between two points of a path, @p length apart, miss of the energy that the
   * nonlinear layers store on the way; at most 1 for a step that is short enough. It ends at the
   * place @p tau of @p course.
   */
  double
  energy_defect(const PathContext &context,
                const Course &course,
                const PathPoint &from,
                const PathPoint &to,
                const double length,
                const double tau,
                IterationCount &count);

  /** Adds to the count what the cubics between the points of @p segment miss: the steps to come may
   * miss so much less. */
  void
  note_energy_lost(const PathContext &context,
                   const Course &course,
                   PathSegment &segment,
                   IterationCount &count);

  /** Speed of slip of an element that slips, in the direction in which its strength acts [m per
   * unit of the path]; negative if the slip turns back. */
  double
  slip_speed(const PathContext &context, const PathPoint &point, const std::size_t k);
} // namespace fuga

#endif
