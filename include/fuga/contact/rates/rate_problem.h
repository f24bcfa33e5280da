// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_rates_rate_problem_h
#define fuga_contact_rates_rate_problem_h

#include <fuga/contact/cones/cone_rate_problem.h>
#include <fuga/contact/element/contact_boundary.h>
#include <fuga/contact/scheme/working_scheme.h>

#include <functional>

namespace fuga
{
  /** How the continuation was found; every next one is tried when the one before failed. */
  enum class RateMethod
  {
    /** The scheme as it was, or with all violating elements switched at once until none violates.
     */
    block_switching,
    /** One element at a time, lowest index first. */
    single_switching,
    /** All combinations of a small boundary set. */
    enumeration,
    /** Lexicographic Lemke on the whole boundary set. */
    lemke,
    /** Single switching from many first guesses and Lemke with several covering vectors, then all
     * combinations, divided until each is ruled out. */
    search
  };

  /** What the rate problem found. */
  struct Continuation
  {
    /** True: `rates` satisfy every rate inequality, and the working scheme has the states that go
     * with them. */
    bool exists = false;
    JointRates rates;
    /** Beside a nonlinear layer a motion that nothing resists rests in them: the curve may not hold
     * it. */
    bool rests = false;
    /** Elements lose strength as they take these states: the rates do not hold. */
    bool costs_strength = false;
    RateMethod method   = RateMethod::block_switching;
    /** If none exists: that is certain, since a proof rules out every combination of states. */
    bool is_ruled_out = false;
    /** If none exists: the motion that meets the least resistance, if one was found. */
    bool has_mechanism = false;
    JointRates mechanism;
    /** In space, if nothing moves freely either: a virtual motion that may show that none exists.
     */
    std::optional<JointRates> barrier;
    /** Continuations known. */
    std::size_t n_branches = 1;
    /** Schemes tried. */
    unsigned int n_schemes = 0;
    /** One of them had a negative determinant. */
    bool met_negative_determinant = false;
  };

  /** One of several ways in which the joints can go on. */
  struct Branch
  {
    /** States of the boundary elements. */
    std::vector<ContactState> states;
    /** With two tangential bars, those of their slips. */
    std::vector<TangentVector> directions;
    JointRates rates;
    /** Sign of the determinant of its scheme: negative beyond critical friction. */
    int determinant_sign = 0;
    /** Σ T ṡ [MN m per unit of the path]. */
    double dissipation = 0.;
    /** Σ Ṫ ṡ: decides between branches that leave from the apex of the cone, where T = 0. */
    double dissipation_growth = 0.;
  };

  /** How the joints go on beyond a limit load, where the load is no longer given. */
  struct ControlledContinuation
  {
    bool exists = false;
    /** Per unit of the largest jump [m]. */
    JointRates rates;
    /** Rate of the load time per unit of the largest jump [1/m]: zero on a plateau, negative where
     * the load falls. */
    double load_rate = 0.;
  };

  struct BoundaryLcp;

  /**
   * Decides by rates, for all elements on a boundary at once, how the joints go on:
   *
   *     at the strength, σ = sign T:   0 ≤ σ ṡ  ⟂  (f|N|)˙ - σ Ṫ ≥ 0,
   *     N = 0 and gap = 0:             0 ≤ ġ   ⟂  -Ṅ ≥ 0,  with the same in both directions
   *
   * (doc/theory.md, section 4). All other elements keep their state. Where elements have two
   * tangential bars, ConeRateProblem decides.
   */
  class RateProblem
  {
  public:
    RateProblem(const std::vector<ContactElement> &elements,
                const LayeredSystem &system,
                WorkingScheme &scheme);

    /** With two tangential bars: the scheme in which all elements of the boundary set are stuck. */
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
     * Finds a continuation from @p state under @p drive; the states of the scheme are the first
     * guess. @p resticking: elements whose slip has just come to rest; with two tangential bars,
     * what is @p widening times rounding does not move them again.
     */
    Continuation
    solve(const JointState &state,
          const std::vector<BoundaryElement> &set,
          const Drive &drive,
          const std::vector<std::size_t> &resticking = {},
          const double widening                      = 1.);

    /**
     * Elements of @p set that give reason to look for further continuations: the determinant of the
     * present scheme changes its sign if one of them begins or ceases to slip. All of them if the
     * determinant is not positive. Costs nothing beside a solution of the rate problem.
     */
    std::vector<std::size_t>
    critical_elements(const std::vector<BoundaryElement> &set);

    /**
     * False if it is certain that the continuation just found is the only one, or if nothing speaks
     * against it where that is not known. Certain where the slips are monotone; where not all of
     * the set are slips of tangential bars the determinants are asked.
     */
    bool
    may_have_others(const std::vector<BoundaryElement> &set, const Continuation &found);

    /**
     * Continuations with different rates. All of them if can_be_enumerated(), otherwise those that
     * switching from several schemes and Lemke's method with several
     * covering vectors reach. The one that the present scheme describes, if it is one, comes first;
     * the present scheme is restored.
     */
    std::vector<Branch>
    branches(const JointState &state, const std::vector<BoundaryElement> &set, const Drive &drive);

    /** Gives the elements of @p set the states of a branch. */
    void
    take(const std::vector<BoundaryElement> &set, const Branch &branch)
    {
      for (std::size_t i = 0; i < set.size(); ++i)
        scheme.set_state(set[i].element,
                         branch.states[i],
                         branch.directions.empty() ? TangentVector{{1., 0.}}
                                                   : branch.directions[i]);
    }

