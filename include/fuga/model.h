// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_model_h
#define fuga_model_h

#include <fuga/base/phase_timer.h>
#include <fuga/bodies/load_program.h>
#include <fuga/bodies/monitor.h>
#include <fuga/contact/event_path.h>
#include <fuga/io/parameters.h>

namespace fuga
{
  /**
   * What all variants of a problem share: the mesh, the bodies, condensed once, and the loads. The
   * members are in the order in which data goes through them. Construction reads and checks
   * everything; nothing is written.
   */
  template <int dim>
  class Model
  {
  public:
    /** @throws InputError, NumericalFailure */
    explicit Model(const Parameters &parameters);

    const Parameters parameters;
    mutable PhaseTimer timer;
    const JointedMesh mesh;
    CondensedSystem<dim> bodies;
    /** Found before the bodies are condensed, as loads and joints are. */
    const std::vector<MonitorPoint<dim>> monitor_points;
    const LoadProgram loads;
    const std::vector<Monitor> monitors;
    const std::vector<std::string> joint_names, stage_names;
    const std::vector<std::array<double, 3>> normals;

    PathOptions
    path_options() const;

    /** Sizes for the summary. */
    std::vector<std::pair<std::string, std::size_t>>
    sizes() const;

  private:
    std::vector<JointDefinition>
    joint_definitions() const;
    std::vector<bool>
    frictionless_joints() const;
    std::vector<MonitorPoint<dim>>
    find_monitor_points() const;
    LoadProgram
    make_loads();
    std::vector<Monitor>
    make_monitors() const;
    std::vector<std::string>
    find_joint_names() const;
    std::vector<std::string>
    find_stage_names() const;
    std::vector<std::array<double, 3>>
    find_normals() const;
  };
} // namespace fuga

#endif
