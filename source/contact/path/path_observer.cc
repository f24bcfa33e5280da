// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/path/path_observer.h>

#include <limits>

namespace fuga
{
  // The segment is followed from station to station, with a stop at every requested load time. The
  // state at the end is returned.
  JointState
  report_piecewise(PathSegment &segment,
                   const Course &course,
                   const std::vector<double> &levels,
                   std::size_t &next_level,
                   PathObserver &observer)
  {
    std::vector<double> stations = segment.stations();
    const double rounding =
      4. * std::numeric_limits<double>::epsilon() * std::max(1., course.t_end);
    PathPoint from = segment.at(stations.front());
    for (std::size_t i = 1; i < stations.size(); ++i)
      {
        const double next   = course.kind == Course::Kind::loading && next_level < levels.size()
                                ? levels[next_level] - course.t
                                : std::numeric_limits<double>::infinity();
        const bool is_level = next <= stations[i] + rounding;
        if (is_level && next < stations[i] - rounding)
          stations.insert(stations.begin() + static_cast<std::ptrdiff_t>(i), next);
        PathPoint to = segment.at(stations[i]);
        observer.advanced(from, to, stations[i] - stations[i - 1]);
        if (is_level)
          observer.reached(next_level++, to.state);
        from = std::move(to);
      }
    return from.state;
  }
} // namespace fuga
