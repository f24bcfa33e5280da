// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_space_node_cells_on_face_h
#define fuga_bodies_space_node_cells_on_face_h

#include <deal.II/base/point.h>

#include <utility>
#include <vector>

namespace fuga
{
  /**
   * Return the part of a face that belongs to each of its nodes, by its corners in the reference of
   * the face: it extends between the points up to which the weights of Gauss and Lobatto's rule add
   * up, so that its area is the integral of the node's shape function; on a triangle, between the
   * midpoints of the edges and the centre. @p n_corners is that of the face. Nodes are in the order
   * of ReferenceElement::Face.
   */
  template <int dim>
  std::vector<std::vector<dealii::Point<dim - 1>>>
  node_cells_on_face(const std::size_t n_corners, const unsigned int degree);

  /** Return the pairs of nodes of a face whose parts meet along more than a point. */
  std::vector<std::pair<std::size_t, std::size_t>>
  neighbours_on_face(const unsigned int dim,
                     const std::size_t n_corners,
                     const unsigned int degree);
} // namespace fuga

#endif
