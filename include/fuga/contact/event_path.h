// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_event_path_h
#define fuga_contact_event_path_h

#include <fuga/contact/curved_segment.h>
#include <fuga/contact/load_history.h>
#include <fuga/contact/mechanism.h>
#include <fuga/contact/rate_problem.h>
#include <fuga/contact/report_counter.h>

#include <memory>

namespace fuga
{
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

  template <typename Result, typename Visitor, only_for<Result, PathResult> = 0>
  void
  for_each_field(Result &result, Visitor &&visit)
  {
    auto &[verdict,
           t,
           mechanism,
           mechanism_jumps,
           n_events,
           n_zero_steps,
           n_steps,
           n_jumps,
           n_schemes,
           n_decided_by] = result;
    visit("verdict", verdict);
    visit("t", t);
    visit("mechanism", mechanism);
    visit("mechanism_jumps", mechanism_jumps);
    visit("n_events", n_events);
    visit("n_zero_steps", n_zero_steps);
    visit("n_steps", n_steps);
    visit("n_jumps", n_jumps);
    visit("n_schemes", n_schemes);
    visit("n_decided_by", n_decided_by);
  }

  /**
   * A place between two segments from which a path can be followed again, bit for bit. Segments are
   * never cut: where they are divided would change the steps along a curve. What the observer heard
   * behind the cut, levels for instance, is counted instead and not reported again.
   */
  struct PathCut
  {
    JointState state;
    /** What was found so far. */
    PathResult result;
    IterationCount iterations;
    SchemeMemory scheme;
    /** Steps without progress that came one after the other last. */
    std::size_t n_zero_steps_in_row = 0;
    std::size_t next_level          = 0;
    /** First guess of the next decision, see PathSegment::resticking(). */
    std::vector<std::size_t> resticking;
    /** Reports to the observer since the cut. */
    std::size_t n_reports = 0;
  };

  template <typename Cut, typename Visitor, only_for<Cut, PathCut> = 0>
  void
  for_each_field(Cut &cut, Visitor &&visit)
  {
    auto
      &[state, result, iterations, scheme, n_zero_steps_in_row, next_level, resticking, n_reports] =
        cut;
    visit("state", state);
    visit("result", result);
    visit("iterations", iterations);
    visit("scheme", scheme);
    visit("n_zero_steps_in_row", n_zero_steps_in_row);
    visit("next_level", next_level);
    visit("resticking", resticking);
    visit("n_reports", n_reports);
  }

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

    /**
     * Follows the rest of a history from a cut of run() on the same problem; levels, events and the
     * end are the same bit for bit. Reports only what comes after the cut and its reports. Stages
     * behind the end of the history of the cut do not matter to it.
     * @throws NumericalFailure also if the path is not the same.
     */
    PathResult
    resume(const PathCut &cut, const std::vector<double> &levels, PathObserver &observer);

    /** The last cut, if the observer wants cuts; after the end of the history the end itself. */
    const PathCut &
    last_cut() const
    {
      return cut;
    }

    /** Work of the steps with nonlinear layers so far. */
    IterationCount
    iterations() const;

  private:
    JointState
    virgin_state() const;
    PathResult
    follow(const std::vector<double> &levels, ReportCounter &observer);
    void
    make_cut(const JointState &state,
             const PathResult &result,
             const std::size_t n_zero_steps_in_row,
             ReportCounter &observer);
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
    PathCut cut;
  };
} // namespace fuga

#endif
