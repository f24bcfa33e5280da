// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/quadrature_lib.h>

#include <fuga/bodies/space/face_map.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Corners of a face between which a line moves, from (a0, b0) to (a1, b1). */
    struct Rails
    {
      unsigned int a0, a1, b0, b1;
    };

    /** Return the rails along which a function changes least, and along whose lines it changes
     * most. */
    Rails
    choose_rails(const Vector &values)
    {
      const auto change = [&](const unsigned int i, const unsigned int j) {
        return std::abs(values[i] - values[j]);
      };
      if (values.size() == 4)
        return change(0, 1) + change(2, 3) >= change(0, 2) + change(1, 3) ? Rails{0, 2, 1, 3}
                                                                          : Rails{0, 1, 2, 3};
      if (change(0, 1) >= std::max(change(1, 2), change(0, 2)))
        return {0, 2, 1, 2};
      return change(1, 2) >= change(0, 2) ? Rails{1, 0, 2, 0} : Rails{0, 1, 2, 1};
    }
  } // namespace


  template <int dim>
  FaceMap<dim>::FaceMap(const Discretization<dim> &discretization,
                        const BoundaryFace &boundary_face)
    : space(discretization), face(boundary_face)
  {
    for (const unsigned int corner : space.reference_element().face(face.number).corners)
      its_corners.push_back(space.position(space.face_node(face, corner)));
  }


  template <int dim>
  dealii::Point<dim>
  FaceMap<dim>::point(const FacePoint &at) const
  {
    // The point is computed relative to the first corner, so that a face far from the origin keeps
    // its digits.
    const auto shares         = space.reference_element().corner_values(face.number, at);
    dealii::Point<dim> result = its_corners[0];
    for (std::size_t v = 1; v < shares.size(); ++v)
      result += shares[v] * (its_corners[v] - its_corners[0]);
    return result;
  }


  template <int dim>
  Vector
  FaceMap<dim>::heights() const
  {
    Vector result;
    for (const auto &corner : its_corners)
      result.push_back(corner[dim - 1]);
    return result;
  }


  template <int dim>
  double
  FaceMap<dim>::interpolate(const Vector &at_corners, const FacePoint &at) const
  {
    return dot(space.reference_element().corner_values(face.number, at), at_corners);
  }


  template <int dim>
  dealii::Tensor<1, dim>
  FaceMap<dim>::tangent(const FacePoint &at, const unsigned int coordinate) const
  {
    const auto shares = space.reference_element().corner_derivatives(face.number, at, coordinate);
    dealii::Tensor<1, dim> result;
    for (std::size_t v = 1; v < shares.size(); ++v)
      result += shares[v] * (its_corners[v] - its_corners[0]);
    return result;
  }


  template <int dim>
  double
  FaceMap<dim>::density(const FacePoint &at) const
  {
    if constexpr (dim == 2)
      return space.face_length(face) * space.extent_across(point(at));
    else
      return dealii::cross_product_3d(tangent(at, 0), tangent(at, 1)).norm();
  }


  template <int dim>
  dealii::Tensor<1, dim>
  FaceMap<dim>::normal(const FacePoint &at) const
  {
    dealii::Tensor<1, dim> normal;
    if constexpr (dim == 2)
      {
        const auto along = tangent(at, 0);
        normal[0]        = along[1];
        normal[1]        = -along[0];
      }
    else
      normal = dealii::cross_product_3d(tangent(at, 0), tangent(at, 1));
    normal /= normal.norm();

    const std::size_t n_corners = space.reference_element().n_corners();
    dealii::Point<dim> center;
    for (std::size_t v = 0; v < n_corners; ++v)
      center += space.position(space.cell_nodes(face.cell)[v]) / static_cast<double>(n_corners);
    return (center - its_corners[0]) * normal > 0. ? -normal : normal;
  }


  template <int dim>
  auto
  FaceMap<dim>::lines(const std::vector<Vector> &corner_functions,
                      const unsigned int n_points) const -> std::vector<Line>
  {
    const auto &corner = space.reference_element().face(face.number).corner_points;
    if constexpr (dim == 2)
      return {{corner[0], corner[1], 1.}};
    else
      {
        const Rails rails        = choose_rails(corner_functions.front());
        std::vector<double> cuts = {0., 1.};
        for (const Vector &f : corner_functions)
          for (const auto &[from, to] :
               {std::pair(rails.a0, rails.a1), std::pair(rails.b0, rails.b1)})
            if (f[from] * f[to] < 0.)
              cuts.push_back(f[from] / (f[from] - f[to]));
        std::sort(cuts.begin(), cuts.end());

        const bool triangle = its_corners.size() == 3; // where the rails meet
        const dealii::QGauss<1> rule(n_points);
        std::vector<Line> result;
        for (std::size_t part = 0; part + 1 < cuts.size(); ++part)
          for (unsigned int q = 0; q < rule.size(); ++q)
            {
              const double width = cuts[part + 1] - cuts[part];
              const double s     = cuts[part] + width * rule.point(q)[0];
              result.push_back({corner[rails.a0] + s * (corner[rails.a1] - corner[rails.a0]),
                                corner[rails.b0] + s * (corner[rails.b1] - corner[rails.b0]),
                                rule.weight(q) * width * (triangle ? 1. - s : 1.)});
            }
        return result;
      }
  }


  template class FaceMap<2>;
  template class FaceMap<3>;
} // namespace fuga
