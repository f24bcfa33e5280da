// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_model_phase_run_h
#define fuga_run_model_phase_run_h

#include <fuga/bodies/motion/bodies_in_motion.h>
#include <fuga/contact/dynamics/dynamic_path.h>
#include <fuga/contact/judge/judge.h>
#include <fuga/output/results/joint_results.h>
#include <fuga/run/model/joint_model.h>
#include <fuga/run/model/model.h>
#include <fuga/run/model/safety_search.h>

namespace fuga
{
  /**
   * The computation of one phase of construction, common to a run and a variant of a sweep. The
   * members are in the order in which data flows through them. Nothing is written.
   */
  template <int dim>
  class PhaseRun
  {
  public:
    /**
     * @p parameters are those of the model, except for laws and strength of the joints and the
     * motion of the ground. @p similar is a layered system of other joints of the same model,
     * @p steps are the solvers of another motion of its bodies; they are used if they fit. Model
     * and parameters must outlive this object.
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
    /** The loads without the subsequent searches for factors of safety. */
    const LoadHistory loading;
    /** The bodies of a dynamic stage. */
    const std::unique_ptr<BodiesInMotion<dim>> motion;
    const std::unique_ptr<ContactPath> path;
    Judge judge;

    /** Functions that an observer of the path calls before and after a step of a dynamic stage. */
    void
    began_step(const ContactSystem &system, const LoadHistory &history);
    void
    ended_step(const JointState &state);

    /** Return the path of a dynamic stage. */
    DynamicPath &
    dynamic_path() const;

    /** Return the energies for the tables. */
    EnergyLedger
    energies() const;

    /** Return the displacement of bodies in motion, by nodes. */
    Vector
    displacement_in_motion() const;

    /**
     * Return the input of the monitors in a state: interface coordinates, or displacements in
     * motion.
     */
    Vector
    monitored(const JointState &state) const;

    std::vector<ElementResult>
    results(const JointState &state) const;

    /**
     * Return what the next phase has to know about the end of this one, except for the records of a
     * run. @p until_rest: the next phase is a motion of bodies that are not in equilibrium.
     */
    PhaseEnd
    leave(const JointState &last_state,
          const PathResult &result,
          const std::size_t next_level,
          const bool until_rest = false);

    /**
     * Let the judge continue after the phase that ended with @p before, for which the model was
     * made. Return the checkpoint from which the path goes on, with the records of @p before.
     */
    Checkpoint
    enter(const PhaseEnd &before);

  private:
    /** Return the displacement @p u of the motion plus the displacement before it, by nodes. */
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
