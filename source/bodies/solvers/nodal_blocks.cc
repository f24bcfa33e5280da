// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/processes.h>
#include <fuga/bodies/solvers/elimination_order.h>
#include <fuga/bodies/solvers/nodal_blocks.h>

#include <algorithm>
#include <numeric>

namespace fuga
{
  namespace
  {
    /** Return the displacement of a point in one rigid motion: shifts first, then rotations. */
    template <int dim>
    dealii::Tensor<1, dim>
    rigid_motion(const unsigned int number, const dealii::Tensor<1, dim> &arm)
    {
      dealii::Tensor<1, dim> u;
      if (number < dim)
        u[number] = 1.;
      else
        {
          // In the plane the only rotation is that about z.
          const unsigned int axis = dim == 2 ? 2 : number - dim;
          const unsigned int a = (axis + 1) % 3, b = (axis + 2) % 3;
          u[a] = -arm[b];
          u[b] = arm[a];
        }
      return u;
    }


    template <int dim>
    std::vector<unsigned int>
    process_of_nodes(const Discretization<dim> &space)
    {
      std::vector<unsigned int> result(space.n_nodes(), 0);
      if (processes::number() == 1)
        return result;
      std::fill(result.begin(), result.end(), processes::number() - 1);
      for (std::size_t cell = 0; cell < space.n_cells(); ++cell)
        for (std::size_t i = 0; i < space.reference_element().n_nodes(); ++i)
          {
            unsigned int &process = result[space.cell_nodes(cell)[i]];
            process               = std::min(process, space.owner(cell));
          }
      return result;
    }
  } // namespace


  int
  NodalBlocks::n_own_rows() const
  {
    return first_rows[processes::rank() + 1] - first_rows[processes::rank()];
  }


  int
  NodalBlocks::own_place(const int row) const
  {
    return row - first_rows[processes::rank()];
  }


  template <int dim>
  NodalBlocks
  nodal_blocks(const Discretization<dim> &space, const InterfaceCoordinates<dim> &coordinates)
  {
    constexpr unsigned int n_motions = dim * (dim + 1) / 2;
    constexpr int n_components = dim, none = -1;
    const auto owners = owners_of_coordinates(space, coordinates);

    std::vector<int> first_row(space.n_nodes(), none), n_owned(space.n_nodes(), 0);
    for (const unsigned int node : owners)
      ++n_owned[node];
    const auto n_rows_of = [&](const std::size_t node) {
      return (n_owned[node] + n_components - 1) / n_components * n_components;
    };
    NodalBlocks blocks;
    const std::vector<unsigned int> process = process_of_nodes(space);
    blocks.first_rows.assign(processes::number() + 1, 0);
    for (std::size_t node = 0; node < space.n_nodes(); ++node)
      blocks.first_rows[process[node] + 1] += n_rows_of(node);
    std::partial_sum(blocks.first_rows.begin(), blocks.first_rows.end(), blocks.first_rows.begin());
    std::vector<int> next = blocks.first_rows;
    for (std::size_t node = 0; node < space.n_nodes(); ++node)
      {
        first_row[node] = next[process[node]];
        next[process[node]] += n_rows_of(node);
      }

    dealii::Point<dim> center;
    for (std::size_t node = 0; node < space.n_nodes(); ++node)
      center += space.position(node) / static_cast<double>(space.n_nodes());
    double size = 0.;
    for (std::size_t node = 0; node < space.n_nodes(); ++node)
      size = std::max(size, space.position(node).distance(center));

    blocks.block_size = dim;
    blocks.rows.assign(owners.size(), none);
    blocks.rigid_motions = DenseMatrix(static_cast<std::size_t>(blocks.n_own_rows()), n_motions);
    // Components keep their place. Sliding along a joint, which belongs to no component and is zero
    // in a rigid motion, takes the remaining places.
    std::vector<bool> is_taken(static_cast<std::size_t>(blocks.n_rows()), false);
    for (unsigned int node = 0; node < space.n_nodes(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        if (const auto coordinate = coordinates.coordinate_of(node * dim + c);
            coordinate && *coordinate < owners.size() && owners[*coordinate] == node)
          {
            const int row                           = first_row[node] + static_cast<int>(c);
            blocks.rows[*coordinate]                = row;
            is_taken[static_cast<std::size_t>(row)] = true;
            if (process[node] == processes::rank())
              for (unsigned int k = 0; k < n_motions; ++k)
                blocks.rigid_motions(static_cast<std::size_t>(blocks.own_place(row)), k) =
                  rigid_motion<dim>(k, (space.position(node) - center) / size)[c];
          }
    for (std::size_t i = 0; i < owners.size(); ++i)
      if (blocks.rows[i] == none)
        {
          auto row = static_cast<std::size_t>(first_row[owners[i]]);
          while (is_taken[row])
            ++row;
          is_taken[row]  = true;
          blocks.rows[i] = static_cast<int>(row);
        }
    return blocks;
  }


  template NodalBlocks
  nodal_blocks(const Discretization<2> &, const InterfaceCoordinates<2> &);
  template NodalBlocks
  nodal_blocks(const Discretization<3> &, const InterfaceCoordinates<3> &);
} // namespace fuga
