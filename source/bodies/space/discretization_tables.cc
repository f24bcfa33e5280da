// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/tria.h>

#include <fuga/base/disjoint_sets.h>
#include <fuga/bodies/processes.h>
#include <fuga/bodies/space/discretization.h>
#include <fuga/bodies/space/serial_cell_id.h>

#include <algorithm>
#include <numeric>

namespace fuga
{
  /** The cells of all processes and bodies, those of the first process first. */
  template <int dim>
  struct Discretization<dim>::Gathered
  {
    struct Cell
    {
      dealii::CellId id;
      unsigned int body = 0, owner = 0;
      /** Number in the tables, or no_cell. */
      unsigned int number = no_cell;
    };

    std::vector<Cell> cells;
    /** deal.II's number of the first degree of freedom, by cell and node. */
    std::vector<unsigned int> dofs;
    /** The cells, sorted by id. */
    std::vector<unsigned int> order;

    unsigned int
    number_of(const dealii::CellId &id) const
    {
      const auto at = std::lower_bound(
        order.begin(), order.end(), id, [this](const unsigned int cell, const dealii::CellId &key) {
          return cells[cell].id < key;
        });
      return cells[*at].number;
    }
  };


  namespace
  {
    /** A node of this process, its vertex of the coarse mesh if it is one, and its position. */
    template <int dim>
    struct Place
    {
      unsigned int dof, vertex;
      dealii::Point<dim> position;
    };


    /** Return deal.II's local numbers of the first degree of freedom of the nodes of a cell. */
    template <int dim>
    std::vector<unsigned int>
    first_dofs(const dealii::FiniteElement<dim, dim> &element)
    {
      std::vector<unsigned int> result(element.n_dofs_per_cell() / dim);
      for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
        if (const auto [component, node] = element.system_to_component_index(i); component == 0)
          result[node] = i;
      return result;
    }


    template <typename Cell>
    unsigned int
    first_own(const std::vector<Cell> &cells, const unsigned int rank)
    {
      const auto at = std::find_if(
        cells.begin(), cells.end(), [rank](const Cell &cell) { return cell.owner == rank; });
      return static_cast<unsigned int>(at - cells.begin());
    }
  } // namespace


  template <int dim>
  void
  Discretization<dim>::make_tables()
  {
    const Gathered gathered = gather_cells();
    number_nodes(gathered);
    find_boundary_faces();
    find_pieces(gathered);
  }


  template <int dim>
  auto
  Discretization<dim>::gather_cells() -> Gathered
  {
    const std::vector<unsigned int> first = first_dofs(*element);
    std::vector<dealii::types::global_dof_index> indices(element->n_dofs_per_cell());
    Gathered gathered;
    for (const auto &cell : dofs->active_cell_iterators())
      if (cell->is_locally_owned())
        {
          gathered.cells.push_back({serial_cell_id(cell), cell->material_id(), my_rank});
          cell->get_dof_indices(indices);
          for (const unsigned int i : first)
            gathered.dofs.push_back(indices[i]);
        }
    gathered.cells = processes::gather(std::move(gathered.cells));
    gathered.dofs  = processes::gather(std::move(gathered.dofs));

    gathered.order.resize(gathered.cells.size());
    std::iota(gathered.order.begin(), gathered.order.end(), 0);
    const auto before = [&cells = gathered.cells](const unsigned int a, const unsigned int b) {
      return cells[a].id < cells[b].id;
    };
    // A single process has them sorted already, except after local refinement.
    if (!std::is_sorted(gathered.order.begin(), gathered.order.end(), before))
      std::sort(gathered.order.begin(), gathered.order.end(), before);
    for (const unsigned int k : gathered.order)
      if (auto &cell = gathered.cells[k]; there[cell.body])
        {
          cell.number = static_cast<unsigned int>(bodies.size());
          bodies.push_back(cell.body);
          if (processes::number() > 1)
            owners.push_back(cell.owner);
        }

    unsigned int next = first_own(gathered.cells, my_rank);
    cell_numbers.assign(mesh->n_active_cells(), no_cell);
    for (const auto &cell : mesh->active_cell_iterators())
      if (cell->is_locally_owned())
        cell_numbers[cell->active_cell_index()] = gathered.cells[next++].number;
    return gathered;
  }


