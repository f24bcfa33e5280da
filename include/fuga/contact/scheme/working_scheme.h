// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_scheme_working_scheme_h
#define fuga_contact_scheme_working_scheme_h

#include <fuga/contact/scheme/scheme_memory.h>
#include <fuga/contact/system/updated_inverse.h>

#include <optional>

namespace fuga
{
  /** The stiffness that represents a nonlinear layer in the matrix of the working scheme. */
  enum class LayerStiffness
  {
    /** dσ/dw at the present deformation, for Newton's method and the rates of the true path. */
    tangent,
    /** dσ/dw at zero deformation, A/ρ0: the constant matrix of the paper's iteration (3), (7). */
    initial
  };

  /** Tells which solutions of a scheme are accepted. */
  enum class SchemeAnswer
  {
    /** All solutions except those which show that the scheme is a mechanism, see largest_motion. */
    of_no_mechanism,
    /** All solutions that annul the defects, with as little as possible of motions that nothing
     * resists: used to remove rounding in a scheme in which the path has come so far. */
    of_any_size
  };

  /** Work on the active matrix so far, done by this object. */
  struct SchemeWork
  {
    /** Number of matrices factorised, and of rows and columns inserted into or removed from an
     * inverse. */
    std::size_t n_factorisations = 0;
    std::size_t n_updates        = 0;
    /** Number of bars whose dislocation has ever been an unknown, at least in a scheme that was
     * tried. */
    std::size_t n_bars_ever_active = 0;
  };

  /**
   * The paper's working scheme: the states of all contact elements, and the linear system that
   * results from them. A bar is *active* if its dislocation is unknown; its row then reads
   *
   *     open           N = 0            and   T = 0
   *     slip           T + σ f N = σ c A; along two tangents e·T + f N = c A, with d_t along e;
   *                    f and c A are those of the strength's tangent if its envelope is curved
   *     closed, nonlinear layer         N = N_law(g),   stuck:   T = T_law(jump - slip)
   *     slip with dilatancy             g = 0 above the risen lips
   *
   * where p = R a - W d, linearised (SchemeRow). Closed and stuck bars of a rigid or linear layer
   * are not active. The inverse of the active matrix is updated when states change.
   */
  class WorkingScheme : private SchemeMemory
  {
  public:
    WorkingScheme(const std::vector<ContactElement> &elements, const LayeredSystem &system);

    ContactState
    state(const std::size_t element) const
    {
      return states[element];
    }

    const std::vector<ContactState> &
    all_states() const
    {
      return states;
    }

    /** Set the state of an element. The @p direction of slip is used where there are two tangential
     * bars. */
    void
    set_state(const std::size_t element,
              const ContactState state,
              const TangentVector &direction = {{1., 0.}});

    /** Begin a finite step: directions of slip turn, each by its entry of @p compliances times the
     * force across it [m/MN] (append_rows()). An empty vector ends the step. */
    void
    let_turn(const Vector &compliances);

    /** Return the direction in which an element slips; zero if it does not. */
    TangentVector
    slip_direction_of(const std::size_t element) const
    {
      return slip_direction(elements[element], states[element], directions[element]);
    }

    /** Set the remaining strength of an element. */
    void
    set_strength(const std::size_t element, const Strength &strength);

    /** Return whether some layer or envelope of strength is nonlinear: paths are then curves and
     * matrices depend on the state. */
    bool
    is_nonlinear() const
    {
      return nonlinear;
    }

    /** Set the stiffness of nonlinear bars, and the slopes of the strengths, to those at @p at.
     * This has no effect on linear ones. */
    void
    linearise(const JointState &at, const LayerStiffness stiffness = LayerStiffness::tangent);

    /**
     * Return the rates under @p drive, in addition with rates of dislocation @p imposed on all bars
     * if that vector is not empty. Return nothing if the scheme is a mechanism (or beyond critical
     * friction).
     */
    std::optional<JointRates>
    rates(const Drive &drive, const Vector &imposed = {});

