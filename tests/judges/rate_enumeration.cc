// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "judges/rate_enumeration.h"

#include "judges/linear_solve.h"
#include "judges/scheme.h"
#include "judges/sizes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fuga::judges
{
  namespace
  {
    bool
    equal(const Vector &u, const Vector &v)
    {
      const double scale = std::max(largest(u), largest(v));
      for (std::size_t i = 0; i < u.size(); ++i)
        if (std::abs(u[i] - v[i]) > 1e-8 * scale)
          return false;
      return true;
    }

    std::vector<ContactState>
    choices(const JudgeElement &element, const RateElement &at)
    {
      switch (at.status)
        {
          case RateStatus::open:
            return {ContactState::open};
          case RateStatus::stick:
            return {ContactState::stick};
          case RateStatus::frictionless:
            return {element.has_tangential_bar() ? ContactState::slip_forward
                                                 : ContactState::stick};
          case RateStatus::slip_limit:
            if (!(std::abs(at.sign) == 1.) || !element.has_tangential_bar())
              throw std::invalid_argument("enumerate_rates: slip_limit needs sign = ±1 and a bar");
            return {ContactState::stick,
                    at.sign > 0. ? ContactState::slip_forward : ContactState::slip_backward};
          case RateStatus::grazing:
            if (element.has_tangential_bar() && element.cohesion == 0.)
              return {ContactState::open,
                      ContactState::stick,
                      ContactState::slip_forward,
                      ContactState::slip_backward};
            return {ContactState::open, ContactState::stick};
        }
      return {};
    }

    /** The inequalities of one element. */
    bool
    consistent(const JudgeElement &element,
               const RateElement &at,
               const ContactState state,
               const RateSolution &rates,
               const double slip_rate,
               const double load_size,
               const double tolerance)
    {
      const double F     = tolerance * std::max(load_size, largest(rates.forces));
      const double L     = tolerance * largest(rates.jumps);
      const double N     = rates.forces[element.normal_bar];
      const bool bar     = element.has_tangential_bar();
      const double T     = bar ? rates.forces[element.tangential_bar] : 0.;
      const double sigma = slip_sign(state);
      if (at.status == RateStatus::slip_limit)
        return state == ContactState::stick ? at.sign * T <= -element.friction * N + F
                                            : sigma * slip_rate >= -L;
      if (at.status != RateStatus::grazing)
        return true;
      if (state == ContactState::open)
        return rates.jumps[element.normal_bar] >= -L;
      if (N > F)
        return false;
      if (state == ContactState::stick)
        return !bar || element.cohesion > 0. || std::abs(T) <= -element.friction * N + F;
      return sigma * slip_rate >= -L;
    }
  } // namespace


  RateEnumeration
  enumerate_rates(const JudgeProblem &problem,
                  const std::vector<RateElement> &elements,
                  const Vector &load_rate,
                  const double tolerance)
  {
    validate(problem);
    const std::size_t n   = problem.elements.size();
    const std::size_t n_x = problem.n_coordinates();
    if (elements.size() != n)
      throw std::invalid_argument("enumerate_rates: one RateElement per element, please");

    std::vector<std::vector<ContactState>> options;
    Vector compliances = normal_compliances(problem);
    double n_schemes   = 1.;
    for (std::size_t k = 0; k < n; ++k)
      {
        const JudgeElement &element = problem.elements[k];
        options.push_back(choices(element, elements[k]));
        n_schemes *= static_cast<double>(options.back().size());
        if (element.has_nonlinear_layer())
          compliances[k] = 1. / cubic_root_tangent(element.normal_compliance,
                                                   element.layer_thickness,
                                                   std::max(0., elements[k].closure));
      }
    if (n_schemes > 262144.)
      throw std::invalid_argument("enumerate_rates: too many boundary elements");

    RateEnumeration result;
    std::vector<std::size_t> digits(n, 0);
    std::vector<ContactState> states(n);
    Vector rhs(load_rate);
    rhs.resize(n_x + problem.n_bars(), 0.);
    while (true)
      {
        for (std::size_t k = 0; k < n; ++k)
          states[k] = options[k][digits[k]];
        ++result.n_schemes;
        const LinearSolution linear =
          solve_linear(scheme_matrix(problem, states, compliances), rhs, true);
        if (!linear.regular)
          ++result.n_singular;
        if (linear.regular || linear.consistent)
          {
            RateSolution rates;
            const double *const values = linear.X.col(0).data();
            rates.x.assign(values, values + n_x);
            rates.forces.assign(values + n_x, values + rhs.size());
            rates.jumps   = problem.jumps(rates.x);
            rates.states  = states;
            rates.family  = !linear.regular;
            bool accepted = true;
            for (std::size_t k = 0; k < n; ++k)
              {
                const JudgeElement &element = problem.elements[k];
                double slip                 = 0.;
                if (element.has_tangential_bar() && states[k] != ContactState::stick)
                  slip =
                    rates.jumps[element.tangential_bar] -
                    element.shear_compliance / element.area * rates.forces[element.tangential_bar];
                rates.slip.push_back(slip);
                accepted =
                  accepted &&
                  consistent(
                    element, elements[k], states[k], rates, slip, largest(load_rate), tolerance);
              }
            for (const RateSolution &known : result.solutions)
              accepted =
                accepted && !(equal(known.x, rates.x) && equal(known.forces, rates.forces));
            if (accepted)
              result.solutions.push_back(rates);
          }

        std::size_t k = 0;
        while (k < n && ++digits[k] == options[k].size())
          digits[k++] = 0;
        if (k == n)
          return result;
      }
  }

  std::vector<RateElement>
  rate_elements(const JudgeProblem &problem, const StepSolution &solution, const double tolerance)
  {
    const double F = tolerance * largest(solution.forces);
    const double L = tolerance * std::max(largest(solution.jumps), largest(solution.gap));
    std::vector<RateElement> result;
    for (std::size_t k = 0; k < problem.elements.size(); ++k)
      {
        const JudgeElement &element = problem.elements[k];
        const double pressing       = -solution.forces[element.normal_bar];
        const double T =
          element.has_tangential_bar() ? solution.forces[element.tangential_bar] : 0.;
        RateElement at;
        at.closure         = std::max(0., -solution.gap[k]);
        const double limit = element.friction * pressing + element.cohesion * element.area;
        if (pressing <= F)
          at.status = solution.gap[k] > L ? RateStatus::open : RateStatus::grazing;
        else if (element.has_tangential_bar() && element.friction == 0. && element.cohesion == 0.)
          at.status = RateStatus::frictionless;
        else if (element.has_tangential_bar() && std::abs(T) >= limit - F)
          {
            at.status = RateStatus::slip_limit;
            at.sign   = T >= 0. ? 1. : -1.;
          }
        result.push_back(at);
      }
    return result;
  }
} // namespace fuga::judges