    /**
     * The motion that goes on at a load which may fall or stay: the rate problem with the load rate
     * λ̇ as one more unknown and the amount of motion as given (doc/theory.md, section 7). @p
     * unit_load drives at λ̇ = 1. The working scheme takes the states that go with it.
     */
    ControlledContinuation
    solve_controlled(const JointState &state,
                     const std::vector<BoundaryElement> &set,
                     const Drive &unit_load);

    /**
     * The release of lost strength that no constant load allows: the load falls while that part of
     * its displacement which is due to opening and slip stands still (doc/theory.md, eq. 7b). The
     * rates are those per unit of @p release.
     */
    ControlledContinuation
    solve_release(const JointState &state,
                  const std::vector<BoundaryElement> &set,
                  const Drive &release,
                  const Drive &unit_load);

    /** The states of @p set have few enough combinations to try all. With two tangential bars, where
     * directions of slip are all given, that is so for the set decided last. */
    bool
    can_be_enumerated(const std::vector<BoundaryElement> &set) const;

    /** With two tangential bars, the search tried all combinations of states of the last set. */
    bool
    is_small() const
    {
      return cones.is_small();
    }

    static constexpr std::size_t max_enumerated = 6;

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
    take_cones(const std::vector<BoundaryElement> &set, const ConeContinuation &found);
    ControlledContinuation
    solve_yielding_cones(const JointState &state,
                         const std::vector<BoundaryElement> &set,
                         const Drive &drive,
                         const Drive &unit_load,
                         const ConeRateProblem::Control control);
    void
    measure_by_largest_jump(const Drive &unit_load, ControlledContinuation &motion) const;

    Continuation
    solve_cones(const JointState &state,
                const std::vector<BoundaryElement> &set,
                const Drive &drive,
                const std::vector<std::size_t> &resticking,
                const double widening);

    ContactState
    state_on_closing(const JointState &state,
                     const BoundaryElement &candidate,
                     const JointRates &rates) const;

    enum class Stride
    {
      all_at_once,
      one_at_a_time,
      /** The same where all else has failed: rates_of_scheme(). */
      last_resort
    };
    /** Along a curve every point is a solution of its own, in which a free motion that rests has to
     * be held: only as a @p last_resort it is no mechanism. */
    std::optional<WorkingScheme::FreeMotion>
    rates_of_scheme(const Drive &drive, const bool last_resort = false);
    bool
    switch_states(const JointState &state,
                  const std::vector<BoundaryElement> &set,
                  const Drive &drive,
                  const Stride stride,
                  Continuation &result);
    /** Tries all schemes until @p found returns true. */
    template <typename Found>
    bool
    enumerate(const JointState &state,
              const std::vector<BoundaryElement> &set,
              const Drive &drive,
              Continuation &result,
              const Found &found);
    std::optional<BoundaryLcp>
    boundary_lcp(const JointState &state,
                 const std::vector<BoundaryElement> &set,
                 const Drive &drive,
                 Continuation &result);
    void
    take_states(const BoundaryLcp &lcp, const std::vector<BoundaryElement> &set, const Vector &z);
    bool
    respond(const JointState &state,
            const std::size_t k,
            const ContactState unknown,
            JointRates &response);
    bool
    complementarity(const JointState &state,
                    const std::vector<BoundaryElement> &set,
                    const Drive &drive,
                    Continuation &result);
    /** Whether switching from the present scheme ends in a continuation. */
    using Guess = std::function<bool()>;
    void
    guess_by_resistance(const BoundaryLcp &lcp,
                        const std::vector<BoundaryElement> &set,
                        const Guess &guess);
    void
    guess_by_cones(const JointState &state,
                   const std::vector<BoundaryElement> &set,
                   const Drive &drive,
                   const std::vector<std::size_t> &resticking,
                   const Guess &guess);
    /** Searches what is left when all else has failed; finds a continuation or rules it out. */
    void
    search_all(const JointState &state,
               const std::vector<BoundaryElement> &set,
               const Drive &drive,
               const std::vector<std::size_t> &resticking,
               Continuation &result);

    std::vector<Branch>
    branches_of_cones(const JointState &state,
                      const std::vector<BoundaryElement> &set,
                      const Drive &drive);
    void
    note_dissipation(const JointState &state, Branch &branch) const;
    Branch
    present_branch(const JointState &state,
                   const std::vector<BoundaryElement> &set,
                   const JointRates &rates);
    void
    set_states(const std::vector<BoundaryElement> &set, const std::vector<ContactState> &states);
    std::vector<ContactState>
    states_of(const std::vector<BoundaryElement> &set) const;
    bool
    is_new(const std::vector<Branch> &known, const JointRates &rates, const Drive &drive) const;
    std::vector<std::vector<ContactState>>
    first_guesses(const std::vector<BoundaryElement> &set);
    /** Adds to @p known, up to @p n_wanted. */
    std::vector<Branch>
    search_branches(const JointState &state,
                    const std::vector<BoundaryElement> &set,
                    const Drive &drive,
                    const std::vector<Branch> &known,
                    const std::size_t n_wanted);

    const std::vector<ContactElement> &elements;
    const LayeredSystem &system;
    WorkingScheme &scheme;
    WorkingScheme off_boundary;
    const bool has_cones;
    ConeRateProblem cones;
  };

  /** The states an element on a boundary can take. */
  std::vector<ContactState>
  admissible_states(const BoundaryElement &element);
} // namespace fuga

#endif
