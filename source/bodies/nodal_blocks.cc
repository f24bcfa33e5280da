// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/elimination_order.h>
#include <fuga/bodies/nodal_blocks.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    /** Displacement of a point in one rigid motion: shifts first, then rotations. */
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
  } // namespace


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
    int n_rows = 0;
    for (std::size_t node = 0; node < space.n_nodes(); ++node)
      {
        first_row[node] = n_rows;
        n_rows += (n_owned[node] + n_components - 1) / n_components * n_components;
      }

    dealii::Point<dim> center;
    for (std::size_t node = 0; node < space.n_nodes(); ++node)
      center += space.position(node) / static_cast<double>(space.n_nodes());
    double size = 0.;
    for (std::size_t node = 0; node < space.n_nodes(); ++node)
      size = std::max(size, space.position(node).distance(center));

    NodalBlocks blocks;
    blocks.block_size = dim;
    blocks.n_rows     = static_cast<unsigned int>(n_rows);
    blocks.rows.assign(owners.size(), none);
    blocks.rigid_motions = DenseMatrix(blocks.n_rows, n_motions);
    // Components keep their place; sliding along a joint, which is nobody's component and rests in
    // a rigid motion, takes what is left.
    std::vector<bool> is_taken(blocks.n_rows, false);
    for (unsigned int node = 0; node < space.n_nodes(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        if (const auto coordinate = coordinates.coordinate_of(node * dim + c);
            coordinate && *coordinate < owners.size() && owners[*coordinate] == node)
          {
            const int row                           = first_row[node] + static_cast<int>(c);
            blocks.rows[*coordinate]                = row;
            is_taken[static_cast<std::size_t>(row)] = true;
            for (unsigned int k = 0; k < n_motions; ++k)
              blocks.rigid_motions(static_cast<std::size_t>(row), k) =
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
