// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_judge_conditioning_h
#define fuga_contact_judge_conditioning_h

#include <fuga/contact/path/contact_path.h>

#include <functional>
#include <memory>

namespace fuga
{
  /** Measures how far the answer of a problem moves when its loads, or the jumps of its joints,
   * change in their last digits. */
  struct Conditioning
  {
    /** The relative change of all loads. */
    double change = 0.;
    /** Resulting change of the forces and jumps at the levels and at the end, relative to the
     * largest of the path. */
    double forces = 0., jumps = 0.;
    /** True if the path ends in another way, or at a load that differs by more than the change
     * explains. */
    bool other_end = false;

    /**
     * Change of a force, relative to the largest of the path, if the dislocation of its bar changes
     * in the last digit of a double: ε |d| W_ii. Joints that move far beside stiff ones that carry
     * little have large values, even if the loads do not change.
     */
    double last_digit = 0.;

    /** Return whether an error of this relative size can be attributed to the data. */
    bool
    explains(const double error) const
    {
      return explains_by_loads(error) || explains_by_last_digit(error);
    }

    bool
    explains_by_loads(const double error) const;

    bool
    explains_by_last_digit(const double error) const;
  };

  /**
   * Follow a path from its beginning, and again with all loads larger by about 1e-15, the least
   * change that a double resolves. An answer that moves by as much as it violates the contact
   * conditions is not known any better, whatever the solver does. This costs several paths and is
   * meant for answers that are in doubt. @p make_path makes the path under given loads. No further
   * path is followed once the result so far is @p enough.
   */
  Conditioning
  conditioning(const std::function<std::unique_ptr<ContactPath>(const LoadHistory &)> &make_path,
               const LayeredSystem &system,
               const LoadHistory &history,
               const std::vector<double> &levels,
               const std::function<bool(const Conditioning &)> &enough = {});
} // namespace fuga

#endif
