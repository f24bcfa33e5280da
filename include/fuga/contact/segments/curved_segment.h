// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_segments_curved_segment_h
#define fuga_contact_segments_curved_segment_h

#include <fuga/contact/segments/event_location.h>
#include <fuga/contact/segments/scheme_equilibrium.h>
#include <fuga/contact/segments/step_control.h>
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
    /** Work of the shear forces, integrated with the weights of the method [MN m]. */
    double work = 0.;

    /** Return the rates of slip of stage number @p j along both tangents. */
    Vector
    velocity(const std::size_t j) const;
  };

  /**
   * The path of a working scheme whose equations are not linear: its layers are nonlinear, its
   * friction is being reduced, or slips have directions that turn.
   *
   * Where no direction turns, every point of the curve is an equilibrium of its own, which is found
   * by a tangent predictor and an iterated corrector.
   *
   * Otherwise the elements that do not turn form the *background*, a working scheme in which the
   * turning elements stick. It responds to their slips s and the rise of their lips, if necessary
   * as a nonlinear one that is linearised at every stage. With it
   *
   *     T_i + (f_i N_i - c_i) e_i = 0,   ṡ_i = γ_i e_i      for all turning elements i
   *
   * is integrated by a singly diagonally implicit Runge-Kutta pair of order 5(4): its stages are
   * return mappings, its results are exactly on the cones, and slips that are long compared with f
   * N/k, with forces that follow them at once, do not shorten its steps. Nonlinear layers are
   * algebraic equations of every stage.
   *
   * Events are located on the steps themselves: a step that passes one is repeated, shorter, until
   * it ends there. All event functions are monitored at every point, so that none is skipped; the
   * loss of slip (re-stick) is one of them.
   */
  class CurvedSegment : public PathSegment
  {
  public:
    /** Constructor. @p directions are those of slip, given for all elements if some of them turn:
     * the scheme of @p context then becomes that of the background. Without them it is the scheme
     * of the path. */
    CurvedSegment(const PathContext &context,
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
      /** Its place, and the length of the step to it. */
      double tau = 0., length = 0.;
      PathPoint point;
      TurningStage stage;
      /** Rates of slip of the slipping elements along their directions. */
      Vector slip_rates;
      EventFunctions functions;
      /** Error of the step, relative to what is allowed, and energy lost by it [MN m]. */
      double error = 0., energy_lost = 0.;
    };

    /** How long the steps are. */
    struct Stepping
    {
      /** Least length of the first step, and shortest length of any. */
      double least_first = 0., shortest = 0.;
      /** Shortest part of a step, up to an event, that is measured like a step. */
      double shortest_part = 0.;
      /** Share by which a step that reaches the end of the course may be longer. */
      double stretch = 1.;
      /** The next step aims at an error that is this many times smaller than what is allowed. */
      double margin = 1.;
    };

    bool
    turns() const
    {
      return !turning.empty();
    }

    bool
    is_reduction() const
    {
      return course.share_rate != 0.;
    }

    Stepping
    stepping() const;
    void
    take_scales();
    TurningStage
    stage_at_start(const std::vector<TangentVector> &directions) const;
    void
    take_background();
    void
    take_strengths(const double tau, const JointState &state, const Vector &forces_of_turning);
    Vector
    forces_of_turning(const JointState &state) const;
    bool
    solve_stage_of_linear(const TurningStageSolver::Demand demand,
                          const double tau,
                          const double advance,
                          const TurningStage &base,
                          Vector &xi,
                          TurningStage &stage);
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
    double
    slip_noise(const PathPoint &point) const;
    bool
    complete(Station &station);
    std::optional<JointRates>
    rates_of_slips(Station &station);
    std::optional<JointRates>
    rates_without_turns(Station &station);
    bool
    find_rates(Station &station);
    Drive
    drive_of(const Station &station) const;
    void
    note_functions(Station &station) const;
    double
    driving_force() const;
    double
    size_of_jumps(const Vector &dislocations, const Vector &forces) const;
    /** Return the load time, or the length of a path beyond a limit load, that others are compared
     * with. */
    double
    parameter_scale() const;
    bool
    loses_control(const Station &station) const;
    double
    error_of_rounding(const Station &from);
    /** Return the end of the longest step that is accurate enough, beginning with @p length;
     * nothing if the curve ends with @p from. */
    std::optional<Station>
    take_step(const Station &from, StepControl &length);
    void
    append(Station &&station);
    bool
    is_resolved(const Station &from, Station &event) const;
    /** Handle a point where even the shortest step fails. @throws PathFailure if the curve does not
     * end there. */
    void
    expect_end(const PathPoint &point);
    [[noreturn]] void
    give_up() const;
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
    step(const Station &from, const double length, Station &to);
    bool
    step_of_turns(const Station &from, const double length, Station &to);
    bool
    step_without_turns(const Station &from, Station &to);
    double
    error_of_step(const Station &from, Station &to);
    double
    defect_of_cubics(const Station &from, Station &to) const;
    double
    work_defect(const Station &from, const Station &to) const;
    double
    turn_defect(const Station &from, const Station &to) const;
    double
    rise_defect(const Station &from, const Station &to) const;
    double
    strength_defect(const Station &from, const Station &to, const ContactBoundary &here) const;
    bool
    slips_back(const JointState &from, const JointState &to) const;
    bool
    grows_beyond_bounds(const double negligible_load, const double bend) const;
    std::optional<Station>
    step_from(const Station &from, const Station &near, const double tau, Vector &&guess);
    bool
    meet(const Station &from, const Station &before, Station &reached);
    std::vector<std::size_t>
    elements_on_boundary(const Station &station) const;
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
    const PathOptions::Iteration iteration;
    /** Numbers of the turning elements, and of all that slip against a shear force, the turning
     * ones first. */
    std::vector<std::size_t> turning, slipping;
    /** tan ψ of the turning elements. */
    const Vector dilatancies;
    /** The start as the background sees it, with the turning elements stuck. */
    JointState stuck;
    /** True if strengths are not linear in load and pressure: they are being reduced, or an
     * envelope is curved. */
    const bool strengths_bend;
    /** True if the background responds linearly, everywhere along the segment in the same way. */
    const bool linear;
    const double step_tolerance, least_energy_loss;
    const Stepping steps;
    IterationCount &count;
    TurningStageSolver solver;
    SchemeEquilibrium equilibrium;
    const ReservesOfCurve reserves;
    /** Sign of the determinant of the scheme at the start of a strength reduction. */
    const int determinant_sign;
    /** Largest force and jump, which errors are relative to. Where nothing turns the latter is that
     * of the points so far: all jumps may vanish at once, where all elements lift off or come down
     * together, and would then be no scale for themselves. */
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
