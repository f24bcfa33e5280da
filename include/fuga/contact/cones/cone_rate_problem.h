// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_cones_cone_rate_problem_h
#define fuga_contact_cones_cone_rate_problem_h

#include <fuga/contact/cones/cone_lcp.h>
#include <fuga/contact/cones/cone_program.h>
#include <fuga/contact/element/rate_law.h>
#include <fuga/contact/scheme/working_scheme.h>

#include <functional>
#include <optional>

namespace fuga
{
  /** The way in which a path goes on, according to ConeRateProblem. */
  struct ConeContinuation
  {
    bool exists = false;
    JointRates rates;
    /** States of the elements of the boundary set, in their order. */
    std::vector<ContactState> states;
    /** Unit slip directions of the elements among them that slip. */
    std::vector<TangentVector> directions;
    unsigned int n_schemes = 0;
    /** True if nothing exists because some motion meets no resistance. */
    bool has_mechanism = false;
    JointRates mechanism;
    /** If nothing exists: true if that is certain, since a proof rules out every combination of
     * states. */
    bool is_ruled_out = false;
    /** Otherwise: a virtual motion that may show that no rates exist, see find_barrier(). */
    std::optional<JointRates> barrier;
    /** The rate λ̇ of the load, where the load is an unknown. */
    double load_rate = 0.;
    /** Sign of the determinant of the scheme; it is negative beyond critical friction. */
    int determinant_sign = 0;
    /** True if only a search found it. */
    bool by_search = false;
  };

  /**
   * The rate problem of the boundary set alone (doc/theory.md, section 17). Let v be the rates of
   * dislocation and q = r - W v those of the bar forces: RateLaw tells what each element demands of
   * them. All other elements keep their rows in the working scheme.
   *
   * The problem is solved by a semismooth Newton method in the states and slip directions. If the
   * method cycles, it is restarted from the solution for a softer layer, from solutions for
   * associated friction, and from block Gauss-Seidel sweeps over the elements. Only results that
   * satisfy every condition are accepted.
   */
  class ConeRateProblem
  {
  public:
    ConeRateProblem(const std::vector<ContactElement> &elements, const LayeredSystem &system);

    /** A function that decides on states found: whether they, or those that they lead to, are a
     * solution; with @p as_they_are, whether they are. */
    using Accept = std::function<bool(const ConeContinuation &states, const bool as_they_are)>;

    /**
     * Solve the rate problem for the elements of @p set. In @p background these elements are stuck
     * and all others have their states. @p resticking lists the elements whose slip has just come
     * to rest; rates up to @p widening times rounding do not move them again. The search goes on
     * until @p accept, if it is given, accepts the states found.
     */
    ConeContinuation
    solve(const JointState &state,
          const std::vector<BoundaryElement> &set,
          WorkingScheme &background,
          const Drive &drive,
          const std::vector<std::size_t> &resticking,
          const double widening,
          const Accept &accept = {});

    /** Return whether it is certain that the last set has one solution, whatever the load
     * (doc/theory.md, section 17). */
    bool
    has_one_solution() const;

    /** Return whether the states of the last set have few enough combinations to try them all, with
     * directions that are not given solved for. */
    bool
    is_small() const;

    /** Return the solution with the given @p states and @p directions, if it is one, and the others
     * that a search finds; one of them may occur twice. If @p accept is given, it gets them, and
     * nothing is returned. */
    std::vector<ConeContinuation>
    all_solutions(const JointState &state,
                  const std::vector<BoundaryElement> &set,
                  WorkingScheme &background,
                  const Drive &drive,
                  const std::vector<ContactState> &states,
                  const std::vector<TangentVector> &directions,
                  const Accept &accept = {});

    /** The condition that determines the rate of a load that is an unknown. */
    enum class Control
    {
      /** Something moves; the scale of the rates is arbitrary. */
      motion,
      /** The displacement of the load that is due to the motion stays constant. */
      displacement
    };

    /** Solve the rate problem with a load that gives way: the rates are driven by @p drive and λ̇
     * times @p unit_load (doc/theory.md, eqs. 7a and 7b). */
    ConeContinuation
    solve_yielding(const JointState &state,
                   const std::vector<BoundaryElement> &set,
                   WorkingScheme &background,
                   const Drive &drive,
                   const Drive &unit_load,
                   const Control control);

