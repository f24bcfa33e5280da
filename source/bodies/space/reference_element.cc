// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/quadrature.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/mapping.h>

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/space/reference_element.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fuga
{
  namespace
  {
    template <int dim>
    std::unique_ptr<dealii::FiniteElement<dim>>
    make_element(const dealii::ReferenceCell &shape, const unsigned int degree)
    {
      // The integral of a quadratic function over the face of a tetrahedron vanishes at the
      // corners, which leaves no area for their contact elements.
      const unsigned int largest = shape.is_hyper_cube() ? 8 : dim == 2 ? 2 : 1;
      if (degree < 1 || degree > largest)
        {
          const bool simplex = shape.is_simplex();
          throw InputError(fmt::format(
            "Polynomial degree {}: on {} the degrees 1 to {} exist; change the degree or the mesh.",
            degree,
            dim == 2 ? (simplex ? "triangles" : "quadrilaterals")
                     : (simplex ? "tetrahedra" : "hexahedra"),
            largest));
        }
      if (shape.is_simplex())
        return std::make_unique<dealii::FE_SimplexP<dim>>(degree);
      return std::make_unique<dealii::FE_Q<dim>>(degree);
    }

    template <int dim>
    std::vector<double>
    linear_functions(const dealii::ReferenceCell &cell, const dealii::Point<dim> &point)
    {
      std::vector<double> values(cell.n_vertices());
      for (unsigned int i = 0; i < values.size(); ++i)
        values[i] = cell.d_linear_shape_function(point, i);
      return values;
    }
  } // namespace


  template <int dim>
  ReferenceElement<dim>::ReferenceElement(const dealii::ReferenceCell &shape,
                                          const unsigned int degree,
                                          const bool with_radius)
    : element(make_element<dim>(shape, degree))
    , rule(std::make_unique<dealii::Quadrature<dim>>(shape.get_gauss_type_quadrature<dim>(
        degree + (shape.is_hyper_cube() || with_radius ? 1 : 0))))
    , faces(shape.n_faces())
  {
    for (const auto &point : element->get_unit_support_points())
      node_geometry.push_back(linear_functions(shape, point));
    for (unsigned int f = 0; f < faces.size(); ++f)
      tabulate_face(f, degree);
  }


  template <int dim>
  ReferenceElement<dim>::~ReferenceElement() = default;


  template <int dim>
  const dealii::Mapping<dim, dim> &
  ReferenceElement<dim>::mapping() const
  {
    return element->reference_cell().template get_default_linear_mapping<dim>();
  }


  template <int dim>
  std::vector<double>
  ReferenceElement<dim>::corner_values(const unsigned int number, const FacePoint &point) const
  {
    return linear_functions(element->reference_cell().face_reference_cell(number), point);
  }


  template <int dim>
  std::vector<double>
  ReferenceElement<dim>::corner_derivatives(const unsigned int number,
                                            const FacePoint &point,
                                            const unsigned int coordinate) const
  {
    const auto face = element->reference_cell().face_reference_cell(number);
    std::vector<double> derivatives(face.n_vertices());
    for (unsigned int i = 0; i < derivatives.size(); ++i)
      derivatives[i] = face.d_linear_shape_function_gradient(point, i)[coordinate];
    return derivatives;
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


  // A node is on a face if the corners of the face alone determine its place.
  template <int dim>
  void
  ReferenceElement<dim>::find_face_nodes(const unsigned int number)
  {
    const auto reference         = element->reference_cell();
    const unsigned int n_corners = reference.face_reference_cell(number).n_vertices();
    Face &face                   = faces[number];
    face.corners.resize(n_corners);
    for (unsigned int v = 0; v < n_corners; ++v)
      face.corner_points.push_back(
        reference.face_reference_cell(number).template vertex<dim - 1>(v));

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
    const dealii::Quadrature<dim - 1> points =
      element->reference_cell()
        .face_reference_cell(number)
        .template get_gauss_type_quadrature<dim - 1>(degree + 2);
    face.weight = points.get_weights();
    face.points = points.get_points();
    for (const FacePoint &point : face.points)
      face.values.push_back(face_values(number, point));
  }


  template class ReferenceElement<2>;
  template class ReferenceElement<3>;
} // namespace fuga
