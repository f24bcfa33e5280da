// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/cubic.h>
#include <fuga/base/errors.h>
#include <fuga/contact/cone_segment.h>
#include <fuga/contact/implicit_runge_kutta.h>

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

    /** First guess for stage number @p k: the parabola through the three stages before, or less. */
    void
    predict(const std::size_t k,
            const std::vector<Vector> &stage_rates,
            const std::vector<std::vector<TangentVector>> &stage_directions,
            Vector &rates,
            std::vector<TangentVector> &directions)
    {
      const auto &c           = runge_kutta::abscissae;
      const std::size_t first = k > 3 ? k - 3 : 0;
      std::fill(rates.begin(), rates.end(), 0.);
      std::fill(directions.begin(), directions.end(), TangentVector{{0., 0.}});
      for (std::size_t j = first; j < k; ++j)
        {
          double weight = 1.;
          for (std::size_t m = first; m < k; ++m)
            if (m != j)
              weight *= (c[k] - c[m]) / (c[j] - c[m]);
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
  } // namespace

  double
  ConeSegment::rate_tolerance(const Station &station) const
  {
    return no_slip_rate * max_abs(station.point.rates.dislocations);
  }

  // One step of the Runge-Kutta pair. The error is relative to the tolerance.
  bool
  ConeSegment::step(const Station &from, const double length, Station &to, double &error)
  {
    namespace rk        = runge_kutta;
    const std::size_t n = slipping.size();
    std::array<Vector, rk::n_stages> rates;
    rates[0].resize(2 * n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t a = 0; a < 2; ++a)
        rates[0][2 * i + a] = from.slip_rates[i] * from.stage.directions[i][a];
    const auto power = [&](const ConeStage &stage, const Vector &slip_rates) {
      double sum = 0.;
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t a = 0; a < 2; ++a)
          sum += stage.forces[3 * i + 1 + a] * slip_rates[2 * i + a];
      return sum;
    };

    to.stage    = from.stage;
    double work = length * rk::weights.back()[0] * power(from.stage, rates[0]);
    Vector xi   = from.slip_rates;
    // Of the stages so far: rates of slip along the directions, and these.
    std::vector<Vector> stage_rates                          = {from.slip_rates};
    std::vector<std::vector<TangentVector>> stage_directions = {from.stage.directions};
    for (std::size_t k = 1; k < rk::n_stages; ++k)
      {
        Vector base = from.stage.slips;
        for (std::size_t j = 0; j < k; ++j)
          for (std::size_t i = 0; i < 2 * n; ++i)
            base[i] += length * rk::weights[k][j] * rates[j][i];
        predict(k, stage_rates, stage_directions, xi, to.stage.directions);
        for (double &value : xi)
          value *= length * rk::diagonal;
        // Stages on the cones by their rates alone, so that the method keeps its order (as one for
        // a differential-algebraic system it would lose it); the last one, the result, exactly.
        const auto demand =
          k + 1 < rk::n_stages ? ConeStageSolver::Demand::rates : ConeStageSolver::Demand::cone;
        if (!solver.solve(demand,
                          from.tau + rk::abscissae[k] * length,
                          length * rk::diagonal,
                          base,
                          xi,
                          to.stage))
          return false;
        stage_rates.push_back(xi);
        for (double &value : stage_rates.back())
          value /= length * rk::diagonal;
        stage_directions.push_back(to.stage.directions);
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

    Vector difference(2 * n, 0.);
    for (std::size_t k = 0; k < rk::n_stages; ++k)
      for (std::size_t i = 0; i < 2 * n; ++i)
        difference[i] += length * (rk::weights.back()[k] - rk::embedded[k]) * rates[k][i];
    // Close to a mechanism the rounding of the forces moves the slips.
    constexpr double force_rounding = 1e-13;
    const double uncertainty        = force_rounding * force_scale *
                               max_abs(from.point.rates.dislocations) /
                               max_abs(course.drive.reactions);
    error = std::max(max_abs(difference) / (jump_scale + uncertainty / cone_step_tolerance),
                     max_abs(solver.resistance(difference)) / force_scale) /
            cone_step_tolerance;
    error = std::max(error, work_defect(from, to, length, work));
    return std::isfinite(error);
  }

  // What an observer that takes forces and slips for cubics between the ends of a step gets wrong
  // in the work of friction, relative to the share that is allowed.
  double
  ConeSegment::work_defect(const Station &from,
                           const Station &to,
                           const double length,
                           const double work) const
  {
    constexpr double allowed_share = 5e-11;
    constexpr double least_share   = 1e-13;
    const double r                 = std::sqrt(0.15);
    const double abscissae[]       = {0.5 - r, 0.5, 0.5 + r};
    const double weights[]         = {5. / 18., 8. / 18., 5. / 18.};
    double of_cubics               = 0.;
    const auto add                 = [&](const std::size_t bar) {
      const PathPoint &a = from.point, &b = to.point;
      const CubicOnUnitInterval force(a.state.forces[bar],
                                      a.rates.forces[bar] * length,
                                      b.state.forces[bar],
                                      b.rates.forces[bar] * length);
      const CubicOnUnitInterval slip(a.state.dislocations[bar],
                                     a.rates.dislocations[bar] * length,
                                     b.state.dislocations[bar],
                                     b.rates.dislocations[bar] * length);
      for (int i = 0; i < 3; ++i)
        of_cubics += weights[i] * force.value(abscissae[i]) * slip.slope(abscissae[i]);
    };
    for (const SlippingElement &slip : slipping)
      {
        add(context.elements[slip.element].tangential_bar);
        if (context.elements[slip.element].has_second_tangential_bar())
          add(context.elements[slip.element].second_tangential_bar);
      }
    return std::abs(of_cubics - work) /
           (allowed_share * std::abs(work) + least_share * force_scale * jump_scale);
  }

  // While slip directions turn into those of a mechanism, the load approaches its limit as slips
  // grow without bounds, exponentially: at the limit the jumps would double within a negligible
  // load, and hardly any force answers.
  bool
  ConeSegment::grows_beyond_bounds(const Station &station) const
  {
    constexpr double negligible_load = 1e-6, weak_answer = 1e-3;
    const JointRates &rates = station.point.rates;
    const JointState &state = station.point.state;
    const double growth     = max_abs(rates.dislocations);
    return negligible_load * std::max(1., course.t_end) * growth >=
             max_abs(context.system.jumps(state.dislocations, state.forces)) &&
           max_abs(rates.forces) <= weak_answer * context.system.largest_stiffness() * growth;
  }

  void
  ConeSegment::find_end_of_curve()
  {
    end                   = 0.; // as far as the curve is known, if a step fails
    const double shortest = 1e-13 * std::max(1., course.t_end);
    double length         = std::min(
      course.length, 1.1 * context.boundary.distance(start.state, start.rates, course.drive));
    length = std::clamp(length, 1e-6 * course.length, 0.1 * course.length);
    while (curve.back().tau < course.length)
      {
        Station from = curve.back();
        length       = std::min(length, course.length - from.tau);
        at_limit     = grows_beyond_bounds(from);
        if (at_limit)
          break;
        if (length < shortest && course.length - from.tau > shortest)
          {
            throw NumericalFailure(fmt::format(
              "The path cannot be followed beyond load time {}: even the shortest step fails.",
              from.point.state.t));
          }
        Station to;
        double error = 0.;
        if (!step(from, length, to, error))
          {
            length *= 0.25;
            continue;
          }
        if (error > 1.)
          {
            length *= std::max(0.1, 0.9 * std::pow(error, -0.2));
            continue;
          }
        if (first_event(from, to) <= 1.)
          if (std::optional<Station> event = locate(from, to))
            {
              if (event->tau > from.tau)
                curve.push_back(std::move(*event));
              break;
            }
        curve.push_back(std::move(to));
        length *= std::min(5., 0.9 * std::pow(std::max(error, 1e-8), -0.2));
      }
    end = curve.back().tau;
  }

  // The share of the way from a to b at which the first reserve is used up, by cubics and, for
  // rates of slip, by secants; above one if none is.
  double
  ConeSegment::first_event(const Station &a, const Station &b) const
  {
    constexpr double none = 2.;
    const double length   = b.tau - a.tau;
    double first          = none;
    for (std::size_t i = 0; i < a.reserves.size(); ++i)
      {
        const Reserve &before = a.reserves[i], &after = b.reserves[i];
        // What was on its boundary at the beginning has been left there by the rates.
        const bool leaving = before.value <= before.tolerance;
        const double value = std::max(0., before.value);
        const double rate  = leaving ? std::max(0., before.rate) : before.rate;
        const CubicOnUnitInterval course_of(value, rate * length, after.value, after.rate * length);
        if (after.value < -after.tolerance || course_of.minimum() < -before.tolerance)
          {
            const double root = course_of.first_descending_root();
            first             = std::min(
              first,
              root < 1. || after.value >= -after.tolerance ? root : value / (value - after.value));
          }
      }
    for (std::size_t i = 0; i < slipping.size(); ++i)
      if (b.slip_rates[i] < -rate_tolerance(b))
        {
          const double before = std::max(a.slip_rates[i], 0.);
          first               = std::min(first, before / (before - b.slip_rates[i]));
        }
    return first;
  }

  bool
  ConeSegment::is_passed(const Station &station) const
  {
    for (const Reserve &reserve : station.reserves)
      if (reserve.value < -reserve.tolerance)
        return true;
    for (const double rate : station.slip_rates)
      if (rate < -rate_tolerance(station))
        return true;
    return false;
  }

  bool
  ConeSegment::is_reached(const Station &station) const
  {
    for (const Reserve &reserve : station.reserves)
      if (reserve.value <= reserve.tolerance && reserve.rate < 0.)
        return true;
    for (std::size_t i = 0; i < slipping.size(); ++i)
      if (station.slip_rates[i] <= rate_tolerance(station) &&
          curve.back().slip_rates[i] > rate_tolerance(curve.back()))
        return true;
    return false;
  }

  // Steps from the same point, shorter and longer, until one ends at the event.
  std::optional<ConeSegment::Station>
  ConeSegment::locate(const Station &from, const Station &passed)
  {
    constexpr int max_steps = 60;
    Station low = from, high = passed;
    const double resolution = std::numeric_limits<double>::epsilon() * std::max(1., course.t_end);
    for (int i = 0; i < max_steps; ++i)
      {
        const double share = first_event(low, high);
        if (share > 1.)
          return {};
        double tau = low.tau + share * (high.tau - low.tau);
        // Alternately a bisection, should the interpolation stand still.
        if (i > 4 && i % 2 == 0)
          tau = 0.5 * (low.tau + high.tau);
        if (tau - low.tau <= resolution || high.tau - low.tau <= 2. * resolution)
          {
            if (low.tau > from.tau || share <= 1e-9 || high.tau - low.tau <= 2. * resolution)
              break;
            tau = low.tau + 2. * resolution;
          }
        tau = std::min(tau, high.tau);
        Station middle;
        double error;
        if (!step(from, tau - from.tau, middle, error))
          throw NumericalFailure("An event inside a step of the path could not be located.");
        if (is_passed(middle))
          high = std::move(middle);
        else
          {
            low = std::move(middle);
            if (is_reached(low))
              break;
          }
      }
    for (std::size_t i = 0; i < slipping.size(); ++i)
      if (low.slip_rates[i] <= std::max(rate_tolerance(low), 0.) ||
          (high.slip_rates[i] < 0. && high.tau - low.tau <= 4. * resolution))
        if (from.slip_rates[i] > low.slip_rates[i] || high.slip_rates[i] < low.slip_rates[i])
          lost_slip.push_back(slipping[i].element);
    return low;
  }
} // namespace fuga