  private:
    /** One element of the boundary set and its present answer. */
    struct Candidate : RateLaw, RateAnswer
    {
      using RateLaw::RateLaw;

      /** The first of its rows in the reduced system: n, then t1 and t2 if it may slip there. */
      std::size_t row = 0;
      /** True if its slip has just come to rest. */
      bool resting = false;
      /** What the working scheme takes for zero in the rates of its normal force and of its shear,
       * in the largest motion that is no mechanism. */
      double no_force = 0., no_shear = 0.;
    };

    /** A state that a candidate may take, and the direction of slip that it begins with. */
    struct Choice
    {
      ContactState state;
      TangentVector direction;
    };

    enum class Outcome
    {
      solved,
      singular,
      cycled
    };

    /** Number of schemes that are tried: first with all violations changed at once, then with the
     * worst one alone. */
    static constexpr unsigned int n_together = 25, n_iterations = 80;
    /** Number of combinations of states that are tried where the only alternative is not to know.
     */
    static constexpr double most_combinations_at_last = 1e5;

    /** The matrix W and the vector r of the boundary set, and the size of the terms in W. */
    struct ReducedSystem
    {
      DenseMatrix W;
      Vector r, diagonal;
    };

    /** Set up the reduced system of @p set. If there is none, @p result contains the mechanism. */
    void
    take_set(const JointState &state,
             const std::vector<BoundaryElement> &set,
             WorkingScheme &background,
             const Drive &drive,
             const std::vector<std::size_t> &resticking,
             ConeContinuation &result);
    /** Return the largest rates of dislocation that are not those of a mechanism. */
    JointRates
    largest_rates(const Drive &drive) const;
    /** Return whether the present states are accepted; without a function that decides, all are. */
    bool
    is_accepted(const bool as_they_are = false) const;
    /** Return whether the present answers lead to a solution: by the way that decides what is
     * accepted, if there is one, else by Newton's method. */
    bool
    settles(ConeContinuation &result);
    void
    take_solution(ConeContinuation &result) const;
    bool
    has_free_directions() const;
    std::vector<Choice>
    choices(const Candidate &candidate) const;
    std::vector<std::vector<Choice>>
    choices() const;
    static void
    take(const Choice &choice, Candidate &candidate);
    bool
    is_solution(ConeContinuation &result);
    void
    try_all(ConeContinuation &result, const std::function<bool()> &note);
    void
    try_guesses(ConeContinuation &result, const std::function<bool()> &note);
    /** Call @p note at every solution until it returns true; the candidates then keep that
     * solution. */
    bool
    search(ConeContinuation &result,
           const std::function<bool()> &note,
           const double most_combinations_tried = 0.);
    /** As a last resort, search for a solution. Return whether one was found; if not, @p result may
     * tell why. */
    bool
    find_another_way(WorkingScheme &background, const Drive &drive, ConeContinuation &result);
    /** Search and prove. This works only where all directions of slip are given. */
    bool
    search_with_proof(ConeContinuation &result);
    std::vector<ConeUnknown>
    unknowns_of(const std::vector<bool> &opened, const bool all_may_part) const;
    LcpNoise
    noise_of(const std::vector<ConeUnknown> &unknowns) const;
    /** Set up the problem in which the states of @p may_open are given. Return nothing if the
     * elements that open are without support. */
    std::optional<ConeLcp>
    problem_of(const std::vector<ConeUnknown> &unknowns,
               const std::vector<std::size_t> &may_open,
               const std::vector<bool> &opened) const;
    void
    take_answers(const std::vector<ConeUnknown> &unknowns,
                 const Vector &z,
                 const double share_of_nothing,
                 const std::vector<bool> &opened);
    /** Return the rates of dislocation that belong to z. */
    Vector
    motion_of(const std::vector<ConeUnknown> &unknowns, const Vector &z) const;
    /** Begin from the answers that Lemke's method gives with this covering vector. */
    bool
    pivot(const std::vector<ConeUnknown> &unknowns,
          const ConeLcp &problem,
          const Vector &shares,
          ConeContinuation &result);
    Outcome
    approach_by_pivoting(ConeContinuation &result);
    Outcome
    approach_from_present_states(ConeContinuation &result);
    bool
    pivot_from_many(ConeContinuation &result, const std::function<bool()> &note);
    Vector
    on_boundaries(const Vector &forces, const bool by_work) const;
    void
    yield(const ReducedSystem &given, const Vector &load, const Vector &weights, const double k);
    bool
    drive_by_spring(const ReducedSystem &given,
                    const Vector &load,
                    const bool by_work,
                    const double spring,
                    const Control control,
                    ConeContinuation &result);
    void
    take_softened(const ReducedSystem &stiff, const double softness);
    Outcome
    approach_from_softer_layer(ConeContinuation &result);
    DenseMatrix
    associated_motions(std::vector<ConeBlock> &blocks) const;
    Outcome
    approach_by_associated_slip(ConeContinuation &result);
    static void
    take_from_program(const ConeProgram::Place place,
                      const double strength,
                      const Vector &rates,
                      Candidate &candidate);
    /** Return whether the loads drive it beyond doubt. */
    bool
    find_mechanism(WorkingScheme &background, ConeContinuation &result);
    std::optional<JointRates>
    find_barrier(WorkingScheme &background, const Drive &drive) const;
    bool
    end_idle_motion();
    bool
    is_admissible(const Vector &motion) const;
    /** Return the power that growing loads and falling strengths, also that of friction where the
     * loads relieve it, exert on @p motion, per square of the path parameter; set @p size to the
     * sum of the sizes of its terms. */
    double
    driving_power(const Vector &motion, double &size) const;
    Outcome
    iterate(const unsigned int max_iterations, ConeContinuation &result);
    /** Compute the rates of the present scheme. Return false if something moves freely in it; weak
     * springs then hold it. */
    bool
    solve_scheme();
    bool
    update_scheme(const bool one_by_one);
    DemandedAnswer
    demand(const Candidate &candidate) const;
    bool
    is_settled() const;
    void
    slip_where_neutral();
    void
    sweep(const unsigned int n_sweeps);
    double
    own_stiffness(const std::size_t row) const;
    void
    relax(Candidate &candidate);
    void
    take_from_rates();
    void
    change_rate(const std::size_t row, const double change);
    void
    refresh_forces();
    static constexpr double rate_tolerance = ContactBoundary::RateNoise::share;
    double
    noise(const std::size_t row) const;
    /** Return the tangential rows of a candidate in @p values (v, q or the diagonal); the second
     * entry is zero if there is no such row. */
    static TangentVector
    tangential_rows(const Candidate &candidate, const Vector &values)
    {
      return {
        {values[candidate.row + 1], candidate.n_tangents == 2 ? values[candidate.row + 2] : 0.}};
    }
    /** Return the mean stiffness along the tangents; shear_noise() is the noise of the tangential
     * forces and the strength. */
    double
    shear_stiffness(const Candidate &candidate) const;
    double
    shear_noise(const Candidate &candidate) const;
    JointRates
    full_rates(WorkingScheme &background, const Drive &drive, const Vector &reduced) const;

    const std::vector<ContactElement> &elements;
    const LayeredSystem &system;
    /** The reduced system of the present boundary set. */
    std::vector<Candidate> candidates;
    std::vector<std::size_t> bars;
    /** False if something moves freely although the whole set is stuck. */
    bool has_system = false;
    DenseMatrix W;
    Vector r, v, q;
    /** The diagonal of the stiffness before bars were released, i.e. the size of the terms in W. */
    Vector diagonal;
    /** The null vector of the last singular scheme. */
    Vector free_motion;
    /** Sign of the determinant of the last scheme; 0 if that scheme is singular. */
    int determinant_sign = 0;
    /** The change of the rates in the last of those sweeps that did not come to rest. */
    Vector drift;
    /** The motion along the first ray with which Lemke's method has ended. */
    Vector ray;
    Accept accept;
    /** Multiple of the rounding errors that does not move elements which have just come to rest. */
    double noise_at_rest = 1.;
  };
} // namespace fuga

#endif
