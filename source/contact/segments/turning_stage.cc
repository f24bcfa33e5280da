// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/segments/turning_stage.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  TurningStageSolver::TurningStageSolver(const Vector &stiffness, IterationCount &iteration_count)
    : diagonal(stiffness), count(iteration_count)
  {
  }

  // Factors of an earlier response are kept: they are useful as long as it is near by.
  void
  TurningStageSolver::set_response(TurningResponse &&new_response)
  {
    response    = std::move(new_response);
    force_sizes = resistance({response.slips.begin(), response.slips.end()}, response.dilations);
    for (std::size_t i = 0; i < force_sizes.size(); ++i)
      force_sizes[i] = std::abs(force_sizes[i] + response.forces[i]);
  }

  void
  TurningStageSolver::set_strengths(const std::vector<TurningElement> &elements)
  {
    turning = elements;
  }

  Vector
  TurningStageSolver::resistance(const Vector &slips, const Vector &dilations) const
  {
    if (response.against_slip.size() == 0)
      return {};
    Vector result = multiply(response.against_slip, slips);
    if (response.against_rise.size() > 0)
      for (std::size_t j = 0; j < dilations.size(); ++j)
        view(result) += dilations[j] * response.against_rise.col(j);
    return result;
  }

  // Terms as large as the stiffness where rigid joints cross times the longest slip cancel.
  Vector
  TurningStageSolver::forces_at(const double tau, const TurningStage &stage) const
  {
    Accurate forces     = accurate(response.forces);
    const auto take_off = [&forces](const long double change, const double *const column) {
      if (change != 0.L)
        add_scaled(forces.size(), -change, column, forces.data());
    };
    take_off(response.tau - tau, response.rates.data());
    for (std::size_t j = 0; j < stage.slips.size(); ++j)
      take_off(stage.slips[j] - response.slips[j], response.against_slip.col(j).data());
    if (response.against_rise.size() > 0)
      for (std::size_t j = 0; j < stage.dilations.size(); ++j)
        take_off(stage.dilations[j] - response.dilations[j], response.against_rise.col(j).data());
    return {forces.begin(), forces.end()};
  }

  Vector
  TurningStageSolver::noise(const double tau, const TurningStage &base) const
  {
    constexpr double rounding = 1e-15, slip_rounding = 1e-18;
    const double longest_slip = max_abs(Vector(base.slips.begin(), base.slips.end()));
    Vector result;
    for (std::size_t i = 0; i < turning.size(); ++i)
      {
        double size = turning[i].cohesion;
        for (std::size_t a = 0; a < 3; ++a)
          size += (a == 0 ? turning[i].friction : 1.) *
                  (force_sizes[3 * i + a] + std::abs(tau * response.rates[3 * i + a]));
        result.push_back(rounding * size + slip_rounding * diagonal[i] * longest_slip);
      }
    return result;
  }

  void
  TurningStageSolver::set_slips(const TurningStage &base,
                                const Vector &xi,
                                TurningStage &stage) const
  {
    stage.slips     = base.slips;
    stage.dilations = base.dilations;
    for (std::size_t i = 0; i < xi.size(); ++i)
      {
        for (std::size_t a = 0; a < 2; ++a)
          stage.slips[2 * i + a] += xi[i] * stage.directions[i][a];
        stage.dilations[i] += xi[i] * turning[i].rise;
      }
  }

  // Components along e and across it: T + (f N - c) e, or its rate along e.
  TurningStageSolver::Residual
  TurningStageSolver::evaluate(const Demand demand,
                               const TurningStage &base,
                               const Vector &noise,
                               const double advance,
                               const Vector &xi,
                               TurningStage &stage) const
  {
    constexpr double rounding = 1e-15;
    const std::size_t n       = turning.size();
    Vector slip(2 * n), rise(n);
    set_slips(base, xi, stage);
    for (std::size_t i = 0; i < n; ++i)
      {
        for (std::size_t a = 0; a < 2; ++a)
          slip[2 * i + a] = xi[i] * stage.directions[i][a];
        rise[i] = xi[i] * turning[i].rise;
      }
    const Vector change = resistance(slip, rise);
    stage.forces        = base.forces;
    Residual result;
    result.values.resize(2 * n);
    result.flow.resize(3 * n);
    for (std::size_t i = 0; i < 3 * n; ++i)
      {
        stage.forces[i] -= change[i];
        result.flow[i] = advance * response.rates[i] - change[i];
      }
    const Vector &along    = demand == Demand::rates ? result.flow : stage.forces;
    const double flow_size = max_abs(xi);
    for (std::size_t i = 0; i < n; ++i)
      {
        const TurningElement &own = turning[i];
        const TangentVector e = stage.directions[i], side = normal_to(e);
        const double strength =
          demand == Demand::rates
            ? advance * (own.cohesion_rate - own.friction_rate * stage.forces[3 * i])
            : own.cohesion;
        result.values[2 * i] = e[0] * along[3 * i + 1] + e[1] * along[3 * i + 2] +
                               own.friction * along[3 * i] - strength;
        result.values[2 * i + 1] =
          side[0] * stage.forces[3 * i + 1] + side[1] * stage.forces[3 * i + 2];
        const double of_both = noise[i] + rounding * diagonal[i] * flow_size;
        for (std::size_t a = 0; a < 2; ++a)
          if (result.values[2 * i + a] != 0.)
            result.worst = std::max(result.worst, std::abs(result.values[2 * i + a]) / of_both);
      }
    return result;
  }

  Vector
  TurningStageSolver::lost_forces(const std::size_t j,
                                  const TangentVector &slip,
                                  const double rise) const
  {
    Vector result(response.against_slip.rows(), 0.);
    for (std::size_t a = 0; a < 2; ++a)
      view(result) += slip[a] * response.against_slip.col(2 * j + a);
    if (response.against_rise.size() > 0)
      view(result) += rise * response.against_rise.col(j);
    return result;
  }

  bool
  TurningStageSolver::take_factors(const Demand demand,
                                   const double advance,
                                   const Vector &xi,
                                   const TurningStage &stage,
                                   const Residual &residual)
  {
    Factorisation &own         = factorisations[static_cast<std::size_t>(demand)];
    const Factorisation &other = factorisations[1 - static_cast<std::size_t>(demand)];
    if (!own.factors && other.factors)
      {
        own = {other.factors->without_corrections(), other.arms};
        return false;
      }
    const std::size_t n = turning.size();
    // Ratio of the slip of a stage to the stretch of an element until it slips.
    constexpr double weak_ratio = 0.03;
    const bool of_rates         = demand == Demand::rates;
    Vector &arms                = own.arms;
    arms.resize(n);
    DenseMatrix M(2 * n, 2 * n);
    std::vector<bool> is_weak(2 * n, false);
    for (std::size_t j = 0; j < n; ++j)
      {
        const TangentVector ej = stage.directions[j], sj = normal_to(ej);
        const double k     = diagonal[j];
        const double shear = ej[0] * stage.forces[3 * j + 1] + ej[1] * stage.forces[3 * j + 2];
        arms[j]            = std::abs(xi[j]) + std::abs(shear) / k;
        if (arms[j] == 0.)
          arms[j] = std::numeric_limits<double>::min();
        const double ratio = xi[j] / arms[j];
        is_weak[2 * j + 1] = !turns_are_coupled && std::abs(ratio) <= weak_ratio;
        for (std::size_t a = 0; a < 2; ++a)
          {
            const TangentVector slip = a == 0 ? ej : TangentVector{{ratio * sj[0], ratio * sj[1]}};
            const Vector lost        = lost_forces(j, slip, a == 0 ? turning[j].rise : 0.);
            for (std::size_t i = 0; i < n; ++i)
              {
                const TangentVector e = stage.directions[i], side = normal_to(e),
                                    T = {{lost[3 * i + 1], lost[3 * i + 2]}};
                const double friction =
                  turning[i].friction + (of_rates ? advance * turning[i].friction_rate : 0.);
                M(2 * i, 2 * j + a)     = dot(e, T) + friction * lost[3 * i];
                M(2 * i + 1, 2 * j + a) = dot(side, T);
              }
          }
        M(2 * j + 1, 2 * j + 1) += shear / arms[j];
        if (of_rates)
          M(2 * j, 2 * j + 1) -=
            (sj[0] * residual.flow[3 * j + 1] + sj[1] * residual.flow[3 * j + 2]) / arms[j];
      }
    own.factors.emplace(M, is_weak);
    return true;
  }

  bool
  TurningStageSolver::take_step(const Vector &step,
                                const Vector &arms,
                                Vector &xi,
                                TurningStage &stage)
  {
    constexpr double largest_turn = 1.;
    bool is_whole                 = true;
    for (std::size_t j = 0; j < xi.size(); ++j)
      {
        xi[j] += step[2 * j];
        const double wanted   = step[2 * j + 1] / arms[j],
                     turn     = std::clamp(wanted, -largest_turn, largest_turn);
        is_whole              = is_whole && turn == wanted;
        const TangentVector e = stage.directions[j], side = normal_to(e);
        for (std::size_t a = 0; a < 2; ++a)
          stage.directions[j][a] = std::cos(turn) * e[a] + std::sin(turn) * side[a];
      }
    return is_whole;
  }

  // Whether a stage can be solved must not depend on what was solved before.
  bool
  TurningStageSolver::solve(const Demand demand,
                            const double tau,
                            const double advance,
                            const TurningStage &base,
                            Vector &xi,
                            TurningStage &stage)
  {
    const bool has_old_factors     = factorisations[0].factors || factorisations[1].factors;
    const Vector first_xi          = xi;
    const TurningStage first_stage = stage;
    if (iterate(demand, tau, advance, base, xi, stage))
      return true;
    factorisations = {};
    if (!has_old_factors)
      return false;
    xi    = first_xi;
    stage = first_stage;
    return iterate(demand, tau, advance, base, xi, stage);
  }

  bool
  TurningStageSolver::iterate(const Demand demand,
                              const double tau,
                              const double advance,
                              const TurningStage &base,
                              Vector &xi,
                              TurningStage &stage)
  {
    constexpr unsigned int max_iterations = 30, patience = 8;
    // Residuals, in units of rounding, at which a stagnating iteration is accepted, and above which
    // its steps show more than rounding.
    constexpr double accepted = 20., well_above_rounding = 1e3;
    // Reduction that new factors should achieve at a time. Others are given up if more iterations
    // with them are ahead than new ones would cost.
    constexpr double slow      = 0.2;
    const double worthwhile    = 6. + static_cast<double>(turning.size()) / 40.;
    Factorisation &own         = factorisations[static_cast<std::size_t>(demand)];
    const Vector noise_of_base = noise(tau, base);
    Residual residual          = evaluate(demand, base, noise_of_base, advance, xi, stage);
    bool needs_factors         = !own.factors;
    double best                = std::numeric_limits<double>::infinity();
    unsigned int since_best    = 0;
    Vector last_step; // empty if nothing can be learnt from it
    ++count.n_solutions;
    for (unsigned int i = 0; i < max_iterations && since_best < patience; ++i)
      {
        if (residual.worst <= 1.)
          return true;
        if (!std::isfinite(residual.worst))
          return false;
        const bool fresh = needs_factors && take_factors(demand, advance, xi, stage, residual);
        if (own.factors->first_factors().reciprocal_condition() == 0.)
          return false;
        if (needs_factors)
          last_step.clear();
        Vector step = own.factors->solve(residual.values, last_step);
        ++count.n_iterations;
        count.max_in_one                = std::max<std::size_t>(count.max_in_one, i + 1);
        const TurningStage stage_before = stage;
        const Vector xi_before          = xi;
        const Residual residual_before  = residual;
        const bool is_whole             = take_step(step, own.arms, xi, stage);
        residual                        = evaluate(demand, base, noise_of_base, advance, xi, stage);
        if (residual.worst <= accepted && residual.worst >= 0.5 * residual_before.worst)
          return true;
        const double gain = residual_before.worst / residual.worst;
        needs_factors     = !(std::log(residual.worst) <= worthwhile * std::log(gain));
        turns_are_coupled = turns_are_coupled || (fresh && slow * gain < 1. &&
                                                  own.factors->first_factors().has_weak_unknowns());
        last_step =
          is_whole && residual_before.worst > well_above_rounding ? std::move(step) : Vector();
        since_best = residual.worst < 0.5 * best ? 0 : since_best + 1;
        best       = std::min(best, residual.worst);
        if (residual.worst < 10. * residual_before.worst)
          continue;
        if (fresh)
          return false;
        stage    = stage_before;
        xi       = xi_before;
        residual = residual_before;
      }
    return residual.worst <= accepted;
  }

  std::optional<Vector>
  TurningStageSolver::slip_rates(const TurningStage &stage) const
  {
    const std::size_t n = turning.size();
    DenseMatrix M(n, n);
    Vector rates(n);
    for (std::size_t i = 0; i < n; ++i)
      {
        const TurningElement &own = turning[i];
        const TangentVector e     = stage.directions[i];
        rates[i] = own.friction * response.rates[3 * i] + e[0] * response.rates[3 * i + 1] +
                   e[1] * response.rates[3 * i + 2] -
                   (own.cohesion_rate - own.friction_rate * stage.forces[3 * i]);
      }
    for (std::size_t j = 0; j < n; ++j)
      {
        const Vector lost = lost_forces(j, stage.directions[j], turning[j].rise);
        for (std::size_t i = 0; i < n; ++i)
          M(i, j) = turning[i].friction * lost[3 * i] +
                    dot(stage.directions[i], {{lost[3 * i + 1], lost[3 * i + 2]}});
      }
    const LuFactors solver(std::move(M));
    if (solver.reciprocal_condition() == 0.)
      return {};
    solver.solve(rates);
    return rates;
  }
} // namespace fuga
