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
   * The data that all variants of a problem share: the mesh, the bodies, condensed once, and the
   * loads; all of one phase of construction if bodies are built or removed on the way. The members
   * are in the order in which data flows through them. The constructor reads and checks everything;
   * nothing is written.
   */
  template <int dim>
  class Model
  {
  public:
    /**
     * Create the model of the first phase of construction, or of the one with the state
     * @p construction from a checkpoint. With @p condensation never, for checks of the input, there
     * are no monitors and the bodies cannot be solved.
     * @throws InputError, NumericalFailure
     */
    explicit Model(const Parameters &parameters,
                   const ConstructionState &construction = {},
                   const Condensation condensation       = Condensation::with_loads);

    /**
     * Create the model of the phase after @p before. @p same_bodies are those of another model that
     * is no longer used and has the same bodies and joints: they are not condensed again.
     */
    Model(const Parameters &parameters,
          const PhaseEnd &before,
          std::shared_ptr<CondensedSystem<dim>> same_bodies = nullptr);

    const std::shared_ptr<const Parameters> shared_parameters;
    const Parameters &parameters;
    mutable PhaseTimer timer;
    const std::shared_ptr<const JointedMesh> shared_mesh;
    const JointedMesh &mesh;
    /** The bodies; they refer to the parameters of the model for which they were made. */
    const std::shared_ptr<CondensedSystem<dim>> shared_bodies;
    const CondensedSystem<dim> &bodies;
    /** The state that this phase took over from the previous one. */
    ConstructionState construction;
    /**
     * Points of the monitors; like loads and joints, they are found before the bodies are
     * condensed.
     */
    const std::vector<MonitorPoint<dim>> monitor_points;
    const LoadProgram loads;
    const std::vector<Monitor> monitors;
    const std::vector<std::string> joint_names, stage_names;
    const std::vector<ElementFrame> frames;
    /** Tells for each joint whether there are bodies on both sides. */
    const std::vector<bool> joints_there;

    PathOptions
    path_options() const;

    /** Return the resultants of the joints. @p dissipation has one entry per element. */
    std::vector<JointResultant>
    resultants(const std::vector<ElementResult> &results, const Vector &dissipation) const;

    /**
     * Return the mechanism of a path in words, empty if there is none. @p elements are those of the
     * joints.
     */
    std::string
    motion(const std::vector<ContactElement> &elements, const PathResult &result) const;

    /** Check the joints. @throws InputError if they have negative gaps. */
    void
    check_joints(const std::vector<JointParameters> &joints) const;

    /** Return the sizes for the summary. */
    std::vector<std::pair<std::string, std::size_t>>
    sizes() const;

    /**
     * The state of the joints at the beginning of a phase that follows another one; otherwise
     * empty.
     */
    JointState first_state;

    /** Return the stage after this phase. */
    unsigned int
    next_stage() const
    {
      return end_of_phase(parameters.model, construction.stage);
    }

    /** Return whether inertia acts; the phase then consists of one stage or a part of one. */
    bool
    is_dynamic() const
    {
      return construction.until_rest || parameters.model.stages[construction.stage].is_dynamic();
    }

    /** Return whether a path that ended with @p result continues as a motion. */
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
