// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_path_contact_path_h
#define fuga_contact_path_contact_path_h

#include <fuga/contact/element/standstill.h>
#include <fuga/contact/load_history.h>
#include <fuga/contact/path/path_result.h>
#include <fuga/contact/path/report_counter.h>

namespace fuga
{
  /**
   * The step-by-step analysis of the contact along a load history, from event to event: what
   * EventPath, which knows S as a matrix, and MatrixFreePath have in common.
   */
  class ContactPath
  {
  public:
    virtual ~ContactPath() = default;

    /**
     * Follows the whole history, reporting to @p observer at the load times @p levels (increasing).
     * @throws NumericalFailure if a step cannot be completed.
     */
    PathResult
    run(const std::vector<double> &levels, PathObserver &observer);

    /**
     * Follows the rest of a history from a cut of run() on the same problem; levels, events and the
     * end are the same bit for bit. Reports only what comes after the cut and its reports. Stages
     * behind the end of the history of the cut do not matter to it.
     * @throws NumericalFailure also if the path is not the same.
     */
    PathResult
    resume(const PathCut &cut, const std::vector<double> &levels, PathObserver &observer);

    /**
     * Follows the loads from a state in which the path of another problem ended: the one before a
     * change of construction. Of @p end, state, result, iterations and next level count.
     * @throws NumericalFailure, as run().
     */
    PathResult
    go_on(const PathCut &end, const std::vector<double> &levels, PathObserver &observer);

    /**
     * Follows the loads from @p state in the schemes as they are: one of many paths through nearly
     * the same loads. Counts on from @p so_far; no levels.
     * @throws NumericalFailure, as run().
     */
    PathResult
    follow_step(const JointState &state, const PathResult &so_far, PathObserver &observer);

    /** The last cut, if the observer wants cuts; after the end of the history the end itself. */
    const PathCut &
    last_cut() const
    {
      return cut;
    }

    /** What a cut keeps besides the state. */
    virtual PathMemory
    memory() const
    {
      return {iteration_count, {}, {}};
    }

    virtual void
    restore(const PathMemory &memory)
    {
      iteration_count = memory.iterations;
    }

    /** Work of the steps along curves so far. */
    virtual IterationCount
    iterations() const
    {
      return iteration_count;
    }

    /** The energies of @p then count: what was followed since has come to nothing. */
    void
    take_back_energies(const IterationCount &then)
    {
      iteration_count.largest_energy = then.largest_energy;
      iteration_count.largest_load   = then.largest_load;
      iteration_count.energy_lost    = then.energy_lost;
    }

    /** Work on the matrices of the working schemes so far. */
    virtual SchemeWork
    work() const = 0;

  protected:
    ContactPath(const std::vector<ContactElement> &elements,
                const LayeredSystem &system,
                const LoadHistory &history);

    /** follow() with all that a cut knows but its memory. */
    PathResult
    follow_from_cut(const std::vector<double> &levels, PathObserver &observer);

    /** The loop over the events, from the last cut on. */
    virtual PathResult
    follow(const std::vector<double> &levels, ReportCounter &observer) = 0;

    /** Keeps a place from which the path can be followed again, if the observer wants it. */
    void
    make_cut(const JointState &state, const PathResult &result, ReportCounter &observer);

    /** What changes next: lost strength and water at a fixed load, or the load up to its next
     *  corner. */
    Course
    next_course(const JointState &state) const;

    /** The reactions of the stuck joint, and water in open elements, to loads at @p factor_rates. */
    void
    set_reactions(const JointState &state, const Vector &factor_rates, Drive &drive) const;

    /** Factor by which the tolerances of boundaries grow at a standstill. */
    double
    widening_of_tolerances() const;

    /** The same of the rounding that does not move an element which has just come to rest. */
    double
    widening_at_rest() const;

    /** PathSegment::find_end(); at a failure what was reached before it is reported, and @p state
     * is its end. */
    double
    find_end(PathSegment &segment,
             const Course &course,
             const std::vector<double> &levels,
             PathObserver &observer,
             JointState &state);

    /** Counts a segment that ended in @p state, and tells progress from a step without length.
     *  @throws PathFailure at a standstill without end. */
    void
    note_step(const PathSegment &segment,
              const Course &course,
              const double length,
              const JointState &state,
              PathResult &result);

    void
    note_zero_step(const JointState &state, PathResult &result);

    /** Gives an element another state, with all that goes with it; the event. */
    ContactEvent
    change_element(const std::size_t k,
                   const ContactState to,
                   const TangentVector &direction,
                   const double no_force,
                   JointState &state) const;

    /**
     * Lets the water in joints follow the states of the elements, unless it stands still in this
     * stage; see renew_water(). @p no_force: what counts as no force [MN], per bar. Whether
     * anything changed: then the water changes at this load, before the load goes on.
     */
    bool
    let_water_follow(const Vector &no_force,
                     JointState &state,
                     PathObserver &observer,
                     PathResult &result);

    /** Counts and reports events at one load. */
    static void
    report(const std::vector<ContactEvent> &events,
           const JointState &state,
           PathObserver &observer,
           PathResult &result);

    /** Reports the levels up to the load of @p state, to which the path has jumped. */
    void
    reach_levels(const std::vector<double> &levels,
                 const JointState &state,
                 PathObserver &observer);

    /** The limit load with the mechanism @p motion. */
    void
    take_limit(const JointState &state, const JointRates &motion, PathResult &result) const;

    const std::vector<ContactElement> &elements;
    const LayeredSystem &system;
    const LoadHistory &history;
    Standstill standstill;
    std::size_t next_level = 0;
    /** First guess of the next decision, see PathSegment::resticking(). */
    std::vector<std::size_t> resticking;
    IterationCount iteration_count;
    PathCut cut;
  };
} // namespace fuga

#endif
