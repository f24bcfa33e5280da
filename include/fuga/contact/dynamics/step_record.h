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
   * Stores the reports of a time step until it is known whether the step counts, and sums up what
   * it costs the joints.
   */
  class StepRecord : public PathObserver
  {
  public:
    /** The step begins in the state @p start and ends at the load time @p end. Its path has a time
     * of its own, from 0 to 1, so that the shortest steps of long stages do not lose digits, and
     * does not know the water in joints, which is constant during a motion. All states that are
     * handed on therefore get the load time, the part of the step that is done, and the water of
     * @p start. */
    StepRecord(const JointState &start,
               const double end,
               const std::vector<ContactElement> &elements,
               const LayeredSystem &system);

    /** Stop following a path when its record is @p hopeless. */
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

    /** Report everything to @p observer. */
    void
    replay(PathObserver &observer) const;

    const JointState &
    start() const
    {
      return first;
    }

    /** Return the state that the path of the step has reached. */
    const JointState &
    end() const
    {
      return last;
    }

    /** Return the same state in the motion. */
    JointState
    end_of_motion() const
    {
      return in_motion(last);
    }

    /** Return ∫ p·dδ of all bars [MNm]. */
    double
    joint_work() const;

    /** Return (p_n + p)/2 · Δδ: the work that the time integration assumes instead. */
    double
    work_of_means() const;

    /**
     * Return the cost of the events within the step [MNm], as far as it is done; the time
     * integration knows only (p_n + p)/2. The cost is the sum over the elements of two differences:
     * that between the work of this mean on the jump and joint_work(), and that between the mean
     * and the mean along the path, an impulse, whose work on lips that move with @p rate [m/s]
     * comes later. @p length is the length of the step [s].
     */
    double
    cost_of_events(const double length, const double rate) const;

    /** Return the largest change of a jump [m]. */
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
    /** ∫ p dδ of each bar, and ∫ p dt with the time of the path. */
    Vector work, impulse;
    /** Work that is known only up to half of the change of the forces. */
    double cost_of_jumps = 0.;
    std::function<bool(const StepRecord &)> is_hopeless;
    /** A report; it is called with this object, which may have been moved since. */
    using Report = std::function<void(const StepRecord &, PathObserver &)>;
    std::vector<Report> reports;
  };
} // namespace fuga

#endif
