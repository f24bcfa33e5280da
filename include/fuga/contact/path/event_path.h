// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_path_event_path_h
#define fuga_contact_path_event_path_h

#include <fuga/contact/path/contact_path.h>
#include <fuga/contact/path/slow_motion.h>
#include <fuga/contact/rates/rate_problem.h>

#include <memory>

namespace fuga
{
  /**
   * The paper's step-by-step analysis: find the load of the next event on the contact, advance to
   * it exactly, change the working scheme, and continue. The class knows bars, laws and loads, but
   * no mesh. Elements have one tangential bar, in the plane, or two, with Coulomb's circular cone
   * (doc/theory.md, section 17), or none.
   */
  class EventPath : public ContactPath
  {
  public:
    EventPath(const std::vector<ContactElement> &elements,
              const LayeredSystem &system,
              const LoadHistory &history,
              const PathOptions &options);

    SchemeWork
    work() const override;
    PathMemory
    memory() const override;
    void
    restore(const PathMemory &memory) override;

    /** Jump from @p from, a settled state, directly to the end of the present course, where the
     * events on the way lead nowhere: as Follow::stage_ends does, or else as a jump. Return whether
     * there is an equilibrium to jump to. */
    bool
    jump_over_course(const JointState &from, PathObserver &observer, PathResult &result);

  private:
    PathResult
    follow(const std::vector<double> &levels, ReportCounter &observer) override;
    /** Advance to the next event. Return whether the path goes on after it. */
    bool
    advance(JointState &state,
            const std::vector<double> &levels,
            PathObserver &observer,
            PathResult &result);
    /** Handle a state from which no continuation exists. Return whether there is another way on. */
    bool
    leave_path(JointState &state,
               const Continuation &continuation,
               const std::vector<double> &levels,
               PathObserver &observer,
               PathResult &result);
    /** Try to jump where the path cannot be computed, because an equilibrium may exist beyond that
     * place. */
    bool
    jump_over_failure(JointState &state,
                      const std::vector<double> &levels,
                      PathObserver &observer,
                      PathResult &result);
    /** Set the state to @p end, and report its events. */
    void
    jump_to(const JointState &end, JointState &state, PathObserver &observer, PathResult &result);
    bool
    jump_to_corner(JointState &state,
                   const std::vector<double> &levels,
                   PathObserver &observer,
                   PathResult &result);
    /** Set the values that count as zero in forces, jumps and their rates at @p state. */
    void
    set_boundary(const JointState &state, const Course &course, const double widening);
    Continuation
    decide(JointState &state, const Course &course, PathObserver &observer, PathResult &result);
    /** Solve again, with more elements on their boundaries, where nothing moves freely and yet no
     * @p continuation exists. */
    void
    decide_on_wider_boundary(JointState &state,
                             const Course &course,
                             PathObserver &observer,
                             Continuation &continuation,
                             PathResult &result);
    bool
    break_exhausted_bonds(JointState &state, PathObserver &observer, PathResult &result) const;
    void
    choose_branch(const JointState &state,
                  const std::vector<BoundaryElement> &set,
                  const Drive &drive,
                  Continuation &continuation,
                  PathResult &result);
    /** Set the states and strengths of the working scheme to those of @p state. */
    void
    take_scheme(JointState &state);
    /** Let the elements of @p set stick that have no force to give up and would lose friction by a
     * slip with the rate zero. */
    void
    rest_at_apex(const JointState &state,
                 const std::vector<BoundaryElement> &set,
                 const Drive &drive,
                 const JointRates &rates);
    /** Return whether the scheme costs strength, so that its rates do not hold. */
    bool
    adopt_scheme(JointState &state,
                 const std::vector<BoundaryElement> &set,
                 const std::size_t n_branches,
                 PathObserver &observer,
                 PathResult &result) const;
    /** Follow the path beyond a limit load, on request. @p ahead is the amount by which the load
     * may still grow. */
    void
    go_beyond_limit(JointState &state,
                    const double ahead,
                    PathObserver &observer,
                    PathResult &result);
    struct ControlledStep
    {
      ControlledContinuation motion;
      Course course;
    };
    ControlledStep
    step_beyond(const JointState &state,
                const std::vector<BoundaryElement> &set,
                const double left);
    std::unique_ptr<PathSegment>
    segment_beyond(ControlledStep &step,
                   const JointState &state,
                   const double first_t,
                   const double last_t);
    YieldingLoad
    yielding_load(const ControlledStep &step, const JointState &state) const;
    /** Return an equilibrium near by, at loads that are larger by @p ahead, or by as much as the
     * course or the level lets them grow. */
    std::optional<JumpEnd>
    equilibrium_ahead(const JointState &state,
                      const double ahead,
                      const std::vector<double> &levels);
    /** Jump to an equilibrium near by. Return whether the path goes on after the jump. */
    bool
    jump_to_equilibrium(JointState &state,
                        const std::vector<double> &levels,
                        PathObserver &observer,
                        PathResult &result);
    /** End the path where equilibrium is lost: jump to another one or go beyond the limit, both on
     * request. Return whether the path goes on after a jump. @p ahead is the amount by which the
     * load may still grow. */
    bool
    jump_or_go_beyond(JointState &state,
                      const double ahead,
                      const std::vector<double> &levels,
                      PathObserver &observer,
                      PathResult &result);
    /** Return whether the direction of a slip turns. @p size is the size of the force rates that
     * others are compared with, if it is larger than they. */
    bool
    turns(const PathPoint &start, const bool is_curved, double size = 0.) const;
    void
    find_critical_elements(JointState &state, PathResult &result);
    std::unique_ptr<PathSegment>
    make_segment(const Course &course, const PathPoint &start);
    void
    note_what_was_tried(const Continuation &continuation,
                        const std::vector<BoundaryElement> &set,
                        PathResult &result) const;
    void
    lose_equilibrium(JointState &state,
                     const Continuation &continuation,
                     PathObserver &observer,
                     PathResult &result);

    const PathOptions options;
    const bool in_space;
    ContactBoundary boundary;
    WorkingScheme scheme;
    RateProblem rate_problem;
    /** The rates of the last step if its length was zero. */
    JointRates last_rates;
  };
} // namespace fuga

#endif
