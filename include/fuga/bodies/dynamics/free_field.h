// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_dynamics_free_field_h
#define fuga_bodies_dynamics_free_field_h

#include <fuga/bodies/dynamics/driving_forces.h>
#include <fuga/bodies/dynamics/free_column.h>

namespace fuga
{
  /**
   * The ground beside a plane model, which moves as if the model were not there: a column on every
   * side with the nodes of the side, in its steps of time. It acts on the side with its stress σ_f
   * and, through the dashpots of the absorbing boundary, with its velocity v_f,
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
    /** @throws InputError for sides that are not of one piece, or that stand on nothing. */
    FreeField(const BodyModel<dim> &model,
              const DrivingForces<dim> &driving,
              const FreeColumn::Damping &damping);

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
    using Face = typename Discretization<dim>::BoundaryFace;

    /** What a displacement of the column does to a side [MN/m]. */
    struct Traction
    {
      std::size_t dof = 0, of_column = 0;
      double factor = 0.;
    };

    struct Side
    {
      std::unique_ptr<FreeColumn> column;
      std::vector<Traction> tractions;
      /** Node of the column at the height of a node of the side. */
      std::map<unsigned int, unsigned int> nodes;
    };

    Side
    make_side(const std::vector<Face> &faces, const FreeColumn::Damping &damping) const;

    /** Numbers of the nodes of a face from below. */
    std::vector<std::size_t>
    from_below(const Face &face) const;

    FreeColumn::Drive
    drive_at(const double time) const;

    FreeColumn::Foot
    foot(const Face &lowest) const;

    const BodyModel<dim> &model;
    const DrivingForces<dim> &driving;
    const Dashpots<dim> dashpots;
    std::vector<Side> sides;
  };
} // namespace fuga

#endif
