// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_path_implicit_step_h
#define fuga_contact_path_implicit_step_h

#include <fuga/contact/segments/path_segment.h>

namespace fuga
{
  /**
   * A step from a state to the end of a course, without the events in between: the state at the end
   * satisfies all contact conditions with the slip of the whole step in the direction of the shear
   * force there (backward Euler). This is the state that the events lead to if every element that
   * slips or opens does so all the way, in one direction; otherwise the path matters, and only the
   * events find it. An element loses the strength that opening or slip costs if equilibrium without
   * this loss needs the opening or the slip.
   *
   * The state is found by a semismooth Newton method on the condensed system, after Alart and
   * Curnier: each iterate is the solution of a working scheme, whose states and directions of slip
   * follow from forces and jumps, made comparable by the stiffness of the bars. Where the method
   * does not converge for the whole course, it begins from its solution for a part of it.
   * (doc/theory.md, section 3)
   */
  class ImplicitStep
  {
  public:
    ImplicitStep(const PathContext &context, const Course &course);

    /** Return the end of the course in a step from @p from; nothing if none was found. */
    std::optional<JointState>
    solve(const JointState &from);

    /** Return the number of schemes solved so far. */
    std::size_t
    n_schemes() const
    {
      return schemes;
    }

  private:
    /** The state that an element should take according to forces and jumps. */
    struct Demand
    {
      ContactState state      = ContactState::open;
      TangentVector direction = {{1., 0.}};
      /** Slip divided by shear force, see WorkingScheme::let_turn() [m/MN]. */
      double turning = 0.;
    };

    std::optional<JointState>
    solve(const JointState &from, const double tau, const JointState &guess);
    bool
    find_equilibrium(const double tau, JointState &state);
    void
    correct_forces(JointState &state) const;
    /** Let lips that have begun to slip, unlike in @p before, slide until nothing shears them. */
    void
    unload_slips(const std::vector<ContactState> &before, JointState &state) const;
    bool
    take_demands(JointState &state);
    Demand
    demand_on(const JointState &state, const std::size_t k) const;
    Demand
    demand_on_shear(const JointState &state,
                    const std::size_t k,
                    const double strength,
                    const double noise) const;
    void
    complete(const double tau, JointState &state) const;
    TangentVector
    slip_of_step(const JointState &state, const std::size_t k) const;
    bool
    lose_strength(JointState &state);
    JointState
    finished(JointState state) const;

    PathContext context;
    const Course &course;
    /** The beginning of the step, with the strength that is left at its end. */
    JointState start;
    std::size_t schemes = 0;
  };
} // namespace fuga

#endif
