// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_cell_geometry_h
#define fuga_bodies_cell_geometry_h

#include <fuga/bodies/discretization.h>

namespace fuga
{
  /**
   * Gradients and volumes at the quadrature points of one cell after the other. Nothing is computed
   * again for a cell that is a translated copy of the one before, as most cells of a regular mesh
   * are.
   */
  template <int dim>
  class CellGeometry
  {
  public:
    explicit CellGeometry(const Discretization<dim> &discretization);

    /**
     * Goes to a cell; returns false if it has the geometry of the last one.
     * @throws InputError for a cell that is folded over.
     */
    bool
    move_to(const std::size_t cell);

    std::size_t
    n_points() const
    {
      return volumes.size();
    }

    /** Quadrature weight times the volume of point @p q, with the extent across the plane. */
    double
    volume(const std::size_t q) const
    {
      return volumes[q];
    }

    /** Gradients of all shape functions at point @p q. */
    const std::vector<dealii::Tensor<1, dim>> &
    gradients(const std::size_t q) const
    {
      return all_gradients[q];
    }

    dealii::Point<dim>
    point(const std::size_t q) const;

  private:
    bool
    is_translated_copy() const;

    void
    compute();

    const Discretization<dim> &discretization;
    const ReferenceElement<dim> &reference;
    std::vector<dealii::Point<dim>> corners;
    std::vector<dealii::Tensor<1, dim>> edges;
    /** Of the first corner, when edges and volumes were computed. */
    double radius = 0.;
    std::vector<double> volumes;
    std::vector<std::vector<dealii::Tensor<1, dim>>> all_gradients;
  };
} // namespace fuga

#endif
