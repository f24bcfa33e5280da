// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/cell_owners.h>
#include <fuga/bodies/construction.h>
#include <fuga/bodies/discretization.h>
#include <fuga/bodies/disjoint_sets.h>
#include <fuga/bodies/mesh_refinement.h>
#include <fuga/bodies/point_text.h>
#include <fuga/bodies/processes.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    ReferenceShape
    shape_of_cells(const JointedMesh &jointed, const unsigned int dim)
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
      const bool hypercube = shape == CellShape::quadrilateral || shape == CellShape::hexahedron;
      return hypercube ? ReferenceShape::hypercube : ReferenceShape::simplex;
    }

    /** Six times the volume of a tetrahedron; for a hexahedron that of four corners around its
     *  first one, which for its orientation is enough. */
    double
    signed_volume(const JointedMesh &jointed, const JointedMesh::Cell &cell)
    {
      const bool hexahedron = cell.shape == CellShape::hexahedron;
      std::array<dealii::Tensor<1, 3>, 3> edges;
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int c = 0; c < 3; ++c)
          {
            const unsigned int other = hexahedron ? (k == 0 ? 1 : k == 1 ? 3 : 4) : k + 1;
            edges[k][c] =
              jointed.vertices[cell.vertices[other]][c] - jointed.vertices[cell.vertices[0]][c];
          }
      return dealii::cross_product_3d(edges[0], edges[1]) * edges[2];
    }

    double
    signed_measure(const JointedMesh &jointed, const JointedMesh::Cell &cell)
    {
      if (dimension(cell.shape) == 3)
        return signed_volume(jointed, cell);
      double twice         = 0.;
      const unsigned int n = n_vertices(cell.shape);
      for (unsigned int i = 0; i < n; ++i)
        {
          const auto &a = jointed.vertices[cell.vertices[i]];
          const auto &b = jointed.vertices[cell.vertices[(i + 1) % n]];
          twice += a[0] * b[1] - a[1] * b[0];
        }
      return twice / 2.;
    }

    /** Right-handed corners in the order deal.II wants them: of every bottom and top
     *  counter-clockwise in the file, and by coordinates there. */
    template <int dim>
    dealii::CellData<dim>
    cell_data(const JointedMesh &jointed, const JointedMesh::Cell &cell)
    {
      const double measure = signed_measure(jointed, cell);
      if (!(std::abs(measure) > 0.))
        {
          dealii::Point<dim> at;
          for (unsigned int c = 0; c < dim; ++c)
            at[c] = jointed.vertices[cell.vertices[0]][c];
          throw InputError(fmt::format("A cell of body '{}' at {} has no {}. Mend the mesh there.",
                                       jointed.body_names[cell.body],
                                       text_of(at),
                                       dim == 2 ? "area" : "volume"));
        }
      const unsigned int n    = n_vertices(cell.shape);
      const unsigned int ring = n == 8 ? 4 : dim == 3 ? 3 : n;
      dealii::CellData<dim> data(n);
      for (unsigned int i = 0; i < n; ++i)
        {
          const unsigned int first = i / ring * ring, k = i % ring;
          data.vertices[i] = cell.vertices[first + (measure > 0. ? k : (ring - k) % ring)];
        }
      for (unsigned int i = 0; ring == 4 && i < n; i += ring)
        std::swap(data.vertices[i + 2], data.vertices[i + 3]);
      data.material_id = cell.body;
      return data;
    }

    /** Boundary id 0 is what deal.II gives to faces that are not listed: labels are shifted by one.
     */
    template <int structdim>
    dealii::CellData<structdim>
    face_data(const JointedMesh::Face &face)
    {
      const unsigned int n = n_vertices(face.shape);
      dealii::CellData<structdim> data(n);
      std::copy(face.vertices.begin(), face.vertices.begin() + n, data.vertices.begin());
      if (n == 4)
        std::swap(data.vertices[2], data.vertices[3]);
      data.boundary_id = face.label + 1;
      return data;
    }

    /** Makes r = 0 exact where it is meant. */
    template <int dim>
    void
    put_on_axis(std::vector<dealii::Point<dim>> &vertices)
    {
      double radius = 0.;
      for (const auto &vertex : vertices)
        radius = std::max(radius, std::abs(vertex[0]));
      const double tolerance = 1e-10 * radius;
      for (auto &vertex : vertices)
        if (vertex[0] < -tolerance)
          throw InputError(fmt::format(
            "The mesh has a point at ({:g}, {:g}), beyond the axis of revolution x = 0. An "
            "axisymmetric model is the half with x >= 0 of a section: move or cut the "
            "mesh, or set Mesh/Assumption to plane strain.",
            vertex[0],
            vertex[1]));
        else if (vertex[0] <= tolerance)
          vertex[0] = 0.;
    }
  } // namespace


  template <int dim>
  Discretization<dim>::Discretization(const JointedMesh &jointed,
                                      const ModelDefinition &model,
                                      const unsigned int stage)
    : axisymmetric(model.assumption == PlaneAssumption::axisymmetric)
    , thickness(model.thickness)
    , reference(shape_of_cells(jointed, dim), model.polynomial_degree, axisymmetric)
    , cell_mapping(reference.make_mapping())
    , mesh(std::make_unique<dealii::Triangulation<dim>>())
    , element(std::make_unique<dealii::FESystem<dim>>(reference.scalar_element(), dim))
    , there(bodies_in_stage(jointed.body_names, model, stage))
  {
    create_mesh(jointed, model);
    dofs = std::make_unique<dealii::DoFHandler<dim>>(*mesh);
    dofs->distribute_dofs(*element);
    vertex_nodes.assign(jointed.vertices.size(), no_node);
    number_nodes();
    if (mesh->has_hanging_nodes())
      hanging = HangingNodes<dim>(*dofs, node_dofs);
    find_boundary_faces();
    find_pieces();
    my_rank = processes::rank();
    if (processes::number() > 1)
      owners = cell_owners(*this, processes::number());
  }


  template <int dim>
  Discretization<dim>::~Discretization() = default;


  template <int dim>
  void
  Discretization<dim>::create_mesh(const JointedMesh &jointed, const ModelDefinition &model)
  {
    std::vector<dealii::Point<dim>> vertices(jointed.vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
      for (unsigned int c = 0; c < dim; ++c)
        vertices[i][c] = jointed.vertices[i][c];

    if (axisymmetric)
      put_on_axis(vertices);

    std::vector<dealii::CellData<dim>> cells;
    cells.reserve(jointed.cells.size());
    for (const auto &cell : jointed.cells)
      cells.push_back(cell_data<dim>(jointed, cell));
    if (reference.scalar_element().reference_cell().is_hyper_cube())
      dealii::GridTools::consistently_order_cells(cells);

    dealii::SubCellData faces;
    for (const auto &face : jointed.faces)
      if constexpr (dim == 2)
        faces.boundary_lines.push_back(face_data<1>(face));
      else
        faces.boundary_quads.push_back(face_data<2>(face));
    // As p4est balances: across corners too.
    if (!model.local_refinements.empty())
      mesh->set_mesh_smoothing(dealii::Triangulation<dim>::limit_level_difference_at_vertices);
    mesh->create_triangulation(vertices, cells, faces);
    for (const auto &face : mesh->active_face_iterators())
      if (face->at_boundary())
        face->set_boundary_id(face->boundary_id() == 0 ? JointedMesh::no_label - 1
                                                       : face->boundary_id() - 1);
    mesh->refine_global(model.refinements);
    for (const auto &marked : model.local_refinements)
      refine_marked_cells(*mesh, jointed, marked);
    if (model.refined_once_more)
      mesh->refine_global(1);
  }


  template <int dim>
  void
  Discretization<dim>::number_nodes()
  {
    const unsigned int n_local = static_cast<unsigned int>(reference.n_nodes());
    // Local number of the degree of freedom of node i in direction c.
    std::vector<unsigned int> local(n_local * dim);
    for (unsigned int i = 0; i < element->n_dofs_per_cell(); ++i)
      {
        const auto component                            = element->system_to_component_index(i);
        local[component.second * dim + component.first] = i;
      }

    std::vector<unsigned int> node_of_dof(dofs->n_dofs(), no_node);
    std::vector<dealii::types::global_dof_index> indices(element->n_dofs_per_cell());
    nodes_of_cells.reserve(mesh->n_active_cells() * n_local);
    bodies.reserve(mesh->n_active_cells());
    node_dofs.reserve(dofs->n_dofs());
    cell_numbers.assign(mesh->n_active_cells(), no_cell);
    for (const auto &cell : dofs->active_cell_iterators())
      {
        if (!there[cell->material_id()])
          continue;
        cell_numbers[cell->active_cell_index()] = static_cast<unsigned int>(bodies.size());
        bodies.push_back(cell->material_id());
        cell->get_dof_indices(indices);
        for (unsigned int i = 0; i < n_local; ++i)
          {
            unsigned int &node = node_of_dof[indices[local[i * dim]]];
            if (node == no_node)
              {
                node = static_cast<unsigned int>(positions.size());
                for (unsigned int c = 0; c < dim; ++c)
                  node_dofs.push_back(indices[local[i * dim + c]]);
                dealii::Point<dim> position;
                for (unsigned int v = 0; v < reference.n_corners(); ++v)
                  position += reference.geometry_at_node(i)[v] * cell->vertex(v);
                positions.push_back(position);
              }
            nodes_of_cells.push_back(node);
          }
        for (unsigned int v = 0; v < reference.n_corners(); ++v)
          if (cell->vertex_index(v) < vertex_nodes.size())
            vertex_nodes[cell->vertex_index(v)] = *(nodes_of_cells.end() - n_local + v);
      }
  }


  template <int dim>
  void
  Discretization<dim>::find_boundary_faces()
  {
    for (const auto &cell : mesh->active_cell_iterators())
      if (cell->at_boundary())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary())
            {
              const auto id       = cell->face(f)->boundary_id();
              const auto label    = id == JointedMesh::no_label - 1 ? JointedMesh::no_label : id;
              const auto in_table = cell_numbers[cell->active_cell_index()];
              if (in_table == no_cell)
                absent_labels.insert(label);
              else
                outer_faces.push_back({in_table, f, label});
            }
  }


  template <int dim>
  void
  Discretization<dim>::find_pieces()
  {
    DisjointSets sets(n_cells());
    for (const auto &cell : mesh->active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (!cell->at_boundary(f) && cell->neighbor(f)->is_active())
          {
            const unsigned int one   = cell_numbers[cell->active_cell_index()],
                               other = cell_numbers[cell->neighbor(f)->active_cell_index()];
            // A larger neighbour does not see this cell.
            if (one != no_cell && other != no_cell &&
                (other < one || cell->neighbor(f)->level() < cell->level()))
              sets.unite(one, other);
          }
    piece_count = sets.number(pieces);
  }


  template <int dim>
  std::size_t
  Discretization<dim>::n_own_cells() const
  {
    return owners.empty()
             ? n_cells()
             : static_cast<std::size_t>(std::count(owners.begin(), owners.end(), my_rank));
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
