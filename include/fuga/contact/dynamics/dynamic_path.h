// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_dynamics_dynamic_path_h
#define fuga_contact_dynamics_dynamic_path_h

#include <fuga/contact/dynamics/motion_cut.h>
#include <fuga/contact/dynamics/step_record.h>
#include <fuga/contact/dynamics/step_system.h>
#include <fuga/contact/path/event_path.h>

#include <optional>

namespace fuga
{
  /**
   * The contact of bodies in motion, computed time step by time step. A step is the static problem
   * with another stiffness, see MovingBodies, and the paper's step-by-step analysis follows it from
   * event to event, so that all contact conditions hold at its end. The step is halved where events
   * within it cost energy, because the time integration does not know of them, or where an element
   * slips beyond the time at which it comes to rest. Each length has its own stiffness, which is
   * condensed when first needed. (doc/theory.md, section 19)
   *
   * A motion until rest (TimeGrid) reports no levels, and ends with the verdict that the load is
   * beyond its limit if the bodies still move after the last step.
   */
  class DynamicPath : public ContactPath, private MotionProgress
  {
  public:
    /** Constructor. @p system and @p history are those of the bodies at rest. */
    DynamicPath(const std::vector<ContactElement> &elements,
                const LayeredSystem &system,
                const LoadHistory &history,
                MovingBodies &bodies,
                const TimeGrid &grid,
                const PathOptions &options);

    ~DynamicPath() override;

    SchemeWork
    work() const override;

    /** Return the number of iterations. The energies in it are those before the motion, since each
     * length of steps has its own. */
    IterationCount
    iterations() const override;

    /** Do the same as resume(), from a cut between two whole steps. A motion until rest has no such
     * cuts. */
    PathResult
    resume_motion(const PathCut &cut,
                  const MotionCut &motion,
                  const std::vector<double> &levels,
                  PathObserver &observer);

    /** Return the part of the last cut that last_cut() does not contain. */
    const MotionCut &
    last_motion_cut() const
    {
      return motion_cut;
    }

    /** Return the energies since the motion began. */
    const MotionLedger &
    energies() const
    {
      return ledger;
    }

    /** Return the number of steps of each rung. */
    const std::vector<std::size_t> &
    n_steps() const
    {
      return steps_of_rung;
    }

    /** Return whether the last step ended where a whole one does. */
    bool
    is_at_whole_step() const
    {
      return tick % (std::size_t(1) << grid.halvings) == 0;
    }

  private:
    struct Rung;

    struct Attempt
    {
      PathResult result;
      StepRecord record;
      /** The reason why there is no state at the end of the step; empty if there is one. */
      std::string failure;
      /** The state in which a layer was at its closure limit, if that is the reason. */
      std::optional<JointState> exhausted;
    };

    PathResult
    follow(const std::vector<double> &levels, ReportCounter &observer) override;

    void
    begin(const JointState &state);
    /** Return the energy that is rounding of the forces and jumps of the joints in @p state. */
    double
    rounding_of_work(const JointState &state) const;

    MotionCut
    motion_memory() const;

    void
    restore_motion(const MotionCut &motion);

    /** Advance from the present time by one step of rung @p number, or by two of the next one. */
    void
    advance(const unsigned int number,
            const std::vector<double> &levels,
            JointState &state,
            PathResult &result,
            PathObserver &observer);

    Rung &
    rung(const unsigned int number);

    Attempt
    attempt(const unsigned int number, const JointState &state, const PathResult &result);

    /** Throw because the shortest step, @p number, has failed, and so has the @p last attempt at
     * load time @p t. */
    [[noreturn]] void
    give_up(const Attempt &last, const unsigned int number, const double t) const;

    /** Return the rung to continue with after an attempt that is accepted: that of the longest step
     * that will not cost too much if it costs what this one has cost. Return nothing if this
     * attempt has failed or costs too much. */
    std::optional<unsigned int>
    promising_rung_after(const Attempt &attempt, const unsigned int number) const;

    /** Return whether events already cost far more than is allowed before the end of the step. */
    bool
    is_hopeless(const StepRecord &record, const unsigned int number) const;

    double
    cost_of_events(const StepRecord &record, const unsigned int number) const;

    /** Return the energy that events may cost [MNm]. */
    double
    allowed_cost(const StepRecord &record) const;

    void
    accept(const Attempt &attempt,
           const unsigned int number,
           const std::vector<double> &levels,
           JointState &state,
           PathResult &result,
           PathObserver &observer);

    /** Return the work of friction beyond the time at which slips came to rest [MNm]. */
    double
    cost_of_rest(const StepRecord &record, const double length) const;

    /** Return the mean rate of slip of an element in a step [m/s]; zero if it does not slip at the
     * end. */
    TangentVector
    mean_slip_rate(const StepRecord &record, const std::size_t k, const double length) const;

    /** Return the load time after @p tick of the shortest steps. */
    double
    time_at(const std::size_t tick) const;

    MovingBodies &bodies;
    const TimeGrid grid;
    const PathOptions options;
    std::vector<std::unique_ptr<Rung>> rungs;
    /** The load history in the time of a step. */
    const LoadHistory history_of_step;
    MotionCut motion_cut;
    /** The cut from which follow() goes on instead of beginning. */
    std::optional<MotionCut> restart;
  };
} // namespace fuga

#endif
