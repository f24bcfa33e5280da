// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_water_in_joints_h
#define fuga_contact_water_in_joints_h

#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/laws/contact_state.h>

#include <string_view>
#include <vector>

namespace fuga
{
  /** Where the water in a contact element comes from. */
  enum class WaterAccess
  {
    /** It seeps through the closed joint. */
    seepage,
    /** The element is open and connected with the reservoir by open elements. */
    upstream,
    /** The element is open and connected with the tailwater only. */
    downstream,
    /** The element is open, but connected with neither: it keeps the water that it had. */
    isolated
  };

  /** The word used in every output. */
  constexpr std::string_view
  access_name(const WaterAccess access)
  {
    return access == WaterAccess::seepage      ? "seepage"
           : access == WaterAccess::upstream   ? "reservoir"
           : access == WaterAccess::downstream ? "tailwater"
                                               : "isolated";
  }

  /** How water gets from one contact element to another. */
  struct WaterNetwork
  {
    /** Of every element, those that open water would reach directly from it. */
    std::vector<std::vector<std::size_t>> neighbours;
    /** Whether an element lies at an upstream (downstream) end, where the reservoir (the tailwater)
     * reaches it. */
    std::vector<bool> upstream, downstream;
    /** Whether there is water in an element at all. */
    std::vector<bool> wet;
  };

  /**
   * What the contact layer knows of the water in joints (doc/theory.md, section 12): how it
   * spreads, and the force ω with which it presses the two sides of every element apart, beyond
   * what ContactSystem::load_patterns() contain. That part belongs to the joint without any open
   * element, for which ω = 0.
   */
  class WaterInJoints
  {
  public:
    virtual ~WaterInJoints() = default;

    virtual const WaterNetwork &
    network() const = 0;

    /** ω [MN] of all bars, zero for tangential ones; linear in the load factors (or their rates).
     */
    virtual Vector
    forces(const std::vector<WaterAccess> &access, const Vector &factors) const = 0;
  };

  /** The elements from which a chain of neighbours, all of them @p open, leads to one of @p ends. */
  std::vector<bool>
  connected(const WaterNetwork &network,
            const std::vector<bool> &open,
            const std::vector<bool> &ends);
} // namespace fuga

#endif
