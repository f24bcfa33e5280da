// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "judges/semismooth_newton.h"

#include "judges/linear_solve.h"
#include "judges/newton_equations.h"
#include "judges/scheme.h"
#include "judges/sizes.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace fuga::judges
{
  namespace
  {
    /** Newton from @p y; true if |F| fell to rounding or no longer falls at a tiny value. */
    bool
    newton(const NewtonEquations &equations,
           Vector &y,
           const bool damped,
           const unsigned int max_iterations,
           unsigned int &n_iterations)
    {
      std::vector<double> history;
      double force_size = 0.;
      for (unsigned int iteration = 0; iteration < max_iterations; ++iteration, ++n_iterations)
        {
          DenseMatrix jacobian(y.size(), y.size());
          Vector F = equations.evaluate(y, &jacobian);
          Vector d, slope;
          equations.dislocations(y, d, slope);
          force_size = std::max(norm(equations.forces(d)), norm(equations.form.R[1]));
          for (std::size_t i = 0; i < y.size(); ++i)
            force_size = std::max(force_size, std::abs(equations.stiffness[i] * d[i]));
          const double merit = norm(F);
          if (merit <= 1e-14 * force_size)
            return true;
          if (!std::isfinite(merit))
            return false;
          history.push_back(merit);

          for (double &entry : F)
            entry = -entry;
          LinearSolution step = solve_linear(std::move(jacobian), F, true);
          // A singular Jacobian: its least-squares step of least norm (Gauss-Newton) still
          // descends.
          Vector dy(step.X.col(0).data(), step.X.col(0).data() + y.size());
          double part = equations.permitted_part(y, dy);

          const std::size_t window = std::min<std::size_t>(history.size(), 6);
          const double reference =
            *std::max_element(history.end() - static_cast<std::ptrdiff_t>(window), history.end());
          Vector candidate(y.size());
          double new_merit = 0.;
          for (unsigned int halving = 0; halving < 30; ++halving, part *= .5)
            {
              for (std::size_t i = 0; i < y.size(); ++i)
                candidate[i] = y[i] + part * dy[i];
              new_merit = norm(equations.evaluate(candidate, nullptr));
              if (!damped || new_merit <= (1. - 1e-4 * part) * reference)
                break;
            }
          // Rounding: nothing falls any more.
          if (new_merit >= merit && merit <= 1e-11 * force_size)
            return true;
          if (damped && !(new_merit <= reference))
            return false;
          y = candidate;
        }
      return false;
    }

    /** Damped Newton from elements open, closed and displaced at random, always the same ones. */
    void
    try_random_starts(const NewtonEquations &equations,
                      Vector &y,
                      const NewtonOptions &options,
                      unsigned int &n_iterations)
    {
      std::mt19937 generator(1);
      const auto number = [&] { return static_cast<double>(generator()) / 2147483648. - 1.; };
      double length     = 0.;
      for (std::size_t i = 0; i < y.size(); ++i)
        length = std::max(
          {length, std::abs(y[i]), std::abs(equations.form.R[1][i]) / equations.stiffness[i]});
      const Vector start = y;
      for (unsigned int attempt = 0; attempt < options.n_random_starts; ++attempt)
        {
          y = start;
          for (const JudgeElement &element : equations.problem.elements)
            {
              const double opening  = number() * length;
              y[element.normal_bar] = element.has_nonlinear_layer()
                                        ? std::max(opening, .5 * number() * element.layer_thickness)
                                        : std::max(0., opening);
              if (element.has_tangential_bar())
                y[element.tangential_bar] += number() * length;
            }
          if (newton(equations, y, true, options.max_iterations, n_iterations))
            return;
        }
    }

    /** Leads @p part from 0 to 1 with adaptive increments. */
    bool
    follow(NewtonEquations &equations,
           double &part,
           Vector &y,
           const NewtonOptions &options,
           unsigned int &n_iterations)
    {
      double reached = 0., increment = .25;
      part = 0.;
      if (!newton(equations, y, true, options.max_iterations, n_iterations))
        y = equations.start();
      while (reached < 1.)
        {
          Vector trial = y;
          part         = std::min(1., reached + increment);
          if (newton(equations, trial, true, options.max_iterations, n_iterations))
            {
              y       = trial;
              reached = part;
              increment *= 2.;
            }
          else if ((increment *= .25) < options.smallest_increment)
            {
              part = 1.;
              return false;
            }
        }
      return true;
    }
  } // namespace


  NewtonStep
  semismooth_newton_step(const JudgeProblem &problem,
                         const Vector &slip_before,
                         const Vector &load,
                         const NewtonOptions &options)
  {
    validate(problem);
    NewtonStep result;
    const Vector load_before =
      options.load_before.empty() ? Vector(load.size(), 0.) : options.load_before;
    NewtonEquations equations(problem, slip_before, load_before, load);
    if (!equations.form.regular)
      {
        result.strategy = "indeterminate";
        return result;
      }
    const bool linear = std::none_of(problem.elements.begin(),
                                     problem.elements.end(),
                                     [](const JudgeElement &e) { return e.has_nonlinear_layer(); });
    double best       = -1.;

    for (const double scale : {1., .1, 10.})
      for (const std::string &name : options.strategies)
        {
          equations.scale = scale;
          Vector y        = equations.start();
          if (name == "random starts")
            try_random_starts(equations, y, options, result.n_iterations);
          else if (name == "load homotopy")
            follow(equations, equations.load_part, y, options, result.n_iterations);
          else if (name == "friction homotopy")
            follow(equations, equations.friction_part, y, options, result.n_iterations);
          else
            newton(equations, y, name == "damped", options.max_iterations, result.n_iterations);

          StepSolution solution = equations.solution(y, load);
          if (linear)
            {
              const SchemeSolution scheme =
                solve_scheme(problem, slip_before, load, solution.states, false);
              if (scheme.solved && scheme.solution.residual < solution.residual)
                solution = scheme.solution;
            }
          if (best < 0. || solution.residual < best)
            {
              best            = solution.residual;
              result.solution = solution;
              result.strategy = name;
            }
          if (best <= options.tolerance)
            {
              result.converged = true;
              return result;
            }
        }
    result.strategy = "none";
    return result;
  }
} // namespace fuga::judges
