// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/loads/plan_outline.h>

#include <algorithm>

namespace fuga
{
  // The diagonals among these edges lie inside, so that no line meets them first or last.
  PlanOutline::PlanOutline(const std::vector<PlanPoint> &corners)
  {
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (std::size_t j = i + 1; j < corners.size(); ++j)
        add({{corners[i], corners[j]}});
  }

  void
  PlanOutline::add(const Edge &edge)
  {
    if (all_edges.empty())
      its_width = {{edge[0].across, edge[0].across}};
    all_edges.push_back(edge);
    for (const PlanPoint &point : edge)
      its_width = {{std::min(its_width[0], point.across), std::max(its_width[1], point.across)}};
  }

  std::optional<PlanOutline::Edge>
  PlanOutline::slice(const double across) const
  {
    if (across < its_width[0] || across > its_width[1])
      return {};
    std::optional<Edge> result;
    const auto include = [&](const PlanPoint &point) {
      if (!result)
        result = Edge{{point, point}};
      if (point.along < (*result)[0].along)
        (*result)[0] = point;
      if (point.along > (*result)[1].along)
        (*result)[1] = point;
    };
    for (const auto &[from, to] : all_edges)
      if (from.across == to.across && from.across == across)
        {
          include(from);
          include(to);
        }
      else if (std::min(from.across, to.across) <= across &&
               across <= std::max(from.across, to.across))
        {
          const double share = (across - from.across) / (to.across - from.across);
          include({from.along + share * (to.along - from.along),
                   across,
                   from.height + share * (to.height - from.height)});
        }
    return result;
  }
} // namespace fuga
