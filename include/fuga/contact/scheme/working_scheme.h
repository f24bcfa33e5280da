// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_scheme_working_scheme_h
#define fuga_contact_scheme_working_scheme_h

#include <fuga/contact/scheme/scheme_memory.h>
#include <fuga/contact/system/updated_inverse.h>

#include <optional>

namespace fuga
{
  /** Which stiffness stands for a nonlinear layer in the matrix of the working scheme. */
  enum class LayerStiffness
  {
    /** dσ/dw at the present deformation: Newton, and the rates of the true path. */
    tangent,
    /** dσ/dw at zero deformation, A/ρ0: the constant matrix of the paper's iteration (3), (7). */
    initial
  };

  /** Which answers of a scheme count. */
  enum class SchemeAnswer
  {
    /** None that shows that it is a mechanism, see largest_motion. */
    of_no_mechanism,
    /** All that annul its defects, of motions that nothing resists as little as possible: for
     * rounding in a scheme in which the path has come so far. */
    of_any_size
  };

  /** What was done with the active matrix so far, by this object. */
  struct SchemeWork
  {
    /** Matrices factorised, and rows and columns inserted into or removed from an inverse. */
    std::size_t n_factorisations = 0;
    std::size_t n_updates        = 0;
    /** Bars whose dislocation has ever been an unknown, in a scheme that was tried at least. */
    std::size_t n_bars_ever_active = 0;
  };

  /**
   * The paper's working scheme: the states of all contact elements, and the linear system they
   * leave. A bar is *active* if its dislocation is unknown; its row then reads
   *
   *     open           N = 0            and   T = 0
   *     slip           T + σ f N = σ c A; along two tangents e·T + f N = c A, with d_t along e
   *     closed, nonlinear layer         N = N_law(g),   stuck:   T = T_law(jump - slip)
   *     slip with dilatancy             g = 0 above the risen lips
   *
   * with p = R a - W d, linearised (SchemeRow). Closed and stuck bars of a rigid or linear layer
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

    /** @p direction of slip counts where there are two tangential bars. */
    void
    set_state(const std::size_t element,
              const ContactState state,
              const TangentVector &direction = {{1., 0.}});

    /** A finite step begins: directions of slip turn, each by its @p compliances times the force
     * across it [m/MN] (append_rows()). Without numbers it ends. */
    void
    let_turn(const Vector &compliances);

    /** The direction in which an element slips; zero if it does not. */
    TangentVector
    slip_direction_of(const std::size_t element) const
    {
      return slip_direction(elements[element], states[element], directions[element]);
    }

    /** What is left of the strength of an element. */
    void
    set_strength(const std::size_t element, const Strength &strength);

    /** Some layer is nonlinear: paths are curves and matrices depend on the state. */
    bool
    is_nonlinear() const
    {
      return nonlinear;
    }

    /** Takes the stiffness of nonlinear bars from @p at. Without effect on linear layers. */
    void
    linearise(const JointState &at, const LayerStiffness stiffness = LayerStiffness::tangent);

    /**
     * The rates under @p drive and, if it is not empty, with rates of dislocation @p imposed on all
     * bars in addition; nothing if the scheme is a mechanism (or beyond critical friction).
     */
    std::optional<JointRates>
    rates(const Drive &drive, const Vector &imposed = {});

    /**
     * The stiffness of the scheme against dislocations imposed in some bars: entry (i, j) is what
     * bar @p of[i] loses of its force per unit of bar @p against[j] [MN/m]. Empty if the scheme is
     * a mechanism.
     */
    std::optional<DenseMatrix>
    stiffness(const std::vector<std::size_t> &of, const std::vector<std::size_t> &against);

    /** Counts a bar as active that is so beside the scheme. */
    void
    note_active(const std::size_t bar)
    {
      its_work.n_bars_ever_active += ever_active[bar] ? 0 : 1;
      ever_active[bar] = true;
    }

    /** The rates that a unit rate of imposed (additional) dislocation in one bar causes. */
    std::optional<JointRates>
    response(const std::size_t bar);

