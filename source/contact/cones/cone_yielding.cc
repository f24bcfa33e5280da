// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/cones/cone_rate_problem.h>

#include <algorithm>
#include <cmath>
#include <limits>

// A load that is an unknown acts through a spring, which the motion relieves. For linear conditions
// any spring that is sufficiently stiff gives the motion of eq. 7a, except for its scale.
namespace fuga
{
  namespace
  {
    /** Stiffnesses of the spring, in units of the stiffness of the joints against the load. */
    constexpr std::array<double, 3> springs = {{30., 1000., 1.}};
    /** Share of the motion that the spring alone would cause below which a motion counts as
     * zero. */
    constexpr double no_motion = 1e-9;

    double
    spring_unit(const Vector &load, const Vector &weights, const Vector &diagonal)
    {
      double softness = 0.;
      for (std::size_t row = 0; row < load.size(); ++row)
        softness = std::max(softness, std::abs(load[row] * weights[row]));
      return softness > 0. ? max_abs(diagonal) / softness : 0.;
    }
  } // namespace

  // The result multiplies the rates of dislocation: it contains the forces of the load that work on
  // the motion, with their part in friction, or the same weight for everything that may move. At
  // the apex the direction of slip is that of the present rates.
  Vector
  ConeRateProblem::on_boundaries(const Vector &forces, const bool by_work) const
  {
    Vector control(forces.size(), 0.);
    for (const Candidate &candidate : candidates)
      {
        const std::size_t n = candidate.row;
        if (candidate.grazing)
          control[n] = by_work ? forces[n] : std::sqrt(diagonal[n]);
        if (candidate.n_tangents == 0)
          continue;
        const TangentVector T       = tangential_rows(candidate, forces),
                            v_t     = tangential_rows(candidate, v);
        const bool has_no_direction = candidate.at_apex && length(v_t) == 0.;
        const TangentVector e       = candidate.at_apex ? direction_of(v_t) : candidate.direction;
        const double along          = dot(e, T) + candidate.friction * forces[n];
        for (std::size_t i = 0; i < candidate.n_tangents; ++i)
          if (has_no_direction)
            control[n + 1 + i] = by_work ? T[i] : 0.;
          else
            control[n + 1 + i] = e[i] * (by_work ? along : std::sqrt(shear_stiffness(candidate)));
      }
    return control;
  }

  // The equations are q = r + λ̇ load - W v with λ̇ = k (1 - control·v), where r is given, or the
  // same without the 1.
  void
  ConeRateProblem::yield(const ReducedSystem &given,
                         const Vector &load,
                         const Vector &weights,
                         const double k)
  {
    W = given.W;
    r = given.r;
    for (std::size_t j = 0; j < weights.size(); ++j)
      if (weights[j] != 0.)
        W.col(j) += k * weights[j] * view(load);
    v.assign(bars.size(), 0.);
    q = r;
  }

  // The spring of stiffness k is either followed until the displacement of the load stands still,
  // or used as it is.
  bool
  ConeRateProblem::drive_by_spring(const ReducedSystem &given,
                                   const Vector &load,
                                   const bool by_work,
                                   const double spring,
                                   const Control control,
                                   ConeContinuation &result)
  {
    constexpr int max_repetitions = 60;
    constexpr double no_change = 1e-14, accepted = 1e-10;
    double last                           = std::numeric_limits<double>::infinity();
    const std::vector<Candidate> at_first = candidates;
    ReducedSystem driven                  = given;
    const bool repeats                    = control == Control::displacement;
    v.assign(bars.size(), 0.);
    const double k   = spring * spring_unit(load, on_boundaries(load, by_work), diagonal);
    result.load_rate = repeats ? 0. : k;
    for (int i = 0; k > 0. && i < max_repetitions; ++i)
      {
        const Vector weights = on_boundaries(load, by_work);
        for (std::size_t row = 0; row < load.size(); ++row)
          driven.r[row] = given.r[row] + result.load_rate * load[row];
        candidates = at_first;
        yield(driven, load, weights, k);
        Outcome outcome = iterate(n_iterations, result);
        if (outcome != Outcome::solved)
          {
            candidates = at_first;
            outcome    = approach_from_softer_layer(result);
          }
        if (outcome != Outcome::solved)
          break;
        const double change = k * dot(weights, v);
        result.load_rate -= change;
        if (!repeats)
          {
            double motion = 0.;
            for (std::size_t row = 0; row < v.size(); ++row)
              motion = std::max(motion, diagonal[row] * std::abs(v[row]));
            if (motion > no_motion * k * max_abs(load))
              return true;
            break;
          }
        const double share = std::abs(change) / std::abs(result.load_rate);
        if (share <= no_change || (share <= accepted && share >= 0.5 * last))
          return result.load_rate <= 0.;
        last = share;
      }
    candidates = at_first;
    return false;
  }

  ConeContinuation
  ConeRateProblem::solve_yielding(const JointState &state,
                                  const std::vector<BoundaryElement> &set,
                                  WorkingScheme &background,
                                  const Drive &drive,
                                  const Drive &unit_load,
                                  const Control control)
  {
    ConeContinuation result;
    const std::optional<JointRates> unit = background.rates(unit_load);
    if (!unit)
      return result;
    take_set(state, set, background, drive, {}, result);
    if (!has_system)
      return result;
    Vector load;
    for (const std::size_t bar : bars)
      load.push_back(unit->forces[bar]);
    const ReducedSystem given = {W, r, diagonal};
    for (const bool by_work : {true, false})
      for (const double spring : springs)
        {
          if ((!by_work && control == Control::displacement) ||
              !drive_by_spring(given, load, by_work, spring, control, result))
            continue;
          slip_where_neutral();
          take_solution(result);
          Drive whole = drive;
          for (std::size_t bar = 0; bar < whole.reactions.size(); ++bar)
            whole.reactions[bar] += result.load_rate * unit_load.reactions[bar];
          result.rates = full_rates(background, whole, v);
          return result;
        }
    return result;
  }
} // namespace fuga
