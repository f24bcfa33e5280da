// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_contact_beyond_record_h
#define fuga_tests_contact_beyond_record_h

#include "contact/toy_system.h"

namespace fuga::tests
{
  /** Keeps the states beyond the limit as well, and has them judged. */
  class BeyondRecord : public Record
  {
  public:
    using Record::Record;

    std::vector<JointState> beyond;
    Vector lengths;

    void
    went_beyond(const double length, const JointState &state) override
    {
      worst.absorb(judge.judge(state));
      if (length == 0.) // the limit itself
        return;
      lengths.push_back(length);
      beyond.push_back(state);
    }
  };

  struct BeyondRun
  {
    PathResult result;
    BeyondRecord record;
  };

  /** Follows a path beyond its limit load until the largest jump has grown by @p largest_jump. */
  BeyondRun
  follow_beyond(const ContactSystem &system,
                const std::vector<ContactElement> &elements,
                const LoadHistory &history,
                const double largest_jump,
                const std::vector<double> &levels);

  /** The same with elements in the plane, which is returned, and in space, with tangents turned by
   * any angle: expects the same states. */
  BeyondRun
  follow_beyond_in_plane_and_space(const ToySystem &system,
                                   const std::vector<ContactElement> &elements,
                                   const LoadHistory &history,
                                   const double largest_jump,
                                   const std::vector<double> &levels);
} // namespace fuga::tests

#endif
