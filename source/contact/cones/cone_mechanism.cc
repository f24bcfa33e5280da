// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/cones/cone_barrier.h>
#include <fuga/contact/cones/cone_rate_problem.h>
#include <fuga/contact/element/mechanism.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Share of the sizes of its terms below which the power of loads counts as zero. */
    constexpr double no_power = 1e-10;
    /** The same for what may yet be the power of errors of the motion. */
    constexpr double doubtful_power = 1e-7;

    Drive
    at_rest(const LayeredSystem &system)
    {
      Drive result;
      result.reactions.assign(system.n_bars(), 0.);
      return result;
    }
  } // namespace

  // The motion is the ray of Lemke's method, which meets no resistance if any motion does, that of
  // a scheme without resistance, or the change that every sweep adds to rates that grow beyond
  // bounds. It is a mechanism if the load drives it, nothing resists and no closed element would
  // penetrate or slip against its force; anything else only shows that no solution was found.
  bool
  ConeRateProblem::find_mechanism(WorkingScheme &background, ConeContinuation &result)
  {
    bool is_driven = false;
    for (Vector &motion : std::array<std::reference_wrapper<Vector>, 3>{{ray, free_motion, drift}})
      {
        if (motion.empty() || result.has_mechanism)
          continue;
        double size        = 0.;
        const double power = driving_power(motion, size);
        if (power < 0.)
          for (double &rate : motion)
            rate = -rate;
        result.mechanism     = full_rates(background, at_rest(system), motion);
        result.has_mechanism = is_admissible(motion) && std::abs(power) > no_power * size &&
                               is_free_motion(result.mechanism, system);
        is_driven = result.has_mechanism && std::abs(power) > doubtful_power * size;
      }
    return is_driven;
  }

  // The forces that a broken bond releases, and water that comes in, are not known to those who
  // judge the barrier.
  std::optional<JointRates>
  ConeRateProblem::find_barrier(WorkingScheme &background, const Drive &drive) const
  {
    if (!drive.release.empty() || !drive.missing_water.empty())
      return {};
    std::vector<ConeAnswer> answers;
    for (const Candidate &candidate : candidates)
      {
        using Place = ConeAnswer::Place;
        ConeAnswer answer;
        answer.row        = candidate.row;
        answer.n_tangents = candidate.n_tangents;
        answer.friction   = candidate.friction;
        answer.rise       = candidate.rise;
        answer.direction  = candidate.direction;
        if (candidate.n_tangents == 0 || (!candidate.at_apex && candidate.grazing))
          answer.place = Place::parting;
        else if (candidate.at_apex)
          answer.place = Place::at_apex;
        answer.strength_rate =
          answer.place == Place::on_cone ? candidate.strength_rate : candidate.tension_rate;
        // A cone without width has two sides along one tangent.
        if (candidate.at_apex && candidate.n_tangents == 1 && candidate.friction == 0.)
          for (const double sign : {1., -1.})
            {
              ConeAnswer side    = answer;
              side.place         = Place::on_cone;
              side.direction     = {{sign, 0.}};
              side.strength_rate = 0.;
              answers.push_back(side);
              answer.place = Place::parting;
            }
        if (candidate.friction > 0. || candidate.n_tangents != 1 || !candidate.at_apex ||
            candidate.grazing)
          answers.push_back(answer);
      }
    const std::optional<Vector> barrier = fuga::find_barrier(W, r, diagonal, answers);
    return barrier ? std::optional<JointRates>(full_rates(background, at_rest(system), *barrier))
                   : std::nullopt;
  }

  // Where elements slip apart on both sides of an axis, their friction is in balance, and all of
  // them may also be carried along until the first one comes to rest. Nothing determines how far;
  // there the rates are determined again. Return false if the loads drive the motion, or nothing
  // ends it.
  bool
  ConeRateProblem::end_idle_motion()
  {
    double size        = 0.;
    const double power = driving_power(free_motion, size);
    if (std::abs(power) > no_power * size)
      return false;
    const double no_rate = 1e-6 * max_abs(free_motion);
    Candidate *first     = nullptr;
    double shortest      = std::numeric_limits<double>::infinity();
    for (Candidate &candidate : candidates)
      {
        const bool open = candidate.state == ContactState::open;
        if (!open && !is_slipping(candidate.state))
          continue;
        const double left = std::max(0., open ? v[candidate.row] : candidate.slip);
        const double rate = open
                              ? free_motion[candidate.row]
                              : dot(candidate.direction, tangential_rows(candidate, free_motion));
        // Among candidates that are equal up to rounding, the first one is taken.
        if (std::abs(rate) > no_rate && left < 0.999999 * std::abs(rate) * shortest)
          {
            shortest = left / std::abs(rate);
            first    = &candidate;
          }
      }
    if (first == nullptr)
      return false;
    first->state = ContactState::stick;
    first->slip = first->strength = 0.;
    return true;
  }

  bool
  ConeRateProblem::is_admissible(const Vector &motion) const
  {
    double size = 0.;
    for (std::size_t row = 0; row < motion.size(); ++row)
      size = std::max(size, std::sqrt(diagonal[row]) * std::abs(motion[row]));
    const double none = 1e-6 * size;
    for (const Candidate &candidate : candidates)
      {
        const std::size_t n = candidate.row;
        const double slip =
          candidate.n_tangents == 0 ? 0. : length(tangential_rows(candidate, motion));
        const double normal = std::sqrt(diagonal[n]) * (motion[n] - candidate.rise * slip);
        if (candidate.grazing ? normal < -none : std::abs(normal) > none)
          return false;
        if (candidate.at_apex || candidate.n_tangents == 0)
          continue;
        const double forward = dot(tangential_rows(candidate, motion), candidate.direction);
        if (std::sqrt(shear_stiffness(candidate)) * forward < -none)
          return false;
      }
    return true;
  }

  double
  ConeRateProblem::driving_power(const Vector &motion, double &size) const
  {
    double power = size = 0.;
    const auto add      = [&](const double term) {
      power += term;
      size += std::abs(term);
    };
    for (std::size_t row = 0; row < motion.size(); ++row)
      add(r[row] * motion[row]);
    for (const Candidate &candidate : candidates)
      if (!candidate.at_apex && candidate.n_tangents > 0)
        add((candidate.friction * r[candidate.row] - candidate.strength_rate) *
            dot(tangential_rows(candidate, motion), candidate.direction));
    return power;
  }
} // namespace fuga
