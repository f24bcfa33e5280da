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
   * in the steps of time of the model. It acts on the side with its stress σ_f and, through the
   * dashpots of the absorbing boundary, with its velocity v_f,
   *
   *     σ_f n + C v_f,
   *
   * so that what is different about the model, and only that, is absorbed (J. P. Wolf,
   * Soil-structure interaction in time domain, Prentice-Hall, 1988, and P. A. Cundall, H. Hansteen,
   * S. Lacasse, P. B. Selnes, NESSI: soil structure interaction program for dynamic and static
   * problems, NGI report 51508-9, 1980).
   */
  template <int dim>
  class FreeField
  {
  public:
    /** @throws InputError for sides beside which is no column, or that stand on nothing. */
    FreeField(const BodyModel<dim> &model,
              const DrivingForces<dim> &driving,
              const typename FreeColumn<dim>::Damping &damping);

    /** At rest. */
    void
    begin();

    /** Adds to @p forces what acts at the end of a step of the length @p h and number @p rung. */
    void
    try_step(const unsigned int rung, const double h, const double time_at_end, Vector &forces);

    /** Takes the step that was tried last. */
    void
    finish_step();

    /** Appends those of all sides to @p integrations. */
    void
    remember(std::vector<IntegrationMemory> &integrations) const;

    /** Takes them, behind that of the bodies, and goes on at this time. */
    void
    restore(const std::vector<IntegrationMemory> &integrations, const double time);

  private:
    /** What a displacement of the column does to a side [MN/m]. */
    struct Traction
    {
      std::size_t dof = 0, of_column = 0;
      double factor = 0.;
    };

    struct Side
    {
      std::unique_ptr<FreeColumn<dim>> column;
      std::vector<Traction> tractions;
      /** Where in the column a node of the side is. */
      std::map<unsigned int, typename FreeColumn<dim>::Place> nodes;
    };

    Side
    make_side(const SideOfGround<dim> &faces,
              const typename FreeColumn<dim>::Damping &damping) const;

    /** Adds what the column does to a face. */
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
