// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_element_standstill_h
#define fuga_contact_element_standstill_h

#include <fuga/contact/element/contact_boundary.h>

#include <set>

namespace fuga
{
  /**
   * Remembers the decisions at one load, for steps of zero length. An element that was on a
   * boundary there stays on it, whatever rounding says, so the boundary set only grows. A scheme
   * that comes back with the same set would come back for ever and is detected.
   */
  class Standstill
  {
  public:
    /** Forget the boundary elements: the load went on, or a strength was lost, so that they do not
     * hold any more. */
    void
    forget();

    /** Return the union of @p set and all elements that were on a boundary before at this load. */
    std::vector<BoundaryElement>
    unite(std::vector<BoundaryElement> set);

    /** Note a step of zero length. Return whether the scheme is new with the present set. */
    bool
    note(const std::vector<ContactState> &scheme);

    std::size_t
    n_steps() const
    {
      return steps;
    }

    /** Return the number of schemes that came back. */
    std::size_t
    n_repetitions() const
    {
      return repetitions;
    }

  private:
    std::vector<BoundaryElement> known;
    std::set<std::vector<ContactState>> schemes;
    std::size_t steps       = 0;
    std::size_t repetitions = 0;
  };
} // namespace fuga

#endif
