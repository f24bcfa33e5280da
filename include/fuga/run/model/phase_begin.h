// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_model_phase_begin_h
#define fuga_run_model_phase_begin_h

#include <fuga/bodies/program/load_program.h>
#include <fuga/input/parameters.h>
#include <fuga/run/model/phase_end.h>

namespace fuga
{
  /**
   * Return for each joint whether it has no shear strength and therefore needs no tangential bars.
   */
  std::vector<bool>
  frictionless_joints(const std::vector<JointParameters> &joints);

  /**
   * Check gaps, loads and temperatures of all phases after the first one, so that nothing is
   * computed before the input of all of them has been checked. @throws InputError
   */
  template <int dim>
  void
  check_later_phases(const Parameters &parameters, const JointedMesh &mesh);

  /**
   * Begin a phase in the state @p construction, which takes over the forces of bars and the
   * stress-free shapes of new bodies from @p before (null after a restart). The loads that the
   * structure carries already, and those that are released, are added to @p program.
   */
  template <int dim>
  void
  begin_phase(const ModelDefinition &definition,
              const PhaseEnd *before,
              CondensedSystem<dim> &bodies,
              ConstructionState &construction,
              LoadProgram &program);

  /**
   * Return the state of the joints in which the phase after @p before begins: bars keep their
   * forces, and new ones begin without force at the present position of the bodies, which is stored
   * in @p construction as offsets of the jumps. @p factors are those of the load patterns at this
   * moment.
   */
  template <int dim>
  JointState
  take_over_joints(const Parameters &parameters,
                   const CondensedSystem<dim> &bodies,
                   const PhaseEnd &before,
                   const Vector &factors,
                   ConstructionState &construction);

  /** Describe what is built, removed and grouted when @p stage begins. */
  template <int dim>
  std::string
  change_of_construction(const ModelDefinition &definition,
                         const CondensedSystem<dim> &bodies,
                         const unsigned int stage);
} // namespace fuga

#endif