    /**
     * Return the stiffness of the scheme against dislocations imposed in some bars: entry (i, j) is
     * the loss of the force of bar @p of[i] per unit of bar @p against[j] [MN/m]. It is empty if
     * the scheme is a mechanism.
     */
    std::optional<DenseMatrix>
    stiffness(const std::vector<std::size_t> &of, const std::vector<std::size_t> &against);

    /** Count a bar as active that is active outside of the scheme. */
    void
    note_active(const std::size_t bar)
    {
      its_work.n_bars_ever_active += ever_active[bar] ? 0 : 1;
      ever_active[bar] = true;
    }

    /** Return the rates caused by a unit rate of imposed (additional) dislocation in one bar. */
    std::optional<JointRates>
    response(const std::size_t bar);

    /** Return the residuals of the active rows at a state [MN], in the order of the active bars. */
    Vector
    residual(const JointState &at);

    /**
     * Compute one Newton step: the change of dislocations and forces that annuls the linearised
     * residual. The forces of the result are those of the linear relation p = R a - W d.
     */
    std::optional<JointRates>
    correction(const Vector &residual, const SchemeAnswer answer = SchemeAnswer::of_no_mechanism);

    /** The motion in which a drive sets a singular scheme. */
    struct FreeMotion
    {
      JointRates rates;
      /** True if the drive works on a motion that nothing resists; only the signs of the rates are
       * then meaningful. */
      bool is_driven = true;
      /** True if there is such a motion but it rests; the rates are then those of the scheme. */
      bool rests = false;
    };

    /** Return the rates under @p drive; they are a mechanism only if the drive works on a free
     * motion. */
    std::optional<FreeMotion>
    motion(const Drive &drive)
    {
      if (std::optional<JointRates> found = rates(drive))
        return FreeMotion{std::move(*found), false};
      return driven_motion(drive);
    }

    /** Return the motion without resistance in which @p drive sets a singular scheme (largest
     * entry 1); one of them if it drives none. */
    JointRates
    mechanism(const Drive &drive) const;

    const SchemeWork &
    work() const
    {
      return its_work;
    }

    const SchemeMemory &
    memory() const
    {
      return *this;
    }

    /**
     * Continue where a scheme with the same bars and laws was.
     * @throws NumericalFailure if its matrix cannot be built again.
     */
    void
    restore(const SchemeMemory &memory);

    /**
     * Return the sign of the determinant of the active matrix; 0 if it is singular. Without
     * friction it is positive: W is positive definite wherever a scheme is no mechanism.
     */
    int
    determinant_sign();

    /**
     * Return the determinant after the tangential bar of @p element has taken the equation of state
     * @p to, divided by the present one and made dimensionless by W of that bar. It is positive
     * without friction.
     */
    double
    determinant_ratio(const std::size_t element, const ContactState to);

    /** An element on its strength, and the direction in which it slips or would slip. */
    struct SlipDirection
    {
      std::size_t element;
      double sign;
    };

    /**
     * Return whether the slips of these elements, for the given rest of the scheme, change their
     * reserves of strength monotonically: xᵀMx > 0 for the matrix M of the rate problem
     * (doc/theory.md, eq. 7). The problem then has one solution for every load. Return nothing if
     * the slip of one of them is not due to its tangential bar alone, or if the inverse is not that
     * of the present matrix.
     */
    std::optional<bool>
    is_monotone(const std::vector<SlipDirection> &slips);

  private:
    static constexpr std::size_t no_row = static_cast<std::size_t>(-1);
    /** Stiffness that lets free motions rest, in units of scale()². */
    static constexpr double usual_addition = 1e-8;

    std::vector<SchemeRow>
    wanted_rows() const;
    void
    append_rows_of(const std::size_t element,
                   const ContactState in_state,
                   const std::optional<double> &turning_of_slip,
                   std::vector<SchemeRow> &to) const;
    bool
    has_row(const SchemeRow &row) const
    {
      return position[row.bar] != no_row && rows[position[row.bar]] == row;
    }

