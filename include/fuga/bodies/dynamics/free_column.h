// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_dynamics_free_column_h
#define fuga_bodies_dynamics_free_column_h

#include <fuga/contact/dynamics/time_integration.h>

#include <array>
#include <optional>

namespace fuga
{
  /**
   * A column of ground of unit section whose points move as far as their height says: waves of
   * shear and of pressure between its foot and its free surface, in the steps of the bodies beside
   * it. Entry 2 node + component: 0 is horizontal, 1 vertical; nodes from below.
   */
  class FreeColumn
  {
  public:
    struct Cell
    {
      /** Of its lowest node; the others follow. */
      unsigned int first_node = 0;
      /** Of the nodes [m]. */
      Vector heights;
      /** [MN s²/m⁴] */
      double density = 0.;
      /** Of shear and pressure waves: μ and λ + 2μ [MPa]. */
      std::array<double, 2> moduli = {{0., 0.}};
    };

    /** What is below, by components: a dashpot [MPa s/m], or a support. */
    struct Foot
    {
      std::array<double, 2> dashpots = {{0., 0.}};
      std::array<bool, 2> held       = {{false, false}};
    };

    /** αM + βK is the damping of the ground. */
    struct Damping
    {
      double of_mass = 0., of_stiffness = 0.;
    };

    FreeColumn(const std::vector<Cell> &cells,
               const Foot &foot,
               const Damping &damping,
               const double spectral_radius,
               const unsigned int n_rungs);

    /** What drives it, by components: the ground on which a rigid base moves [m/s²], or the
     * velocity of the wave that comes up [m/s]. */
    struct Drive
    {
      std::array<double, 2> acceleration = {{0., 0.}}, wave = {{0., 0.}};
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
    add_cell(const Cell &cell);

    Vector
    forces_of(const Drive &drive) const;

    Vector
    damping_times(const Vector &v) const;

    /** K + a1 C + a0 M of a step of the length @p h. */
    DenseMatrix
    stiffness_of_step(const double h) const;

    const Foot foot;
    const Damping damping;
    const double spectral_radius;
    Vector mass;
    DenseMatrix stiffness;
    std::vector<std::optional<LuFactors>> factors; // by rung
    std::optional<TimeIntegration> now, next;
    Vector forces, forces_at_end;
  };

  /** ∫ Lᵢ Lⱼ ds, ∫ Lᵢ Lⱼ' ds and ∫ Lᵢ' Lⱼ' ds of the Lagrange polynomials of these @p points of (0, 1). */
  struct LineIntegrals
  {
    explicit LineIntegrals(const Vector &points);

    DenseMatrix values, slopes_by_values, slopes;
  };
} // namespace fuga

#endif
