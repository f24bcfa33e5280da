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
   * A column of ground with unit cross-section whose points move as a function of their height
   * only: waves of shear and of pressure between its foot and its free surface, computed with the
   * time steps of the bodies beside it. Vectors have entries dim node + component, where the last
   * component is vertical; nodes are numbered from below.
   */
  template <int dim>
  class FreeColumn
  {
  public:
    /** A finite element of ground. */
    struct Cell
    {
      /** Heights of foot and top [m]. */
      double foot = 0., top = 0.;
      /** Mass density [MN s²/m⁴]. */
      double density = 0.;
      /** Lamé's λ and μ [MPa]. */
      double lambda = 0., mu = 0.;
    };

    /** The condition at the foot, by components: a dashpot [MPa s/m], or a support. */
    struct Foot
    {
      std::array<double, dim> dashpots = {};
      std::array<bool, dim> held       = {};
    };

    /** The coefficients of the damping αM + βK of the ground. */
    struct Damping
    {
      double of_mass = 0., of_stiffness = 0.;
    };

    /**
     * @p cells are ordered from below, @p degree is that of their polynomials, @p radius the
     * spectral radius of the integration in time.
     */
    FreeColumn(const std::vector<Cell> &cells,
               const unsigned int degree,
               const Foot &foot,
               const Damping &damping,
               const double radius,
               const unsigned int n_rungs);

    /**
     * A place in the column: the cell and the shape functions of its nodes, starting with the first
     * one.
     */
    struct Place
    {
      const Cell *cell       = nullptr;
      std::size_t first_node = 0;
      /** The shape functions and their derivatives [1/m]. */
      Vector values, slopes;
    };

    /** Return the place at @p height, in the nearest cell. */
    Place
    place(const double height) const;

    /**
     * The excitation of the column, by components: the acceleration of the ground with a rigid base
     * [m/s²], or the velocity of the upward wave [m/s].
     */
    struct Drive
    {
      std::array<double, dim> acceleration = {}, wave = {};
    };

    /** Begin at rest. */
    void
    begin(const Drive &drive);

    /**
     * Compute a step of length @p h and number @p rung, at whose end @p drive acts. It may be tried
     * again.
     */
    void
    try_step(const unsigned int rung, const double h, const Drive &drive);

    /** Accept the step that was tried last. */
    void
    finish_step();

    /**
     * Continue from an earlier state of integration() between two steps, with the present @p drive.
     */
    void
    restore(const IntegrationMemory &memory, const Drive &drive);

    const IntegrationMemory &
    integration() const
    {
      return now->memory();
    }

    /** Return u + β v at the end of the step that was tried last; velocity() returns v. */
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

    /** Return K + a1 C + a0 M for a step of length @p h. */
    DenseMatrix
    stiffness_of_step(const double h) const;

    const std::vector<Cell> cells;
    const unsigned int degree;
    /** Shape functions of the nodes of a cell on (0, 1). */
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
