// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_judge_conditioning_h
#define fuga_contact_judge_conditioning_h

#include <fuga/contact/path/contact_path.h>

#include <functional>
#include <memory>

namespace fuga
{
  /** How far the answer of a problem moves when its loads, or the jumps of its joints, change in
   * their last digits. */
  struct Conditioning
  {
    /** The relative change of all loads. */
    double change = 0.;
    /** By how much forces and jumps at the levels and at the end then differ, beside the largest of
     * the path. */
    double forces = 0., jumps = 0.;
    /** The path ends in another way, or at another load by more than the change explains. */
    bool other_end = false;

    /**
     * By how much a force moves, beside the largest of the path, if the dislocation of its bar
     * changes in the last digit that a double has: ε |d| W_ii. Joints that move far beside stiff
     * ones that carry little have large values; loads need not change for that.
     */
    double last_digit = 0.;

    /** Whether an error of this relative size is that of the data. */
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
   * Follows a path from its beginning and again with all loads larger by some 1e-15: what a double
   * can just tell. An answer that moves by as much as it violates the contact conditions is known
   * no better, whatever the solver does. Costs several paths: for answers that are in doubt.
   * @p make_path makes the path under given loads. No further one is followed once what was found
   * is @p enough.
   */
  Conditioning
  conditioning(const std::function<std::unique_ptr<ContactPath>(const LoadHistory &)> &make_path,
               const LayeredSystem &system,
               const LoadHistory &history,
               const std::vector<double> &levels,
               const std::function<bool(const Conditioning &)> &enough = {});
} // namespace fuga

#endif
