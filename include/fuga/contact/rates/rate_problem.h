// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_rates_rate_problem_h
#define fuga_contact_rates_rate_problem_h

#include <fuga/contact/cones/cone_rate_problem.h>
#include <fuga/contact/scheme/working_scheme.h>

namespace fuga
{
  /** The method by which the continuation was found; each method is tried when the one before has
   * failed. */
  enum class RateMethod
  {
    /** Keep the scheme, or switch all violating elements at once until none violates. */
    block_switching,
    /** Switch one element at a time, the one with the lowest index first. */
    single_switching,
    /** Newton's method for the rates of the boundary set alone, from several beginnings
     * (ConeRateProblem). */
    newton,
    /** Try all combinations of states of a small boundary set, or divide them until each is ruled
     * out. */
    search
  };

  /** The result of the rate problem. */
  struct Continuation
  {
    /** If true, `rates` satisfy every rate inequality, and the working scheme has the states that
     * belong to them. */
    bool exists = false;
    JointRates rates;
    /** True if elements lose strength as they take these states, so that the rates do not hold. */
    bool costs_strength = false;
    RateMethod method   = RateMethod::block_switching;
    /** If no continuation exists: true if that is certain, since a proof rules out every
     * combination of states. */
    bool is_ruled_out = false;
    /** If no continuation exists: true if a motion was found; mechanism is the one that meets the
     * least resistance. */
    bool has_mechanism = false;
    JointRates mechanism;
    /** If nothing moves freely either: a virtual motion that may show that no
     * continuation exists. */
    std::optional<JointRates> barrier;
    /** Number of continuations known. */
    std::size_t n_branches = 1;
    /** Number of schemes tried. */
    unsigned int n_schemes = 0;
    /** True if one of them had a negative determinant. */
    bool met_negative_determinant = false;
  };

  /** One of several ways in which the joints can go on. */
  struct Branch
  {
    /** States of the boundary elements. */
    std::vector<ContactState> states;
    /** Directions of their slips; along one tangential bar their signs. */
    std::vector<TangentVector> directions;
    JointRates rates;
    /** Sign of the determinant of the scheme; it is negative beyond critical friction. */
    int determinant_sign = 0;
    /** Σ T ṡ [MN m per unit of the path]. */
    double dissipation = 0.;
    /** Σ Ṫ ṡ; it decides between branches that leave from the apex of the cone, where T = 0. */
    double dissipation_growth = 0.;
  };

  /** The way in which the joints go on beyond a limit load, where the load is no longer given. */
  struct ControlledContinuation
  {
    bool exists = false;
    /** Rates per unit of the largest jump [m]. */
    JointRates rates;
    /** Rate of the load time per unit of the largest jump [1/m]: zero on a plateau, negative where
     * the load falls. */
    double load_rate = 0.;
  };

  /**
   * Determines from rates how the joints go on, for all elements on a boundary at once: each of
   * them has a RateLaw. All other elements keep their state.
   */
  class RateProblem
  {
  public:
    RateProblem(const std::vector<ContactElement> &elements,
                const LayeredSystem &system,
                WorkingScheme &scheme);

    /** Return the scheme in which all elements of the boundary set are stuck, with two tangential
     * bars. */
    WorkingScheme &
    background()
    {
      return off_boundary;
    }

    const WorkingScheme &
    background() const
    {
      return off_boundary;
    }

    /**
     * Find a continuation from @p state under @p drive, with the states of the scheme as the first
     * guess. @p resticking lists the elements whose slip has just come to rest; rates up to @p
     * widening times rounding do not move them again.
     */
    Continuation
    solve(const JointState &state,
          const std::vector<BoundaryElement> &set,
          const Drive &drive,
          const std::vector<std::size_t> &resticking = {},
          const double widening                      = 1.);

    /**
     * Return the elements of @p set that give reason to look for further continuations: the
     * determinant of the present scheme changes its sign if one of them begins or ceases to slip.
     * Return all of them if the determinant is not positive. The cost is negligible compared with a
     * solution of the rate problem.
     */
    std::vector<std::size_t>
    critical_elements(const std::vector<BoundaryElement> &set);

    /**
     * Return false if it is certain that the continuation just found is the only one, or if that is
     * not known but nothing speaks against it. It is certain where the slips are monotone; where
     * not all elements of the set are slips of tangential bars the determinants are used.
     */
    bool
    may_have_others(const std::vector<BoundaryElement> &set, const Continuation &found);

