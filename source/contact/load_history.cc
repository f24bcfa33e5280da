// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/load_history.h>

#include <algorithm>
#include <stdexcept>

namespace fuga
{
  LoadHistory::LoadHistory(std::vector<double> corner_times,
                           std::vector<Vector> factors_at_corners,
                           Vector shares_at_corners)
    : corners(std::move(corner_times))
    , values(std::move(factors_at_corners))
    , shares(std::move(shares_at_corners))
  {
    if (corners.size() < 2 || corners.size() != values.size() ||
        (!shares.empty() && shares.size() != corners.size()) ||
        !std::is_sorted(corners.begin(), corners.end(), std::less_equal<>()))
      throw std::invalid_argument("A load history needs increasing corners with one vector each.");
  }

  LoadHistory
  LoadHistory::with_corner(const double t) const
  {
    LoadHistory result = *this;
    const auto place   = std::lower_bound(corners.begin(), corners.end(), t) - corners.begin();
    if (corners[static_cast<std::size_t>(place)] == t)
      return result;
    result.corners.insert(result.corners.begin() + place, t);
    result.values.insert(result.values.begin() + place, factors(t));
    if (!shares.empty())
      result.shares.insert(result.shares.begin() + place, strength_share(t));
    return result;
  }

  LoadHistory
  LoadHistory::with_carried_loads(const double begin, const double end) const
  {
    LoadHistory result = *this;
    for (std::size_t i = 0; i < corners.size(); ++i)
      {
        result.values[i].push_back(1.);
        result.values[i].push_back(std::clamp((end - corners[i]) / (end - begin), 0., 1.));
      }
    return result;
  }

  unsigned int
  LoadHistory::n_patterns() const
  {
    return static_cast<unsigned int>(values.front().size());
  }

  LoadHistory
  LoadHistory::until(const double corner) const
  {
    const auto n = std::upper_bound(corners.begin(), corners.end(), corner) - corners.begin();
    LoadHistory result{{corners.begin(), corners.begin() + n},
                       {values.begin(), values.begin() + n},
                       shares.empty() ? Vector() : Vector(shares.begin(), shares.begin() + n)};
    result.times_of_still_water = times_of_still_water;
    return result;
  }

  LoadHistory
  LoadHistory::reducing_strength(const double share_at_end) const
  {
    LoadHistory result = *this;
    result.shares.assign(corners.size(), 1.);
    result.shares.back() = share_at_end;
    return result;
  }

  double
  LoadHistory::end() const
  {
    return corners.back();
  }

  std::size_t
  LoadHistory::segment_after(const double t) const
  {
    const auto next    = std::upper_bound(corners.begin(), corners.end(), t);
    const auto segment = std::max<std::ptrdiff_t>(0, next - corners.begin() - 1);
    return std::min<std::size_t>(static_cast<std::size_t>(segment), corners.size() - 2);
  }

  double
  LoadHistory::next_corner(const double t) const
  {
    return corners[segment_after(t) + 1];
  }

  double
  LoadHistory::last_corner(const double t) const
  {
    return corners[segment_after(t)];
  }

  Vector
  LoadHistory::factors(const double t) const
  {
    const std::size_t k = segment_after(t);
    const double length = corners[k + 1] - corners[k];
    const double s      = (t - corners[k]) / length;
    Vector result(n_patterns());
    for (std::size_t j = 0; j < result.size(); ++j)
      result[j] = (1. - s) * values[k][j] + s * values[k + 1][j];
    return result;
  }

  Vector
  LoadHistory::rates(const double t) const
  {
    const std::size_t k = segment_after(t);
    const double length = corners[k + 1] - corners[k];
    Vector result(n_patterns());
    for (std::size_t j = 0; j < result.size(); ++j)
      result[j] = (values[k + 1][j] - values[k][j]) / length;
    return result;
  }

  void
  LoadHistory::keep_water_still(const double begin, const double end)
  {
    times_of_still_water.push_back({{begin, end}});
  }

  bool
  LoadHistory::water_stands_still(const double t) const
  {
    return std::any_of(times_of_still_water.begin(),
                       times_of_still_water.end(),
                       [t](const auto &time) { return t >= time[0] && t < time[1]; });
  }

  double
  LoadHistory::strength_share(const double t) const
  {
    if (shares.empty())
      return 1.;
    const std::size_t k = segment_after(t);
    const double s      = (t - corners[k]) / (corners[k + 1] - corners[k]);
    return (1. - s) * shares[k] + s * shares[k + 1];
  }

  double
  LoadHistory::strength_share_rate(const double t) const
  {
    if (shares.empty())
      return 0.;
    const std::size_t k = segment_after(t);
    return (shares[k + 1] - shares[k]) / (corners[k + 1] - corners[k]);
  }
} // namespace fuga
