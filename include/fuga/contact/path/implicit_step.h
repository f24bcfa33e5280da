// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_path_implicit_step_h
#define fuga_contact_path_implicit_step_h

#include <fuga/contact/segments/path_segment.h>

namespace fuga
{
  /**
   * From a state to the load at the end of a stage in one step, without the events between: the
   * state at the end satisfies all contact conditions with the slip of the whole step as the
   * direction of slip. It is the state that the events lead to if every element that slips or opens
   * in the stage keeps doing so (a monotone stage); otherwise the path matters and only the events
   * find it.
   *
   * Solved by switching all elements that violate a condition at once (a primal-dual active set
   * method) with the working schemes of the path. Needs linear or rigid layers.
   */
  class ImplicitStep
  {
  public:
    ImplicitStep(const std::vector<ContactElement> &elements,
                 const LayeredSystem &system,
                 WorkingScheme &scheme);

    /** Solves for load factors @p factors at load time @p t; nothing if no scheme satisfies all conditions. */
    std::optional<JointState>
    solve(const JointState &from, const double t, const Vector &factors);

    /** Schemes tried so far. */
    std::size_t n_schemes = 0;

  private:
    bool
    satisfy_scheme(const JointState &from, const Vector &factors, JointState &state);
    bool
    switch_violating(const JointState &from, const JointState &state);
    ContactState
    state_wanted(const JointState &from, const JointState &state, const std::size_t k) const;

    const std::vector<ContactElement> &elements;
    const LayeredSystem &system;
    WorkingScheme &scheme;
  };
} // namespace fuga

#endif