    /**
     * Return the continuations with different rates. These are all of them if can_be_enumerated(),
     * otherwise those that Newton's method reaches from several beginnings. The one that the
     * present scheme describes, if it is one, comes first; the present scheme is restored.
     */
    std::vector<Branch>
    branches(const JointState &state, const std::vector<BoundaryElement> &set, const Drive &drive);

    /** Give the elements of @p set the states of a branch. */
    void
    take(const std::vector<BoundaryElement> &set, const Branch &branch)
    {
      for (std::size_t i = 0; i < set.size(); ++i)
        scheme.set_state(set[i].element, branch.states[i], branch.directions[i]);
    }

    /**
     * Find the motion that goes on at a load which may fall or stay: the rate problem with the load
     * rate λ̇ as an additional unknown and with a given amount of motion (doc/theory.md, section
     * 7). @p unit_load is the drive at λ̇ = 1. The working scheme takes the states that belong to
     * the motion.
     */
    ControlledContinuation
    solve_controlled(const JointState &state,
                     const std::vector<BoundaryElement> &set,
                     const Drive &unit_load);

    /**
     * Find the release of lost strength that no constant load allows: the load falls while that
     * part of its displacement which is due to opening and slip stays constant (doc/theory.md, eq.
     * 7b). The rates are those per unit of @p release.
     */
    ControlledContinuation
    solve_release(const JointState &state,
                  const std::vector<BoundaryElement> &set,
                  const Drive &release,
                  const Drive &unit_load);

    /** Return whether the directions of slip of @p set are given and its states have few enough
     * combinations to try them all. */
    bool
    can_be_enumerated(const std::vector<BoundaryElement> &set) const;

    /** Return whether the search tried all combinations of states of the set that was decided last.
     */
    bool
    is_small() const
    {
      return reduced.is_small();
    }

  private:
    struct Switch
    {
      std::size_t element;
      ContactState to;
    };

    std::vector<Switch>
    violations(const JointState &state,
               const std::vector<BoundaryElement> &set,
               const Drive &drive,
               const JointRates &rates) const;

    void
    take_background(const JointState &state, const std::vector<BoundaryElement> &set);
    bool
    take_states(const std::vector<BoundaryElement> &set, const ConeContinuation &found);
    /** Return the function by which the working scheme, which then has the states accepted, decides
     * on what the reduced problem finds, with @p checked as its result. It has the last word where
     * slips have given directions; in space the reduced problem has it, and there is no function.
     */
    ConeRateProblem::Accept
    acceptance(const JointState &state,
               const std::vector<BoundaryElement> &set,
               const Drive &drive,
               Continuation &checked);
    void
    note_active(const std::vector<BoundaryElement> &set, const JointRates &rates);
    void
    solve_reduced(const JointState &state,
                  const std::vector<BoundaryElement> &set,
                  const Drive &drive,
                  Continuation &result);
    ControlledContinuation
    solve_yielding(const JointState &state,
                   const std::vector<BoundaryElement> &set,
                   const Drive &drive,
                   const Drive &unit_load,
                   const ConeRateProblem::Control control);
    void
    measure_by_largest_jump(const Drive &unit_load, ControlledContinuation &motion) const;

    /** Switch states of the working scheme, by the method that @p result names; a search takes the
     * states as they are. */
    bool
    switch_states(const JointState &state,
                  const std::vector<BoundaryElement> &set,
                  const Drive &drive,
                  Continuation &result);
    /** Return the states and directions of the working scheme. */
    Branch
    present_branch(const std::vector<BoundaryElement> &set) const;
    void
    note_dissipation(const JointState &state, Branch &branch) const;
    std::vector<ContactState>
    states_of(const std::vector<BoundaryElement> &set) const;
    bool
    is_new(const std::vector<Branch> &known, const JointRates &rates, const Drive &drive) const;

    const std::vector<ContactElement> &elements;
    const LayeredSystem &system;
    WorkingScheme &scheme;
    WorkingScheme off_boundary;
    const bool in_space;
    ConeRateProblem reduced;
    /** The elements whose slip has just come to rest, and the factor for their noise. */
    std::vector<std::size_t> resting;
    double noise_at_rest = 1.;
  };
} // namespace fuga

#endif
