// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_segments_diverging_rates_h
#define fuga_contact_segments_diverging_rates_h

#include <fuga/contact/segments/path_segment.h>

namespace fuga
{
  /** Parts of a stage by which a path may end below a limit, or a maximum of the load, where it
   * cannot be followed up to it. */
  constexpr double near_enough = 1e-6;

  /** Station i of a curve, as a place and as a point. */
  struct CurvePoint
  {
    double tau             = 0.;
    const PathPoint *point = nullptr;
  };

  /** Whether the rates of dislocation along @p curve grow like (τ* - τ)^(-1/@p exponent), and τ* is
   * no further from its end than @p within: with 1 the motion grows beyond bounds, with 2 the load
   * has a maximum at τ*. */
  bool
  rates_diverge(const std::vector<CurvePoint> &curve, const int exponent, const double within);
} // namespace fuga

#endif
