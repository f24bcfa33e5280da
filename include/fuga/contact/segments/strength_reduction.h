// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_segments_strength_reduction_h
#define fuga_contact_segments_strength_reduction_h

#include <fuga/contact/segments/path_segment.h>

namespace fuga
{
  /**
   * What drives the joints at a point of a course: Course::drive, and the rates of strength that
   * belong to the pressures there while a strength reduction goes on (doc/theory.md, section 7).
   */
  Drive
  drive_at(const std::vector<ContactElement> &elements,
           const Course &course,
           const JointState &state);

  /**
   * Whether a reduction bends the path of a scheme: where something slides, the equations
   * themselves change with the strength. Otherwise only the boundaries move.
   */
  bool
  is_bent_by_reduction(const std::vector<ContactElement> &elements,
                       const Course &course,
                       const JointState &state);
} // namespace fuga

#endif