    /** Residuals of the active rows at a state [MN], in the order of the active bars. */
    Vector
    residual(const JointState &at);

    /**
     * One Newton step: the change of dislocations and forces that annuls the linearised residual.
     * The forces of the result are those of the linear relation p = R a - W d.
     */
    std::optional<JointRates>
    correction(const Vector &residual, const SchemeAnswer answer = SchemeAnswer::of_no_mechanism);

    /** How a drive sets a singular scheme in motion. */
    struct FreeMotion
    {
      JointRates rates;
      /** The drive works on a motion that nothing resists: only the signs of the rates mean
       * something. */
      bool is_driven = true;
      /** Such a motion is there, but rests: the rates are those of the scheme. */
      bool rests = false;
    };

    /** The rates under @p drive: a mechanism only if the drive works on a free motion. */
    std::optional<FreeMotion>
    motion(const Drive &drive)
    {
      if (std::optional<JointRates> found = rates(drive))
        return FreeMotion{std::move(*found), false};
      return driven_motion(drive);
    }

    /** A direction of motion without resistance of a singular scheme (null vector, largest entry
     * 1). */
    JointRates
    mechanism() const;

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

    /** Goes on where a scheme with the same bars and laws was.
     * @throws NumericalFailure if its matrix cannot be built again. */
    void
    restore(const SchemeMemory &memory);

    /**
     * Sign of the determinant of the active matrix; 0 if it is singular. Without friction it is
     * positive: W is positive definite wherever a scheme is no mechanism.
     */
    int
    determinant_sign();

    /**
     * The determinant after the tangential bar of @p element has taken the equation of state @p to,
     * over the present one; made dimensionless by W of that bar. Positive without friction.
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
     * Whether the slips of these elements, the rest of the scheme given, answer their reserves of
     * strength monotonically: xᵀMx > 0 for the matrix M of the rate problem (doc/theory.md, eq. 7).
     * Then it has one solution for every load. Nothing if the slip of one of them is not the work
     * of its tangential bar alone, or the inverse is not that of the present matrix.
     */
    std::optional<bool>
    is_monotone(const std::vector<SlipDirection> &slips);

  private:
    static constexpr std::size_t no_row = static_cast<std::size_t>(-1);

    std::vector<SchemeRow>
    wanted_rows() const;
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
    /** What a unit of the unknown of @p of does to the equation of @p row. */
    double
    entry(const SchemeRow &row, const SchemeRow &of) const;
    /** own · p, with the forces of all bars. */
    double
    forces_in(const SchemeRow &row, const double *forces) const;
    DenseMatrix
    active_matrix() const;
    /** The rates with a stiffness added, those with it taken back, and what share of the drive is
     * left unresisted then. */
    struct MotionBeside
    {
      JointRates first, refined;
      double unresisted = 1.;
    };
    /** @p added_stiffness in units of scale()². */
    std::optional<MotionBeside>
    motion_beside(const double added_stiffness,
                  const Vector &rhs,
                  const Vector &force_offset) const;
    /**
     * The rates of a singular scheme, with a stiffness added to every active bar that is too small
     * to matter where others resist. Nothing if even that has no solution.
     */
    std::optional<FreeMotion>
    driven_motion(const Drive &drive) const;
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
    /** What an imposed unit dislocation in a bar does to the equation of a row, as an unknown
     * would. */
    double
    imposed_entry(const SchemeRow &row, const std::size_t bar) const;
    /** M⁻¹ C; nothing if M is singular. */
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
    /** The largest defect of a row relative to its largest factor, in the units of
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
    /** See let_turn(); empty along a path. */
    Vector turning;
    UpdatedInverse inverse;
    /** Element of each bar. */
    std::vector<std::size_t> element_of_bar;
    /** Row of each bar, or no_row. */
    std::vector<std::size_t> position;
    std::vector<bool> ever_active;
    SchemeWork its_work;

    /** The path asks again, where an event changes the scheme, for the rates that led there. */
    struct Solution
    {
      Vector rhs, offset;
      JointRates result;
    };

    /** Of the scheme as it is. */
    std::optional<Solution> last_solution;
  };
} // namespace fuga

#endif
