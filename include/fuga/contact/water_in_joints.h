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
  /** The origin of the water in a contact element. */
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

  /** Return the word used in all output. */
  constexpr std::string_view
  access_name(const WaterAccess access)
  {
    return access == WaterAccess::seepage      ? "seepage"
           : access == WaterAccess::upstream   ? "reservoir"
           : access == WaterAccess::downstream ? "tailwater"
                                               : "isolated";
  }

  /** The connections by which water gets from one contact element to another. */
  struct WaterNetwork
  {
    /** For every element, the elements that open water would reach directly from it. */
    std::vector<std::vector<std::size_t>> neighbours;
    /** True for an element that lies at an upstream (downstream) end, where the reservoir (the
     * tailwater) reaches it. */
    std::vector<bool> upstream, downstream;
    /** True for an element with water in it. */
    std::vector<bool> wet;
  };

  /**
   * The water in joints as the contact layer knows it (doc/theory.md, section 12): how it spreads,
   * and the force ω with which it presses the two sides of every element apart, in excess of what
   * ContactSystem::load_patterns() contain. The latter part belongs to the joint without any open
   * element, for which ω = 0.
   */
  class WaterInJoints
  {
  public:
    virtual ~WaterInJoints() = default;

    virtual const WaterNetwork &
    network() const = 0;

    /** Return ω [MN] of all bars, zero for tangential ones; linear in the load factors (or their
     * rates). */
    virtual Vector
    forces(const std::vector<WaterAccess> &access, const Vector &factors) const = 0;
  };

  /** Return the elements from which a chain of neighbours, all of them @p open, leads to one of
   * @p ends. */
  std::vector<bool>
  connected(const WaterNetwork &network,
            const std::vector<bool> &open,
            const std::vector<bool> &ends);
} // namespace fuga

#endif
