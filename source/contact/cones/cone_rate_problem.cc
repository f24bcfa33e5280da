// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/cones/cone_rate_problem.h>
#include <fuga/contact/element/mechanism.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Numbers of Gauss-Seidel sweeps before Newton's method is tried again, for the first and the
     * second time. */
    constexpr std::array<unsigned int, 2> n_sweeps = {{400, 4000}};
  } // namespace

  ConeRateProblem::ConeRateProblem(const std::vector<ContactElement> &contact_elements,
                                   const LayeredSystem &layered_system)
    : elements(contact_elements), system(layered_system)
  {
  }

  ConeContinuation
  ConeRateProblem::solve(const JointState &state,
                         const std::vector<BoundaryElement> &set,
                         WorkingScheme &background,
                         const Drive &drive,
                         const std::vector<std::size_t> &resticking,
                         const double widening,
                         const Accept &accepts)
  {
    ConeContinuation result;
    noise_at_rest = widening;
    take_set(state, set, background, drive, resticking, result);
    accept = accepts;
    if (!has_system)
      {
        result.by_search = accept && search(
                                       result, [] { return true; }, most_combinations_at_last);
        result.has_mechanism = !result.by_search;
        if (result.by_search)
          take_solution(result);
        accept = {};
        return result;
      }
    const std::vector<Candidate> at_first = candidates;
    Outcome outcome                       = Outcome::cycled;
    for (const auto approach : {&ConeRateProblem::approach_by_pivoting,
                                &ConeRateProblem::approach_from_present_states,
                                &ConeRateProblem::approach_from_softer_layer,
                                &ConeRateProblem::approach_by_associated_slip})
      if (outcome != Outcome::solved)
        {
          candidates = at_first;
          outcome    = (this->*approach)(result);
        }
    for (const unsigned int n : n_sweeps)
      {
        if (outcome == Outcome::solved)
          break;
        sweep(n);
        take_from_rates();
        outcome = iterate(n_iterations, result);
      }
    if (outcome != Outcome::solved)
      {
        result.by_search = find_another_way(background, drive, result);
        if (!result.by_search)
          {
            accept = {};
            return result;
          }
      }
    slip_where_neutral();
    accept = {};
    take_solution(result);
    result.rates = full_rates(background, drive, v);
    return result;
  }

  void
  ConeRateProblem::take_set(const JointState &state,
                            const std::vector<BoundaryElement> &set,
                            WorkingScheme &background,
                            const Drive &drive,
                            const std::vector<std::size_t> &resticking,
                            ConeContinuation &result)
  {
    candidates.clear();
    bars.clear();
    has_system = false;
    accept     = {};
    free_motion.clear();
    drift.clear();
    ray.clear();
    const ContactBoundary::RateNoise noise_at_most(system, largest_rates(drive), drive);
    for (const BoundaryElement &member : set)
      {
        const ContactElement &element = elements[member.element];
        Candidate candidate(member, element, state, drive);
        candidate.no_force = noise_at_most.force(element.normal_bar);
        for (std::size_t a = 1; a <= candidate.n_tangents; ++a)
          candidate.no_shear = std::max(candidate.no_shear, noise_at_most.force(element.bar(a)));
        candidate.no_shear += candidate.friction * candidate.no_force;
        candidate.row = bars.size();
        candidate.resting =
          std::find(resticking.begin(), resticking.end(), member.element) != resticking.end();
        candidate.state = candidate.resting ? ContactState::stick : state.states[member.element];
        candidate.direction = candidate.shear_direction;
        for (std::size_t a = 0; a <= candidate.n_tangents; ++a)
          bars.push_back(element.bar(a));
        candidates.push_back(candidate);
      }
    r.assign(bars.size(), 0.);
    const std::optional<JointRates> stuck = background.rates(drive);
    std::optional<DenseMatrix> stiffness  = background.stiffness(bars, bars);
    if (!stuck || !stiffness)
      {
        result.has_mechanism = true;
        result.mechanism     = background.mechanism(drive);
        return;
      }
    has_system = true;
    W          = std::move(*stiffness);
    r.clear();
    for (const std::size_t bar : bars)
      r.push_back(stuck->forces[bar]);
    v.assign(bars.size(), 0.);
    q = r;
    diagonal.clear();
    for (const std::size_t bar : bars)
      diagonal.push_back(system.stiffness()(bar, bar));
    const double largest = max_abs(diagonal); // bars that nothing resists have no size of their own
    std::replace(diagonal.begin(), diagonal.end(), 0., largest > 0. ? largest : 1.);
  }

  bool
  ConeRateProblem::settles(ConeContinuation &result)
  {
    return accept ? is_accepted() : iterate(n_iterations, result) == Outcome::solved;
  }

  bool
  ConeRateProblem::is_accepted(const bool as_they_are) const
  {
    if (!accept)
      return true;
    ConeContinuation found;
    take_solution(found);
    return accept(found, as_they_are);
  }

  JointRates
  ConeRateProblem::largest_rates(const Drive &drive) const
  {
    double driving_force = 0.;
    for (std::size_t i = 0; i < drive.reactions.size(); ++i)
      driving_force =
        std::max({driving_force,
                  std::abs(drive.reactions[i]) / system.scale(i),
                  drive.strength.empty() ? 0. : std::abs(drive.strength[i]) / system.scale(i)});
    JointRates largest;
    largest.forces.assign(system.n_bars(), 0.);
    for (std::size_t i = 0; i < system.n_bars(); ++i)
      largest.dislocations.push_back(largest_motion * driving_force / system.scale(i));
    return largest;
  }

  void
  ConeRateProblem::take_solution(ConeContinuation &result) const
  {
    result.exists           = true;
    result.determinant_sign = determinant_sign;
    for (const Candidate &candidate : candidates)
      {
        result.states.push_back(state_of(candidate, elements[candidate.element]));
        result.directions.push_back(candidate.direction);
      }
  }

  JointRates
  ConeRateProblem::full_rates(WorkingScheme &background,
                              const Drive &drive,
                              const Vector &reduced) const
  {
    Vector imposed(system.n_bars(), 0.);
    for (std::size_t i = 0; i < bars.size(); ++i)
      imposed[bars[i]] = reduced[i];
    const std::optional<JointRates> rates = background.rates(drive, imposed);
    return rates ? *rates : JointRates();
  }

  ConeRateProblem::Outcome
  ConeRateProblem::iterate(const unsigned int max_iterations, ConeContinuation &result)
  {
    for (unsigned int i = 0; i < max_iterations + candidates.size(); ++i)
      {
        ++result.n_schemes;
        const bool regular = solve_scheme();
        if (!update_scheme(i >= n_together))
          {
            if (regular && is_settled())
              return is_accepted() ? Outcome::solved : Outcome::cycled;
            if (!regular && !end_idle_motion())
              return Outcome::singular;
          }
        free_motion.clear(); // that of a scheme that the next one replaces
      }
    return Outcome::cycled;
  }

  ConeRateProblem::Outcome
  ConeRateProblem::approach_from_present_states(ConeContinuation &result)
  {
    return iterate(n_iterations, result);
  }

  void
  ConeRateProblem::refresh_forces()
  {
    q = r;
    for (std::size_t j = 0; j < v.size(); ++j)
      if (v[j] != 0.)
        view(q) -= v[j] * W.col(j);
  }

  double
  ConeRateProblem::noise(const std::size_t row) const
  {
    return rate_tolerance * (std::abs(r[row]) + diagonal[row] * max_abs(v));
  }

  double
  ConeRateProblem::shear_stiffness(const Candidate &candidate) const
  {
    const TangentVector stiffnesses = tangential_rows(candidate, diagonal);
    return (stiffnesses[0] + stiffnesses[1]) / static_cast<double>(candidate.n_tangents);
  }

  double
  ConeRateProblem::shear_noise(const Candidate &candidate) const
  {
    double largest = 0.;
    for (std::size_t i = 1; i <= candidate.n_tangents; ++i)
      largest = std::max(largest, noise(candidate.row + i));
    const bool at_rest = candidate.resting && candidate.state == ContactState::stick;
    return (at_rest ? noise_at_rest : 1.) * (largest + candidate.friction * noise(candidate.row));
  }

  // A stuck element on its cone whose force moves along the tangent plane would leave the cone at
  // second order: it begins to slip with the rate zero.
  void
  ConeRateProblem::slip_where_neutral()
  {
    const std::vector<Candidate> before = candidates;
    const Vector v_before = v, q_before = q;
    bool any = false;
    for (Candidate &candidate : candidates)
      {
        if (candidate.at_apex || candidate.resting || candidate.state != ContactState::stick)
          continue;
        const std::size_t n     = candidate.row;
        const double f          = candidate.friction;
        const TangentVector q_t = tangential_rows(candidate, q);
        const double no_shear   = shear_noise(candidate);
        const double reserve = candidate.strength_rate - dot(candidate.direction, q_t) - f * q[n];
        const double turning = dot(normal_to(candidate.direction), q_t);
        if (reserve <= no_shear && std::abs(turning) > std::sqrt(no_shear * length(q_t)))
          {
            candidate.state = ContactState::slip_forward;
            any             = true;
          }
      }
    if (!any)
      return;
    bool settled = solve_scheme() && is_settled();
    for (const Candidate &candidate : candidates)
      settled = settled && demand(candidate).state == candidate.state;
    if (settled)
      return;
    candidates = before;
    v          = v_before;
    q          = q_before;
  }
} // namespace fuga
