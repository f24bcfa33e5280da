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
#include <limits>

namespace fuga
{
  namespace
  {
    /** Rate of slip, relative to the largest rate of dislocation, that is none. */
    constexpr double no_slip_rate = 1e-10;

    /** At stage number @p k the Lagrange polynomial that is one at stage @p j and zero at the others
     * from @p first to k - 1. */
    double
    lagrange(const std::size_t first, const std::size_t j, const std::size_t k)
    {
      const auto &c = runge_kutta::abscissae;
      double result = 1.;
      for (std::size_t m = first; m < k; ++m)
        if (m != j)
          result *= (c[k] - c[m]) / (c[j] - c[m]);
      return result;
    }

    /** First guess for stage number @p k: the parabola through the three stages before, or less. */
    void
    predict(const std::size_t k,
            const std::vector<Vector> &stage_rates,
            const std::vector<std::vector<TangentVector>> &stage_directions,
            Vector &rates,
            std::vector<TangentVector> &directions)
    {
      const std::size_t first = k > 3 ? k - 3 : 0;
      std::fill(rates.begin(), rates.end(), 0.);
      std::fill(directions.begin(), directions.end(), TangentVector{{0., 0.}});
      for (std::size_t j = first; j < k; ++j)
        {
          const double weight = lagrange(first, j, k);
          for (std::size_t i = 0; i < rates.size(); ++i)
            {
              rates[i] += weight * stage_rates[j][i];
              for (std::size_t a = 0; a < 2; ++a)
                directions[i][a] += weight * stage_directions[j][i][a];
            }
        }
      for (std::size_t i = 0; i < directions.size(); ++i)
        {
          const double size = fuga::length(directions[i]);
          if (size > 0.5)
            directions[i] = {{directions[i][0] / size, directions[i][1] / size}};
          else
            directions[i] = stage_directions.back()[i];
        }
    }

