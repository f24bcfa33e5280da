// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/bodies/solvers/elimination_order.h>

#include <algorithm>
#include <metis.h>
#include <numeric>
#include <type_traits>

namespace fuga
{
  namespace
  {
    /** Lists of different lengths, stored one after the other. */
    struct Lists
    {
      std::vector<unsigned int> start = {0}, entries;

      void
      finish_list()
      {
        start.push_back(static_cast<unsigned int>(entries.size()));
      }
    };

    /** Return for each of @p n numbers the lists in which it occurs. */
    Lists
    transposed(const Lists &lists, const std::size_t n)
    {
      Lists result;
      result.start.assign(n + 1, 0);
      for (const unsigned int entry : lists.entries)
        ++result.start[entry + 1];
      std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
      result.entries.resize(lists.entries.size());
      std::vector<unsigned int> next = result.start;
      for (unsigned int list = 0; list + 1 < lists.start.size(); ++list)
        for (unsigned int k = lists.start[list]; k < lists.start[list + 1]; ++k)
          result.entries[next[lists.entries[k]]++] = list;
      return result;
    }


    Graph
    neighbours(const Lists &cells, const std::size_t n_nodes)
    {
      const Lists cells_of = transposed(cells, n_nodes);
      Graph graph;
      std::vector<unsigned int> seen(n_nodes, static_cast<unsigned int>(-1));
      for (unsigned int node = 0; node < n_nodes; ++node)
        {
          seen[node] = node;
          for (unsigned int c = cells_of.start[node]; c < cells_of.start[node + 1]; ++c)
            for (unsigned int k = cells.start[cells_of.entries[c]];
                 k < cells.start[cells_of.entries[c] + 1];
                 ++k)
              if (const unsigned int other = cells.entries[k]; seen[other] != node)
                {
                  seen[other] = node;
                  graph.neighbours.push_back(static_cast<idx_t>(other));
                }
          graph.start.push_back(static_cast<idx_t>(graph.neighbours.size()));
        }
      return graph;
    }
  } // namespace


  // The seed is fixed so that every run has the same order. METIS_NodeND() catches SIGTERM while it
  // runs and leaves by longjmp(), wherever it is (in malloc(), or with a pointer freed but not
  // reset). The function that ParMETIS calls for its last levels computes the same order and does
  // not do this.
  std::vector<int>
  nested_dissection(Graph graph)
  {
    static_assert(std::is_same_v<idx_t, int>);
    std::vector<idx_t> node_at(graph.start.size() - 1), place_of(node_at.size());
    if (node_at.empty())
      return node_at;
    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_SEED]  = 1;
    const idx_t n_processes     = 1;
    idx_t size_of_separators[1] = {0}; // 2 n_processes - 1 entries, for what processes would share
    if (METIS_NodeNDP(static_cast<idx_t>(node_at.size()),
                      graph.start.data(),
                      graph.neighbours.data(),
                      nullptr,
                      n_processes,
                      options,
                      node_at.data(),
                      place_of.data(),
                      size_of_separators) != METIS_OK)
      throw NumericalFailure("METIS found no order of elimination for the bodies.");
    return node_at;
  }


  template <int dim>
  std::vector<unsigned int>
  owners_of_coordinates(const Discretization<dim> &discretization,
                        const InterfaceCoordinates<dim> &coordinates)
  {
    using Term                      = typename InterfaceCoordinates<dim>::Term;
    constexpr unsigned int none     = static_cast<unsigned int>(-1);
    const unsigned int n_eliminated = coordinates.first_interface_coordinate();
    std::vector<unsigned int> owner(n_eliminated, none);
    std::vector<Term> terms;
    for (unsigned int pass = 0; pass < 2; ++pass)
      for (unsigned int node = 0; node < discretization.n_nodes(); ++node)
        for (unsigned int c = 0; c < dim; ++c)
          {
            coordinates.terms_of(node * dim + c, terms);
            for (const Term &term : terms)
              if (term.coordinate < n_eliminated && owner[term.coordinate] == none &&
                  (terms.size() == 1 || pass == 1))
                owner[term.coordinate] = node;
          }
    return owner;
  }


  template <int dim>
  std::vector<int>
  elimination_order(const Discretization<dim> &discretization,
                    const InterfaceCoordinates<dim> &coordinates)
  {
    using Term                            = typename InterfaceCoordinates<dim>::Term;
    const unsigned int n_eliminated       = coordinates.first_interface_coordinate();
    const std::vector<unsigned int> owner = owners_of_coordinates(discretization, coordinates);
    std::vector<bool> is_plain(discretization.n_nodes());
    for (unsigned int node = 0; node < discretization.n_nodes(); ++node)
      is_plain[node] = coordinates.is_plain(node);
    std::vector<Term> terms;

    Lists cells;
    const std::size_t n_local = discretization.reference_element().n_nodes();
    cells.start.reserve(discretization.n_cells() + 1);
    cells.entries.reserve(discretization.n_cells() * n_local);
    for (std::size_t cell = 0; cell < discretization.n_cells(); ++cell)
      {
        for (std::size_t i = 0; i < n_local; ++i)
          if (const unsigned int node = discretization.cell_nodes(cell)[i]; is_plain[node])
            cells.entries.push_back(node);
          else
            for (unsigned int c = 0; c < dim; ++c)
              {
                coordinates.terms_of(node * dim + c, terms);
                for (const Term &term : terms)
                  if (term.coordinate < n_eliminated)
                    cells.entries.push_back(owner[term.coordinate]);
              }
        const auto begin = cells.entries.begin() + static_cast<std::ptrdiff_t>(cells.start.back());
        std::sort(begin, cells.entries.end());
        cells.entries.erase(std::unique(begin, cells.entries.end()), cells.entries.end());
        cells.finish_list();
      }

    const std::vector<int> nodes = nested_dissection(neighbours(cells, discretization.n_nodes()));
    std::vector<unsigned int> first(discretization.n_nodes() + 1, 0);
    for (const unsigned int node : owner)
      ++first[node + 1];
    std::vector<unsigned int> count(first.begin() + 1, first.end());
    unsigned int place = 0;
    for (const int node : nodes)
      {
        first[static_cast<std::size_t>(node)] = place;
        place += count[static_cast<std::size_t>(node)];
      }
    std::vector<int> order(coordinates.size());
    for (unsigned int i = 0; i < order.size(); ++i)
      order[i] = static_cast<int>(i < n_eliminated ? first[owner[i]]++ : i) + 1;
    return order;
  }


  template std::vector<unsigned int>
  owners_of_coordinates(const Discretization<2> &, const InterfaceCoordinates<2> &);
  template std::vector<unsigned int>
  owners_of_coordinates(const Discretization<3> &, const InterfaceCoordinates<3> &);
  template std::vector<int>
  elimination_order(const Discretization<2> &, const InterfaceCoordinates<2> &);
  template std::vector<int>
  elimination_order(const Discretization<3> &, const InterfaceCoordinates<3> &);
} // namespace fuga
