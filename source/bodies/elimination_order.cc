// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/elimination_order.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    /** Sets of nodes that are not divided further. */
    constexpr std::size_t leaf_size = 12;

    /** Lists of different lengths, one after the other. */
    struct Lists
    {
      std::vector<unsigned int> start = {0}, entries;

      void
      finish_list()
      {
        start.push_back(static_cast<unsigned int>(entries.size()));
      }
    };

    template <int dim>
    class Dissection
    {
    public:
      Dissection(const Discretization<dim> &space, const Lists &nodes_of_cells)
        : discretization(space), cells(nodes_of_cells), side(space.n_nodes(), separator)
      {
      }

      /** The nodes that occur in cells, in the order of elimination. */
      std::vector<unsigned int>
      run()
      {
        std::vector<unsigned int> all_cells, all_nodes;
        for (unsigned int cell = 0; cell + 1 < cells.start.size(); ++cell)
          if (cells.start[cell] < cells.start[cell + 1])
            all_cells.push_back(cell);
        std::vector<bool> seen(discretization.n_nodes(), false);
        for (const unsigned int node : cells.entries)
          if (!seen[node])
            {
              seen[node] = true;
              all_nodes.push_back(node);
            }
        order.reserve(all_nodes.size());
        divide(std::move(all_cells), std::move(all_nodes));
        return std::move(order);
      }

    private:
      enum Side : unsigned char
      {
        low,
        high,
        separator
      };

      void
      divide(std::vector<unsigned int> my_cells, std::vector<unsigned int> nodes)
      {
        if (nodes.size() <= leaf_size)
          {
            order.insert(order.end(), nodes.begin(), nodes.end());
            for (const unsigned int node : nodes)
              side[node] = separator;
            return;
          }
        split(nodes);
        // A cell that reaches across gives its nodes on the low side to the separator.
        for (const unsigned int cell : my_cells)
          {
            bool has[3] = {false, false, false};
            for (unsigned int k = cells.start[cell]; k < cells.start[cell + 1]; ++k)
              has[side[cells.entries[k]]] = true;
            if (has[low] && has[high])
              for (unsigned int k = cells.start[cell]; k < cells.start[cell + 1]; ++k)
                if (side[cells.entries[k]] == low)
                  side[cells.entries[k]] = separator;
          }
        std::vector<unsigned int> cells_of[2], nodes_of[3];
        for (const unsigned int cell : my_cells)
          for (unsigned int k = cells.start[cell]; k < cells.start[cell + 1]; ++k)
            if (const Side at = side[cells.entries[k]]; at != separator)
              {
                cells_of[at].push_back(cell);
                break;
              }
        for (const unsigned int node : nodes)
          nodes_of[side[node]].push_back(node);
        my_cells = {};
        nodes    = {};
        // The marks of the other half must not be taken for those of the next level.
        for (const unsigned int node : nodes_of[high])
          side[node] = separator;
        divide(std::move(cells_of[low]), std::move(nodes_of[low]));
        divide(std::move(cells_of[high]), std::move(nodes_of[high]));
        order.insert(order.end(), nodes_of[separator].begin(), nodes_of[separator].end());
      }

      /** Marks the nodes below, above and on the median along the longest side of their box. */
      void
      split(const std::vector<unsigned int> &nodes)
      {
        dealii::Point<dim> least = discretization.position(nodes[0]), most = least;
        for (const unsigned int node : nodes)
          for (unsigned int c = 0; c < dim; ++c)
            {
              least[c] = std::min(least[c], discretization.position(node)[c]);
              most[c]  = std::max(most[c], discretization.position(node)[c]);
            }
        unsigned int longest = 0;
        for (unsigned int c = 1; c < dim; ++c)
          if (most[c] - least[c] > most[longest] - least[longest])
            longest = c;
        values.clear();
        for (const unsigned int node : nodes)
          values.push_back(discretization.position(node)[longest]);
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        const double tolerance = 1e-9 * (most[longest] - least[longest]);
        for (const unsigned int node : nodes)
          {
            const double offset = discretization.position(node)[longest] - *middle;
            side[node]          = offset < -tolerance ? low : offset > tolerance ? high : separator;
          }
      }

      const Discretization<dim> &discretization;
      const Lists &cells;
      std::vector<Side> side;
      std::vector<double> values;
      std::vector<unsigned int> order;
    };
  } // namespace


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

    const std::vector<unsigned int> nodes = Dissection<dim>(discretization, cells).run();
    std::vector<unsigned int> first(discretization.n_nodes() + 1, 0);
    for (const unsigned int node : owner)
      ++first[node + 1];
    std::vector<unsigned int> count(first.begin() + 1, first.end());
    unsigned int place = 0;
    for (const unsigned int node : nodes)
      {
        first[node] = place;
        place += count[node];
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
