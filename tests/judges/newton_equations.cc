// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "judges/newton_equations.h"

#include <algorithm>
#include <cmath>

namespace fuga::judges
{
  NewtonEquations::NewtonEquations(const JudgeProblem &problem_,
                                   const Vector &slip_before_,
                                   const Vector &load_before,
                                   const Vector &load)
    : problem(problem_)
    , slip_before(slip_before_)
    , form(dislocation_form(problem_, {load_before, load}))
    , stiffness(stiffness_scales(form.W))
  {
  }

  Vector
  NewtonEquations::start() const
  {
    Vector y(problem.n_bars(), 0.);
    for (std::size_t k = 0; k < problem.elements.size(); ++k)
      {
        const JudgeElement &element = problem.elements[k];
        y[element.normal_bar]       = element.initial_gap;
        if (element.has_tangential_bar())
          y[element.tangential_bar] = slip_before[k];
      }
    return y;
  }

  void
  NewtonEquations::dislocations(const Vector &y, Vector &d, Vector &slope) const
  {
    d = y;
    slope.assign(y.size(), 1.);
    for (const JudgeElement &element : problem.elements)
      {
        const std::size_t n = element.normal_bar;
        d[n] -= element.initial_gap;
        if (element.has_nonlinear_layer() && y[n] < 0.)
          {
            const double rho = element.normal_compliance, zeta = element.layer_thickness;
            d[n] += rho * cubic_root_stress(rho, zeta, -y[n]);
            slope[n] -= rho * cubic_root_tangent(rho, zeta, -y[n]);
          }
      }
  }

  Vector
  NewtonEquations::forces(const Vector &d) const
  {
    Vector p(d.size());
    for (std::size_t i = 0; i < p.size(); ++i)
      p[i] = (1. - load_part) * form.R[0][i] + load_part * form.R[1][i];
    for (std::size_t j = 0; j < d.size(); ++j)
      for (std::size_t i = 0; i < p.size(); ++i)
        p[i] -= form.W(i, j) * d[j];
    return p;
  }

  Vector
  NewtonEquations::evaluate(const Vector &y, DenseMatrix *const jacobian) const
  {
    Vector d, slope;
    dislocations(y, d, slope);
    const Vector p = forces(d);
    Vector F(y.size());
    // Row i of the Jacobian: (factor) ∂p_b plus single entries.
    const auto add_force_row = [&](const std::size_t row, const std::size_t b, double factor) {
      if (jacobian != nullptr)
        for (std::size_t j = 0; j < y.size(); ++j)
          (*jacobian)(row, j) -= factor * form.W(b, j) * slope[j];
    };
    const auto add_entry = [&](const std::size_t row, const std::size_t j, double value) {
      if (jacobian != nullptr)
        (*jacobian)(row, j) += value;
    };
    for (std::size_t k = 0; k < problem.elements.size(); ++k)
      {
        const JudgeElement &element = problem.elements[k];
        const std::size_t n         = element.normal_bar;
        const bool law9             = element.has_nonlinear_layer();
        const double c_n            = scale * stiffness[n];
        const bool closed           = law9 ? y[n] < 0. : p[n] + c_n * y[n] < 0.;
        double pressing = 0., pressing_slope = 0.;
        if (law9)
          {
            const double rho = element.normal_compliance, zeta = element.layer_thickness;
            if (closed)
              {
                pressing       = element.area * cubic_root_stress(rho, zeta, -y[n]);
                pressing_slope = -element.area * cubic_root_tangent(rho, zeta, -y[n]);
              }
            F[n] = p[n] + pressing;
            add_force_row(n, n, 1.);
            add_entry(n, n, pressing_slope);
          }
        else if (closed)
          {
            pressing = -(p[n] + c_n * y[n]);
            F[n]     = -c_n * y[n];
            add_entry(n, n, -c_n);
          }
        else
          {
            F[n] = p[n];
            add_force_row(n, n, 1.);
          }
        if (!element.has_tangential_bar())
          continue;

        const std::size_t t = element.tangential_bar;
        const double c_t    = scale * stiffness[t];
        const double mu =
          friction_part * element.friction * element.envelope.slope(element.area, pressing);
        const double trial = p[t] + c_t * (y[t] - slip_before[k]);
        const double r     = closed ? friction_part * element.strength(pressing) : 0.;
        if (closed && std::abs(trial) < r)
          {
            F[t] = -c_t * (y[t] - slip_before[k]);
            add_entry(t, t, -c_t);
            continue;
          }
        const double sign = trial >= 0. ? 1. : -1.;
        F[t]              = p[t] - sign * r;
        add_force_row(t, t, 1.);
        if (closed && law9)
          add_entry(t, n, -sign * mu * pressing_slope);
        else if (closed)
          {
            add_force_row(t, n, sign * mu);
            add_entry(t, n, sign * mu * c_n);
          }
      }
    return F;
  }

  double
  NewtonEquations::permitted_part(const Vector &y, const Vector &dy) const
  {
    double part = 1.;
    for (const JudgeElement &element : problem.elements)
      if (element.has_nonlinear_layer() && dy[element.normal_bar] < 0.)
        part = std::min(
          part, .9 * (element.layer_thickness + y[element.normal_bar]) / -dy[element.normal_bar]);
    return part;
  }

  StepSolution
  NewtonEquations::solution(const Vector &y, const Vector &load) const
  {
    StepSolution result;
    Vector d, slope;
    dislocations(y, d, slope);
    result.forces   = forces(d);
    result.x        = form.x_R[1];
    Vector openings = y;
    for (std::size_t j = 0; j < d.size(); ++j)
      for (std::size_t i = 0; i < result.x.size(); ++i)
        result.x[i] += form.X(i, j) * d[j];
    for (const JudgeElement &element : problem.elements)
      {
        if (element.has_nonlinear_layer())
          openings[element.normal_bar] = std::max(0., y[element.normal_bar]);
        result.slip.push_back(element.has_tangential_bar() ? y[element.tangential_bar] : 0.);
      }
    result.states = name_states(problem, slip_before, result.forces, openings, stiffness);
    complete(problem, slip_before, load, result);
    return result;
  }

} // namespace fuga::judges