  template <int dim>
  void
  Discretization<dim>::number_nodes(const Gathered &gathered)
  {
    const std::size_t n_local = reference.n_nodes();
    std::vector<unsigned int> node_of_dof(dofs->n_dofs(), no_node), number_of_dof;
    const bool all_there = bodies.size() == gathered.cells.size();
    if (!all_there)
      number_of_dof = node_of_dof;
    unsigned int n_nodes = 0, n_numbers = 0;
    nodes_of_cells.reserve(n_cells() * n_local);
    for (const unsigned int k : gathered.order)
      for (std::size_t i = k * n_local; i < (k + 1) * n_local; ++i)
        {
          const unsigned int dof = gathered.dofs[i];
          if (!all_there && number_of_dof[dof] == no_node)
            number_of_dof[dof] = n_numbers++;
          if (gathered.cells[k].number == no_cell)
            continue;
          if (node_of_dof[dof] == no_node)
            {
              node_of_dof[dof] = n_nodes++;
              if (!all_there)
                numbers_of_nodes.push_back(number_of_dof[dof]);
            }
          nodes_of_cells.push_back(node_of_dof[dof]);
        }
    positions.resize(n_nodes);
    find_positions(node_of_dof);
    if (mesh->has_hanging_nodes())
      hanging = HangingNodes<dim>(*dofs, node_of_dof, n_nodes);
  }


  template <int dim>
  void
  Discretization<dim>::find_positions(const std::vector<unsigned int> &node_of_dof)
  {
    const std::vector<unsigned int> first = first_dofs(*element);
    std::vector<dealii::types::global_dof_index> indices(element->n_dofs_per_cell());
    const dealii::IndexSet &own = dofs->locally_owned_dofs();
    std::vector<bool> is_found(own.n_elements(), false);
    std::vector<Place<dim>> places;
    for (const auto &cell : dofs->active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        cell->get_dof_indices(indices);
        for (unsigned int i = 0; i < first.size(); ++i)
          {
            const auto dof = indices[first[i]];
            if (node_of_dof[dof] == no_node || !own.is_element(dof) ||
                is_found[own.index_within_set(dof)])
              continue;
            is_found[own.index_within_set(dof)] = true;
            Place<dim> place{dof, no_node, {}};
            for (unsigned int v = 0; v < reference.n_corners(); ++v)
              place.position += reference.geometry_at_node(i)[v] * cell->vertex(v);
            if (i < reference.n_corners() && cell->vertex_index(i) < vertex_nodes.size())
              place.vertex = cell->vertex_index(i);
            places.push_back(place);
          }
      }
    for (const Place<dim> &place : processes::gather(std::move(places)))
      {
        const unsigned int node = node_of_dof[place.dof];
        positions[node]         = place.position;
        if (place.vertex != no_node)
          vertex_nodes[place.vertex] = node;
      }
  }


  template <int dim>
  void
  Discretization<dim>::find_boundary_faces()
  {
    std::vector<unsigned int> of_absent;
    for (const auto &cell : mesh->active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary())
            {
              const auto id       = cell->face(f)->boundary_id();
              const auto label    = id == JointedMesh::no_label - 1 ? JointedMesh::no_label : id;
              const auto in_table = cell_numbers[cell->active_cell_index()];
              if (in_table == no_cell)
                of_absent.push_back(label);
              else
                outer_faces.push_back({in_table, f, label});
            }
    outer_faces = processes::gather(std::move(outer_faces));
    std::sort(
      outer_faces.begin(), outer_faces.end(), [](const BoundaryFace &a, const BoundaryFace &b) {
        return std::make_pair(a.cell, a.number) < std::make_pair(b.cell, b.number);
      });
    of_absent = processes::gather(std::move(of_absent));
    absent_labels.insert(of_absent.begin(), of_absent.end());
  }


  template <int dim>
  void
  Discretization<dim>::find_pieces(const Gathered &gathered)
  {
    DisjointSets sets(n_cells());
    std::vector<std::array<unsigned int, 2>> together;
    for (const auto &cell : mesh->active_cell_iterators())
      {
        const unsigned int number = cell_numbers[cell->active_cell_index()];
        if (number == no_cell)
          continue;
        for (const unsigned int f : cell->face_indices())
          // Small cells see a larger neighbour, which does not see them.
          if (!cell->at_boundary(f) && cell->neighbor(f)->is_active())
            {
              const auto neighbour      = cell->neighbor(f);
              const unsigned int beyond = neighbour->is_locally_owned()
                                            ? cell_numbers[neighbour->active_cell_index()]
                                            : gathered.number_of(serial_cell_id(neighbour));
              if (beyond == no_cell)
                continue;
              sets.unite(number, beyond);
            }
      }
    if (processes::number() > 1)
      for (unsigned int cell = 0; cell < n_cells(); ++cell)
        if (sets.find(cell) != cell)
          together.push_back({{cell, sets.find(cell)}});
    for (const auto &[one, other] : processes::gather(std::move(together)))
      sets.unite(one, other);
    piece_count = sets.number(pieces);
  }


  template class Discretization<2>;
  template class Discretization<3>;
} // namespace fuga
