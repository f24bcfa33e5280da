// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/segments/course.h>
#include <fuga/contact/segments/curved_segment.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  std::optional<PathPoint>
  CurvedSegment::solve(const double tau, const Vector &predicted_dislocations)
  {
    PathPoint point    = {points.front().state, {}};
    JointState &state  = point.state;
    state.dislocations = predicted_dislocations;
    release(course.drive, tau, state);
    complete_state(context, course, tau, state);
    // A law knows nothing behind its closure limit, where the prediction may lead.
    if (passes_limit_of_law(context.elements, state))
      {
        state.dislocations = points.front().state.dislocations;
        complete_state(context, course, tau, state);
        if (passes_limit_of_law(context.elements, state))
          return {};
      }
    if (course.share_rate != 0.)
      for (std::size_t k = 0; k < context.elements.size(); ++k)
        context.scheme.set_strength(k, state.strengths[k]);
    if (!equilibrium.solve(tau, largest_jump, state))
      return {};

    context.scheme.linearise(state);
    const std::optional<JointRates> rates =
      context.scheme.rates(drive_at(context.elements, course, state));
    if (!rates)
      return {};
    if (is_behind_pole())
      return {};
    point.rates = *rates;
    return point;
  }
} // namespace fuga
