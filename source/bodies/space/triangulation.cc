// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/distributed/shared_tria.h>
#include <deal.II/distributed/tria.h>

#include <deal.II/grid/grid_tools.h>

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/point_text.h>
#include <fuga/bodies/processes.h>
#include <fuga/bodies/space/mesh_refinement.h>
#include <fuga/bodies/space/triangulation.h>
#include <p4est.h>
#include <sc.h>

#include <cmath>

namespace fuga
{
  namespace
  {
    /** Return six times the volume of a tetrahedron; for a hexahedron that of four corners around
     * its first one, which is sufficient to determine its orientation. */
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

    /** Return right-handed corners in the order that deal.II requires: in the file those of every
     * bottom and top are counter-clockwise, in deal.II they are ordered by coordinates. */
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
          throw InputError(
            fmt::format("A cell of body '{}' at {} has no {}. Correct the mesh there.",
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

    /** deal.II assigns boundary id 0 to faces that are not listed, so labels are shifted by one. */
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

    /** Set r = 0 exactly where it is meant. */
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

    bool
    is_refined(const ModelDefinition &model)
    {
      return model.refinements > 0 || !model.local_refinements.empty() || model.refined_once_more;
    }


    /** Start p4est once; it is silent, as it would otherwise report what it does. */
    void
    start_p4est(const MPI_Comm communicator)
    {
      if (sc_package_id >= 0)
        return;
      sc_init(communicator, 0, 0, nullptr, SC_LP_SILENT);
      p4est_init(nullptr, SC_LP_SILENT);
    }


    /** p4est balances across corners as well, and so does the plain mesh. p4est would keep a coarse
     * mesh as a whole on every process, together with its own data of the cells, which takes twice
     * the memory. */
    template <int dim>
    std::unique_ptr<dealii::Triangulation<dim>>
    make_empty_triangulation(const bool hypercubes, const ModelDefinition &model)
    {
      using Plain = dealii::Triangulation<dim>;
      const auto smoothing =
        model.local_refinements.empty() ? Plain::none : Plain::limit_level_difference_at_vertices;
      if (processes::number() == 1)
        return std::make_unique<Plain>(smoothing);
      processes::meet(processes::Place::mesh); // deal.II's functions wait for all
      const MPI_Comm communicator = MPI_Comm_f2c(processes::fortran_communicator());
      if (!hypercubes || !is_refined(model))
        {
          using Shared = dealii::parallel::shared::Triangulation<dim>;
          return std::make_unique<Shared>(communicator, smoothing, false, Shared::partition_metis);
        }
      start_p4est(communicator);
      return std::make_unique<dealii::parallel::distributed::Triangulation<dim>>(communicator,
                                                                                 smoothing);
    }
  } // namespace


  template <int dim>
  std::unique_ptr<dealii::Triangulation<dim, dim>>
  make_triangulation(const JointedMesh &jointed, const ModelDefinition &model)
  {
    std::vector<dealii::Point<dim>> vertices(jointed.vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
      for (unsigned int c = 0; c < dim; ++c)
        vertices[i][c] = jointed.vertices[i][c];

    if (model.assumption == PlaneAssumption::axisymmetric)
      put_on_axis(vertices);

    const bool hypercubes = n_vertices(jointed.cells.front().shape) == 1u << dim;
    std::vector<dealii::CellData<dim>> cells;
    cells.reserve(jointed.cells.size());
    for (const auto &cell : jointed.cells)
      cells.push_back(cell_data<dim>(jointed, cell));
    if (hypercubes)
      dealii::GridTools::consistently_order_cells(cells);

    dealii::SubCellData faces;
    for (const auto &face : jointed.faces)
      if constexpr (dim == 2)
        faces.boundary_lines.push_back(face_data<1>(face));
      else
        faces.boundary_quads.push_back(face_data<2>(face));
    auto mesh = make_empty_triangulation<dim>(hypercubes, model);
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
    return mesh;
  }


  template std::unique_ptr<dealii::Triangulation<2, 2>>
  make_triangulation(const JointedMesh &, const ModelDefinition &);
  template std::unique_ptr<dealii::Triangulation<3, 3>>
  make_triangulation(const JointedMesh &, const ModelDefinition &);
} // namespace fuga
