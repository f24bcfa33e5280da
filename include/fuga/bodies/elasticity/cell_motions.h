// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_elasticity_cell_motions_h
#define fuga_bodies_elasticity_cell_motions_h

#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/bodies/space/discretization.h>

namespace fuga
{
  /**
   * The rigid motions of one cell after the other. They cause no forces, and the forces of a cell
   * have no resultants; but a stiffness matrix K in double precision knows that only to ε‖K‖, which
   * beside the forces of a slender body that bends far is much. Vectors: entry (node of the cell *
   * dim + component).
   */
  template <int dim>
  class CellMotions
  {
  public:
    explicit CellMotions(const Discretization<dim> &discretization);

    void
    move_to(const std::size_t cell);

    /** Takes the rigid motion out of displacements of the nodes, or the resultants out of forces on
     * them: v -= R Rᵀ v. */
    void
    take_out(Vector &v) const;

  private:
    /** Makes a rotation orthogonal to those before it, and a unit vector. */
    void
    orthonormalize(const std::size_t k);

    const Discretization<dim> &discretization;
    const std::size_t n_nodes;
    /** Component of the first shift that causes no forces. */
    const unsigned int first_shift;
    /** Of the nodes from the first one: cells that are copies have the same rotations. */
    std::vector<dealii::Tensor<1, dim>> arms;
    /** Orthonormal, about the mean of the nodes. */
    std::vector<Vector> rotations;
    bool is_ready = false;
  };
} // namespace fuga

#endif
