// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/segments/course.h>
#include <fuga/contact/segments/curved_segment.h>
#include <fuga/contact/segments/implicit_runge_kutta.h>
#include <fuga/contact/segments/layer_work.h>
#include <fuga/contact/segments/step_control.h>

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
      view(result) += c[k] * length * view(from.rates.dislocations);
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
  CurvedSegment::predict(const SlipStages &before,
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
  CurvedSegment::base_of(const Station &from,
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

  bool
  CurvedSegment::step(const Station &from, const double length, Station &to)
  {
    to.length = length;
    to.tau    = from.tau + length;
    if (course.length - to.tau < 4. * std::numeric_limits<double>::epsilon() * course.length)
      to.tau = course.length;
    return turns() ? step_of_turns(from, length, to) : step_without_turns(from, to);
  }

  // On the way forces are computed from those at the beginning, at the end they are not.
  bool
  CurvedSegment::step_without_turns(const Station &from, Station &to)
  {
    const KnownForces known = known_forces(context, course, from.tau, from.point.state);
    JointState &state       = to.point.state;
    if (state.dislocations.empty())
      state.dislocations =
        along(from.point.state.dislocations, to.tau - from.tau, from.point.rates.dislocations);
    if (!settle(to.tau, to.stage, state, &known))
      return false;
    const bool is_refined = context.system.refines_forces(state.dislocations, state.forces);
    return (!is_refined || settle(to.tau, to.stage, state, nullptr)) && find_rates(to);
  }

  // This is one step of the Runge-Kutta pair.
  bool
  CurvedSegment::step_of_turns(const Station &from, const double length, Station &to)
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

    const double noise = slip_noise(from.point);
    // On the way forces are computed from the last ones; those of the result are not.
    const KnownForces known =
      linear ? KnownForces() : known_forces(context, course, from.tau, from.point.state);
    JointState &state = to.point.state;
    state             = from.point.state;
    to.stage          = from.stage;
    Vector xi(from.slip_rates.begin(), from.slip_rates.begin() + static_cast<std::ptrdiff_t>(n));
    SlipStages stages = {from.tau, length, {xi}, {from.stage.directions}, {}, 0.};
    if (linear)
      stages.lost_forces.push_back(
        solver.resistance(stages.velocity(0), products(xi, dilatancies)));
    const Vector first_forces = linear ? solver.forces_at(from.tau, from.stage) : Vector();
    stages.work = length * rk::weights.back()[0] * power(from.stage, stages.velocity(0));
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
                         noise,
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
        stages.work += length * rk::weights.back()[k] * power(to.stage, stages.velocity(k));
      }
    last_stages = std::move(stages);
    return complete(to);
  }

  // The error of the step that was taken last, relative to the tolerance.
  double
  CurvedSegment::error_of_step(const Station &from, Station &to)
  {
    if (!turns())
      return defect_of_cubics(from, to);
    namespace rk        = runge_kutta;
    const std::size_t n = turning.size();
    Vector difference(2 * n, 0.), of_rises(n, 0.);
    for (std::size_t k = 0; k < rk::n_stages; ++k)
      {
        const double weight = to.length * (rk::weights.back()[k] - rk::embedded[k]);
        add_multiple(weight, last_stages.velocity(k), difference);
        add_multiple(weight, products(last_stages.rates[k], dilatancies), of_rises);
      }
    return std::max({max_abs(difference) / (step_tolerance * jump_scale + slip_noise(from.point)),
                     max_abs(solver.resistance(difference, of_rises)) /
                       (step_tolerance * force_scale + force_noise(to.point.state)),
                     work_defect(from, to),
                     turn_defect(from, to),
                     rise_defect(from, to),
                     defect_of_cubics(from, to)});
  }
} // namespace fuga
