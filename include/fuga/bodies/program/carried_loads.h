// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_program_carried_loads_h
#define fuga_bodies_program_carried_loads_h

#include <fuga/bodies/condensed/condensed_system.h>
#include <fuga/bodies/construction.h>

namespace fuga
{
  /** Two load patterns of a phase of construction (doc/theory.md, eq. 22 and 23). */
  struct CarriedLoads
  {
    /** The forces that hold the bodies in their stress-free shapes; constant. */
    LoadPattern carried;
    /**
     * The forces that are out of balance when the phase begins: the forces of removed bodies, minus
     * the loads that wait for the new bodies. To be released in the first stage.
     */
    LoadPattern released;
  };

  /**
   * Compute the carried loads from the @p patterns of all loads and their @p factors when the phase
   * begins.
   */
  template <int dim>
  CarriedLoads
  carried_loads(const CondensedSystem<dim> &system,
                const ModelDefinition &model,
                const ConstructionState &state,
                const std::vector<LoadPattern> &patterns,
                const Vector &factors);

  /**
   * Set the displacement of new bodies where they are held by supports: they are built at the
   * supports' displacement. This concerns the degrees of freedom (Discretization::dof()) that were
   * not @p there before.
   */
  template <int dim>
  void
  put_new_nodes_on_supports(const CondensedSystem<dim> &system,
                            const std::vector<bool> &there,
                            const std::vector<LoadPattern> &patterns,
                            const Vector &factors,
                            Vector &displacement);

  /**
   * Return the shape of the bodies that are built in the stage of @p state, for its displacement.
   */
  template <int dim>
  StressFreeShape
  shape_of_new_bodies(const CondensedSystem<dim> &system,
                      const ModelDefinition &model,
                      const ConstructionState &state);
} // namespace fuga

#endif