    /** First guess of the dislocations of stage number @p k: behind the beginning of the step, with
     * its rates, the polynomial that leads through the (at most three) stages before. */
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
          const double weight = (c[k] * c[k]) / (c[j] * c[j]) * lagrange(first, j, k);
          for (std::size_t bar = 0; bar < result.size(); ++bar)
            result[bar] += weight * (stages[j][bar] - from.state.dislocations[bar] -
                                     c[j] * length * from.rates.dislocations[bar]);
        }
      return result;
    }
  } // namespace

  double
  TurningSegment::rate_tolerance(const Station &station) const
  {
    return no_slip_rate * max_abs(station.point.rates.dislocations);
  }

  double
  TurningSegment::driving_force() const
  {
    if (course.yielding)
      return (course.yielding->stiffness + std::abs(*start.load_rate)) *
             max_abs(course.yielding->drive.reactions);
    const Drive drive = drive_at(context.elements, course, start.state);
    return std::max({max_abs(drive.reactions), max_abs(drive.release), max_abs(drive.strength)});
  }

  double
  TurningSegment::parameter_scale() const
  {
    return course.yielding ? course.length : std::max(1., course.t_end);
  }

  // The motion has changed so much that its measure no longer controls it: another segment begins.
  bool
  TurningSegment::loses_control(const Station &station) const
  {
    return course.yielding &&
           std::abs(*station.point.load_rate - *start.load_rate) > 0.5 * course.yielding->stiffness;
  }

  // Forces are differences of terms as large as the stiffness of a rigid joint times the slip.
  // Close to a mechanism their rounding moves the slips.
  double
  TurningSegment::force_noise(const JointState &state) const
  {
    constexpr double force_rounding = 1e-13, stage_rounding = 1e-14;
    return std::max(force_rounding * force_scale,
                    stage_rounding * context.system.largest_stiffness() *
                      max_abs(state.dislocations));
  }

  // One step of the Runge-Kutta pair. The error is relative to the tolerance.
  bool
  TurningSegment::step(const Station &from, const double length, Station &to, double &error)
  {
    namespace rk        = runge_kutta;
    const std::size_t n = turning.size();
    std::array<Vector, rk::n_stages> rates;
    rates[0].resize(2 * n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t a = 0; a < 2; ++a)
        rates[0][2 * i + a] = from.slip_rates[i] * from.stage.directions[i][a];
    const auto power = [&](const TurningStage &stage, const Vector &slip_rates) {
      double sum = 0.;
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t a = 0; a < 2; ++a)
          sum += stage.forces[3 * i + 1 + a] * slip_rates[2 * i + a];
      return sum;
    };

    Vector rise;
    for (const std::size_t k : turning)
      rise.push_back(start.state.strengths[k].dilatancy);

    // Where nothing drives nothing slips.
    const double drive = driving_force();
    const double slip_noise =
      drive > 0. ? force_noise(from.point.state) * max_abs(from.point.rates.dislocations) / drive
                 : 0.;
    // On the way forces follow from the last ones; those of the result do not.
    const KnownForces known =
      linear ? KnownForces() : known_forces(context, course, from.tau, from.point.state);
    JointState &state = to.point.state;
    state             = from.point.state;
    to.stage          = from.stage;
    double work       = length * rk::weights.back()[0] * power(from.stage, rates[0]);
    Vector xi(from.slip_rates.begin(), from.slip_rates.begin() + static_cast<std::ptrdiff_t>(n));
    // Of the stages so far: rates of slip along the directions, and these.
    std::vector<Vector> stage_rates                          = {xi};
    std::vector<std::vector<TangentVector>> stage_directions = {from.stage.directions};
    std::vector<Vector> stage_dislocations                   = {from.point.state.dislocations};
    for (std::size_t k = 1; k < rk::n_stages; ++k)
      {
        TurningStage base = from.stage;
        for (std::size_t j = 0; j < k; ++j)
          for (std::size_t i = 0; i < n; ++i)
            {
              const double weight = length * rk::weights[k][j];
              for (std::size_t a = 0; a < 2; ++a)
                base.slips[2 * i + a] += static_cast<long double>(weight) * rates[j][2 * i + a];
              base.dilations[i] += weight * rise[i] * stage_rates[j][i];
            }
        predict(k, stage_rates, stage_directions, xi, to.stage.directions);
        for (double &value : xi)
          value *= length * rk::diagonal;
        // Stages on the cones by their rates alone, so that the method keeps its order (as one for
        // a differential-algebraic system it would lose it); the last one, the result, exactly.
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
                         state))
          return false;
        stage_rates.push_back(xi);
        for (double &value : stage_rates.back())
          value /= length * rk::diagonal;
        stage_directions.push_back(to.stage.directions);
        stage_dislocations.push_back(state.dislocations);
        rates[k].resize(2 * n);
        for (std::size_t i = 0; i < n; ++i)
          for (std::size_t a = 0; a < 2; ++a)
            rates[k][2 * i + a] = xi[i] * to.stage.directions[i][a] / (length * rk::diagonal);
        work += length * rk::weights.back()[k] * power(to.stage, rates[k]);
      }
    to.tau = from.tau + length;
    if (course.length - to.tau < 4. * std::numeric_limits<double>::epsilon() * course.length)
      to.tau = course.length;
    if (!complete(to))
      return false;

    Vector difference(2 * n, 0.), of_rises(n, 0.);
    for (std::size_t k = 0; k < rk::n_stages; ++k)
      {
        const double weight = length * (rk::weights.back()[k] - rk::embedded[k]);
        for (std::size_t i = 0; i < 2 * n; ++i)
          difference[i] += weight * rates[k][i];
        for (std::size_t i = 0; i < n; ++i)
          of_rises[i] += weight * rise[i] * stage_rates[k][i];
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

  // Dislocations are rounded, by which forces leave the cones. A step puts them back, whatever its
  // length: the error of the shortest ones is rounding and no reason to shorten another.
  double
  TurningSegment::error_of_rounding(const Station &from, const double shortest)
  {
    constexpr double largest = 10., margin = 2.;
    double worst = 0.;
    for (const double length : {2. * shortest, 8. * shortest, 32. * shortest})
      {
        Station to;
        double error = 0.;
        if (!step(from, length, to, error) || error > largest)
          return 1.;
        worst = std::max(worst, error);
      }
    return std::max(1., margin * worst);
  }

  // A boundary a few shortest steps ahead is met where the curve ends: of elements that reach it
  // together one may be a rounding error behind the others. Slips that grow beyond bounds although
  // something answers them go on behind a jump.
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
        // Rounding is what a shorter step has left as it was.
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
        if (first_event(from, to) <= 1.)
          if (std::optional<Station> event = locate(from, to))
            {
              if (event->tau > from.tau)
                curve.push_back(std::move(*event));
              break;
            }
        const bool is_event = meet_event(from, to);
        curve.push_back(std::move(to));
        if (is_event)
          break;
        allowed  = 1.;
        is_known = false;
        rejected = no_boundary;
        length.accept(error, length() > short_step);
      }
    // An event may come just before the maximum.
    at_turning_point =
      at_turning_point || (!course.yielding && !at_limit && turns_back(near_maximum));
    return end = curve.back().tau;
  }
} // namespace fuga
