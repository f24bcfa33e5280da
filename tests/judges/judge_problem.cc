// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "judges/judge_problem.h"

#include "judges/sizes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace fuga::judges
{
  namespace
  {
    double
    positive(const double value)
    {
      return std::max(0., value);
    }

    void
    require(const bool condition, const std::string &what)
    {
      if (!condition)
        throw std::invalid_argument("JudgeProblem: " + what);
    }

    /** Lengths and forces that relative numbers refer to. */
    struct Scales
    {
      double length = 0.;
      double force  = 0.;
    };

    Scales
    scales_of(const JudgeProblem &problem,
              const Vector &slip_before,
              const Vector &load,
              const Vector &jumps,
              const Vector &forces,
              const Vector &slip)
    {
      Scales scales;
      scales.force = std::max({largest(load), largest(forces), std::numeric_limits<double>::min()});
      // Where rigid joints let nothing move, the last digits of the jumps are measured by the
      // deformation that the largest force causes, of which they are the rounding.
      constexpr double least_share = 1e-4;
      double stiffest              = 0.;
      for (Eigen::Index i = 0; i < problem.S.rows(); ++i)
        stiffest = std::max(stiffest, problem.S(i, i));
      const double unmoved = stiffest > 0. ? least_share * scales.force / stiffest : 0.;
      scales.length        = std::max({largest(jumps),
                                       largest(slip),
                                       largest(slip_before),
                                       unmoved,
                                       std::numeric_limits<double>::min()});
      for (const JudgeElement &element : problem.elements)
        scales.length = std::max(scales.length, std::abs(element.initial_gap));
      return scales;
    }

    double
    normal_violation(const JudgeElement &element,
                     const double gap,
                     const double pressing,
                     const Scales &scales)
    {
      const double F = scales.force;
      const double L = scales.length;
      if (element.has_nonlinear_layer())
        {
          if (pressing < 0.)
            return std::max(-pressing / F, positive(-gap) / L);
          if (-gap >= element.layer_thickness)
            return std::numeric_limits<double>::infinity();
          const double rho = element.normal_compliance, zeta = element.layer_thickness;
          const double by_length = -gap - cubic_root_closure(rho, zeta, pressing / element.area);
          const double by_force =
            pressing - (gap < 0. ? element.area * cubic_root_stress(rho, zeta, -gap) : 0.);
          return std::min(std::abs(by_length) / L, std::abs(by_force) / F);
        }
      const double opening = gap + element.normal_compliance / element.area * pressing;
      return std::max({positive(-pressing) / F,
                       positive(-opening) / L,
                       std::min(positive(pressing) / F, positive(opening) / L)});
    }

    double
    tangential_violation(const JudgeElement &element,
                         const double gap,
                         const double pressing,
                         const double shear,
                         const double elastic_error,
                         const double slip_increment,
                         const Scales &scales)
    {
      const double F       = scales.force;
      const double L       = scales.length;
      const double opening = element.has_nonlinear_layer()
                               ? positive(gap)
                               : gap + element.normal_compliance / element.area * pressing;
      const bool closed    = opening / L <= std::max(positive(pressing) / F, 1e-11);
      const double limit   = element.strength(positive(pressing), closed);
      const double advance = shear >= 0. ? slip_increment : -slip_increment;
      return std::max({std::abs(elastic_error) / L,
                       positive(std::abs(shear) - limit) / F,
                       std::min(positive(limit - std::abs(shear)) / F, std::abs(advance) / L),
                       std::min(positive(-advance) / L, std::abs(shear) / F)});
    }
  } // namespace


  Vector
  JudgeProblem::jumps(const Vector &x) const
  {
    if (B.size() == 0)
      return x;
    Vector delta(B.rows(), 0.);
    for (std::size_t j = 0; j < x.size(); ++j)
      for (std::size_t i = 0; i < delta.size(); ++i)
        delta[i] += B(i, j) * x[j];
    return delta;
  }

  void
  validate(const JudgeProblem &problem)
  {
    require(problem.S.rows() == problem.S.cols(), "S is not square");
    require(problem.B.size() == 0 || problem.B.cols() == problem.S.rows(), "B does not fit S");
    std::vector<unsigned int> owners(problem.n_bars(), 0u);
    for (const JudgeElement &element : problem.elements)
      {
        require(element.normal_bar < owners.size(), "normal bar out of range");
        ++owners[element.normal_bar];
        if (element.has_tangential_bar())
          {
            require(element.tangential_bar < owners.size(), "tangential bar out of range");
            ++owners[element.tangential_bar];
          }
        require(element.area > 0., "area must be positive");
        require(element.normal_compliance >= 0. && element.shear_compliance >= 0. &&
                  element.friction >= 0. && element.cohesion >= 0. && element.layer_thickness >= 0.,
                "a negative material constant");
        require(!element.has_nonlinear_layer() || element.normal_compliance > 0.,
                "law (9) needs an initial compliance");
      }
    for (const unsigned int owner : owners)
      require(owner == 1, "every bar must belong to exactly one element");
  }

  double
  step_residual(const JudgeProblem &problem,
                const Vector &slip_before,
                const Vector &load,
                const Vector &x,
                const Vector &forces,
                const Vector &slip)
  {
    const Vector delta = problem.jumps(x);
    for (const Vector *const v : {&x, &forces, &slip})
      for (const double entry : *v)
        if (!std::isfinite(entry))
          return std::numeric_limits<double>::infinity();

    // Equilibrium.
    double imbalance = 0., largest_term = 0.;
    for (std::size_t i = 0; i < x.size(); ++i)
      {
        double sum = -load[i], terms = std::abs(load[i]);
        for (std::size_t j = 0; j < x.size(); ++j)
          {
            sum += problem.S(i, j) * x[j];
            terms = std::max(terms, std::abs(problem.S(i, j) * x[j]));
          }
        for (std::size_t bar = 0; bar < forces.size(); ++bar)
          {
            sum += problem.jump_operator(bar, i) * forces[bar];
            terms = std::max(terms, std::abs(problem.jump_operator(bar, i) * forces[bar]));
          }
        imbalance    = std::max(imbalance, std::abs(sum));
        largest_term = std::max(largest_term, terms);
      }
    double residual = largest_term > 0. ? imbalance / largest_term : 0.;

    // Contact.
    const Scales scales = scales_of(problem, slip_before, load, delta, forces, slip);
    for (std::size_t k = 0; k < problem.elements.size(); ++k)
      {
        const JudgeElement &element = problem.elements[k];
        const double gap            = element.initial_gap + delta[element.normal_bar];
        const double pressing       = -forces[element.normal_bar];
        residual = std::max(residual, normal_violation(element, gap, pressing, scales));
        if (element.has_tangential_bar())
          {
            const double shear         = forces[element.tangential_bar];
            const double elastic_error = delta[element.tangential_bar] - slip[k] -
                                         element.shear_compliance / element.area * shear;
            residual = std::max(
              residual,
              tangential_violation(
                element, gap, pressing, shear, elastic_error, slip[k] - slip_before[k], scales));
          }
      }
    return residual;
  }

  void
  complete(const JudgeProblem &problem,
           const Vector &slip_before,
           const Vector &load,
           StepSolution &solution)
  {
    solution.jumps = problem.jumps(solution.x);
    solution.gap.clear();
    for (const JudgeElement &element : problem.elements)
      solution.gap.push_back(element.initial_gap + solution.jumps[element.normal_bar]);
    const Scales scales =
      scales_of(problem, slip_before, load, solution.jumps, solution.forces, solution.slip);
    solution.force_scale  = scales.force;
    solution.length_scale = scales.length;
    solution.residual =
      step_residual(problem, slip_before, load, solution.x, solution.forces, solution.slip);
  }

  Vector
  no_slip(const JudgeProblem &problem)
  {
    return Vector(problem.elements.size(), 0.);
  }

  double
  distance(const StepSolution &a, const StepSolution &b)
  {
    const auto difference = [](const Vector &u, const Vector &v, const double scale) {
      double worst = 0.;
      for (std::size_t i = 0; i < u.size(); ++i)
        worst = std::max(worst, std::abs(u[i] - v[i]));
      return scale > 0. ? worst / scale : 0.;
    };
    return std::max(difference(a.forces, b.forces, std::max(a.force_scale, b.force_scale)),
                    difference(a.jumps, b.jumps, std::max(a.length_scale, b.length_scale)));
  }

  double
  cubic_root_stress(const double rho0, const double zeta0, const double w)
  {
    return w / (rho0 * (1. - std::cbrt(w / zeta0)));
  }

  double
  cubic_root_tangent(const double rho0, const double zeta0, const double w)
  {
    const double q = std::cbrt(w / zeta0);
    return (1. - 2. * q / 3.) / (rho0 * (1. - q) * (1. - q));
  }

  double
  cubic_root_closure(const double rho0, const double zeta0, const double sigma)
  {
    if (sigma <= 0.)
      return 0.;
    const double kappa = rho0 * sigma / zeta0;
    // q³ + κq - κ is increasing and convex for q > 0, so Newton from the right (q = 1) is monotone.
    double q = 1.;
    for (unsigned int i = 0; i < 200; ++i)
      {
        const double next = q - (q * q * q + kappa * (q - 1.)) / (3. * q * q + kappa);
        if (!(next < q))
          break;
        q = next;
      }
    return zeta0 * q * q * q;
  }
} // namespace fuga::judges
