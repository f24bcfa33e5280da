// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/cone_stage.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    /** The bars of the slipping elements, and which of the rows N, T1, T2 of each they are. */
    struct SlippingBars
    {
      std::vector<std::size_t> bars, rows;

      SlippingBars(const std::vector<ContactElement> &elements,
                   const std::vector<SlippingElement> &slipping)
      {
        for (std::size_t i = 0; i < slipping.size(); ++i)
          {
            const ContactElement &element                = elements[slipping[i].element];
            const std::array<unsigned int, 3> of_element = {
              {element.normal_bar, element.tangential_bar, element.second_tangential_bar}};
            for (std::size_t a = 0; a < element.n_bars(); ++a)
              {
                bars.push_back(of_element[a]);
                rows.push_back(3 * i + a);
              }
          }
      }
    };
  } // namespace

  ConeStageSolver::ConeStageSolver(const std::vector<ContactElement> &elements,
                                   const std::vector<SlippingElement> &slipping_elements,
                                   const ReleasedSystem &released,
                                   const Vector &at_start,
                                   const Vector &rates,
                                   IterationCount &iteration_count)
    : slipping(slipping_elements)
    , count(iteration_count)
    , K(3 * slipping.size(), 2 * slipping.size())
  {
    const SlippingBars own(elements, slipping);
    const Vector reduced_start = released.reactions(at_start, own.bars);
    const Vector reduced_rates = released.reactions(rates, own.bars);
    const DenseMatrix reduced  = released.stiffness(own.bars);
    p0.assign(3 * slipping.size(), 0.);
    p1 = p0;
    for (std::size_t j = 0; j < own.bars.size(); ++j)
      {
        const std::size_t row = own.rows[j];
        p0[row]               = reduced_start[j];
        p1[row]               = reduced_rates[j];
        if (row % 3 == 0)
          continue;
        const std::size_t column = 2 * (row / 3) + row % 3 - 1;
        for (std::size_t i = 0; i < own.bars.size(); ++i)
          K(own.rows[i], column) = reduced(i, j);
      }
    for (const SlippingElement &slip : slipping)
      {
        diagonal.push_back(released.own_stiffness(elements[slip.element].tangential_bar));
        is_plane.push_back(elements[slip.element].has_second_tangential_bar());
      }
  }

  Vector
  ConeStageSolver::resistance(const Vector &slips) const
  {
    return K.empty() ? Vector() : multiply(K, slips);
  }

  // Terms as large as the stiffness where rigid joints cross times the longest slip cancel.
  ConeStageSolver::Base
  ConeStageSolver::base(const double tau, const Accurate &slips) const
  {
    constexpr double rounding = 1e-15, slip_rounding = 1e-18;
    Accurate forces     = accurate(p0);
    double longest_slip = 0.;
    add_scaled(forces.size(), tau, p1.data(), forces.data());
    for (std::size_t j = 0; j < slips.size(); ++j)
      {
        add_scaled(forces.size(), -slips[j], K.column(j), forces.data());
        longest_slip = std::max(longest_slip, std::abs(static_cast<double>(slips[j])));
      }
    Base result = {slips, {forces.begin(), forces.end()}, {}};
    for (std::size_t i = 0; i < slipping.size(); ++i)
      {
        double size = 0.;
        for (std::size_t a = 0; a < 3; ++a)
          size += (a == 0 ? slipping[i].friction : 1.) *
                  (std::abs(p0[3 * i + a]) + std::abs(tau * p1[3 * i + a]));
        result.noise.push_back(rounding * size + slip_rounding * diagonal[i] * longest_slip);
      }
    return result;
  }

  // Components along e and across: T + f N e, or its rate along e.
  ConeStageSolver::Residual
  ConeStageSolver::evaluate(const Demand demand,
                            const Base &from,
                            const double advance,
                            const Vector &xi,
                            ConeStage &stage) const
  {
    constexpr double rounding = 1e-15;
    const std::size_t n       = slipping.size();
    Vector flow(2 * n);
    stage.slips = from.slips;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t a = 0; a < 2; ++a)
        {
          flow[2 * i + a] = xi[i] * stage.directions[i][a];
          stage.slips[2 * i + a] += flow[2 * i + a];
        }
    const Vector change = resistance(flow);
    stage.forces        = from.forces;
    Residual result;
    result.values.resize(2 * n);
    result.flow.resize(3 * n);
    for (std::size_t i = 0; i < 3 * n; ++i)
      {
        stage.forces[i] -= change[i];
        result.flow[i] = advance * p1[i] - change[i];
      }
    const Vector &along    = demand == Demand::rates ? result.flow : stage.forces;
    const double flow_size = max_abs(xi);
    for (std::size_t i = 0; i < n; ++i)
      {
        const double f        = slipping[i].friction;
        const TangentVector e = stage.directions[i], side = normal_to(e);
        result.values[2 * i] = e[0] * along[3 * i + 1] + e[1] * along[3 * i + 2] + f * along[3 * i];
        result.values[2 * i + 1] =
          side[0] * stage.forces[3 * i + 1] + side[1] * stage.forces[3 * i + 2];
        const double noise = from.noise[i] + rounding * diagonal[i] * flow_size;
        for (std::size_t a = 0; a < 2; ++a)
          if (result.values[2 * i + a] != 0.)
            result.worst = std::max(result.worst, std::abs(result.values[2 * i + a]) / noise);
      }
    return result;
  }

  void
  ConeStageSolver::factorise(const Demand demand,
                             const Vector &xi,
                             const ConeStage &stage,
                             const Residual &residual)
  {
    const std::size_t n = slipping.size();
    Vector &arms        = factorisations[static_cast<std::size_t>(demand)].arms;
    arms.resize(n);
    DenseMatrix M(2 * n, 2 * n);
    for (std::size_t j = 0; j < n; ++j)
      {
        const TangentVector ej = stage.directions[j], sj = normal_to(ej);
        const double k     = diagonal[j];
        const double shear = ej[0] * stage.forces[3 * j + 1] + ej[1] * stage.forces[3 * j + 2];
        arms[j]            = std::abs(xi[j]) + std::abs(shear) / k;
        if (arms[j] == 0.)
          arms[j] = std::numeric_limits<double>::min();
        const double ratio = xi[j] / arms[j];
        for (std::size_t i = 0; i < n; ++i)
          {
            const TangentVector e = stage.directions[i], side = normal_to(e);
            for (std::size_t a = 0; a < 2; ++a)
              {
                const TangentVector c = a == 0 ? ej : TangentVector{{ratio * sj[0], ratio * sj[1]}};
                const auto force      = [&](const std::size_t row) {
                  return K(3 * i + row, 2 * j) * c[0] + K(3 * i + row, 2 * j + 1) * c[1];
                };
                const TangentVector T   = {{force(1), force(2)}};
                M(2 * i, 2 * j + a)     = dot(e, T) + slipping[i].friction * force(0);
                M(2 * i + 1, 2 * j + a) = dot(side, T);
              }
          }
        // Along a single bar nothing turns.
        M(2 * j + 1, 2 * j + 1) += is_plane[j] ? shear / arms[j] : 1.;
        if (demand == Demand::rates)
          M(2 * j, 2 * j + 1) -=
            (sj[0] * residual.flow[3 * j + 1] + sj[1] * residual.flow[3 * j + 2]) / arms[j];
      }
    factorisations[static_cast<std::size_t>(demand)].factors.emplace(std::move(M));
  }

  void
  ConeStageSolver::take_step(const Vector &step, const Vector &arms, Vector &xi, ConeStage &stage)
  {
    constexpr double largest_turn = 1.;
    for (std::size_t j = 0; j < xi.size(); ++j)
      {
        xi[j] += step[2 * j];
        const double turn     = std::clamp(step[2 * j + 1] / arms[j], -largest_turn, largest_turn);
        const TangentVector e = stage.directions[j], side = normal_to(e);
        for (std::size_t a = 0; a < 2; ++a)
          stage.directions[j][a] = std::cos(turn) * e[a] + std::sin(turn) * side[a];
      }
  }

  bool
  ConeStageSolver::solve(const Demand demand,
                         const double tau,
                         const double advance,
                         const Accurate &base_slips,
                         Vector &xi,
                         ConeStage &stage)
  {
    constexpr unsigned int max_iterations = 30;
    // Residuals, in units of rounding, with which an iteration that stands still is accepted.
    constexpr double accepted = 20.;
    // Factors serve as long as they gain a digit or so at a time.
    constexpr double slow        = 0.2;
    Factorisation &factorisation = factorisations[static_cast<std::size_t>(demand)];
    const Base from              = base(tau, base_slips);
    Residual residual            = evaluate(demand, from, advance, xi, stage);
    bool needs_factors           = !factorisation.factors;
    ++count.n_solutions;
    for (unsigned int i = 0; i < max_iterations; ++i)
      {
        if (residual.worst <= 1.)
          return true;
        if (!std::isfinite(residual.worst))
          return false;
        const bool fresh = needs_factors;
        if (needs_factors)
          factorise(demand, xi, stage, residual);
        if (factorisation.factors->reciprocal_condition() == 0.)
          {
            factorisation.factors.reset();
            return false;
          }
        Vector step = residual.values;
        factorisation.factors->solve(step);
        ++count.n_iterations;
        count.max_in_one               = std::max<std::size_t>(count.max_in_one, i + 1);
        const ConeStage stage_before   = stage;
        const Vector xi_before         = xi;
        const Residual residual_before = residual;
        take_step(step, factorisation.arms, xi, stage);
        residual = evaluate(demand, from, advance, xi, stage);
        if (residual.worst <= accepted && residual.worst >= 0.5 * residual_before.worst)
          return true;
        needs_factors = !(residual.worst <= slow * residual_before.worst);
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
  ConeStageSolver::slip_rates(const std::vector<TangentVector> &directions) const
  {
    const std::size_t n = slipping.size();
    DenseMatrix M(n, n);
    Vector rates(n);
    for (std::size_t i = 0; i < n; ++i)
      {
        const TangentVector e = directions[i];
        const double f        = slipping[i].friction;
        rates[i]              = f * p1[3 * i] + e[0] * p1[3 * i + 1] + e[1] * p1[3 * i + 2];
        for (std::size_t j = 0; j < n; ++j)
          for (std::size_t a = 0; a < 2; ++a)
            M(i, j) += (f * K(3 * i, 2 * j + a) + e[0] * K(3 * i + 1, 2 * j + a) +
                        e[1] * K(3 * i + 2, 2 * j + a)) *
                       directions[j][a];
      }
    const LuFactors solver(std::move(M));
    if (solver.reciprocal_condition() == 0.)
      return {};
    solver.solve(rates);
    return rates;
  }
} // namespace fuga
