// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_rate_problem_h
#define fuga_contact_rate_problem_h

#include <fuga/contact/contact_boundary.h>
#include <fuga/contact/working_scheme.h>

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
    lemke
  };

  /** What the rate problem found. */
  struct Continuation
  {
    /** True: `rates` satisfy every rate inequality, and the working scheme has the states that go
     * with them. */
    bool exists = false;
    JointRates rates;
    RateMethod method = RateMethod::block_switching;
    /** If none exists: the motion that meets the least resistance, if one was found. */
    bool has_mechanism = false;
    JointRates mechanism;
    /** Schemes tried. */
    unsigned int n_schemes = 0;
  };

  /**
   * Decides by rates, for all elements on a boundary at once, how the joints go on:
   *
   *     at the strength, σ = sign T:   0 ≤ σ ṡ  ⟂  (f|N|)˙ - σ Ṫ ≥ 0,
   *     N = 0 and gap = 0:             0 ≤ ġ   ⟂  -Ṅ ≥ 0,  with the same in both directions
   *
   * (doc/theory.md, section 4). All other elements keep their state.
   */
  class RateProblem
  {
  public:
    RateProblem(const std::vector<ContactElement> &elements,
                const LayeredSystem &system,
                WorkingScheme &scheme);

    /** Finds a continuation from @p state under @p drive; the states of the scheme are the first guess. */
    Continuation
    solve(const JointState &state, const std::vector<BoundaryElement> &set, const Drive &drive);

    /** Number of consistent continuations, by trying all; for boundary sets of at most
     * max_enumerated elements. */
    unsigned int
    count_continuations(const JointState &state,
                        const std::vector<BoundaryElement> &set,
                        const Drive &drive);

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

    ContactState
    state_on_closing(const JointState &state,
                     const BoundaryElement &candidate,
                     const JointRates &rates) const;

    enum class Stride
    {
      all_at_once,
      one_at_a_time
    };
    bool
    switch_states(const JointState &state,
                  const std::vector<BoundaryElement> &set,
                  const Drive &drive,
                  const Stride stride,
                  Continuation &result);
    unsigned int
    enumerate(const JointState &state,
              const std::vector<BoundaryElement> &set,
              const Drive &drive,
              const bool stop_at_first,
              Continuation &result);
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

    const std::vector<ContactElement> &elements;
    const LayeredSystem &system;
    WorkingScheme &scheme;
  };

  /** The states an element on a boundary can take. */
  std::vector<ContactState>
  admissible_states(const BoundaryElement &element);
} // namespace fuga

#endif
