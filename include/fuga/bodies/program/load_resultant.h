// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_program_load_resultant_h
#define fuga_bodies_program_load_resultant_h

#include <fuga/bodies/condensed/condensed_system.h>

#include <deal.II/base/tensor.h>

namespace fuga
{
  /**
   * Sum of nodal forces, and where it acts. Every component has a line of action of its own: of
   * water on an upright face the horizontal force acts at a third of the depth, that on the bed in
   * the middle of the bed; together they have the moment of all the forces.
   */
  template <int dim>
  class LoadResultant
  {
  public:
    void
    add(const dealii::Point<dim> &place, const dealii::Tensor<1, dim> &force);

    /** All forces times @p factor. */
    void
    scale(const double factor);

    /** @p other besides. */
    void
    add(const LoadResultant &other);

    /** One component [MN]; 0 if it is no more than rounding in the sum of forces. */
    double
    force(const unsigned int component) const;

    /** Where a component that is not 0 acts, by one coordinate (another than its own) [m]. */
    double
    place(const unsigned int component, const unsigned int coordinate) const;

    /** The moment of components whose sum is 0: about z in the plane, about x, y, z in space [MNm].
     */
    std::array<double, 3>
    couple() const;

    /** Whether there are no forces. */
    bool
    is_empty() const
    {
      return size == 0.;
    }

  private:
    dealii::Tensor<1, dim> sum;
    /** Σ f_c x_d. */
    dealii::Tensor<2, dim> moments;
    /** Σ |f|, and the largest coordinate. */
    double size = 0., reach = 0.;
  };

  /** Of nodal forces, entry node * dim + component. */
  template <int dim>
  LoadResultant<dim>
  resultant_of(const Discretization<dim> &discretization, const Vector &forces);

  /** Of the water in the closed elements of a joint on its plus side; on the minus side it is the
   * opposite. @p water: LoadPattern::closed_water. */
  template <int dim>
  LoadResultant<dim>
  resultant_of_water(const CondensedSystem<dim> &system,
                     const unsigned int joint,
                     const Vector &water);
} // namespace fuga

#endif
