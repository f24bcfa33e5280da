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
#include <cmath>

namespace fuga
{
  namespace
  {
    template <int dim>
    std::unique_ptr<dealii::FiniteElement<dim>>
    make_element(const ReferenceShape shape, const unsigned int degree)
    {
      const unsigned int largest = shape == ReferenceShape::simplex ? 2 : 8;
      if (degree < 1 || degree > largest)
        throw InputError(fmt::format(
          "Polynomial degree {}: on {} the degrees 1 to {} exist; change the degree or the mesh.",
          degree,
          shape == ReferenceShape::simplex ? "triangles" : "quadrilaterals",
          largest));
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
  std::pair<dealii::Point<dim>, dealii::Tensor<1, dim>>
  ReferenceElement<dim>::face_line(const unsigned int number) const
  {
    static_assert(dim == 2, "faces are lines");
    const auto reference = element->reference_cell();
    const auto first =
      reference.template vertex<dim>(reference.face_to_cell_vertices(number, 0, 1));
    const auto second =
      reference.template vertex<dim>(reference.face_to_cell_vertices(number, 1, 1));
    return {first, second - first};
  }


  template <int dim>
  std::vector<double>
  ReferenceElement<dim>::face_values(const unsigned int number, const double position) const
  {
    const auto [first, along] = face_line(number);
    std::vector<double> values;
    for (const unsigned int i : faces[number].nodes)
      values.push_back(element->shape_value(i, first + position * along));
    return values;
  }


  template <int dim>
  void
  ReferenceElement<dim>::tabulate_face(const unsigned int number, const unsigned int degree)
  {
    const auto [first, along] = face_line(number);

    Face &face = faces[number];
    std::vector<std::pair<double, unsigned int>> on_face;
    for (unsigned int i = 0; i < n_nodes(); ++i)
      {
        const dealii::Tensor<1, dim> offset = element->unit_support_point(i) - first;
        if (std::abs(offset[0] * along[1] - offset[1] * along[0]) < 1e-10)
          on_face.emplace_back(offset * along, i);
      }
    std::sort(on_face.begin(), on_face.end());
    for (const auto &node : on_face)
      face.nodes.push_back(node.second);

    const dealii::QGauss<1> points(degree + 2);
    face.weight = points.get_weights();
    face.node_weights.assign(face.nodes.size(), 0.);
    for (unsigned int q = 0; q < points.size(); ++q)
      {
        const double s = points.point(q)[0];
        face.position.push_back(s);
        std::vector<double> values = face_values(number, s);
        for (std::size_t k = 0; k < values.size(); ++k)
          face.node_weights[k] += points.weight(q) * values[k];
        face.values.push_back(std::move(values));
      }
  }


  template class ReferenceElement<2>;
} // namespace fuga
