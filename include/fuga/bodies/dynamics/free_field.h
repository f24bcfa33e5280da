// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_dynamics_free_field_h
#define fuga_bodies_dynamics_free_field_h

#include <fuga/bodies/dynamics/driving_forces.h>
#include <fuga/bodies/dynamics/ground_beside.h>

namespace fuga
{
  /**
   * The ground beside a model, which moves as if the model were not there: a column on every side,
   * computed with the time steps of the model. It acts on the side with its stress σ_f and, through
   * the dashpots of the absorbing boundary, with its velocity v_f,
   *
   *     σ_f n + C v_f,
   *
   * so that the difference between the model and the free ground, and only that, is absorbed (J. P.
   * Wolf, Soil-structure interaction in time domain, Prentice-Hall, 1988, and P. A. Cundall, H.
   * Hansteen, S. Lacasse, P. B. Selnes, NESSI: soil structure interaction program for dynamic and
   * static problems, NGI report 51508-9, 1980).
   */
  template <int dim>
  class FreeField
  {
  public:
    /**
     * @throws InputError for sides without a column beside them, or without anything below them.
     */
    FreeField(const BodyModel<dim> &model,
              const DrivingForces<dim> &driving,
              const typename FreeColumn<dim>::Damping &damping);

    /** Begin at rest. */
    void
    begin();

    /**
     * Compute a step of length @p h and number @p rung and add the forces at its end to @p forces.
     */
    void
    try_step(const unsigned int rung, const double h, const double time_at_end, Vector &forces);

    /** Accept the step that was tried last. */
    void
    finish_step();

    /** Append the integrations of all sides to @p integrations. */
    void
    remember(std::vector<IntegrationMemory> &integrations) const;

    /**
     * Restore the integrations of all sides, which follow that of the bodies, and continue at this
     * time.
     */
    void
    restore(const std::vector<IntegrationMemory> &integrations, const double time);

  private:
    /** The force on a side due to a displacement of the column [MN/m]. */
    struct Traction
    {
      std::size_t dof = 0, of_column = 0;
      double factor = 0.;
    };

    struct Side
    {
      std::unique_ptr<FreeColumn<dim>> column;
      std::vector<Traction> tractions;
      /** The place in the column of each node of the side. */
      std::map<unsigned int, typename FreeColumn<dim>::Place> nodes;
    };

    Side
    make_side(const SideOfGround<dim> &faces,
              const typename FreeColumn<dim>::Damping &damping) const;

    /** Add the tractions of the column on a face. */
    void
    add_tractions(const typename Discretization<dim>::BoundaryFace &face, Side &side) const;

    typename FreeColumn<dim>::Drive
    drive_at(const double time) const;

    typename FreeColumn<dim>::Foot
    foot(const SideOfGround<dim> &faces) const;

    const BodyModel<dim> &model;
    const DrivingForces<dim> &driving;
    const Dashpots<dim> dashpots;
    std::vector<Side> sides;
  };
} // namespace fuga

#endif
