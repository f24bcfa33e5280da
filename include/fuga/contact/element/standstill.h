// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_element_standstill_h
#define fuga_contact_element_standstill_h

#include <fuga/contact/element/contact_boundary.h>

#include <set>

namespace fuga
{
  /**
   * Memory of the decisions at one load, for steps without length. An element that was on a
   * boundary there stays on it, whatever rounding says, so the boundary set only grows; a scheme
   * that comes back with the same set would come back for ever and is noticed.
   */
  class Standstill
  {
  public:
    /** The load went on, or a strength was lost: what was known of the boundary does not hold any
     * more. */
    void
    forget();

    /** The set with all elements that were on a boundary before at this load. */
    std::vector<BoundaryElement>
    unite(std::vector<BoundaryElement> set);

    /** Notes a step without length. Tells whether the scheme is new with the present set. */
    bool
    note(const std::vector<ContactState> &scheme);

    std::size_t
    n_steps() const
    {
      return steps;
    }

    /** Schemes that came back. */
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
