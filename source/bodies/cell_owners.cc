// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/cell_owners.h>

#include <algorithm>
#include <numeric>

namespace fuga
{
  namespace
  {
    template <int dim>
    class Bisection
    {
    public:
      Bisection(const Discretization<dim> &space, std::vector<unsigned int> &cell_owners)
        : discretization(space), owners(cell_owners)
      {
      }

      /** Gives the cells to the processes from @p first on. */
      void
      divide(unsigned int *begin,
             unsigned int *end,
             const unsigned int first,
             const unsigned int n_processes)
      {
        if (n_processes == 1 || begin == end)
          {
            for (; begin != end; ++begin)
              owners[*begin] = first;
            return;
          }
        const unsigned int direction = longest_side(begin, end);
        const unsigned int half      = n_processes / 2;
        unsigned int *const middle   = begin + (end - begin) * half / n_processes;
        // Cells at the same place in this direction: by their numbers.
        std::nth_element(begin, middle, end, [&](const unsigned int a, const unsigned int b) {
          return std::make_pair(place(a)[direction], a) < std::make_pair(place(b)[direction], b);
        });
        divide(begin, middle, first, half);
        divide(middle, end, first + half, n_processes - half);
      }

    private:
      const dealii::Point<dim> &
      place(const unsigned int cell) const
      {
        return discretization.position(discretization.cell_nodes(cell)[0]);
      }

      unsigned int
      longest_side(const unsigned int *begin, const unsigned int *end) const
      {
        dealii::Point<dim> least = place(*begin), most = least;
        for (; begin != end; ++begin)
          for (unsigned int c = 0; c < dim; ++c)
            {
              least[c] = std::min(least[c], place(*begin)[c]);
              most[c]  = std::max(most[c], place(*begin)[c]);
            }
        unsigned int longest = 0;
        for (unsigned int c = 1; c < dim; ++c)
          if (most[c] - least[c] > most[longest] - least[longest])
            longest = c;
        return longest;
      }

      const Discretization<dim> &discretization;
      std::vector<unsigned int> &owners;
    };
  } // namespace


  template <int dim>
  std::vector<unsigned int>
  cell_owners(const Discretization<dim> &discretization, const unsigned int n_processes)
  {
    std::vector<unsigned int> owners(discretization.n_cells(), 0), cells(owners.size());
    std::iota(cells.begin(), cells.end(), 0);
    Bisection<dim>(discretization, owners)
      .divide(cells.data(), cells.data() + cells.size(), 0, n_processes);
    return owners;
  }


  template std::vector<unsigned int>
  cell_owners(const Discretization<2> &, const unsigned int);
  template std::vector<unsigned int>
  cell_owners(const Discretization<3> &, const unsigned int);
} // namespace fuga
