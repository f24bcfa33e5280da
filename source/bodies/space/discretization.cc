// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/distributed/tria.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_system.h>

#include <deal.II/grid/tria.h>

#include <fuga/base/errors.h>
#include <fuga/bodies/construction.h>
#include <fuga/bodies/processes.h>
#include <fuga/bodies/space/discretization.h>
#include <fuga/bodies/space/triangulation.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    template <int dim>
    dealii::ReferenceCell
    shape_of_cells(const JointedMesh &jointed)
    {
      if (jointed.cells.empty())
        throw InputError("The mesh has no cells.");
      const CellShape shape = jointed.cells.front().shape;
      for (const auto &cell : jointed.cells)
        if (cell.shape != shape)
          throw InputError(
            dim == 2
              ? "The mesh has triangles and quadrilaterals. Use one kind of cells: in Gmsh, "
                "recombine all surfaces (Recombine Surface{:}) or none."
              : "The mesh has tetrahedra and hexahedra. Use one kind of cells: in Gmsh, make "
                "all volumes transfinite, with recombined surfaces, or none.");
      if (dimension(shape) != dim)
        throw InputError(
          dim == 2
            ? "The cells of a plane model are triangles or quadrilaterals. For a model in space "
              "set "
              "Dimension = 3."
            : "The cells of a model in space are tetrahedra or hexahedra. For a plane model set "
              "Dimension = 2.");
      if (n_vertices(shape) == dim + 1)
        return dealii::ReferenceCells::get_simplex<dim>();
      return dealii::ReferenceCells::get_hypercube<dim>();
    }
  } // namespace


  template <int dim>
  Discretization<dim>::Discretization(const JointedMesh &jointed,
                                      const ModelDefinition &model,
                                      const unsigned int stage)
    : axisymmetric(model.assumption == PlaneAssumption::axisymmetric)
    , thickness(model.thickness)
    , reference(shape_of_cells<dim>(jointed), model.polynomial_degree, axisymmetric)
    , mesh(make_triangulation<dim>(jointed, model))
    , element(std::make_unique<dealii::FESystem<dim>>(reference.scalar_element(), dim))
    , there(bodies_in_stage(jointed.body_names, model, stage))
  {
    dofs = std::make_unique<dealii::DoFHandler<dim>>(*mesh);
    dofs->distribute_dofs(*element);
    my_rank = processes::rank();
    vertex_nodes.assign(jointed.vertices.size(), no_node);
    make_tables();
  }


  template <int dim>
  Discretization<dim>::~Discretization() = default;


  template <int dim>
  std::size_t
  Discretization<dim>::n_own_cells() const
  {
    return owners.empty()
             ? n_cells()
             : static_cast<std::size_t>(std::count(owners.begin(), owners.end(), my_rank));
  }


  template <int dim>
  unsigned int
  Discretization<dim>::n_dofs_of_all_bodies() const
  {
    return dofs->n_dofs();
  }


  template <int dim>
  bool
  Discretization<dim>::is_divided_by_p4est() const
  {
    return dynamic_cast<const dealii::parallel::distributed::Triangulation<dim> *>(mesh.get()) !=
           nullptr;
  }


  template <int dim>
  auto
  Discretization<dim>::boundary_faces(const std::vector<bool> &marked) const
    -> std::vector<BoundaryFace>
  {
    std::vector<BoundaryFace> result;
    for (const BoundaryFace &face : outer_faces)
      if (face.label != JointedMesh::no_label && marked[face.label])
        result.push_back(face);
    return result;
  }


  template <int dim>
  double
  Discretization<dim>::face_length(const BoundaryFace &face) const
  {
    const std::size_t last = reference.face(face.number).nodes.size() - 1;
    return position(face_node(face, 0)).distance(position(face_node(face, last)));
  }


  template <int dim>
  dealii::Point<dim>
  Discretization<dim>::face_center(const BoundaryFace &face) const
  {
    const auto &corners = reference.face(face.number).corners;
    dealii::Point<dim> sum;
    for (const unsigned int corner : corners)
      sum += position(face_node(face, corner));
    return sum / static_cast<double>(corners.size());
  }


  template class Discretization<2>;
  template class Discretization<3>;
} // namespace fuga
