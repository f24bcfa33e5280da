// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_segments_turning_segment_h
#define fuga_contact_segments_turning_segment_h

#include <fuga/contact/segments/event_location.h>
#include <fuga/contact/segments/scheme_equilibrium.h>
#include <fuga/contact/segments/turning_stage.h>

namespace fuga
{
  /** Return whether an element slips along two tangents and carries shear, so that the direction of
   * slip may turn. */
  inline bool
  may_turn(const ContactElement &element, const JointState &state, const std::size_t k)
  {
    return is_slipping(state.states[k]) && element.has_second_tangential_bar() &&
           state.strengths[k].resists_shear();
  }

  /** The stages so far of a step that begins at τ. */
  struct SlipStages
  {
    double tau = -1., length = 0.;
    /** Rates of slip along the directions, and these directions. */
    std::vector<Vector> rates;
    std::vector<std::vector<TangentVector>> directions;
    /** The forces that slips with these rates take away per unit of τ, if they are constant
     * throughout. */
    std::vector<Vector> lost_forces;

    /** Return the rates of slip of stage number @p j along both tangents. */
    Vector
    velocity(const std::size_t j) const;
  };

  /**
   * The path in one working scheme with slips whose directions turn. All other elements form the
   * *background*, a working scheme in which the turning elements stick. It responds to their slips
   * s and the rise of their lips, if necessary as a nonlinear one that is linearised at every
   * stage. With it
   *
   *     T_i + (f_i N_i - c_i) e_i = 0,   ṡ_i = γ_i e_i      for all turning elements i
   *
   * is integrated by a singly diagonally implicit Runge-Kutta pair of order 5(4): its stages are
   * return mappings, its results are exactly on the cones, and slips that are long compared with f
   * N/k, with forces that follow them at once, do not shorten its steps. Nonlinear layers are
   * algebraic equations of every stage. Events are located on the steps themselves: a step that
   * passes one is repeated, shorter, until it ends there.
   */
  class TurningSegment : public PathSegment
  {
  public:
    /** Constructor. The scheme of @p context becomes that of the background. @p directions are
     * given for all elements; only those of the turning ones are used. */
    TurningSegment(const PathContext &context,
                   const Course &course,
                   const PathPoint &start,
                   const std::vector<TangentVector> &directions,
                   const PathOptions &options,
                   IterationCount &count);

    double
    find_end() override;
    PathPoint
    at(const double tau) override;
    std::vector<double>
    stations() const override;
    bool
    ends_at_limit() const override
    {
      return at_limit;
    }

    bool
    ends_at_turning_point() const override
    {
      return at_turning_point;
    }

    JointRates
    motion_at_limit() override;
    std::vector<std::size_t>
    resticking() const override;
    double
    energy_lost() override;

  private:
    /** A point of the curve with all data that steps and events need. */
    struct Station
    {
      double tau = 0.;
      PathPoint point;
      TurningStage stage;
      /** Rates of slip along the directions: first of the turning elements, then of those that slip
       * along one tangent. */
      Vector slip_rates;
      EventFunctions functions;
      /** Energy lost by the step to this point [MN m]. */
      double energy_lost = 0.;
    };

    void
    take_scales();
    TurningStage
    stage_at_start(const std::vector<TangentVector> &directions) const;
    void
    take_background();
    void
    take_strengths(const double tau, const JointState &state);
    bool
    take_response(const double tau, const TurningStage &stage, const JointState &state);
    void
    yield(const YieldingLoad &load, TurningResponse &response) const;
    void
    set_slips(const TurningStage &stage, JointState &state) const;
    bool
    settle(const double tau,
           const TurningStage &stage,
           JointState &state,
           const KnownForces *known);
    bool
    solve_stage(const TurningStageSolver::Demand demand,
                const double tau,
                const double advance,
                const TurningStage &base,
                const double slip_noise,
                const KnownForces &known,
                Vector &xi,
                TurningStage &stage,
                JointState &state);
    double
    force_noise(const JointState &state) const;
    bool
    complete(Station &station);
    bool
    find_rates(Station &station);
    Drive
    drive_of(const Station &station) const;
    void
    note_functions(Station &station) const;
    double
    driving_force() const;
    /** Return the load time, or the length of a path beyond a limit load, that others are compared
     * with. */
    double
    parameter_scale() const;
    bool
    loses_control(const Station &station) const;
    double
    error_of_rounding(const Station &from, const double shortest);
    /** Handle a point where even the shortest step fails. @throws PathFailure if the curve does not
     * end there. */
    void
    expect_end(const PathPoint &point, const double shortest);
    TurningStage
    base_of(const Station &from,
            const Vector &first_forces,
            const SlipStages &stages,
            const std::size_t k) const;
    void
    predict(const SlipStages &before,
            const std::size_t k,
            Vector &rates,
            std::vector<TangentVector> &directions) const;
    bool
    step(const Station &from, const double length, Station &to, double &error);
    double
    work_defect(const Station &from,
                const Station &to,
                const double length,
                const double work) const;
    double
    turn_defect(const Station &from, const Station &to, const double length) const;

    double
    rise_defect(const Station &from, const Station &to, const double length) const;
    bool
    grows_beyond_bounds(const double negligible_load, const double bend) const;
    std::optional<Station>
    step_from(const Station &from, const double tau);
    bool
    meet(const Station &from, Station &reached);
    std::optional<Station>
    locate(const Station &from, const Station &passed);
    bool
    turns_back(const double negligible_load) const;
    /** Return whether the load cannot grow by more than these parts of a stage, to a limit or to a
     * maximum; note which. */
    bool
    is_below_end_of_path(const double near_limit, const double near_maximum);
    std::vector<CurvePoint>
    points_of_curve() const;

    PathContext context;
    const Course course;
    const PathPoint start;
    /** Numbers of the turning elements, and of all elements that slip, the turning ones first. */
    std::vector<std::size_t> turning, slipping;
    /** tan ψ of the turning elements. */
    const Vector dilatancies;
    /** The start as the background sees it, with the turning elements stuck. */
    JointState stuck;
    /** True if the background responds linearly, everywhere along the segment in the same way. */
    const bool linear;
    const double step_tolerance, least_energy_loss;
    IterationCount &count;
    TurningStageSolver solver;
    SchemeEquilibrium equilibrium;
    const ReservesOfCurve reserves;
    /** Largest force and jump, which errors are relative to. */
    double force_scale = 0., jump_scale = 0.;
    /** Factor by which the last iteration about a nonlinear background brought its slips closer to
     * their end. */
    double contraction = 1.;
    bool at_limit = false, at_turning_point = false;
    double end = 0.;
    std::vector<Station> curve;
    /** The stages of the last step that was successful. */
    SlipStages last_stages;
    std::vector<std::size_t> lost_slip;
  };
} // namespace fuga

#endif
