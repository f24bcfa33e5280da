// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "judges/cone_newton.h"

#include "judges/linear_solve.h"
#include "judges/sizes.h"

#include <algorithm>
#include <cmath>

namespace fuga::judges
{
  namespace
  {
    /** Every bar as a bonded spring of its own: what a DislocationForm needs. */
    JudgeProblem
    bonded(const DenseMatrix &S, const DenseMatrix &B, const std::vector<ConeElement> &elements)
    {
      JudgeProblem problem;
      problem.S      = S;
      problem.B      = B;
      const auto add = [&](const unsigned int bar, const double compliance, const double area) {
        JudgeElement spring;
        spring.normal_bar        = bar;
        spring.area              = area;
        spring.normal_compliance = compliance;
        problem.elements.push_back(spring);
      };
      for (const ConeElement &element : elements)
        {
          add(element.normal_bar, element.normal_compliance, element.area);
          for (const unsigned int bar : element.tangential_bars)
            add(bar, element.shear_compliance, element.area);
        }
      validate(problem);
      return problem;
    }

    std::vector<Vector>
    columns_of(const DenseMatrix &matrix)
    {
      std::vector<Vector> result;
      for (Eigen::Index j = 0; j < matrix.cols(); ++j)
        result.emplace_back(matrix.col(j).data(), matrix.col(j).data() + matrix.rows());
      return result;
    }
  } // namespace

  ConeNewton::ConeNewton(const DenseMatrix &S,
                         const DenseMatrix &B,
                         const DenseMatrix &load_patterns,
                         std::vector<ConeElement> elements_)
    : elements(std::move(elements_))
    , form(dislocation_form(bonded(S, B, elements), columns_of(load_patterns)))
    , stiffness(stiffness_scales(form.W))
  {
  }

  ConeNewton
  ConeNewton::with(std::vector<ConeElement> others) const
  {
    ConeNewton result(*this);
    result.elements = std::move(others);
    return result;
  }

  Vector
  ConeNewton::reactions(const Vector &factors) const
  {
    Vector R(stiffness.size(), 0.);
    for (std::size_t l = 0; l < factors.size(); ++l)
      for (std::size_t i = 0; i < R.size(); ++i)
        R[i] += factors[l] * form.R[l][i];
    return R;
  }

  Vector
  ConeNewton::dislocations(const Vector &y, Vector &slope) const
  {
    Vector d = y;
    slope.assign(y.size(), 1.);
    for (const ConeElement &element : elements)
      {
        const std::size_t n = element.normal_bar;
        d[n] -= element.initial_gap;
        if (element.is_curved() && y[n] < 0.)
          {
            d[n] += element.normal_compliance * element.stress(-y[n]);
            slope[n] -= element.normal_compliance * element.tangent(-y[n]);
          }
      }
    return d;
  }

  Vector
  ConeNewton::forces(const Vector &R, const Vector &y) const
  {
    Vector p       = R, slope;
    const Vector d = dislocations(y, slope);
    for (std::size_t j = 0; j < y.size(); ++j)
      for (std::size_t i = 0; i < p.size(); ++i)
        p[i] -= form.W(i, j) * d[j];
    return p;
  }

  double
  ConeNewton::permitted_part(const Vector &y, const Vector &dy) const
  {
    double part = 1.;
    for (const ConeElement &element : elements)
      if (const std::size_t n = element.normal_bar; element.is_curved() && dy[n] < 0.)
        part = std::min(part, .9 * (element.closure_limit + y[n]) / -dy[n]);
    return part;
  }

  double
  ConeNewton::size(const Vector &R, const Vector &p, const Vector &y) const
  {
    double result = std::max({largest(R), largest(p), 1e-300});
    for (std::size_t i = 0; i < y.size(); ++i)
      result = std::max(result, std::abs(stiffness[i] * y[i]));
    return result;
  }

