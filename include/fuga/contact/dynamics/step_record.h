// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_dynamics_step_record_h
#define fuga_contact_dynamics_step_record_h

#include <fuga/contact/path/path_observer.h>
#include <fuga/contact/system/layered_system.h>

#include <functional>

namespace fuga
{
  /**
   * Keeps the reports of a step of time until it is known whether the step counts, and adds up what
   * it costs the joints.
   */
  class StepRecord : public PathObserver
  {
  public:
    /** The step begins in @p start and ends at the load time @p end. Its path has a time of its own,
     * from 0 to 1, lest the shortest steps of long stages have few digits, and does not know the
     * water in joints, which stands still during a motion: all states that are handed on get the
     * load time, the part of the step that is done, and the water of @p start. */
    StepRecord(const JointState &start,
               const double end,
               const std::vector<ContactElement> &elements,
               const LayeredSystem &system);

    /** A path whose record is @p hopeless is not followed any further. */
    void
    stop_if(std::function<bool(const StepRecord &)> hopeless)
    {
      is_hopeless = std::move(hopeless);
    }

    bool
    wants_more() const override
    {
      return !is_hopeless || !is_hopeless(*this);
    }

    void
    advanced(const PathPoint &from, const PathPoint &to, const double length) override;
    void
    jumped(const JointState &to) override;
    void
    changed(const std::vector<ContactEvent> &events, const JointState &state) override;
    void
    reached(const std::size_t index, const JointState &state) override;

    /** Tells @p observer everything. */
    void
    replay(PathObserver &observer) const;

    const JointState &
    start() const
    {
      return first;
    }

    /** Where the path of the step has come to. */
    const JointState &
    end() const
    {
      return last;
    }

    /** The same in the motion. */
    JointState
    end_of_motion() const
    {
      return in_motion(last);
    }

    /** ∫ p·dδ of all bars [MNm]. */
    double
    joint_work() const;

    /** (p_n + p)/2 · Δδ: what the time integration takes for it. */
    double
    work_of_means() const;

    /**
     * What events within the step cost [MNm], as far as it is done: the time integration knows of
     * (p_n + p)/2 only. Sum over the elements of the difference between the work of this mean on
     * the jump and joint_work(), and of that between the mean and the mean along the path, an
     * impulse, whose
     * work on lips that move with @p rate [m/s] comes later. @p length: of the step [s].
     */
    double
    cost_of_events(const double length, const double rate) const;

    /** Largest change of a jump [m]. */
    double
    largest_change() const;

  private:
    double
    load_time(const double of_path) const;
    JointState
    in_motion(JointState of_path) const;
    PathPoint
    in_motion(const PathPoint &of_path) const;
    Vector
    change_of_jumps(const JointState &from, const JointState &to) const;

    const JointState first;
    const double end_time;
    const std::vector<ContactElement> &elements;
    const LayeredSystem &system;
    JointState last;
    /** By bar ∫ p dδ, and ∫ p dt with the time of the path. */
    Vector work, impulse;
    /** Work that is known to half of the change of the forces only. */
    double cost_of_jumps = 0.;
    std::function<bool(const StepRecord &)> is_hopeless;
    /** Called with this object, which may have moved since. */
    using Report = std::function<void(const StepRecord &, PathObserver &)>;
    std::vector<Report> reports;
  };
} // namespace fuga

#endif
