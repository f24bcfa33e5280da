// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_event_path_h
#define fuga_contact_event_path_h

#include <fuga/contact/curved_segment.h>
#include <fuga/contact/load_history.h>
#include <fuga/contact/mechanism.h>
#include <fuga/contact/rate_problem.h>

#include <memory>

namespace fuga
{
  /** One change of the working scheme. */
  struct ContactEvent
  {
    double t            = 0.;
    std::size_t element = 0;
    ContactState from   = ContactState::stick;
    ContactState to     = ContactState::stick;
  };

  /** How a path ended. */
  enum class Verdict
  {
    /** The requested end of the load history was reached. */
    done,
    /** The working scheme is a mechanism: the load cannot grow. */
    limit_load,
    /** No quasi-static continuation exists although nothing moves freely (friction beyond
       critical). */
    no_continuation
  };

  struct PathResult
  {
    Verdict verdict         = Verdict::done;
    double t                = 0.;
    MechanismKind mechanism = MechanismKind::none;
    /** Jumps of the bars in the mechanism, largest 1. */
    Vector mechanism_jumps;
    std::size_t n_events     = 0;
    std::size_t n_zero_steps = 0;
    std::size_t n_steps      = 0;
    /** Implicit steps that took the place of events. */
    std::size_t n_jumps    = 0;
    unsigned int n_schemes = 0;
    /** Continuations found by each RateMethod. */
    std::array<std::size_t, 4> n_decided_by = {{0, 0, 0, 0}};
  };

  /** Receives the path as it is found. All calls come in the order of the load time. */
  class PathObserver
  {
  public:
    virtual ~PathObserver() = default;

    /** The path went from @p from to @p to (τ apart by @p length), smoothly. */
    virtual void
    advanced(const PathPoint &from, const PathPoint &to, const double length) = 0;

    /** The path went to @p to by an implicit step: what happened between is not known. */
    virtual void
    jumped(const JointState &to) = 0;

    /** The scheme changed; @p state has the new states. */
    virtual void
    changed(const std::vector<ContactEvent> &events, const JointState &state) = 0;

    /** A requested load time was reached; @p index counts them. */
    virtual void
    reached(const std::size_t index, const JointState &state) = 0;
  };

  /**
   * The paper's step-by-step analysis: find the load of the next event on the contact, advance to
   * it exactly, change the working scheme, go on. Knows bars, laws and loads, and no mesh.
   */
  class EventPath
  {
  public:
    EventPath(const std::vector<ContactElement> &elements,
              const LayeredSystem &system,
              const LoadHistory &history,
              const PathOptions &options);

    /**
     * Follows the whole history, reporting to @p observer at the load times @p levels (increasing).
     * @throws NumericalFailure if a step cannot be completed.
     */
    PathResult
    run(const std::vector<double> &levels, PathObserver &observer);

    /** Work of the steps with nonlinear layers so far. */
    IterationCount
    iterations() const;

  private:
    JointState
    virgin_state() const;
    Course
    next_course(const JointState &state) const;
    bool
    jump_to_corner(JointState &state,
                   const std::vector<double> &levels,
                   PathObserver &observer,
                   PathResult &result);
    Continuation
    decide(JointState &state, const Course &course, PathObserver &observer, PathResult &result);
    bool
    break_exhausted_bonds(JointState &state, PathObserver &observer, PathResult &result) const;
    std::unique_ptr<PathSegment>
    make_segment(const Course &course, const PathPoint &start);
    double
    find_end(PathSegment &segment,
             const Course &course,
             const std::vector<double> &levels,
             PathObserver &observer);
    JointState
    report_piecewise(PathSegment &segment,
                     const Course &course,
                     const std::vector<double> &levels,
                     PathObserver &observer);
    void
    lose_equilibrium(JointState &state,
                     const Continuation &continuation,
                     PathObserver &observer,
                     PathResult &result) const;

    const std::vector<ContactElement> &elements;
    const LayeredSystem &system;
    const LoadHistory &history;
    const PathOptions options;
    ContactBoundary boundary;
    WorkingScheme scheme;
    RateProblem rate_problem;
    std::size_t next_level = 0;
    /** First guess of the next decision, see PathSegment::resticking(). */
    std::vector<std::size_t> resticking;
    IterationCount iteration_count;
  };
} // namespace fuga

#endif
