// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_path_slow_motion_h
#define fuga_contact_path_slow_motion_h

#include <fuga/contact/path/path_result.h>

#include <optional>

namespace fuga
{
  /** The equilibrium to which the joints jump. */
  struct JumpEnd
  {
    JointState state;
    Jump jump;
  };

  /**
   * Find an equilibrium at the end of @p course near @p from, if no continuous path leads there
   * from @p from. Bodies and joints move on against a viscous resistance κ ẋ of the interface
   * coordinates, in implicit steps, until they rest; κ is as large as needed to make the steps
   * solvable, and decreases to zero. Each step obeys all contact conditions. Return nothing if the
   * motion grows without bound, or rests nowhere; nor is this possible where joints cross or have
   * corners, or where water follows their opening.
   */
  std::optional<JumpEnd>
  find_equilibrium_nearby(const std::vector<ContactElement> &elements,
                          const LayeredSystem &system,
                          const Course &course,
                          const JointState &from);
} // namespace fuga

#endif
