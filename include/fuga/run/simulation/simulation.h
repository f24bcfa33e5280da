// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_simulation_simulation_h
#define fuga_run_simulation_simulation_h

#include <fuga/base/errors.h>
#include <fuga/run/journal/checkpoint_keeper.h>
#include <fuga/run/simulation/motion_continuation.h>

namespace fuga
{
  /**
   * One run of a model: follows the path of a phase, writes all results found on it, and comes to a
   * verdict. The members are in the order in which data flows through them. Nothing is written
   * before run().
   */
  template <int dim>
  class Simulation : private PathObserver
  {
  public:
    /**
     * @p accuracy describes how the mesh of the model was found, if it was adapted. @throws
     * InputError, NumericalFailure
     */
    explicit Simulation(const Model<dim> &model, AccuracyReport accuracy = {});

    ~Simulation() override;

    /** Follow the loads and write all results. */
    ExitCode
    run();

    /**
     * Do the rest of the run to which @p checkpoint belongs, in the same directory: afterwards all
     * results are those of an uninterrupted run, except for times and what the log says about the
     * restart.
     */
    ExitCode
    resume(const Checkpoint &checkpoint);

    /** Return whether run(), resume() or enter_phase() ended between two phases of construction. */
    bool
    is_between_phases() const
    {
      return end_of_phase.has_value();
    }

    /** Return what the next phase has to know in this case. */
    PhaseEnd
    leave_phase();

    /**
     * Continue with the phase after the one that ended with @p before, for which the model was
     * made.
     */
    ExitCode
    enter_phase(const PhaseEnd &before);

    /**
     * Set the @p action that is called after every checkpoint. If it throws, the run ends there.
     */
    void
    on_checkpoint(std::function<void()> action)
    {
      checkpoints.action = std::move(action);
    }

  private:
    bool
    wants_cuts() const override;
    void
    advanced(const PathPoint &from, const PathPoint &to, const double length) override;
    void
    jumped(const JointState &to) override;
    void
    jumped_in_motion(const JointState &to, const double work) override;
    void
    changed(const std::vector<ContactEvent> &events, const JointState &state) override;
    void
    reached(const std::size_t index, const JointState &state) override;
    void
    went_beyond(const double length, const JointState &state) override;
    void
    began_motion() override;
    void
    began_step(const ContactSystem &system, const LoadHistory &history) override;
    void
    ended_step(const JointState &state) override;

    ExitCode
    follow(const std::function<PathResult()> &path_to_follow);
    /**
     * Determine the verdict of @p outcome; return false, without a verdict, if another phase
     * follows.
     */
    bool
    conclude(PathResult found, RunOutcome &outcome);
    /**
     * Determine the verdict of a path that could not be followed for the reason @p why, with the
     * state @p at.
     */
    void
    conclude(const NumericalFailure &why, const JointState &at, RunOutcome &outcome);
    /** Follow each search for a factor of safety from the end of the loads. */
    std::vector<SafetyFactor>
    find_safety(const PathResult &loaded);
    /** Return doubt_about_data(); empty unless the data are ill-conditioned. */
    std::string
    doubt();
    PathResult
    resume_motion(const Checkpoint &checkpoint);
    void
    finish(const RunOutcome &outcome);
    /** Leave complete files of the results so far, and a checkpoint. @throws Interrupted always. */
    [[noreturn]] void
    end_early();

    const Model<dim> &model;
    const Parameters &parameters;
    PhaseRun<dim> phase;
    RunJournal<dim> journal;
    MotionJournal<dim> motion_journal;
    CheckpointKeeper<dim> checkpoints;
    MotionContinuation<dim> continuation;

    /** Whether the path began with the first load of the model. */
    bool from_the_beginning = false;
    /**
     * Whether bodies in motion have reached a level, so that the checkpoint waits for the end of
     * the step.
     */
    bool level_is_due = false;
    std::optional<PathResult> end_of_phase;
    /** Whether the next phase is a motion until rest. */
    bool goes_on_in_motion = false;
  };
} // namespace fuga

#endif