  Vector
  ConeNewton::evaluate(const Vector &R,
                       const Vector &before,
                       const Vector &y,
                       DenseMatrix *const jacobian) const
  {
    const Vector p = forces(R, y);
    Vector F(y.size()), slope;
    dislocations(y, slope);
    const auto add_force = [&](const std::size_t row, const std::size_t bar, const double factor) {
      if (jacobian != nullptr)
        for (std::size_t j = 0; j < y.size(); ++j)
          (*jacobian)(row, j) -= factor * form.W(bar, j) * slope[j];
    };
    const auto add_jump = [&](const std::size_t row, const std::size_t bar, const double factor) {
      if (jacobian != nullptr)
        (*jacobian)(row, bar) += factor;
    };
    for (const ConeElement &element : elements)
      {
        const std::size_t n = element.normal_bar;
        const double c_n    = scale * stiffness[n];
        const bool curved   = element.is_curved();
        const bool closed   = curved ? y[n] < 0. : p[n] + c_n * y[n] < 0.;
        double pressing = 0., hardening = 0.; // P and, of a curved layer, -dP/da
        if (closed && curved)
          {
            pressing  = element.area * element.stress(-y[n]);
            hardening = element.area * element.tangent(-y[n]);
          }
        else if (closed)
          pressing = -(p[n] + c_n * y[n]);
        F[n] = p[n] + pressing;
        if (closed && !curved)
          add_jump(n, n, -c_n);
        else
          {
            add_force(n, n, 1.);
            add_jump(n, n, -hardening);
          }

        const auto &bars = element.tangential_bars;
        double c_t       = 0.;
        for (const unsigned int bar : bars)
          c_t = std::max(c_t, scale * stiffness[bar]);
        Vector trial;
        for (const unsigned int bar : bars)
          trial.push_back(p[bar] + c_t * (y[bar] - before[bar]));
        const double r       = closed ? element.strength(pressing) : 0.;
        const double mu      = element.friction * element.envelope.slope(element.area, pressing);
        const double trial_r = norm(trial);
        for (std::size_t a = 0; a < bars.size(); ++a)
          if (closed && trial_r < r)
            {
              F[bars[a]] = -c_t * (y[bars[a]] - before[bars[a]]);
              add_jump(bars[a], bars[a], -c_t);
            }
          else
            {
              const double e = trial_r > 0. ? trial[a] / trial_r : 0.;
              F[bars[a]]     = p[bars[a]] - r * e;
              add_force(bars[a], bars[a], 1.);
              if (!closed || trial_r == 0.)
                continue;
              // r changes with the pressing force, e with the part of the trial force across it.
              if (!curved)
                add_force(bars[a], n, e * mu);
              add_jump(bars[a], n, e * mu * (curved ? hardening : c_n));
              for (std::size_t b = 0; b < bars.size(); ++b)
                {
                  const double across = (a == b ? 1. : 0.) - e * trial[b] / trial_r;
                  add_force(bars[a], bars[b], -r / trial_r * across);
                  add_jump(bars[a], bars[b], -r / trial_r * across * c_t);
                }
            }
      }
    return F;
  }

  // Damped, with a line search that lets the merit grow for a while.
  bool
  ConeNewton::newton(const Vector &R, const Vector &before, Vector &y) const
  {
    constexpr unsigned int max_iterations = 60, max_halvings = 25, window = 6;
    std::vector<double> history;
    for (unsigned int iteration = 0; iteration < max_iterations; ++iteration)
      {
        DenseMatrix jacobian(y.size(), y.size());
        Vector F             = evaluate(R, before, y, &jacobian);
        const double merit   = norm(F);
        const double rounded = size(R, forces(R, y), y);
        if (merit <= 1e-14 * rounded)
          return true;
        if (!std::isfinite(merit))
          return false;
        history.push_back(merit);
        for (double &entry : F)
          entry = -entry;
        const LinearSolution direction = solve_linear(std::move(jacobian), F, true);
        const double reference =
          *std::max_element(history.end() - static_cast<std::ptrdiff_t>(
                                              std::min<std::size_t>(history.size(), window)),
                            history.end());
        Vector candidate(y.size());
        const Vector change(direction.X.col(0).data(), direction.X.col(0).data() + y.size());
        double part      = permitted_part(y, change);
        double new_merit = 0.;
        for (unsigned int halving = 0; halving < max_halvings; ++halving, part *= .5)
          {
            for (std::size_t i = 0; i < y.size(); ++i)
              candidate[i] = y[i] + part * change[i];
            new_merit = norm(evaluate(R, before, candidate, nullptr));
            if (new_merit <= (1. - 1e-4 * part) * reference)
              break;
          }
        if (new_merit >= merit && merit <= 1e-11 * rounded)
          return true; // rounding: nothing falls any more
        if (!(new_merit <= reference))
          return false;
        y = candidate;
      }
    return false;
  }

  ConeStep
  ConeNewton::step(const Vector &before, const Vector &factors_before, const Vector &factors) const
  {
    const Vector first = reactions(factors_before), last = reactions(factors);
    const auto between = [&](const double part) {
      Vector R(first);
      for (std::size_t i = 0; i < R.size(); ++i)
        R[i] += part * (last[i] - first[i]);
      return R;
    };
    ConeStep result;
    Vector y;
    for (const double factor : {1., .1, 10.})
      {
        scale            = factor;
        y                = before;
        result.converged = newton(last, before, y);
        if (result.converged)
          break;
        // Along the load, from where it was, with increments that adapt.
        y              = before;
        double reached = 0., increment = .25;
        newton(first, before, y);
        while (reached < 1. && increment >= 1e-3)
          {
            Vector trial      = y;
            const double part = std::min(1., reached + increment);
            if (newton(between(part), before, trial))
              {
                y       = trial;
                reached = part;
                increment *= 2.;
              }
            else
              increment *= .25;
          }
        result.converged = reached >= 1.;
        if (result.converged)
          break;
      }
    result.state = {forces(last, y), y};
    return result;
  }
} // namespace fuga::judges