    void
    add_stuck_slips(const std::vector<SlipDirection> &slips,
                    const std::vector<std::size_t> &active,
                    const std::vector<std::size_t> &stuck,
                    DenseMatrix &M) const;
    std::optional<SchemeRow>
    tangential_row(const std::size_t element, const ContactState in_state) const;
    /** Return the effect of a unit of the unknown of @p of on the equation of @p row. */
    double
    entry(const SchemeRow &row, const SchemeRow &of) const;
    /** Return own · p, with @p forces of all bars. */
    double
    forces_in(const SchemeRow &row, const double *forces) const;
    DenseMatrix
    active_matrix() const;
    /** Return the forces in the rows, less @p rhs, while nothing answers. */
    Vector
    unbalanced_forces(const Vector &rhs, const Vector &force_offset) const;
    /** Return @p added_stiffness, in units of scale()², for a row [MN/m]. */
    double
    addition(const SchemeRow &row, const double added_stiffness) const;
    DenseMatrix
    matrix_with_addition(const double added_stiffness) const;
    /** The rates with a stiffness added, those with it removed again, and the share of the drive
     * that is then left unresisted. */
    struct MotionBeside
    {
      JointRates first, refined;
      double unresisted = 1.;
    };
    /** Compute this motion; @p added_stiffness is in units of scale()². */
    std::optional<MotionBeside>
    motion_beside(const double added_stiffness,
                  const Vector &rhs,
                  const Vector &force_offset) const;
    /**
     * Return the rates of a singular scheme, with a stiffness added to every active bar that is too
     * small to matter where others resist. Return nothing if even that has no solution.
     */
    std::optional<FreeMotion>
    driven_motion(const Drive &drive) const;
    /** Return the unknowns of the motion of mechanism(); nothing if the drive works on none. */
    Vector
    free_motion_along(const Drive &drive) const;
    Vector
    drives_of_rows(const Drive &drive) const;
    bool
    bring_up_to_date();
    void
    take_layer_stiffness(const std::vector<SchemeRow> &wanted);
    bool
    update_rows(const std::vector<SchemeRow> &wanted);
    bool
    remove_row(const std::size_t i);
    bool
    append_row(const SchemeRow &row);
    void
    set_rows(const std::vector<SchemeRow> &new_rows);
    bool
    rebuild();
    void
    note_position(const std::size_t row);
    /** Return the effect of an imposed unit dislocation in a bar on the equation of a row, as if it
     * were an unknown. */
    double
    imposed_entry(const SchemeRow &row, const std::size_t bar) const;
    /** Return M⁻¹ C; nothing if M is singular. */
    std::optional<DenseMatrix>
    solve_all(const DenseMatrix &C);
    std::optional<JointRates>
    solve(const Vector &rhs,
          Vector force_offset,
          const SchemeAnswer answer = SchemeAnswer::of_no_mechanism);
    template <typename Number>
    double
    refine(const Vector &rhs,
           const Vector &force_offset,
           const double driving_force,
           JointRates &result) const;
    /** Return the largest defect of a row relative to its largest factor, in the units of
     * LayeredSystem::scale(). */
    double
    defect_of_layers(const Vector &rhs, const JointRates &rates) const;
    template <typename Number>
    double
    apply(const std::vector<Number> &active_dislocations,
          const Vector &force_offset,
          const Vector &rhs,
          JointRates &result,
          Vector &defect) const;

    const std::vector<ContactElement> &elements;
    const LayeredSystem &system;
    bool nonlinear = false;
    /** Compliances of let_turn(); empty along a path. */
    Vector turning;
    UpdatedInverse inverse;
    /** Element of each bar. */
    std::vector<std::size_t> element_of_bar;
    /** Row of each bar, or no_row. */
    std::vector<std::size_t> position;
    std::vector<bool> ever_active;
    SchemeWork its_work;

    /** A solution that is stored because the path asks again, where an event changes the scheme,
     * for the rates that led there. */
    struct Solution
    {
      Vector rhs, offset;
      JointRates result;
    };

    /** The last solution of the scheme as it is. */
    std::optional<Solution> last_solution;
  };
} // namespace fuga

#endif
