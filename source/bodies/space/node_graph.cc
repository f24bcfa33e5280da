// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/space/node_graph.h>

#include <algorithm>

namespace fuga
{
  template <int dim>
  NodeGraph<dim>::NodeGraph(const Discretization<dim> &space,
                            const std::vector<std::size_t> &cells,
                            const std::vector<bool> &is_plain)
  {
    const std::size_t n_nodes = space.n_nodes(), n_local = space.reference_element().n_nodes();
    std::vector<unsigned int> first_cell(n_nodes + 1, 0), cells_of_node;
    for (const std::size_t cell : cells)
      for (std::size_t i = 0; i < n_local; ++i)
        ++first_cell[space.cell_nodes(cell)[i] + 1];
    for (std::size_t node = 0; node < n_nodes; ++node)
      first_cell[node + 1] += first_cell[node];
    cells_of_node.resize(first_cell.back());
    std::vector<unsigned int> next = first_cell;
    for (const std::size_t cell : cells)
      for (std::size_t i = 0; i < n_local; ++i)
        cells_of_node[next[space.cell_nodes(cell)[i]]++] = static_cast<unsigned int>(cell);

    std::vector<unsigned int> seen(n_nodes, static_cast<unsigned int>(-1));
    first_neighbour.reserve(n_nodes + 1);
    first_neighbour.push_back(0);
    first_entry.reserve(n_nodes + 1);
    first_entry.push_back(0);
    neighbours.reserve(n_nodes * (n_local == 3 ? 3 : 4));
    for (unsigned int node = 0; node < n_nodes; ++node)
      {
        for (unsigned int k = first_cell[node]; k < first_cell[node + 1]; ++k)
          for (std::size_t i = 0; i < n_local; ++i)
            {
              const unsigned int other = space.cell_nodes(cells_of_node[k])[i];
              if (other < node && seen[other] != node)
                {
                  seen[other] = node;
                  neighbours.push_back(other);
                }
            }
        std::sort(neighbours.begin() + static_cast<std::ptrdiff_t>(first_neighbour.back()),
                  neighbours.end());
        first_entry.push_back(first_entry.back() + (is_plain[node] ? triangle : 0) +
                              block * (neighbours.size() - first_neighbour.back()));
        first_neighbour.push_back(neighbours.size());
      }
  }


  template class NodeGraph<2>;
  template class NodeGraph<3>;
} // namespace fuga
