// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_simulation_simulation_h
#define fuga_run_simulation_simulation_h

#include <fuga/output/restart/checkpoint.h>
#include <fuga/output/results/monitored_motion.h>
#include <fuga/output/tables/accuracy_report.h>
#include <fuga/output/tables/summary.h>
#include <fuga/output/warnings/model_range.h>
#include <fuga/run/model/phase_run.h>

#include <functional>
#include <memory>
#include <optional>

namespace fuga
{
  /** Exit codes of the program. */
  enum class ExitCode
  {
    done                 = 0,
    input_error          = 1,
    numerical_failure    = 2,
    loss_of_equilibrium  = 3,
    certificate_violated = 4,
    not_written          = 5
  };

  /**
   * One run of a model: joints, layered system, path, judge and writers, in the order in which data
   * goes through them. Nothing is written before run().
   */
  template <int dim>
  class Simulation : private PathObserver, private RunRecord
  {
  public:
    /** @p accuracy: how the mesh of the model was found, if it was. @throws InputError,
     * NumericalFailure */
    explicit Simulation(const Model<dim> &model, AccuracyReport accuracy = {});

    ~Simulation() override;

    /** Follows the loads and writes all results. */
    ExitCode
    run();

    /**
     * Does the rest of the run that @p checkpoint is of, in the same directory: afterwards all results
     * are those of an unbroken run, but for times and what the log says of the restart.
     */
    ExitCode
    resume(const Checkpoint &checkpoint);

    /** Whether run() or another one ended between two phases of construction. */
    bool
    is_between_phases() const
    {
      return end_of_phase.has_value();
    }

    /** What the next phase has to know then. */
    PhaseEnd
    leave_phase();

    /** Goes on with a phase behind the one that ended so, for which the model was made. */
    ExitCode
    enter_phase(const PhaseEnd &before);

    /** Has @p action called behind every checkpoint. If it throws, the run ends there. */
    void
    on_checkpoint(std::function<void()> action)
    {
      checkpoint_action = std::move(action);
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

    /** How a run ended. */
    struct Outcome
    {
      PathResult path;
      std::string verdict;
      ExitCode code = ExitCode::done;
      std::string message;
      std::vector<SafetyFactor> safety;
      LimitProof proof;
    };

    ExitCode
    follow(const std::function<PathResult()> &path_to_follow);
    /** Whether the bodies still move behind a dynamic stage, and are to come to rest before the
     * slow one behind it. */
    bool
    still_move(const PathResult &result) const;
    /** The slow path has lost its equilibrium, @p loss, or has none to begin with, and goes on as a
     * motion. */
    void
    begin_continuation(PathResult &loss);
    /** The motion has ended: either at rest, or @p result becomes the verdict of the slow path that
     * it followed, whose proof is returned. */
    MechanismCertificate
    end_continuation(PathResult &result);
    std::string
    describe(const MotionBeyondLimit &motion) const;
    /** What shows that the data are too ill-conditioned for the bound of the certificate; empty if
     * nothing does, or if it was not asked. */
    std::string
    doubt_about_data() const;
    /** Which layer has closed as far as its law reaches; empty if none has. */
    std::string
    limit_of_law() const;
    /** Follows each search for a factor of safety from the end of the loads. */
    void
    find_safety(Outcome &outcome);
    void
    log_safety(const SafetyFactor &safety);
    bool
    keeps_checkpoints() const;
    void
    begin_output();
    void
    continue_output(const Checkpoint &checkpoint);
    void
    publish(const bool now);
    void
    checkpoint_at_event();
    void
    write_checkpoint();
    void
    write_checkpoint(const Outcome &outcome);
    void
    write_checkpoint(Checkpoint &&checkpoint);
    /** All that a checkpoint keeps but the cut. */
    void
    fill(Checkpoint &checkpoint) const;
    void
    write_fields(const JointState &state,
                 const std::vector<ElementResult> &results,
                 const dealii::Vector<double> &displacement);
    /** The fields of bodies in motion, unless they are there. */
    void
    write_frame();
    /** A row of events.csv: @p change of the jumps of all bars, with work on the joints. */
    void
    note_motion(const double t,
                const std::array<std::string_view, 2> &names,
                const Vector &change,
                const double energy);
    void
    note_accelerations();
    PathResult
    resume_motion(const Checkpoint &checkpoint);
    /** The path of a phase has come to its end. */
    void
    end_motion();
    void
    log_motion();
    void
    log_header();
    void
    log_layers();
    /** What the bodies and the loads of this phase add up to, and what seems to be wrong in them.
     */
    void
    log_model();
    std::string
    shear_description(const unsigned int j) const;
    void
    write_state(const JointState &state, const bool with_fields);
    /** The displacement in a state with coordinates @p x, under load factors @p a, and how well it
     * satisfies the equations of the bodies, which @p certificate takes. */
    dealii::Vector<double>
    displacement(const JointState &state,
                 const Vector &x,
                 const Vector &a,
                 Certificate &certificate) const;
    /** Moves the lips of @p u to where the bodies are in balance with the forces on them, if the @p
     * residual is worth it and both errors are smaller then. Returns whether it did. */
    bool
    balance_lips(const Vector &on_lips,
                 const Vector &a,
                 const dealii::Vector<double> &motion_of_bodies,
                 const double residual,
                 dealii::Vector<double> &u,
                 Certificate &certificate) const;
    void
    write_last_state();
    void
    write_monitors(const double t,
                   const std::string &occasion,
                   const Vector &coordinates,
                   const Vector &factors);
    void
    finish(const Outcome &outcome);
    /** Leaves complete files of what was reached, and a checkpoint. @throws Interrupted always. */
    [[noreturn]] void
    end_early();
    std::string
    describe_critical(const PathResult &result) const;
    /** The equilibrium near by to which the path does not go on continuously; empty if none is
     * known. */
    std::string
    describe_jump(const Jump &jump) const;
    std::string
    reason_of(const PathResult &result) const;
    void
    log_closing_table(const Outcome &outcome);
    /** Those of the last state. */
    void
    log_resultants();
    void
    write_summary(const Outcome &outcome);

    const Model<dim> &model;
    const Parameters &parameters;
    const AccuracyReport accuracy;
    PhaseRun<dim> phase;
    const JointModel &joint;
    const LayeredSystem &layered;
    const SafetySearch<dim> &safety_search;
    /** Of a dynamic stage. */
    const std::unique_ptr<BodiesInMotion<dim>> &motion;
    const std::unique_ptr<ContactPath> &path;
    Judge &judge;
    ModelRange model_range;
    const HistoryContext context;
    RunLog log;
    FieldWriter<dim> fields;
    HistoryWriter history;

    /** The path began with the first load of the model. */
    bool from_the_beginning = false;
    /** A search for safety is under way: checkpoints are those of the path. */
    bool searching = false;
    /** A level of bodies in motion was reached: the checkpoint waits for the end of the step. */
    bool level_is_due = false;
    /** Only if response spectra of a dynamic stage are asked for. */
    std::optional<MonitoredMotion> monitored_motion;
    FileIdentity mesh_identity;
    std::function<void()> checkpoint_action;
    std::optional<PathResult> end_of_phase;
    /** The next phase is a motion until rest. */
    bool goes_on_in_motion = false;
    std::chrono::steady_clock::time_point last_checkpoint;
    double cost_of_checkpoint = 0.;
  };
} // namespace fuga

#endif
