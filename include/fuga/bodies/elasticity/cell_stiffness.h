// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_elasticity_cell_stiffness_h
#define fuga_bodies_elasticity_cell_stiffness_h

#include <fuga/bodies/elasticity/lame_constants.h>
#include <fuga/bodies/space/cell_values.h>

namespace fuga
{
  /**
   * Computes the stiffness matrices of one cell after the other; entry (node * dim + component). A
   * cell with the same shape and body as the previous one reuses its matrix.
   */
  template <int dim>
  class CellStiffness
  {
  public:
    /** @p materials, one for each body, must live as long as this object. */
    CellStiffness(const Discretization<dim> &discretization,
                  const std::vector<LameConstants> &materials);

    /** Return all entries, row by row. */
    const double *
    of(const std::size_t cell);

    /**
     * Compute the displacements of the nodes of @p cell, which is that of the last call of of(),
     * without a rigid motion: a translation, and the rotation at a point of the cell. The rigid
     * motion causes no force, and no rounding error either, which in a slender cell that turns
     * would be larger than the forces. In axisymmetry only a translation along the axis is removed.
     */
    void
    take_deformation(const std::size_t cell, const Vector &u, Vector &local) const;

  private:
    void
    compute();

    /** Return the block of two nodes computed from ∫ ∇N_a ⊗ ∇N_b. */
    dealii::Tensor<2, dim>
    plane_block(const dealii::Tensor<2, dim> &product) const;

    /** Add the contribution of the hoop strain u_r / r. */
    void
    add_hoop(const std::size_t a, const std::size_t b, dealii::Tensor<2, dim> &block) const;

    const Discretization<dim> &discretization;
    const std::vector<LameConstants> &materials;
    CellValues<dim> values;
    std::size_t n_nodes;
    std::vector<double> matrix;
    unsigned int body = static_cast<unsigned int>(-1);
  };
} // namespace fuga

#endif
