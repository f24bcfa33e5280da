// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Prints the tables of some meshes, which have to be the same on any number of processes:
// compare_tables.py compares. Fails if a process has more of a mesh than it should.

#include "bodies/block_mesh.h"
#include "bodies/spatial_meshes.h"
#include "random_refinement.h"

#include <deal.II/distributed/shared_tria.h>
#include <deal.II/distributed/tria.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fuga/mesh/gmsh_reader.h>

#include <numeric>

using namespace fuga;
using namespace fuga::test;

namespace
{
  std::string complaint;

  void
  check(const bool condition, const std::string &text)
  {
    if (!condition)
      complaint += text + "\n";
  }


  std::size_t
  sum_of_all(const std::size_t n)
  {
    const std::vector<std::size_t> numbers = processes::from_all(n);
    return std::accumulate(numbers.begin(), numbers.end(), std::size_t(0));
  }


  /** Refined hexahedra through p4est, all else shared; a process has its own cells. */
  template <int dim>
  void
  check_division(const std::string &name, const Discretization<dim> &space, const bool is_refined)
  {
    const auto &mesh = space.triangulation();
    const auto n     = processes::number();
    using namespace dealii::parallel;
    const bool by_p4est = n > 1 && space.reference_element().n_corners() == 1u << dim && is_refined;
    check((dynamic_cast<const distributed::Triangulation<dim> *>(&mesh) != nullptr) == by_p4est,
          name + ": p4est");
    check((dynamic_cast<const shared::Triangulation<dim> *>(&mesh) != nullptr) ==
            (n > 1 && !by_p4est),
          name + ": shared");
    check(sum_of_all(space.n_own_cells()) == space.n_cells(), name + ": cells of processes");
    std::size_t n_own = 0, n_with_neighbours = 0;
    for (const auto &cell : mesh.active_cell_iterators())
      {
        n_own += cell->is_locally_owned();
        n_with_neighbours += !cell->is_artificial();
      }
    const std::size_t n_all = sum_of_all(n_own);
    // One coarse cell refined three times: 8 x 8 or 8 x 8 x 8 cells, of which a half or a third and
    // a layer around it are here.
    if (name.find("one cell") == 0 && n > 1)
      check(n_own * n < 2 * n_all && 4 * n_with_neighbours <= 3 * n_all,
            fmt::format("{}: {} of {} cells", name, n_with_neighbours, n_all));
    if (n_all >= 20 * n)
      check(10 * n_own * n > 5 * n_all, fmt::format("{}: {} of {} cells", name, n_own, n_all));
  }


  template <int dim>
  void
  print(const std::string &name,
        const JointedMesh &mesh,
        const ModelDefinition &model,
        const unsigned int stage = 0)
  {
    const Discretization<dim> space(mesh, model, stage);
    check_division(name, space, model.refinements + model.local_refinements.size() > 0);
    fmt::print("{}: {} cells, {} nodes, {} pieces, {} degrees of freedom of all bodies\n",
               name,
               space.n_cells(),
               space.n_nodes(),
               space.n_pieces(),
               space.n_dofs_of_all_bodies());
    const std::size_t n = space.reference_element().n_nodes();
    for (std::size_t cell = 0; cell < space.n_cells(); ++cell)
      fmt::print("cell {} in {}: {}\n",
                 space.cell_body(cell),
                 space.cell_piece(cell),
                 fmt::join(space.cell_nodes(cell), space.cell_nodes(cell) + n, " "));
    for (unsigned int node = 0; node < space.n_nodes(); ++node)
      {
        fmt::print("node {}:", space.dof(node, 0));
        for (unsigned int c = 0; c < dim; ++c)
          fmt::print(" {:.12f}", space.position(node)[c] + 0.); // no -0
        fmt::print("\n");
      }
    for (const auto &face : space.boundary_faces())
      fmt::print("face {} of {}: {}\n", face.number, face.cell, face.label);
    for (unsigned int label = 0; label < mesh.label_names.size(); ++label)
      fmt::print("{} lacks faces: {}\n", mesh.label_names[label], space.lacks_faces_of(label));
    for (unsigned int vertex = 0; vertex < mesh.vertices.size(); ++vertex)
      fmt::print("vertex {}: {}\n", vertex, space.node_at_vertex(vertex));
    for (const auto &[node, masters] : space.hanging_nodes().masters())
      for (const auto &[master, weight] : masters)
        fmt::print("{} hangs on {} by {:.12f}\n", node, master, weight);
  }


  template <int dim>
  void
  print_refined(const std::string &name, const JointedMesh &mesh)
  {
    for (const unsigned int degree : {1u, 2u})
      {
        ModelDefinition model;
        model.dimension         = dim;
        model.polynomial_degree = degree;
        tests::refine_at_random<dim>(mesh, model, degree, dim == 2 ? 4 : 2);
        print<dim>(fmt::format("{} of degree {}", name, degree), mesh, model);
        model.refined_once_more = true;
        if (degree == 1)
          print<dim>(name + ", refined once more", mesh, model);
      }
  }


  BlockMesh
  one_cell()
  {
    BlockMesh mesh;
    mesh.add_block("block", 1, 1, rectangle(0., 1., 0., 1.), {{"bottom", "right", "top", "left"}});
    return mesh;
  }


  void
  print_all(const std::string &folder)
  {
    ModelDefinition three_times;
    three_times.refinements = 3;
    print<2>("one cell", one_cell().mesh, three_times);
    three_times.dimension = 3;
    print<3>("one cell in space", extruded(one_cell().mesh, 1), three_times);
    ModelDefinition plain;
    print<2>("two cells", two_blocks().mesh, plain);
    print_refined<2>("plane", two_blocks().mesh);
    print_refined<3>("crossing", extruded(blocks_round_a_crossing(2).mesh, 2));
    print_refined<3>("narrow block", narrow_block());

    ModelDefinition stages           = two_block_model();
    stages.materials.back().built_at = 1;
    print<2>("one block alone", two_blocks().mesh, stages);
    print<2>("both blocks", two_blocks().mesh, stages, 1);

    JointDefinition joint;
    joint.name = joint.line = "joint";
    joint.plus_body         = "upper";
    joint.minus_body        = "lower";
    const auto patch        = [&](const std::string &file) {
      return split_joints(read_gmsh_mesh(folder + "/" + file), {joint});
    };
    ModelDefinition simplices;
    simplices.refinements = 1;
    print<2>("triangles", patch("patch_tri.msh"), simplices);
    simplices.dimension         = 3;
    simplices.polynomial_degree = 1;
    print<3>("tetrahedra", patch("patch_tet.msh"), simplices);
  }
} // namespace


int
main(int, char **arguments)
{
  processes::join();
  print_all(arguments[1]);
  return processes::leave(complaint.empty() ? 0 : 1, complaint);
}
