// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// V7: a cylinder as the initial gap x²/2R, on like elastic half-planes and on a soft layer.

#include "contact/half_plane.h"
#include "known_answer.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  constexpr const char *problem = "V7 line contact";
  constexpr double modulus = 2., radius = 10., f = 0.3;
  /** Gives the half-width 1: a² = 4PR/(πE*). */
  const double load = M_PI * modulus / (4. * radius);

  struct LineContact
  {
    explicit LineContact(const std::size_t n)
      : bodies(n, 2.5, modulus), joint(n, bodies.h, make_rigid_law(), make_rigid_law(), {f, 0.})
    {
      for (std::size_t i = 0; i < n; ++i)
        joint.elements[i].initial_gap = bodies.x[i] * bodies.x[i] / (2. * radius);
    }

    HalfPlanes bodies;
    ToyJoint joint;
  };

  /** Relative L2 error of a bar force against a stress. */
  template <class Stress>
  double
  error(const std::vector<double> &x,
        const double h,
        const Vector &forces,
        const std::size_t bar,
        const Stress &exact)
  {
    double difference = 0., norm = 0.;
    for (std::size_t i = 0; i < x.size(); ++i)
      {
        difference += std::pow(forces[2 * i + bar] / h - exact(x[i]), 2);
        norm += std::pow(exact(x[i]), 2);
      }
    return std::sqrt(difference / norm);
  }

  double
  ellipse(const double x, const double c)
  {
    return std::sqrt(std::max(0., 1. - x * x / (c * c)));
  }
} // namespace

// Hertz: a from the second moment, ∫p x² dx = P a²/4, and p0 at the middle. Both are of second
// order in h = 2.5 a/n (a quarter of the error with half of h; the factors of h² follow from no
// theory: they are the bounds of a method of second order on a length of one). The stress itself,
// constant on an element, is wrong in the elements at the rim, where p ~ √(1 - x²): first order.
TEST(LineContact, Hertz)
{
  double last_error = 1.;
  std::array<double, 2> before{};
  for (const std::size_t n : {51u, 101u, 201u})
    {
      const LineContact contact(n);
      const double h = contact.bodies.h;
      const LayeredSystem layered(contact.bodies.system, contact.joint.elements);
      const LoadHistory history({0., 1.}, {{0., 0.}, {load, 0.}});
      EventPath path(contact.joint.elements, layered, history, {});
      Record record(contact.bodies.system, contact.joint.elements, history);
      EXPECT_EQ(path.run({1.}, record).verdict, Verdict::done);
      EXPECT_LE(record.worst.worst(), 1e-11);
      for (const ContactEvent &event : record.events)
        EXPECT_EQ(event.to, ContactState::stick);

      const Vector &forces = record.levels[0].forces;
      double moment        = 0.;
      for (std::size_t i = 0; i < n; ++i)
        moment -= forces[2 * i] * contact.bodies.x[i] * contact.bodies.x[i];
      const double a = 2. * std::sqrt(moment / load), p0 = -forces[2 * (n / 2)] / h;
      const double p0_exact = 2. * load / M_PI;
      const double l2       = error(
        contact.bodies.x, h, forces, 0, [&](const double x) { return -p0_exact * ellipse(x, 1.); });
      EXPECT_LE(l2, 0.6 * last_error);
      last_error                      = l2;
      const std::array<double, 2> now = {{a - 1., p0 / p0_exact - 1.}};
      for (unsigned int i = 0; n > 51 && i < 2; ++i)
        EXPECT_NEAR(before[i] / now[i], 4., 0.4);
      before = now;
      expect_answer({problem, fmt::format("a, half-planes, h = a/{:.0f}", 1. / h), 1., "Hertz"},
                    a,
                    0.1 * h * h);
      expect_answer(
        {problem, fmt::format("p0 πa/2P, half-planes, h = a/{:.0f}", 1. / h), 1., "Hertz"},
        p0 / p0_exact,
        0.1 * h * h);
    }
}

// Cattaneo and Mindlin: P, then Q. Slip comes in from the rim; element x begins to slip when c =
// a√(1
// - Q/fP) passes through it: |x| - c is at most half its width. The number of those that stick
// gives c to one width. At the end q(x) = f p0 [√(1-x²/a²) - c/a √(1-x²/c²)], with an error as that
// of p.
TEST(LineContact, CattaneoMindlin)
{
  double last_error = 1.;
  for (const std::size_t n : {101u, 201u})
    {
      const LineContact contact(n);
      const double h = contact.bodies.h, Q = 0.9 * f * load;
      const LayeredSystem layered(contact.bodies.system, contact.joint.elements);
      const LoadHistory history({0., 1., 2.}, {{0., 0.}, {load, 0.}, {load, Q}});
      EventPath path(contact.joint.elements, layered, history, {});
      Record record(contact.bodies.system, contact.joint.elements, history);
      EXPECT_EQ(path.run({1., 1. + 0.5 / 0.9, 2.}, record).verdict, Verdict::done);
      EXPECT_LE(record.worst.worst(), 1e-11);

      std::size_t n_slip = 0;
      for (const ContactEvent &event : record.events)
        if (event.t > 1.)
          {
            EXPECT_EQ(event.to, ContactState::slip_forward);
            const double c = std::sqrt(1. - 0.9 * (event.t - 1.));
            EXPECT_NEAR(std::abs(contact.bodies.x[event.element]), c, 0.5 * h) << event.t;
            ++n_slip;
          }
      EXPECT_GE(n_slip, n / 5);
      for (const std::size_t level : {1u, 2u})
        {
          const double share = level == 1 ? 0.5 : 0.9, c = std::sqrt(1. - share);
          std::size_t n_stick = 0;
          for (const ContactState state : record.levels[level].states)
            n_stick += state == ContactState::stick ? 1 : 0;
          expect_answer({problem,
                         fmt::format("c/a at Q = {} fP, h = a/{:.0f}", share, 1. / h),
                         c,
                         "Cattaneo, Mindlin"},
                        0.5 * static_cast<double>(n_stick) * h,
                        h);
        }
      const double c = std::sqrt(0.1), q0 = f * 2. * load / M_PI;
      const double l2 = error(contact.bodies.x, h, record.levels[2].forces, 1, [&](const double x) {
        return q0 * (ellipse(x, 1.) - c * ellipse(x, c));
      });
      EXPECT_LE(l2, 0.6 * last_error);
      last_error = l2;
    }
}

