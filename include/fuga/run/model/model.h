// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_model_model_h
#define fuga_run_model_model_h

#include <fuga/base/phase_timer.h>
#include <fuga/bodies/program/load_program.h>
#include <fuga/bodies/program/monitor.h>
#include <fuga/contact/path/event_path.h>
#include <fuga/input/parameters.h>
#include <fuga/output/results/joint_resultant.h>
#include <fuga/run/model/phase_end.h>

namespace fuga
{
  /**
   * What all variants of a problem share: the mesh, the bodies, condensed once, and the loads; of
   * one phase of construction, if bodies are built or removed on the way. The
   * members are in the order in which data goes through them. Construction reads and checks
   * everything; nothing is written.
   */
  template <int dim>
  class Model
  {
  public:
    /**
     * The first phase of construction, or the one with the state @p construction that a checkpoint
     * remembers.
     * @p condensation never: for checks of the input; there are no monitors then, and the bodies
     * cannot be solved.
     * @throws InputError, NumericalFailure
     */
    explicit Model(const Parameters &parameters,
                   const ConstructionState &construction = {},
                   const Condensation condensation       = Condensation::with_loads);

    /**
     * The phase behind @p before. @p same_bodies: those of another model, which is used no more,
     * with the same bodies and joints: they are not condensed again.
     */
    Model(const Parameters &parameters,
          const PhaseEnd &before,
          std::shared_ptr<CondensedSystem<dim>> same_bodies = nullptr);

    const std::shared_ptr<const Parameters> shared_parameters;
    const Parameters &parameters;
    mutable PhaseTimer timer;
    const std::shared_ptr<const JointedMesh> shared_mesh;
    const JointedMesh &mesh;
    /** They know the parameters of the model that they were made for. */
    const std::shared_ptr<CondensedSystem<dim>> shared_bodies;
    const CondensedSystem<dim> &bodies;
    /** What this phase took over. */
    ConstructionState construction;
    /** Found before the bodies are condensed, as loads and joints are. */
    const std::vector<MonitorPoint<dim>> monitor_points;
    const LoadProgram loads;
    const std::vector<Monitor> monitors;
    const std::vector<std::string> joint_names, stage_names;
    const std::vector<ElementFrame> frames;
    /** Whether a joint has bodies on both sides. */
    const std::vector<bool> joints_there;

    PathOptions
    path_options() const;

    /** What the joints carry; @p dissipation: per element. */
    std::vector<JointResultant>
    resultants(const std::vector<ElementResult> &results, const Vector &dissipation) const;

    /** The mechanism of a path in words, empty without one. @p elements: of the joints. */
    std::string
    motion(const std::vector<ContactElement> &elements, const PathResult &result) const;

    /** @throws InputError if joints have negative gaps. */
    void
    check_joints(const std::vector<JointParameters> &joints) const;

    /** Sizes for the summary. */
    std::vector<std::pair<std::string, std::size_t>>
    sizes() const;

    /** The state of the joints behind another phase; empty else. */
    JointState first_state;

    /** The stage behind this phase. */
    unsigned int
    next_stage() const
    {
      return end_of_phase(parameters.model, construction.stage);
    }

    /** Whether inertia acts; the phase has one stage, or a part of one, then. */
    bool
    is_dynamic() const
    {
      return construction.until_rest || parameters.model.stages[construction.stage].is_dynamic();
    }

    /** Whether a path that ended so goes on as a motion. */
    bool
    goes_on_in_motion(const PathResult &result) const;

    bool
    is_last_phase() const
    {
      return !construction.until_rest && next_stage() == parameters.model.stages.size();
    }

  private:
    Model(const Parameters &parameters,
          const ConstructionState &construction,
          const PhaseEnd *before,
          const Condensation condensation,
          std::shared_ptr<CondensedSystem<dim>> same_bodies = nullptr);

    std::shared_ptr<CondensedSystem<dim>>
    make_bodies(const unsigned int stage,
                const Condensation condensation,
                std::shared_ptr<CondensedSystem<dim>> same_bodies) const;
    std::shared_ptr<const JointedMesh>
    read_mesh() const;
    std::vector<JointDefinition>
    joint_definitions() const;
    std::vector<MonitorPoint<dim>>
    find_monitor_points() const;
    LoadProgram
    make_loads(const PhaseEnd *before, const Condensation condensation);
    std::vector<Monitor>
    make_monitors(const Condensation condensation) const;
    std::vector<std::string>
    find_joint_names() const;
    std::vector<std::string>
    find_stage_names() const;
    std::vector<ElementFrame>
    find_frames() const;
    void
    check_body_solver() const;
    std::vector<bool>
    find_joints_there() const;
  };
} // namespace fuga

#endif
