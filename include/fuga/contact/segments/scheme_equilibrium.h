// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_segments_scheme_equilibrium_h
#define fuga_contact_segments_scheme_equilibrium_h

#include <fuga/base/errors.h>
#include <fuga/contact/segments/path_options.h>
#include <fuga/contact/segments/path_segment.h>

namespace fuga
{
  /** Thrown if a closed layer is_at_closure_limit(), and no equilibrium is found beyond that
   * state. */
  class LawExhausted : public PathFailure
  {
  public:
    LawExhausted(const std::string &what, const JointState &last) : PathFailure(what), state(last)
    {
    }

    const JointState state;
  };

  /**
   * Iterates a working scheme with nonlinear layers to equilibrium at given loads, with Newton's
   * method or the constant matrix of the paper.
   */
  class SchemeEquilibrium
  {
  public:
    /** Constructor. @p answer tells which corrections are accepted. */
    SchemeEquilibrium(const PathContext &context,
                      const Course &course,
                      const PathOptions &options,
                      IterationCount &count,
                      const SchemeAnswer answer = SchemeAnswer::of_no_mechanism);

    /** Correct @p state, which complete_state() has completed, at @p tau. @p largest_jump is the
     * scale of the iteration; for @p known see there. Return false if the iteration does not
     * converge. */
    bool
    solve(const double tau,
          const double largest_jump,
          JointState &state,
          const KnownForces *known = nullptr);

  private:
    PathContext context;
    const Course &course;
    const PathOptions options;
    IterationCount &count;
    const SchemeAnswer answer;
  };

  /** Return whether a closed layer is deformed by more than its law allows. */
  bool
  passes_limit_of_law(const std::vector<ContactElement> &elements, const JointState &state);

  /** Tells whether lips that are apart may meet beyond the limit of their layer: where they do, an
   * event has been passed, and a path that looks for it must be able to see that. */
  enum class OpenLips
  {
    may_pass_limit,
    stay_short_of_limit
  };

  /** Return the largest share of a change, by which the jumps grow by @p growth_of, that keeps
   * every layer with a limit of deformation short of it. */
  double
  limit_safeguard(const std::vector<ContactElement> &elements,
                  const JointState &state,
                  const Vector &growth_of,
                  const OpenLips open_lips);
} // namespace fuga

#endif
