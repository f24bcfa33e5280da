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
   * The step-by-step analysis of the contact along a load history, from event to event. This base
   * class contains what EventPath, which knows S as a matrix, and MatrixFreePath have in common.
   */
  class ContactPath
  {
  public:
    virtual ~ContactPath() = default;

    /**
     * Follow the whole history and report to @p observer at the load times @p levels (increasing).
     * @throws NumericalFailure if a step cannot be completed.
     */
    PathResult
    run(const std::vector<double> &levels, PathObserver &observer);

    /**
     * Follow the rest of a history from a cut of run() on the same problem; levels, events and the
     * end are the same bit for bit. Report only what comes after the cut and its reports. Stages
     * after the end of the history of the cut do not affect it.
     * @throws NumericalFailure also if the path is not the same.
     */
    PathResult
    resume(const PathCut &cut, const std::vector<double> &levels, PathObserver &observer);

    /**
     * Follow the loads from a state in which the path of another problem ended: the one before a
     * change of construction. Only state, result, iterations and next level of @p end are used.
     * @throws NumericalFailure, as run().
     */
    PathResult
    go_on(const PathCut &end, const std::vector<double> &levels, PathObserver &observer);

    /**
     * Follow the loads from @p state in the schemes as they are, as one of many paths through
     * nearly the same loads. Continue the counts of @p so_far; there are no levels.
     * @throws NumericalFailure, as run().
     */
    PathResult
    follow_step(const JointState &state, const PathResult &so_far, PathObserver &observer);

    /** Return the last cut, if the observer wants cuts; after the end of the history it is the end
     * itself. */
    const PathCut &
    last_cut() const
    {
      return cut;
    }

    /** Return the data that a cut keeps besides the state. */
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

    /** Return the work of the steps along curves so far. */
    virtual IterationCount
    iterations() const
    {
      return iteration_count;
    }

    /** Reset the energies to those of @p then, because what was followed since has been
     * discarded. */
    void
    take_back_energies(const IterationCount &then)
    {
      iteration_count.largest_energy = then.largest_energy;
      iteration_count.largest_load   = then.largest_load;
      iteration_count.energy_lost    = then.energy_lost;
    }

    /** Return the work on the matrices of the working schemes so far. */
    virtual SchemeWork
    work() const = 0;

  protected:
    ContactPath(const std::vector<ContactElement> &elements,
                const LayeredSystem &system,
                const LoadHistory &history);

    /** Call follow() with everything that a cut contains except for its memory. */
    PathResult
    follow_from_cut(const std::vector<double> &levels, PathObserver &observer);

    /** Loop over the events, beginning at the last cut. */
    virtual PathResult
    follow(const std::vector<double> &levels, ReportCounter &observer) = 0;

    /** Store a place from which the path can be followed again, if the observer wants it. */
    void
    make_cut(const JointState &state, const PathResult &result, ReportCounter &observer);

    /** Return what changes next: lost strength and water at a fixed load, or the load up to its
     * next corner. */
    Course
    next_course(const JointState &state) const;

    /** Set the reactions of the stuck joint, and of water in open elements, to loads at
     * @p factor_rates. */
    void
    set_reactions(const JointState &state, const Vector &factor_rates, Drive &drive) const;

    /** Return the factor by which the tolerances of boundaries grow at a standstill. */
    double
    widening_of_tolerances() const;

    /** Return the factor for the rounding that does not move an element which has just come to
     * rest. */
    double
    widening_at_rest() const;

    /** Call PathSegment::find_end(). If it fails, report what was reached before; @p state is then
     * the end of that. */
    double
    find_end(PathSegment &segment,
             const Course &course,
             const std::vector<double> &levels,
             PathObserver &observer,
             JointState &state);

    /** Count a segment that ended in @p state, and distinguish progress from a step of zero length.
     * @throws PathFailure at a standstill without end. */
    void
    note_step(const PathSegment &segment,
              const Course &course,
              const double length,
              const JointState &state,
              PathResult &result);

    void
    note_zero_step(const JointState &state, PathResult &result);

    /** Give an element another state, with everything that depends on it; return the event. */
    ContactEvent
    change_element(const std::size_t k,
                   const ContactState to,
                   const TangentVector &direction,
                   const double no_force,
                   JointState &state) const;

    /**
     * Let the water in joints follow the states of the elements, unless it stands still in this
     * stage; see renew_water(). @p no_force is the force that counts as zero [MN], per bar. Return
     * whether anything has changed; the water then changes at this load, before the load goes on.
     */
    bool
    let_water_follow(const Vector &no_force,
                     JointState &state,
                     PathObserver &observer,
                     PathResult &result);

    /** Count and report events at one load. */
    static void
    report(const std::vector<ContactEvent> &events,
           const JointState &state,
           PathObserver &observer,
           PathResult &result);

    /** Report the levels up to the load of @p state, to which the path has jumped. */
    void
    reach_levels(const std::vector<double> &levels,
                 const JointState &state,
                 PathObserver &observer);

    /** Record the limit load with the mechanism @p motion. */
    void
    take_limit(const JointState &state, const JointRates &motion, PathResult &result) const;

    const std::vector<ContactElement> &elements;
    const LayeredSystem &system;
    const LoadHistory &history;
    Standstill standstill;
    /** The states in the segment before. */
    std::vector<ContactState> last_states;
    std::size_t next_level = 0;
    /** First guess of the next decision, see PathSegment::resticking(). */
    std::vector<std::size_t> resticking;
    IterationCount iteration_count;
    PathCut cut;
  };
} // namespace fuga

#endif