// Q and P together with dQ/dP < f: no slip at all, and since the tangential problem is then the
// normal one, step by step, q = (dQ/dP) p in every element: the closed form of the discrete
// problem; 1e-11 for the rounding of a hundred events with S of condition 1e3.
TEST(LineContact, NoSlipIfBothGrowTogether)
{
  for (const double ratio : {0.5 * f, 0.999 * f})
    {
      const LineContact contact(101);
      const LayeredSystem layered(contact.bodies.system, contact.joint.elements);
      const LoadHistory history({0., 1.}, {{0., 0.}, {load, ratio * load}});
      EventPath path(contact.joint.elements, layered, history, {});
      Record record(contact.bodies.system, contact.joint.elements, history);
      EXPECT_EQ(path.run({1.}, record).verdict, Verdict::done);
      EXPECT_LE(record.worst.worst(), 1e-11);
      double slipped = 0.;
      for (const ContactEvent &event : record.events)
        slipped += event.to == ContactState::stick ? 0. : 1.;
      const Vector &forces = record.levels[0].forces;
      double worst         = 0.;
      for (std::size_t i = 0; i < 101; ++i)
        worst = std::max(worst, std::abs(forces[2 * i + 1] + ratio * forces[2 * i]));
      EXPECT_LE(worst, 1e-11 * load);
      expect_answer({problem,
                     fmt::format("elements that slip with dQ/dP = {} f", ratio / f),
                     0.,
                     "Mindlin, Deresiewicz"},
                    slipped,
                    0.);
    }
}

// A rigid cylinder on a soft layer (Winkler): p = k_n (a² - x²)/2R. With nodes at x = jh, node j
// closes when a = jh, at the trapezoidal sum of p, which for a parabola is exactly P = 2k_n a³/(3R)
// (1 - h²/(4a²)).
TEST(LineContact, SoftLayer)
{
  const std::size_t m = 40, n = 2 * m + 1;
  const double k_n = 3., h = 1. / static_cast<double>(m - 5);
  ToyJoint joint(n, h, make_linear_law(1. / k_n), make_linear_law(1.), {f, 0.});
  ToySystem system;
  system.S       = DenseMatrix(2, 2);
  system.B       = DenseMatrix(2 * n, 2);
  system.F       = DenseMatrix(2, 1);
  system.F(0, 0) = -1.;
  Vector x(n);
  for (std::size_t i = 0; i < n; ++i)
    {
      x[i]                          = (static_cast<double>(i) - static_cast<double>(m)) * h;
      system.B(2 * i, 0)            = 1.;
      system.B(2 * i + 1, 1)        = 1.;
      joint.elements[i].initial_gap = x[i] * x[i] / (2. * radius);
    }
  system.motions            = system.B;
  system.motion_loads       = DenseMatrix(2, 1);
  system.motion_loads(0, 0) = -1.;
  const auto P              = [&](const double a) { return 2. * k_n * a * a * a / (3. * radius); };
  const double largest      = P(1.1);
  const LayeredSystem layered(system, joint.elements);
  const LoadHistory history({0., 1.}, {{0.}, {largest}});
  EventPath path(joint.elements, layered, history, {});
  Record record(system, joint.elements, history);
  EXPECT_EQ(path.run({P(1.) * (1. - h * h / 4.) / largest, 1.}, record).verdict, Verdict::done);
  EXPECT_LE(record.worst.worst(), 1e-12);
  for (std::size_t i = 0; i < n; ++i)
    {
      const double p = std::max(0., k_n * (1. - x[i] * x[i]) / (2. * radius));
      EXPECT_NEAR(-record.levels[0].forces[2 * i] / h, p, 1e-12);
    }
  for (const ContactEvent &event : record.events)
    {
      const double a = std::abs(x[event.element]), pressing = event.t * largest;
      EXPECT_NEAR(pressing, P(a) * (1. - h * h / (4. * a * a)), 1e-12);
      if (event.element == n - 6)
        expect_answer({"V7 soft layer", "P at a = 1, h = a/35", P(1.), "closed form"},
                      pressing,
                      1.01 * P(1.) * h * h / 4.);
    }
}
