// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_cone_path_h
#define fuga_contact_cone_path_h

#include <fuga/contact/cone_rate_problem.h>
#include <fuga/contact/cone_segment.h>
#include <fuga/contact/contact_path.h>

namespace fuga
{
  /** What the laws of an element contain that ConePath cannot follow; empty if nothing. */
  std::string
  unavailable_in_cone_path(const ContactElement &element);

  /**
   * The path in three dimensions, with Coulomb's circular cone: elements have two tangential bars,
   * or none (doc/theory.md, section 17). Layers are linear or rigid, and friction is that of
   * Coulomb alone. In the state slip the direction is that of the tangential force; the slips along
   * both tangents are the dislocations of the tangential bars.
   */
  class ConePath : public ContactPath
  {
  public:
    /** @throws InputError if something is asked for that is not available with circular cones. */
    ConePath(const std::vector<ContactElement> &elements,
             const LayeredSystem &system,
             const LoadHistory &history,
             const PathOptions &options);

    const SchemeWork &
    work() const override
    {
      return scheme_work;
    }

  private:
    PathResult
    follow(const std::vector<double> &levels, ReportCounter &observer) override;
    bool
    release_open_elements(const JointState &state, const std::vector<BoundaryElement> &set);
    ConeContinuation
    decide(JointState &state, const Course &course, PathObserver &observer, PathResult &result);
    void
    adopt(JointState &state,
          const std::vector<BoundaryElement> &set,
          const std::vector<ContactState> &states,
          PathObserver &observer,
          PathResult &result);
    /** All that slip. */
    void
    take_critical_elements(const JointState &state, PathResult &result) const;
    void
    lose_equilibrium(JointState &state,
                     const ConeContinuation &continuation,
                     PathObserver &observer,
                     PathResult &result);

    ConeBoundary boundary;
    ReleasedSystem released;
    ConeRateProblem rate_problem;
    /** Slip directions that the last decision left. */
    std::vector<TangentVector> directions;
    SchemeWork scheme_work;
    std::vector<bool> ever_active;
  };
} // namespace fuga

#endif
