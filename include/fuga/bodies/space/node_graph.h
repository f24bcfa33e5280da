// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_space_node_graph_h
#define fuga_bodies_space_node_graph_h

#include <fuga/bodies/space/discretization.h>

#include <algorithm>

namespace fuga
{
  /**
   * The graph of plain nodes that share a cell: for every node its neighbours with smaller numbers,
   * and the position of the first of its entries among the triplets (dim x dim per neighbour, then
   * a triangle).
   */
  template <int dim>
  class NodeGraph
  {
  public:
    static constexpr std::size_t block = dim * dim, triangle = dim * (dim + 1) / 2;

    /** @p cells are cells of plain nodes; every plain node gets a diagonal block. */
    NodeGraph(const Discretization<dim> &discretization,
              const std::vector<std::size_t> &cells,
              const std::vector<bool> &is_plain);

    std::size_t
    n_entries() const
    {
      return first_entry.back();
    }

    std::size_t
    block_entry(const unsigned int node, const unsigned int neighbour) const
    {
      return first_entry[node] +
             block * static_cast<std::size_t>(std::lower_bound(begin(node), end(node), neighbour) -
                                              begin(node));
    }

    std::size_t
    diagonal_entry(const unsigned int node) const
    {
      return first_entry[node + 1] - triangle;
    }

    bool
    has_entries(const unsigned int node) const
    {
      return first_entry[node] < first_entry[node + 1];
    }

    /** Return the neighbours of a node with smaller numbers. */
    const unsigned int *
    begin(const unsigned int node) const
    {
      return neighbours.data() + first_neighbour[node];
    }

    const unsigned int *
    end(const unsigned int node) const
    {
      return neighbours.data() + first_neighbour[node + 1];
    }

  private:
    std::vector<std::size_t> first_neighbour, first_entry;
    std::vector<unsigned int> neighbours;
  };
} // namespace fuga

#endif
