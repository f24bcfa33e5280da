// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_point_text_h
#define fuga_bodies_point_text_h

#include <deal.II/base/point.h>

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace fuga
{
  /**
   * Return a point or a direction as "(x, y)" or "(x, y, z)" with @p digits significant digits, for
   * messages.
   */
  template <int dim>
  std::string
  text_of(const dealii::Tensor<1, dim> &point, const int digits = 6)
  {
    std::string text;
    for (unsigned int c = 0; c < dim; ++c)
      text += fmt::format("{}{:.{}g}", c == 0 ? "(" : ", ", point[c], digits);
    return text + ")";
  }

  /** Return the first @p n_told different @p points, followed by dots if there are more. */
  template <int dim>
  std::string
  text_of_first(const std::vector<dealii::Point<dim>> &points, const std::size_t n_told = 4)
  {
    std::vector<dealii::Point<dim>> different;
    for (const auto &point : points)
      if (std::find(different.begin(), different.end(), point) == different.end())
        different.push_back(point);
    std::string text;
    for (std::size_t i = 0; i < std::min(n_told, different.size()); ++i)
      text += (i > 0 ? ", " : "") + text_of(different[i]);
    return text + (n_told < different.size() ? ", ..." : "");
  }
} // namespace fuga

#endif
