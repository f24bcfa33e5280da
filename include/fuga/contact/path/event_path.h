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
   * it exactly, change the working scheme, go on. Knows bars, laws and loads, and no mesh. Elements
   * have one tangential bar, in the plane, or two, with Coulomb's circular cone (doc/theory.md,
   * section 17), or none.
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

    /** From @p from, a settled state, to the end of the present course at once, where the events on
     * the way lead nowhere: as Follow::stage_ends does, or else as a jump. Whether there is an
     * equilibrium to jump to. */
    bool
    jump_over_course(const JointState &from, PathObserver &observer, PathResult &result);

  private:
    PathResult
    follow(const std::vector<double> &levels, ReportCounter &observer) override;
    /** To the next event. Whether the path goes on behind it. */
    bool
    advance(JointState &state,
            const std::vector<double> &levels,
            PathObserver &observer,
            PathResult &result);
    /** Where no continuation exists. Whether there is another way on. */
    bool
    leave_path(JointState &state,
               const Continuation &continuation,
               const std::vector<double> &levels,
               PathObserver &observer,
               PathResult &result);
    /** Where the path cannot be computed there may yet be an equilibrium behind. */
    bool
    jump_over_failure(JointState &state,
                      const std::vector<double> &levels,
                      PathObserver &observer,
                      PathResult &result);
    /** Takes @p end for the state, with its events. */
    void
    jump_to(const JointState &end, JointState &state, PathObserver &observer, PathResult &result);
    bool
    jump_to_corner(JointState &state,
                   const std::vector<double> &levels,
                   PathObserver &observer,
                   PathResult &result);
    /** What counts as zero in forces, jumps and their rates at @p state. */
    void
    set_boundary(const JointState &state, const Course &course, const double widening);
    Continuation
    decide(JointState &state, const Course &course, PathObserver &observer, PathResult &result);
    /** Asks again, with more elements on their boundaries, where nothing moves freely and yet no
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
    /** States and strengths of the working scheme become those of @p state. */
    void
    take_scheme(JointState &state);
    /** Whether the scheme costs strength, so that its rates do not hold. */
    bool
    adopt_scheme(JointState &state,
                 const std::vector<BoundaryElement> &set,
                 const std::size_t n_branches,
                 PathObserver &observer,
                 PathResult &result) const;
    /** On request. @p ahead: how much the load may still grow. */
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
    /** One near by, at loads that are larger by @p ahead or as far as the course or the level lets
     * them grow. */
    std::optional<JumpEnd>
    equilibrium_ahead(const JointState &state,
                      const double ahead,
                      const std::vector<double> &levels);
    /** Whether the path goes on behind a jump. */
    bool
    jump_to_equilibrium(JointState &state,
                        const std::vector<double> &levels,
                        PathObserver &observer,
                        PathResult &result);
    /** @p size of the force rates that others are small against, if it is larger than they. */
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
    const bool has_cones;
    ContactBoundary boundary;
    WorkingScheme scheme;
    RateProblem rate_problem;
    /** Those of the last step, if it was one without length. */
    JointRates last_rates;
  };
} // namespace fuga

#endif
