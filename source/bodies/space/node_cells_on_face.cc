// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/quadrature_lib.h>

#include <fuga/bodies/space/node_cells_on_face.h>

namespace fuga
{
  namespace
  {
    /** Return 0, the sums of the weights of Gauss and Lobatto's rule, and 1. */
    std::vector<double>
    ends_of_parts(const unsigned int degree)
    {
      const dealii::QGaussLobatto<1> rule(degree + 1);
      std::vector<double> ends = {0.};
      for (unsigned int i = 0; i < degree; ++i)
        ends.push_back(ends.back() + rule.weight(i));
      ends.push_back(1.);
      return ends;
    }
  } // namespace

  template <>
  std::vector<std::vector<dealii::Point<1>>>
  node_cells_on_face<2>(const std::size_t, const unsigned int degree)
  {
    const std::vector<double> ends = ends_of_parts(degree);
    std::vector<std::vector<dealii::Point<1>>> cells;
    for (unsigned int i = 0; i <= degree; ++i)
      cells.push_back({dealii::Point<1>(ends[i]), dealii::Point<1>(ends[i + 1])});
    return cells;
  }

  template <>
  std::vector<std::vector<dealii::Point<2>>>
  node_cells_on_face<3>(const std::size_t n_corners, const unsigned int degree)
  {
    using Point = dealii::Point<2>;
    if (n_corners == 3) // of degree 1
      {
        const Point centre(1. / 3., 1. / 3.), a(0.5, 0.), b(0., 0.5), c(0.5, 0.5);
        return {{Point(0., 0.), a, centre, b},
                {Point(1., 0.), c, centre, a},
                {Point(0., 1.), b, centre, c}};
      }
    const std::vector<double> ends = ends_of_parts(degree);
    std::vector<std::vector<Point>> cells;
    for (unsigned int j = 0; j <= degree; ++j)
      for (unsigned int i = 0; i <= degree; ++i)
        cells.push_back({Point(ends[i], ends[j]),
                         Point(ends[i + 1], ends[j]),
                         Point(ends[i], ends[j + 1]),
                         Point(ends[i + 1], ends[j + 1])});
    return cells;
  }

  std::vector<std::pair<std::size_t, std::size_t>>
  neighbours_on_face(const unsigned int dim, const std::size_t n_corners, const unsigned int degree)
  {
    if (n_corners == 3)
      return {{0, 1}, {1, 2}, {0, 2}};
    std::vector<std::pair<std::size_t, std::size_t>> result;
    const std::size_t n = degree + 1, n_rows = dim == 2 ? 1 : n;
    for (std::size_t j = 0; j < n_rows; ++j)
      for (std::size_t i = 0; i < n; ++i)
        {
          if (i + 1 < n)
            result.emplace_back(j * n + i, j * n + i + 1);
          if (j + 1 < n_rows)
            result.emplace_back(j * n + i, (j + 1) * n + i);
        }
    return result;
  }
} // namespace fuga
