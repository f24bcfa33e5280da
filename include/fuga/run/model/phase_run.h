// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_model_phase_run_h
#define fuga_run_model_phase_run_h

#include <fuga/bodies/motion/bodies_in_motion.h>
#include <fuga/contact/dynamics/dynamic_path.h>
#include <fuga/contact/judge/certificate.h>
#include <fuga/output/results/joint_results.h>
#include <fuga/run/model/joint_model.h>
#include <fuga/run/model/model.h>
#include <fuga/run/model/safety_search.h>

namespace fuga
{
  /**
   * One phase of construction on its way: what a run and a variant of a sweep have in common. The
   * members are in the order in which data goes through them. Nothing is written.
   */
  template <int dim>
  class PhaseRun
  {
  public:
    /**
     * @p parameters: those of the model, but for laws and strength of the joints and the motion of
     * the ground. @p similar: a layered system of other joints of the same model, and @p steps: of
     * another motion of its bodies; they are used if they fit. Model and parameters must outlive
     * this object.
     */
    PhaseRun(const Model<dim> &model,
             const Parameters &parameters,
             const std::shared_ptr<const LayeredSystem> &similar = nullptr,
             const std::shared_ptr<StepSolvers> &steps           = nullptr);

    ~PhaseRun();

    const Model<dim> &model;
    const Parameters &parameters;
    const JointModel joint;
    const std::shared_ptr<const LayeredSystem> shared_layered;
    const LayeredSystem &layered;
    const SafetySearch<dim> safety_search;
    /** The loads without the searches for safety that follow them. */
    const LoadHistory loading;
    /** Of a dynamic stage. */
    const std::unique_ptr<BodiesInMotion<dim>> motion;
    const std::unique_ptr<ContactPath> path;
    Judge judge;

    /** What an observer of the path hears before and behind a step of a dynamic stage. */
    void
    began_step(const ContactSystem &system, const LoadHistory &history);
    void
    ended_step(const JointState &state);

    /** The path of a dynamic stage. */
    DynamicPath &
    dynamic_path() const;

    /** Energies for the tables. */
    EnergyLedger
    energies() const;

    /** Displacement of bodies in motion, by nodes. */
    Vector
    displacement_in_motion() const;

    /** What monitors take in a state: interface coordinates, or displacements in motion. */
    Vector
    monitored(const JointState &state) const;

    std::vector<ElementResult>
    results(const JointState &state) const;

    /** What the next phase has to know of the end of this one, but for the records of a run. @p
     * until_rest: it is a motion of bodies that are not in equilibrium. */
    PhaseEnd
    leave(const JointState &last_state,
          const PathResult &result,
          const std::size_t next_level,
          const bool until_rest = false);

    /** Lets the judge go on behind the phase that ended so, for which the model was made. Returns
     * what the path goes on from, with the records of @p before. */
    Checkpoint
    enter(const PhaseEnd &before);

  private:
    /** What @p u of the motion is with what was before, by nodes. */
    Vector
    since_the_beginning(Vector u) const;

    std::shared_ptr<const LayeredSystem>
    make_layered(const std::shared_ptr<const LayeredSystem> &similar) const;
    std::unique_ptr<BodiesInMotion<dim>>
    make_motion(const std::shared_ptr<StepSolvers> &steps) const;
    std::unique_ptr<ContactPath>
    make_path() const;
  };
} // namespace fuga

#endif
