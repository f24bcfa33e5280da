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
   * The contact of bodies in motion, step of time by step of time. A step is the static problem
   * with another stiffness, see MovingBodies, and the paper's step-by-step analysis leads through
   * it from event to event: at its end all contact conditions hold. Where events within a step
   * cost energy, because the time integration knows nothing of them, or an element slips beyond the
   * time at which it comes to rest, the step is halved; each length has its own stiffness,
   * condensed when first needed. (doc/theory.md, section 19)
   *
   * A motion until rest (TimeGrid) reports no levels, and ends with the verdict that the load is
   * beyond its limit if the bodies still move behind the last step.
   */
  class DynamicPath : public ContactPath, private MotionProgress
  {
  public:
    /** @p system and @p history: those of the bodies at rest. */
    DynamicPath(const std::vector<ContactElement> &elements,
                const LayeredSystem &system,
                const LoadHistory &history,
                MovingBodies &bodies,
                const TimeGrid &grid,
                const PathOptions &options);

    ~DynamicPath() override;

    SchemeWork
    work() const override;

    /** Of the energies, those before the motion: each length of steps has its own. */
    IterationCount
    iterations() const override;

    /** As resume(), from a cut between two whole steps. A motion until rest has none. */
    PathResult
    resume_motion(const PathCut &cut,
                  const MotionCut &motion,
                  const std::vector<double> &levels,
                  PathObserver &observer);

    /** What belongs to last_cut(). */
    const MotionCut &
    last_motion_cut() const
    {
      return motion_cut;
    }

    /** Since the motion began. */
    const MotionLedger &
    energies() const
    {
      return ledger;
    }

    /** Steps by rung. */
    const std::vector<std::size_t> &
    n_steps() const
    {
      return steps_of_rung;
    }

    /** Whether the last step ended where a whole one does. */
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
      /** Why there is no state at the end of the step; empty if there is one. */
      std::string failure;
      /** Where a layer was at its closure limit, if that is why. */
      std::optional<JointState> exhausted;
    };

    PathResult
    follow(const std::vector<double> &levels, ReportCounter &observer) override;

    void
    begin(const JointState &state);
    /** The energy that is rounding of what the joints carry in @p state. */
    double
    rounding_of_work(const JointState &state) const;

    MotionCut
    motion_memory() const;

    void
    restore_motion(const MotionCut &motion);

    /** From the present time by one step of a rung, or by two of the next one. */
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

    /** The shortest step, @p number, has failed, and so has the @p last attempt at load time @p t. */
    [[noreturn]] void
    give_up(const Attempt &last, const unsigned int number, const double t) const;

    /** After an attempt that is accepted: the rung of the longest step that will not cost too much,
     * if it costs what this one has cost. Nothing if this one has failed or costs too much. */
    std::optional<unsigned int>
    promising_rung_after(const Attempt &attempt, const unsigned int number) const;

    /** Events cost far more than is allowed already, before the end of the step. */
    bool
    is_hopeless(const StepRecord &record, const unsigned int number) const;

    double
    cost_of_events(const StepRecord &record, const unsigned int number) const;

    /** What events may cost [MNm]. */
    double
    allowed_cost(const StepRecord &record) const;

    void
    accept(const Attempt &attempt,
           const unsigned int number,
           const std::vector<double> &levels,
           JointState &state,
           PathResult &result,
           PathObserver &observer);

    /** Work of friction beyond the time at which slips came to rest [MNm]. */
    double
    cost_of_rest(const StepRecord &record, const double length) const;

    /** Mean rate of slip of an element in a step [m/s]; zero if it does not slip at the end. */
    TangentVector
    mean_slip_rate(const StepRecord &record, const std::size_t k, const double length) const;

    /** Load time after this number of the shortest steps. */
    double
    time_at(const std::size_t tick) const;

    MovingBodies &bodies;
    const TimeGrid grid;
    const PathOptions options;
    std::vector<std::unique_ptr<Rung>> rungs;
    /** In the time of a step. */
    const LoadHistory history_of_step;
    MotionCut motion_cut;
    /** Where follow() goes on instead of beginning. */
    std::optional<MotionCut> restart;
  };
} // namespace fuga

#endif
