// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_model_phase_begin_h
#define fuga_run_model_phase_begin_h

#include <fuga/bodies/program/load_program.h>
#include <fuga/input/parameters.h>
#include <fuga/run/model/phase_end.h>

namespace fuga
{
  /** Whether joints have no shear strength and so need no tangential bars, by number. */
  std::vector<bool>
  frictionless_joints(const std::vector<JointParameters> &joints);

  /** Checks gaps, loads and temperatures of all phases behind the first one, so that nothing is
   * computed before the input of all of them has been checked. @throws InputError */
  template <int dim>
  void
  check_later_phases(const Parameters &parameters, const JointedMesh &mesh);

  /**
   * A phase begins in the state @p construction, which takes the forces of bars and the stress-free
   * shapes of new bodies over from @p before (none behind a restart). @p program gets the loads that
   * the structure carries already, and those that are released.
   */
  template <int dim>
  void
  begin_phase(const ModelDefinition &definition,
              const PhaseEnd *before,
              CondensedSystem<dim> &bodies,
              ConstructionState &construction,
              LoadProgram &program);

  /**
   * The state of the joints in which the phase behind @p before begins: bars go on feeling what they
   * felt, and new ones begin with nothing, wherever the bodies are, which @p construction takes as
   * offsets of the jumps. @p factors: of the load patterns then.
   */
  template <int dim>
  JointState
  take_over_joints(const Parameters &parameters,
                   const CondensedSystem<dim> &bodies,
                   const PhaseEnd &before,
                   const Vector &factors,
                   ConstructionState &construction);

  /** What is built, removed and grouted when @p stage begins. */
  template <int dim>
  std::string
  change_of_construction(const ModelDefinition &definition,
                         const CondensedSystem<dim> &bodies,
                         const unsigned int stage);
} // namespace fuga

#endif
