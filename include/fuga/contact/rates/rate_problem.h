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
  /** The method by which the continuation was found; each method is tried when the one before has
   * failed. */
  enum class RateMethod
  {
    /** Keep the scheme, or switch all violating elements at once until none violates. */
    block_switching,
    /** Switch one element at a time, the one with the lowest index first. */
    single_switching,
    /** Try all combinations of a small boundary set. */
    enumeration,
    /** Apply the lexicographic Lemke method to the whole boundary set. */
    lemke,
    /** Use single switching from many first guesses and Lemke's method with several covering
     * vectors, then all combinations, divided until each of them is ruled out. */
    search
  };

  /** The result of the rate problem. */
  struct Continuation
  {
    /** If true, `rates` satisfy every rate inequality, and the working scheme has the states that
     * belong to them. */
    bool exists = false;
    JointRates rates;
    /** True if, beside a nonlinear layer, a motion that nothing resists rests in these rates; the
     * curve may not hold it. */
    bool rests = false;
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
    /** If nothing moves freely either, in space: a virtual motion that may show that no
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
    /** Directions of their slips, with two tangential bars. */
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

  struct BoundaryLcp;

  /**
   * Determines from rates how the joints go on, for all elements on a boundary at once:
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
     * guess. @p resticking lists the elements whose slip has just come to rest; with two tangential
     * bars, rates up to @p widening times rounding do not move them again.
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
     * otherwise those that are reached by switching from several schemes and by Lemke's method with
     * several covering vectors. The one that the present scheme describes, if it is one, comes
     * first; the present scheme is restored.
     */
    std::vector<Branch>
    branches(const JointState &state, const std::vector<BoundaryElement> &set, const Drive &drive);

    /** Give the elements of @p set the states of a branch. */
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

    /** Return whether the states of @p set have few enough combinations to try them all. With two
     * tangential bars, where directions of slip are all given, the answer is that for the set
     * decided last. */
    bool
    can_be_enumerated(const std::vector<BoundaryElement> &set) const;

    /** Return whether, with two tangential bars, the search tried all combinations of states of the
     * last set. */
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
      /** Like one_at_a_time, but where all else has failed; see rates_of_scheme(). */
      last_resort
    };
    /** Compute the rates of the scheme. Along a curve every point is a solution of its own, in
     * which a free motion that rests has to be held; it is not considered a mechanism only as a
     * @p last_resort. */
    std::optional<WorkingScheme::FreeMotion>
    rates_of_scheme(const Drive &drive, const bool last_resort = false);
    bool
    switch_states(const JointState &state,
                  const std::vector<BoundaryElement> &set,
                  const Drive &drive,
                  const Stride stride,
                  Continuation &result);
    /** Try all schemes until @p found returns true. */
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
    /** A function that returns whether switching from the present scheme ends in a continuation. */
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
    /** Search the remaining combinations when all else has failed; find a continuation or rule it
     * out. */
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
    /** Search for branches in addition to @p known, up to a total of @p n_wanted. */
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

  /** Return the states that an element on a boundary can take. */
  std::vector<ContactState>
  admissible_states(const BoundaryElement &element);
} // namespace fuga

#endif
