// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/cones/cone_rate_problem.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** A single contact of three bars: q = r - W v. */
    struct LocalProblem
    {
      double friction;
      std::array<double, 3> r;
      double W[3][3];

      /** Return the slip that keeps the force on the cone, at the angle φ of the direction. */
      double
      slip(const TangentVector &e) const
      {
        const double force = friction * r[0] + e[0] * r[1] + e[1] * r[2];
        double stiffness   = 0.;
        for (int j = 0; j < 2; ++j)
          stiffness += (friction * W[0][j + 1] + e[0] * W[1][j + 1] + e[1] * W[2][j + 1]) * e[j];
        return force / stiffness;
      }

      double
      force(const int i, const TangentVector &e, const double xi) const
      {
        return r[i] - xi * (W[i][1] * e[0] + W[i][2] * e[1]);
      }

      /** Return the force across the direction; it is zero where the slip is parallel to the
       * force. */
      double
      defect(const double phi) const
      {
        const TangentVector e = {{std::cos(phi), std::sin(phi)}}, side = normal_to(e);
        const double xi = slip(e);
        return side[0] * force(1, e, xi) + side[1] * force(2, e, xi);
      }

      bool
      is_admissible(const double phi) const
      {
        const TangentVector e = {{std::cos(phi), std::sin(phi)}};
        const double xi       = slip(e);
        return xi >= 0. && force(0, e, xi) <= 0.;
      }

      /** Return v for open lips. */
      std::array<double, 3>
      open() const
      {
        DenseMatrix A(3, 3);
        Vector x(r.begin(), r.end());
        for (int j = 0; j < 3; ++j)
          for (int i = 0; i < 3; ++i)
            A(i, j) = W[i][j];
        LuFactors(std::move(A)).solve(x);
        return {{x[0], x[1], x[2]}};
      }

      std::array<double, 3>
      slipping() const
      {
        constexpr int n_angles = 48;
        const double first     = std::atan2(r[2], r[1]);
        const double step      = 2. * std::acos(-1.) / n_angles;
        // The angles go outwards from the direction of the force without slip.
        for (int i = 0; i < n_angles; ++i)
          {
            const double a = first + (i % 2 == 0 ? 1. : -1.) * (i / 2 + (i % 2)) * step;
            double low = a - 0.5 * step, high = a + 0.5 * step;
            const double at_low = defect(low);
            if ((at_low > 0.) == (defect(high) > 0.))
              continue;
            for (int bisection = 0; bisection < 50; ++bisection)
              {
                const double middle                                   = 0.5 * (low + high);
                ((defect(middle) > 0.) == (at_low > 0.) ? low : high) = middle;
              }
            if (!is_admissible(low))
              continue;
            const TangentVector e = {{std::cos(low), std::sin(low)}};
            const double xi       = slip(e);
            return {{0., xi * e[0], xi * e[1]}};
          }
        return {{0., 0., 0.}};
      }

      std::array<double, 3>
      solve() const
      {
        if (r[0] <= 0. && std::hypot(r[1], r[2]) <= -friction * r[0])
          return {{0., 0., 0.}};
        const std::array<double, 3> apart = open();
        return apart[0] >= 0. ? apart : slipping();
      }
    };
  } // namespace

  void
  ConeRateProblem::change_rate(const std::size_t row, const double change)
  {
    if (change == 0.)
      return;
    v[row] += change;
    view(q) -= change * W.col(row);
  }

  // The stiffness is kept above rounding, because nothing resists where an element carries a
  // mechanism by itself.
  double
  ConeRateProblem::own_stiffness(const std::size_t row) const
  {
    constexpr double rounding = 1e-13;
    return std::max(W(row, row), rounding * diagonal[row]);
  }

  void
  ConeRateProblem::relax(Candidate &candidate)
  {
    const std::size_t n = candidate.row;
    const double f      = candidate.friction;
    if (candidate.n_tangents == 0)
      {
        change_rate(n, std::max(0., v[n] + q[n] / own_stiffness(n)) - v[n]);
        return;
      }
    // A second tangent that is not free gets a row of its own without force.
    LocalProblem local       = {f, {{0., 0., 0.}}, {{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}};
    const std::size_t n_rows = candidate.n_tangents + 1;
    for (std::size_t i = 0; i < n_rows; ++i)
      {
        local.r[i] = q[n + i];
        for (std::size_t j = 0; j < n_rows; ++j)
          {
            local.W[i][j] = i == j ? own_stiffness(n + i) : W(n + i, n + j);
            local.r[i] += local.W[i][j] * v[n + j];
          }
      }
    std::array<double, 3> rates = {{0., 0., 0.}};
    if (candidate.at_apex && candidate.grazing)
      rates = local.solve();
    else
      {
        const TangentVector e =
          candidate.at_apex ? direction_of({{local.r[1], local.r[2]}}) : candidate.direction;
        const double xi = std::max(0., local.slip(e));
        rates           = {{0., xi * e[0], xi * e[1]}};
      }
    for (std::size_t i = 0; i < n_rows; ++i)
      change_rate(n + i, rates[i] - v[n + i]);
  }

  // A sweep goes from element to element; it ends early when nothing moves any more.
  void
  ConeRateProblem::sweep(const unsigned int n_sweeps)
  {
    constexpr double at_rest = 1e-10;
    double unbounded         = 0.;
    for (std::size_t i = 0; i < r.size(); ++i)
      unbounded = std::max(unbounded, 1e9 * std::abs(r[i]) / diagonal[i]);
    v.assign(bars.size(), 0.);
    q = r;
    for (unsigned int i = 0; i < n_sweeps; ++i)
      {
        const Vector before = v;
        for (Candidate &candidate : candidates)
          relax(candidate);
        double change = 0.;
        for (std::size_t j = 0; j < v.size(); ++j)
          change = std::max(change, std::abs(v[j] - before[j]));
        if (change <= at_rest * max_abs(v))
          return;
        if (i + 1 == n_sweeps || change > unbounded)
          {
            drift = v;
            for (std::size_t j = 0; j < v.size(); ++j)
              drift[j] -= before[j];
            return;
          }
      }
  }

  void
  ConeRateProblem::take_from_rates()
  {
    for (Candidate &candidate : candidates)
      {
        const std::size_t n = candidate.row;
        candidate.slip      = 0.;
        if (v[n] > 0.)
          {
            candidate.state = ContactState::open;
            continue;
          }
        candidate.state = ContactState::stick;
        if (candidate.n_tangents == 0)
          continue;
        const TangentVector v_t = tangential_rows(candidate, v);
        if (length(v_t) == 0.)
          continue;
        candidate.state = ContactState::slip_forward;
        candidate.slip  = length(v_t);
        if (!candidate.at_apex)
          continue;
        candidate.direction = {{v_t[0] / candidate.slip, v_t[1] / candidate.slip}};
        candidate.strength  = candidate.friction * std::max(-q[n], 0.);
      }
  }
} // namespace fuga
