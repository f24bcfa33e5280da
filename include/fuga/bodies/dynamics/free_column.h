// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_dynamics_free_column_h
#define fuga_bodies_dynamics_free_column_h

#include <deal.II/base/polynomial.h>

#include <fuga/contact/dynamics/time_integration.h>

#include <array>
#include <optional>

namespace fuga
{
  /**
   * A column of ground of unit section whose points move as far as their height says: waves of
   * shear and of pressure between its foot and its free surface, in the steps of the bodies beside
   * it. Entry dim node + component, the last component of which is vertical; nodes from below.
   */
  template <int dim>
  class FreeColumn
  {
  public:
    /** A finite element of ground. */
    struct Cell
    {
      /** Heights [m]. */
      double foot = 0., top = 0.;
      /** [MN s²/m⁴] */
      double density = 0.;
      /** Lamé's λ and μ [MPa]. */
      double lambda = 0., mu = 0.;
    };

    /** What is below, by components: a dashpot [MPa s/m], or a support. */
    struct Foot
    {
      std::array<double, dim> dashpots = {};
      std::array<bool, dim> held       = {};
    };

    /** αM + βK is the damping of the ground. */
    struct Damping
    {
      double of_mass = 0., of_stiffness = 0.;
    };

    /** @p cells from below; @p degree of their polynomials; @p radius: spectral, of the integration
     * in time. */
    FreeColumn(const std::vector<Cell> &cells,
               const unsigned int degree,
               const Foot &foot,
               const Damping &damping,
               const double radius,
               const unsigned int n_rungs);

    /** A place of the column: the cell and the functions of its nodes, from its first one on. */
    struct Place
    {
      const Cell *cell       = nullptr;
      std::size_t first_node = 0;
      /** The functions and their derivatives [1/m]. */
      Vector values, slopes;
    };

    /** Of the cell nearest to @p height. */
    Place
    place(const double height) const;

    /** What drives it, by components: the ground on which a rigid base moves [m/s²], or the
     * velocity of the wave that comes up [m/s]. */
    struct Drive
    {
      std::array<double, dim> acceleration = {}, wave = {};
    };

    /** At rest. */
    void
    begin(const Drive &drive);

    /** A step of the length @p h and number @p rung, at whose end @p drive acts. It may be tried
     * again. */
    void
    try_step(const unsigned int rung, const double h, const Drive &drive);

    /** Takes the step that was tried last. */
    void
    finish_step();

    /** Goes on from what integration() was between two steps, with the present @p drive. */
    void
    restore(const IntegrationMemory &memory, const Drive &drive);

    const IntegrationMemory &
    integration() const
    {
      return now->memory();
    }

    /** u + β v and v at the end of the step that was tried last. */
    Vector
    strained() const;

    const Vector &
    velocity() const
    {
      return next->velocity();
    }

  private:
    void
    assemble();

    Vector
    forces_of(const Drive &drive) const;

    Vector
    damping_times(const Vector &v) const;

    /** K + a1 C + a0 M of a step of the length @p h. */
    DenseMatrix
    stiffness_of_step(const double h) const;

    const std::vector<Cell> cells;
    const unsigned int degree;
    /** Of the nodes of a cell on (0, 1). */
    const std::vector<dealii::Polynomials::Polynomial<double>> polynomials;
    const Foot foot;
    const Damping damping;
    const double spectral_radius;
    Vector mass;
    DenseMatrix stiffness;
    std::vector<std::optional<LuFactors>> factors; // by rung
    std::optional<TimeIntegration> now, next;
    Vector forces, forces_at_end;
  };
} // namespace fuga

#endif
