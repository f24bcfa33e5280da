// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_space_cell_values_h
#define fuga_bodies_space_cell_values_h

#include <fuga/bodies/space/discretization.h>

namespace fuga
{
  /**
   * Values, gradients and volumes at the quadrature points of one cell after the other. Nothing is
   * computed again for a cell that is a translated copy of the one before, as most cells of a
   * regular mesh are.
   *
   * dealii::FEValues gives the same numbers, but its reinit() takes longer than the product of a
   * cell's matrix with a vector, so that recovering the fields of a mesh of triangles took four
   * times as long; and a process has deal.II's cells of its own part of the mesh only.
   */
  template <int dim>
  class CellValues
  {
  public:
    explicit CellValues(const Discretization<dim> &discretization);

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
    /** At one point of the reference cell; the geometry is linear in its corners. */
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
    /** Of the first corner, when edges and volumes were computed. */
    double radius = 0.;
    std::vector<double> volumes;
    std::vector<std::vector<dealii::Tensor<1, dim>>> gradients;
  };
} // namespace fuga

#endif
