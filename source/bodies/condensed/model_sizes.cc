// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/condensed/model_sizes.h>
#include <fuga/bodies/space/cell_values.h>
#include <fuga/bodies/space/face_map.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    template <int dim>
    double
    face_area(const Discretization<dim> &space,
              const typename Discretization<dim>::BoundaryFace &face)
    {
      const auto &table = space.reference_element().face(face.number);
      const FaceMap<dim> map(space, face);
      double area = 0.;
      for (std::size_t q = 0; q < table.weight.size(); ++q)
        area += table.weight[q] * map.density(table.points[q]);
      return area;
    }
  } // namespace


  template <int dim>
  std::vector<BodySize<dim>>
  body_sizes(const Discretization<dim> &space, const JointedMesh &mesh)
  {
    std::vector<BodySize<dim>> sizes(mesh.body_names.size());
    CellValues<dim> values(space);
    for (std::size_t cell = 0; cell < space.n_cells(); ++cell)
      {
        BodySize<dim> &size = sizes[space.cell_body(cell)];
        ++size.n_cells;
        values.move_to(cell);
        for (std::size_t q = 0; q < values.n_points(); ++q)
          {
            size.volume += values.volume(q);
            size.centroid += values.volume(q) * values.point(q);
          }
      }
    for (BodySize<dim> &size : sizes)
      {
        if (size.volume > 0.)
          size.centroid /= size.volume;
        if (space.is_axisymmetric())
          size.centroid[0] = 0.;
      }
    return sizes;
  }


  template <int dim>
  std::vector<JointSize<dim>>
  joint_sizes(const Discretization<dim> &space,
              const JointGeometry<dim> &geometry,
              const std::size_t n_joints)
  {
    std::vector<JointSize<dim>> sizes(n_joints);
    for (const auto &face : geometry.faces())
      {
        JointSize<dim> &size = sizes[face.joint];
        const auto &table    = space.reference_element().face(face.boundary.number);
        const FaceMap<dim> map(space, face.boundary);
        ++size.n_faces;
        for (std::size_t q = 0; q < table.weight.size(); ++q)
          {
            const double area = table.weight[q] * map.density(table.points[q]);
            size.area += area;
            size.normal -= area * map.normal(table.points[q]);
          }
      }
    for (const auto &pair : geometry.pairs())
      if (pair.minus_node != Discretization<dim>::no_node)
        sizes[pair.joint].distance =
          std::max(sizes[pair.joint].distance,
                   space.position(pair.plus_node).distance(space.position(pair.minus_node)));
    for (JointSize<dim> &size : sizes)
      if (size.area > 0.)
        size.normal /= size.area;
    return sizes;
  }


  template <int dim>
  double
  boundary_area(const Discretization<dim> &space, const unsigned int label)
  {
    double area = 0.;
    for (const auto &face : space.boundary_faces())
      if (face.label == label)
        area += face_area(space, face);
    return area;
  }


  template <int dim>
  std::array<dealii::Point<dim>, 2>
  extent_of(const Discretization<dim> &space)
  {
    std::array<dealii::Point<dim>, 2> extent = {{space.position(0), space.position(0)}};
    for (std::size_t node = 0; node < space.n_nodes(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        {
          extent[0][c] = std::min(extent[0][c], space.position(node)[c]);
          extent[1][c] = std::max(extent[1][c], space.position(node)[c]);
        }
    return extent;
  }


  template std::vector<BodySize<2>>
  body_sizes(const Discretization<2> &, const JointedMesh &);
  template std::vector<JointSize<2>>
  joint_sizes(const Discretization<2> &, const JointGeometry<2> &, const std::size_t);
  template double
  boundary_area(const Discretization<2> &, const unsigned int);
  template std::array<dealii::Point<2>, 2>
  extent_of(const Discretization<2> &);
  template std::vector<BodySize<3>>
  body_sizes(const Discretization<3> &, const JointedMesh &);
  template std::vector<JointSize<3>>
  joint_sizes(const Discretization<3> &, const JointGeometry<3> &, const std::size_t);
  template double
  boundary_area(const Discretization<3> &, const unsigned int);
  template std::array<dealii::Point<3>, 2>
  extent_of(const Discretization<3> &);
} // namespace fuga
