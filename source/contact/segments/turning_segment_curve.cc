// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/numerics/blas.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/segments/course.h>
#include <fuga/contact/segments/implicit_runge_kutta.h>
#include <fuga/contact/segments/layer_work.h>
#include <fuga/contact/segments/step_control.h>
#include <fuga/contact/segments/turning_segment.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Return the value at @p x of the Lagrange polynomial that is one at the abscissa of stage
     * @p j and zero at those of the other stages from @p first up to but not including @p last. */
    double
    lagrange(const std::size_t first, const std::size_t last, const std::size_t j, const double x)
    {
      const auto &c = runge_kutta::abscissae;
      double result = 1.;
      for (std::size_t m = first; m < last; ++m)
        if (m != j)
          result *= (x - c[m]) / (c[j] - c[m]);
      return result;
    }

    /** Evaluate, at the share @p x of a step, the polynomial through the stages of @p given
     * beginning with @p first. */
    void
    interpolate(const SlipStages &given,
                const std::size_t first,
                const double x,
                Vector &rates,
                std::vector<TangentVector> &directions)
    {
      std::fill(rates.begin(), rates.end(), 0.);
      std::fill(directions.begin(), directions.end(), TangentVector{{0., 0.}});
      for (std::size_t j = first; j < given.rates.size(); ++j)
        {
          const double weight = lagrange(first, given.rates.size(), j, x);
          for (std::size_t i = 0; i < rates.size(); ++i)
            {
              rates[i] += weight * given.rates[j][i];
              for (std::size_t a = 0; a < 2; ++a)
                directions[i][a] += weight * given.directions[j][i][a];
            }
        }
      for (std::size_t i = 0; i < directions.size(); ++i)
        {
          const double size = fuga::length(directions[i]);
          if (size > 0.5)
            directions[i] = {{directions[i][0] / size, directions[i][1] / size}};
          else
            directions[i] = given.directions.back()[i];
        }
    }

    /** Return whether the force of an element lies on the other side of its cone than @p before,
     * against its slip: a second solution of eq. 30, to which no path leads. */
    bool
    is_across_cone(const std::vector<TangentVector> &before,
                   const std::vector<TangentVector> &directions,
                   const Vector &xi)
    {
      for (std::size_t i = 0; i < xi.size(); ++i)
        if (xi[i] < 0. && dot(before[i], directions[i]) < 0.)
          return true;
      return false;
    }

    Vector
    products(const Vector &a, const Vector &b)
    {
      Vector result(a.size());
      std::transform(a.begin(), a.end(), b.begin(), result.begin(), std::multiplies<>());
      return result;
    }

    /** Return an initial guess of the dislocations of stage number @p k: the polynomial that starts
     * with the rates at the beginning of the step and leads through the (at most three) stages
     * before. */
    Vector
    predicted_dislocations(const std::size_t k,
                           const double length,
                           const PathPoint &from,
                           const std::vector<Vector> &stages)
    {
      const auto &c           = runge_kutta::abscissae;
      const std::size_t first = std::max<std::size_t>(1, k > 3 ? k - 3 : 0);
      Vector result           = from.state.dislocations;
      blas::axpy(result.size(), c[k] * length, from.rates.dislocations.data(), result.data());
      for (std::size_t j = first; j < k; ++j)
        {
          const double weight = (c[k] * c[k]) / (c[j] * c[j]) * lagrange(first, k, j, c[k]);
          for (std::size_t bar = 0; bar < result.size(); ++bar)
            result[bar] += weight * (stages[j][bar] - from.state.dislocations[bar] -
                                     c[j] * length * from.rates.dislocations[bar]);
        }
      return result;
    }
  } // namespace

  // The first guess for stage number k is the parabola through the three stages before, or fewer;
  // for a step that begins where the last one began, and is no longer, it is the polynomial through
  // all stages of that one.
  void
  TurningSegment::predict(const SlipStages &before,
                          const std::size_t k,
                          Vector &rates,
                          std::vector<TangentVector> &directions) const
  {
    const double abscissa = runge_kutta::abscissae[k];
    const double x        = abscissa * before.length / last_stages.length;
    if (last_stages.tau == before.tau && x <= 1.)
      interpolate(last_stages, 0, x, rates, directions);
    else
      interpolate(before, k > 3 ? k - 3 : 0, abscissa, rates, directions);
  }

  // The result contains the slips and rises from which stage number k goes on by its own rates.
  // Where the background is linear the forces that belong to them follow from those of the stages
  // before, without a product.
  TurningStage
  TurningSegment::base_of(const Station &from,
                          const Vector &first_forces,
                          const SlipStages &stages,
                          const std::size_t k) const
  {
    namespace rk        = runge_kutta;
    TurningStage result = from.stage;
    for (std::size_t j = 0; j < k; ++j)
      {
        const double weight   = stages.length * rk::weights[k][j];
        const Vector velocity = stages.velocity(j);
        add_scaled(velocity.size(), weight, velocity.data(), result.slips.data());
        add_multiple(weight, products(stages.rates[j], dilatancies), result.dilations);
      }
    if (!linear)
      return result;
    result.forces = first_forces;
    add_multiple(rk::abscissae[k] * stages.length, solver.load_rates(), result.forces);
    for (std::size_t j = 0; j < k; ++j)
      add_multiple(-stages.length * rk::weights[k][j], stages.lost_forces[j], result.forces);
    return result;
  }

  // This is one step of the Runge-Kutta pair. The error is relative to the tolerance.
  bool
  TurningSegment::step(const Station &from, const double length, Station &to, double &error)
  {
    namespace rk        = runge_kutta;
    const std::size_t n = turning.size();
    const auto power    = [&](const TurningStage &stage, const Vector &slip_rates) {
      double sum = 0.;
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t a = 0; a < 2; ++a)
          sum += stage.forces[3 * i + 1 + a] * slip_rates[2 * i + a];
      return sum;
    };

    // Where nothing drives, nothing slips.
    const double drive = driving_force();
    const double slip_noise =
      drive > 0. ? force_noise(from.point.state) * max_abs(from.point.rates.dislocations) / drive
                 : 0.;
    // On the way forces are computed from the last ones; those of the result are not.
    const KnownForces known =
      linear ? KnownForces() : known_forces(context, course, from.tau, from.point.state);
    JointState &state = to.point.state;
    state             = from.point.state;
    to.stage          = from.stage;
    Vector xi(from.slip_rates.begin(), from.slip_rates.begin() + static_cast<std::ptrdiff_t>(n));
    SlipStages stages = {from.tau, length, {xi}, {from.stage.directions}, {}};
    if (linear)
      stages.lost_forces.push_back(
        solver.resistance(stages.velocity(0), products(xi, dilatancies)));
    const Vector first_forces = linear ? solver.forces_at(from.tau, from.stage) : Vector();
    double work = length * rk::weights.back()[0] * power(from.stage, stages.velocity(0));
    std::vector<Vector> stage_dislocations = {from.point.state.dislocations};
    for (std::size_t k = 1; k < rk::n_stages; ++k)
      {
        const TurningStage base = base_of(from, first_forces, stages, k);
        predict(stages, k, xi, to.stage.directions);
        for (double &value : xi)
          value *= length * rk::diagonal;
        // Stages are on the cones by their rates alone, so that the method keeps its order (as a
        // method for a differential-algebraic system it would lose it); the last one, the result,
        // is there exactly.
        const auto demand  = k + 1 < rk::n_stages ? TurningStageSolver::Demand::rates
                                                  : TurningStageSolver::Demand::cone;
        state.dislocations = predicted_dislocations(k, length, from.point, stage_dislocations);
        if (!solve_stage(demand,
                         from.tau + rk::abscissae[k] * length,
                         length * rk::diagonal,
                         base,
                         slip_noise,
                         known,
                         xi,
                         to.stage,
                         state) ||
            is_across_cone(from.stage.directions, to.stage.directions, xi))
          return false;
        stages.rates.push_back(xi);
        for (double &value : stages.rates.back())
          value /= length * rk::diagonal;
        stages.directions.push_back(to.stage.directions);
        if (linear)
          {
            stages.lost_forces.push_back(base.forces);
            add_multiple(-1., to.stage.forces, stages.lost_forces.back());
            for (double &force : stages.lost_forces.back())
              force /= length * rk::diagonal;
          }
        stage_dislocations.push_back(state.dislocations);
        work += length * rk::weights.back()[k] * power(to.stage, stages.velocity(k));
      }
    last_stages = std::move(stages);
    to.tau      = from.tau + length;
    if (course.length - to.tau < 4. * std::numeric_limits<double>::epsilon() * course.length)
      to.tau = course.length;
    if (!complete(to))
      return false;

    Vector difference(2 * n, 0.), of_rises(n, 0.);
    for (std::size_t k = 0; k < rk::n_stages; ++k)
      {
        const double weight = length * (rk::weights.back()[k] - rk::embedded[k]);
        add_multiple(weight, last_stages.velocity(k), difference);
        add_multiple(weight, products(last_stages.rates[k], dilatancies), of_rises);
      }
    error = std::max(max_abs(difference) / (step_tolerance * jump_scale + slip_noise),
                     max_abs(solver.resistance(difference, of_rises)) /
                       (step_tolerance * force_scale + force_noise(to.point.state)));
    error = std::max({error,
                      work_defect(from, to, length, work),
                      turn_defect(from, to, length),
                      rise_defect(from, to, length)});
    if (context.scheme.is_nonlinear())
      {
        const StepEnergy energy =
          energy_of_step(context, course, from.point, to.point, length, to.tau, count);
        to.energy_lost = energy.lost;
        error          = std::max(error, energy_defect(energy, least_energy_loss, count));
      }
    return std::isfinite(error);
  }

  // A boundary that is a few shortest steps ahead is met where the curve ends: of elements that
  // reach it together one may be a rounding error after the others. Slips that grow beyond bounds
  // although something resists them go on after a jump.
  void
  TurningSegment::expect_end(const PathPoint &point, const double shortest)
  {
    constexpr double just_ahead = 10., bend_at_last = 2. * bend_of_limit;
    if (is_below_end_of_path(near_enough, near_enough))
      return;
    at_limit = !course.yielding && grows_beyond_bounds(near_enough, bend_at_last);
    at_turning_point =
      !course.yielding && !at_limit &&
      rates_diverge(points_of_curve(), 1, near_enough * std::max(1., course.t_end), bend_at_last);
    if (!at_limit && !at_turning_point &&
        context.boundary.distance(point.state, point.rates, course.drive) >= just_ahead * shortest)
      throw PathFailure(fmt::format(
        "The path cannot be followed beyond load time {}: even the shortest step fails.",
        point.state.t));
  }

  double
  TurningSegment::find_end()
  {
    end                   = 0.; // as far as the curve is known, if a step fails
    const double shortest = 1e-13 * parameter_scale(), short_step = 1e-7 * parameter_scale();
    // Parts of a stage by which the path may end below a limit, or a maximum of the load, if it can
    // be followed.
    constexpr double near_limit = 1e-8, near_maximum = 1e-9;
    StepControl length(first_step(context, course, start, 1e-6 * course.length));
    double allowed  = 1.; // error, as far as it is rounding at the present point
    bool is_known   = course.length <= 2. * shortest;
    double rejected = no_boundary; // error of a longer step from the present point
    while (curve.back().tau < course.length)
      {
        Station from = curve.back();
        check_number_of_steps(curve.size(), from.point.state.t);
        length.limit(course.length - from.tau);
        if (is_below_end_of_path(near_limit, near_maximum) || loses_control(from))
          break;
        if (length() < shortest && course.length - from.tau > shortest)
          {
            expect_end(from.point, shortest);
            break;
          }
        Station to;
        double error = 0.;
        if (!step(from, length(), to, error))
          {
            length.fail();
            continue;
          }
        // An error that a shorter step has left unchanged is rounding.
        if (error > allowed && !is_known && (length() < short_step || error > 0.5 * rejected))
          {
            allowed  = error_of_rounding(from, shortest);
            is_known = true;
          }
        error /= allowed;
        if (error > 1.)
          {
            rejected = error;
            length.reject(error);
            continue;
          }
        if (first_event(from.functions, to.functions, to.tau - from.tau) <= 1.)
          if (std::optional<Station> event = locate(from, to))
            {
              if (event->tau > from.tau)
                curve.push_back(std::move(*event));
              break;
            }
        const bool is_event = meet(from, to);
        curve.push_back(std::move(to));
        if (is_event)
          break;
        allowed  = 1.;
        is_known = false;
        rejected = no_boundary;
        length.accept(error, allowed == 1.);
      }
    // An event may come just before the maximum.
    at_turning_point =
      at_turning_point || (!course.yielding && !at_limit && turns_back(near_maximum));
    return end = curve.back().tau;
  }
} // namespace fuga
