// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_space_cell_values_h
#define fuga_bodies_space_cell_values_h

#include <fuga/bodies/space/discretization.h>

namespace fuga
{
  /**
   * Values, gradients and volumes at the quadrature points of one cell after the other. Nothing is
   * computed again for a cell that is a translated copy of the previous one, like most cells of a
   * regular mesh.
   *
   * dealii::FEValues computes the same numbers, but its reinit() takes longer than the product of a
   * cell's matrix with a vector, so that recovering the fields of a mesh of triangles took four
   * times as long; moreover, a process has deal.II's cells only of its own part of the mesh.
   */
  template <int dim>
  class CellValues
  {
  public:
    explicit CellValues(const Discretization<dim> &discretization);

    /**
     * Go to a cell; return false if it has the geometry of the last one.
     * @throws InputError for a cell that is folded over.
     */
    bool
    move_to(const std::size_t cell);

    std::size_t
    n_points() const
    {
      return volumes.size();
    }

    /**
     * Return the quadrature weight times the volume of point @p q, including the extent across the
     * plane.
     */
    double
    volume(const std::size_t q) const
    {
      return volumes[q];
    }

    dealii::Point<dim>
    point(const std::size_t q) const;

    double
    value(const std::size_t node, const std::size_t q) const
    {
      return tables[q].values[node];
    }

    const dealii::Tensor<1, dim> &
    gradient(const std::size_t node, const std::size_t q) const
    {
      return gradients[q][node];
    }

  private:
    /** Values at one point of the reference cell; the geometry is linear in its corners. */
    struct Table
    {
      double weight = 0.;
      std::vector<double> values, corner_values;
      std::vector<dealii::Tensor<1, dim>> gradients, corner_gradients;
    };

    bool
    is_translated_copy() const;

    void
    compute();

    const Discretization<dim> &discretization;
    std::vector<Table> tables;
    std::vector<dealii::Point<dim>> corners;
    std::vector<dealii::Tensor<1, dim>> edges;
    /** Radius of the first corner when edges and volumes were computed. */
    double radius = 0.;
    std::vector<double> volumes;
    std::vector<std::vector<dealii::Tensor<1, dim>>> gradients;
  };
} // namespace fuga

#endif
