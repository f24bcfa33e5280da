// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/cone_toy.h"
#include "known_answer.h"

#include <cmath>

namespace fuga::tests
{
  namespace
  {
    /** ∫∫ dA/r over the square of side h about (x, y), seen from the origin (Love 1929). */
    double
    potential(const double x, const double y, const double h)
    {
      const auto corner = [](const double a, const double b) {
        const double r = std::hypot(a, b);
        return a * std::log(b + r) + b * std::log(a + r);
      };
      const double x0 = x - 0.5 * h, x1 = x + 0.5 * h, y0 = y - 0.5 * h, y1 = y + 0.5 * h;
      return corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0);
    }

    /** A sphere on an elastic half space with ν = 0 (E* = 1): then normal and tangential
     * compliances are the same, u = p/(πE*)∫dA/r, and do not couple. Squares of side h under
     * uniform tractions. Load 0: approach; loads 1 and 2: shift along both tangents. */
    struct Sphere
    {
      ToySystem system;
      std::unique_ptr<ConeJoint> joint;
      double radius = 1.;
      double h      = 0.;
      std::size_t m;

      Sphere(const std::size_t n_side, const double width, const double friction)
        : h(width / static_cast<double>(n_side)), m(n_side)
      {
        const std::size_t n = m * m;
        const double pi     = std::acos(-1.);
        DenseMatrix C(n, n), inverse(n, n);
        for (std::size_t j = 0; j < n; ++j)
          {
            inverse(j, j) = 1.;
            for (std::size_t i = 0; i < n; ++i)
              C(i, j) =
                potential(place(i, 0) - place(j, 0), place(i, 1) - place(j, 1), h) / (pi * h * h);
          }
        EXPECT_TRUE(solve_positive_definite(C, inverse));
        system.S = DenseMatrix(3 * n, 3 * n);
        system.F = DenseMatrix(3 * n, 3);
        for (std::size_t i = 0; i < n; ++i)
          for (std::size_t j = 0; j < n; ++j)
            for (std::size_t a = 0; a < 3; ++a)
              {
                const double s                 = 0.5 * (inverse(i, j) + inverse(j, i));
                system.S(3 * i + a, 3 * j + a) = s;
                system.F(3 * i + a, a) += a == 0 ? -s : s;
              }
        joint = std::make_unique<ConeJoint>(n, h * h, make_rigid_law(), make_rigid_law(), friction);
        for (std::size_t i = 0; i < n; ++i)
          joint->elements[i].initial_gap =
            (place(i, 0) * place(i, 0) + place(i, 1) * place(i, 1)) / (2. * radius);
      }

      double
      place(const std::size_t element, const int direction) const
      {
        const std::size_t i = direction == 0 ? element % m : element / m;
        return h * (static_cast<double>(i) + 0.5 - 0.5 * static_cast<double>(m));
      }
    };
  } // namespace

  // Cattaneo and Mindlin: pressed first, then shifted. The shear tractions are f times the
  // difference of the pressures at the present approach δ and at δ* = δ - u/f. For these
  // compliances this holds for the discrete squares as well: T = f (|N(δ)| - |N(δ*)|) element by
  // element, without transverse forces. The stick zone is the contact zone at δ*: c/a = √(δ*/δ) =
  // (1 - Q/fP)^{1/3}.
  TEST(ConeSphere, CattaneoMindlin)
  {
    const double f = 0.3, delta = 0.02, rest = 0.5; // δ*/δ
    const double a = std::sqrt(delta);
    const Sphere sphere(17, 2.6 * a, f);
    for (const double direction : {0., 0.7})
      {
        const double shift = f * delta * (1. - rest);
        const LoadHistory history(
          {0., 1., 2.},
          {{0., 0., 0.},
           {delta, 0., 0.},
           {delta, shift * std::cos(direction), shift * std::sin(direction)}});
        const ConeRun run(sphere.system, sphere.joint->elements, history, {rest, 1., 2.});
        ASSERT_EQ(run.result.verdict, Verdict::done);
        EXPECT_LT(run.record.worst.worst(), 1e-8);
        const JointState &before = run.record.levels[0], &pressed = run.record.levels[1],
                         &end = run.record.levels[2];
        double P = 0., Q = 0., largest = 0.;
        for (std::size_t k = 0; k < sphere.m * sphere.m; ++k)
          largest = std::max(largest, -pressed.forces[3 * k]);
        std::size_t n_stick = 0, n_closed = 0;
        for (std::size_t k = 0; k < sphere.m * sphere.m; ++k)
          {
            const double N = -pressed.forces[3 * k];
            const double T = f * (N + before.forces[3 * k]);
            EXPECT_NEAR(end.forces[3 * k], -N, 1e-10 * largest);
            EXPECT_NEAR(end.forces[3 * k + 1], T * std::cos(direction), 1e-9 * largest) << k;
            EXPECT_NEAR(end.forces[3 * k + 2], T * std::sin(direction), 1e-9 * largest) << k;
            P += N;
            Q += T;
            n_stick += end.states[k] == ContactState::stick ? 1 : 0;
            n_closed += end.states[k] != ContactState::open ? 1 : 0;
          }
        // Hertz, and the ring: squares of side a/6.5 resolve areas to a few of them on the rim.
        const double hertz = 4. / 3. * std::sqrt(sphere.radius) * std::pow(delta, 1.5);
        expect_answer(
          {"V7 sphere", "P(δ)/Hertz, squares of side a/6.5", 1., "Hertz"}, P / hertz, 0.02);
        expect_answer({"V7 sphere",
                       "c/a after Q, squares of side a/6.5",
                       std::cbrt(1. - Q / (f * P)),
                       "Cattaneo, Mindlin"},
                      std::sqrt(static_cast<double>(n_stick) / static_cast<double>(n_closed)),
                      0.05);
      }
  }
} // namespace fuga::tests
