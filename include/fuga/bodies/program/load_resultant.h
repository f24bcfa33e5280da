// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_program_load_resultant_h
#define fuga_bodies_program_load_resultant_h

#include <fuga/bodies/condensed/condensed_system.h>

#include <deal.II/base/tensor.h>

namespace fuga
{
  /**
   * The sum of nodal forces, and where it acts. Every component has its own line of action: the
   * horizontal force of water on an upright face acts at a third of the depth, the vertical force
   * on the bed in the middle of the bed; together they have the moment of all the forces.
   */
  template <int dim>
  class LoadResultant
  {
  public:
    void
    add(const dealii::Point<dim> &place, const dealii::Tensor<1, dim> &force);

    /** Multiply all forces by @p factor. */
    void
    scale(const double factor);

    /** Add the forces of @p other. */
    void
    add(const LoadResultant &other);

    /** Return one component [MN]; 0 if it is no more than rounding in the sum of forces. */
    double
    force(const unsigned int component) const;

    /**
     * Return one coordinate (other than its own) of the position at which a component that is not 0
     * acts [m].
     */
    double
    place(const unsigned int component, const unsigned int coordinate) const;

    /**
     * Return the moment of components whose sum is 0: about z in the plane, about x, y, z in space
     * [MNm].
     */
    std::array<double, 3>
    couple() const;

    /** Return whether there are no forces. */
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

  /** Return the resultant of nodal forces, entry node * dim + component. */
  template <int dim>
  LoadResultant<dim>
  resultant_of(const Discretization<dim> &discretization, const Vector &forces);

  /**
   * Return the resultant of the water in the closed elements of a joint on its plus side; on the
   * minus side it is the opposite. @p water is LoadPattern::closed_water.
   */
  template <int dim>
  LoadResultant<dim>
  resultant_of_water(const CondensedSystem<dim> &system,
                     const unsigned int joint,
                     const Vector &water);
} // namespace fuga

#endif
