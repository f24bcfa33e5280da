// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q1.h>

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/reference_element.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fuga
{
  namespace
  {
    template <int dim>
    std::unique_ptr<dealii::FiniteElement<dim>>
    make_element(const ReferenceShape shape, const unsigned int degree)
    {
      // The integral of a quadratic function over the face of a tetrahedron vanishes at the
      // corners: no area for their contact elements.
      const unsigned int largest = shape == ReferenceShape::hypercube ? 8 : dim == 2 ? 2 : 1;
      if (degree < 1 || degree > largest)
        {
          const bool simplex = shape == ReferenceShape::simplex;
          throw InputError(fmt::format(
            "Polynomial degree {}: on {} the degrees 1 to {} exist; change the degree or the mesh.",
            degree,
            dim == 2 ? (simplex ? "triangles" : "quadrilaterals")
                     : (simplex ? "tetrahedra" : "hexahedra"),
            largest));
        }
      if (shape == ReferenceShape::simplex)
        return std::make_unique<dealii::FE_SimplexP<dim>>(degree);
      return std::make_unique<dealii::FE_Q<dim>>(degree);
    }

    /** Exact for the stiffness of affine cells and for constant loads; with a radius as factor for
     *  constant loads and for what a constant stress does. */
    template <int dim>
    dealii::Quadrature<dim>
    make_quadrature(const ReferenceShape shape, const unsigned int degree, const bool with_radius)
    {
      if (shape == ReferenceShape::simplex)
        return dealii::QGaussSimplex<dim>(degree + (with_radius ? 1 : 0));
      return dealii::QGauss<dim>(degree + 1);
    }

    template <int dim>
    std::vector<double>
    values_at(const dealii::FiniteElement<dim> &element, const dealii::Point<dim> &point)
    {
      std::vector<double> values(element.n_dofs_per_cell());
      for (unsigned int i = 0; i < values.size(); ++i)
        values[i] = element.shape_value(i, point);
      return values;
    }

    template <int dim>
    std::vector<dealii::Tensor<1, dim>>
    gradients_at(const dealii::FiniteElement<dim> &element, const dealii::Point<dim> &point)
    {
      std::vector<dealii::Tensor<1, dim>> gradients(element.n_dofs_per_cell());
      for (unsigned int i = 0; i < gradients.size(); ++i)
        gradients[i] = element.shape_grad(i, point);
      return gradients;
    }
  } // namespace


  template <int dim>
  ReferenceElement<dim>::ReferenceElement(const ReferenceShape reference_shape,
                                          const unsigned int degree,
                                          const bool with_radius)
    : shape(reference_shape)
    , element(make_element<dim>(shape, degree))
    , geometry(make_element<dim>(shape, 1))
  {
    for (const auto &point : element->get_unit_support_points())
      node_geometry.push_back(values_at(*geometry, point));
    tabulate_cell(degree, with_radius);
    faces.resize(element->reference_cell().n_faces());
    for (unsigned int f = 0; f < faces.size(); ++f)
      tabulate_face(f, degree);
  }


  template <int dim>
  ReferenceElement<dim>::~ReferenceElement() = default;


  template <int dim>
  std::unique_ptr<dealii::Mapping<dim, dim>>
  ReferenceElement<dim>::make_mapping() const
  {
    if (shape == ReferenceShape::simplex)
      return std::make_unique<dealii::MappingFE<dim>>(*geometry);
    return std::make_unique<dealii::MappingQ1<dim>>();
  }


  template <int dim>
  void
  ReferenceElement<dim>::tabulate_cell(const unsigned int degree, const bool with_radius)
  {
    const auto points = make_quadrature<dim>(shape, degree, with_radius);
    cell.weight       = points.get_weights();
    for (const auto &point : points.get_points())
      {
        cell.values.push_back(values_at(*element, point));
        cell.gradients.push_back(gradients_at(*element, point));
        cell.geometry_values.push_back(values_at(*geometry, point));
        cell.geometry_gradients.push_back(gradients_at(*geometry, point));
      }
  }


  template <int dim>
  std::vector<double>
  ReferenceElement<dim>::corner_values(const unsigned int number, const FacePoint &point) const
  {
    if constexpr (dim == 2)
      return {1. - point[0], point[0]};
    else if (faces[number].corners.size() == 3)
      return {1. - point[0] - point[1], point[0], point[1]};
    else
      return {(1. - point[0]) * (1. - point[1]),
              point[0] * (1. - point[1]),
              (1. - point[0]) * point[1],
              point[0] * point[1]};
  }


  template <int dim>
  std::vector<double>
  ReferenceElement<dim>::corner_derivatives(const unsigned int number,
                                            const FacePoint &point,
                                            const unsigned int coordinate) const
  {
    if constexpr (dim == 2)
      return {-1., 1.};
    else if (faces[number].corners.size() == 3)
      return coordinate == 0 ? std::vector<double>{-1., 1., 0.} : std::vector<double>{-1., 0., 1.};
    else if (coordinate == 0)
      return {point[1] - 1., 1. - point[1], -point[1], point[1]};
    else
      return {point[0] - 1., -point[0], 1. - point[0], point[0]};
  }


  template <int dim>
  std::vector<double>
  ReferenceElement<dim>::face_values(const unsigned int number, const FacePoint &point) const
  {
    const auto reference                 = element->reference_cell();
    const std::vector<double> of_corners = corner_values(number, point);
    dealii::Point<dim> in_cell;
    for (unsigned int v = 0; v < of_corners.size(); ++v)
      in_cell += of_corners[v] *
                 reference.template vertex<dim>(reference.face_to_cell_vertices(number, v, 1));
    std::vector<double> values;
    for (const unsigned int i : faces[number].nodes)
      values.push_back(element->shape_value(i, in_cell));
    return values;
  }


  // A node is on a face if the corners of the face make up its place.
  template <int dim>
  void
  ReferenceElement<dim>::find_face_nodes(const unsigned int number)
  {
    const auto reference         = element->reference_cell();
    const unsigned int n_corners = reference.face_reference_cell(number).n_vertices();
    Face &face                   = faces[number];
    face.corners.resize(n_corners);
    for (unsigned int v = 0; v < n_corners; ++v)
      {
        FacePoint corner;
        if (n_corners == 3)
          for (unsigned int c = 0; c < dim - 1; ++c)
            corner[c] = v == c + 1 ? 1. : 0.;
        else
          for (unsigned int c = 0; c < dim - 1; ++c)
            corner[c] = (v >> c) & 1;
        face.corner_points.push_back(corner);
      }

    using Place = std::array<double, dim - 1>; // the last coordinate first, without rounding
    std::vector<std::pair<Place, unsigned int>> on_face;
    for (unsigned int i = 0; i < n_nodes(); ++i)
      {
        double sum = 0.;
        Place place{};
        for (unsigned int v = 0; v < n_corners; ++v)
          {
            const double share = node_geometry[i][reference.face_to_cell_vertices(number, v, 1)];
            sum += share;
            for (unsigned int c = 0; c < dim - 1; ++c)
              place[dim - 2 - c] += share * face.corner_points[v][c];
          }
        for (double &coordinate : place)
          coordinate = std::round(coordinate * 1e8) / 1e8;
        if (std::abs(sum - 1.) < 1e-10)
          on_face.emplace_back(place, i);
      }
    std::sort(on_face.begin(), on_face.end());
    for (const auto &node : on_face)
      {
        for (unsigned int v = 0; v < n_corners; ++v)
          if (node.second == reference.face_to_cell_vertices(number, v, 1))
            face.corners[v] = static_cast<unsigned int>(face.nodes.size());
        face.nodes.push_back(node.second);
      }
  }


  template <int dim>
  void
  ReferenceElement<dim>::tabulate_face(const unsigned int number, const unsigned int degree)
  {
    find_face_nodes(number);
    Face &face = faces[number];
    dealii::Quadrature<dim - 1> rule;
    if (dim == 3 && shape == ReferenceShape::simplex)
      rule = dealii::QGaussSimplex<dim - 1>(degree + 2);
    else
      rule = dealii::QGauss<dim - 1>(degree + 2);
    face.weight = rule.get_weights();
    face.points = rule.get_points();
    for (const FacePoint &point : face.points)
      face.values.push_back(face_values(number, point));
  }


  template class ReferenceElement<2>;
  template class ReferenceElement<3>;
} // namespace fuga
