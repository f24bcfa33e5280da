// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/cone_toy.h"

#include <fuga/contact/segments/implicit_runge_kutta.h>

#include <cmath>

namespace fuga::tests
{
  namespace
  {
    const double pi = std::acos(-1.);

    /** One element pressed by load 0 and driven in its plane by the displacements u = (a1, a2) at
     * the far end of springs of stiffness K. */
    ToySystem
    driven_element(const double K)
    {
      ToySystem system;
      system.S = DenseMatrix(3, 3);
      system.F = DenseMatrix(3, 3);
      for (std::size_t i = 0; i < 3; ++i)
        system.S(i, i) = system.F(i, i) = K;
      system.S(0, 0) = 0.;
      system.F(0, 0) = -1.;
      return system;
    }

    double
    angle_to_first_tangent(const JointState &state)
    {
      return std::atan2(state.forces[2], state.forces[1]);
    }
  } // namespace

  // The conditions of order 5 and, embedded, of order 4 (Butcher's trees).
  TEST(ConePath, RungeKuttaPairHasItsOrder)
  {
    namespace rk     = runge_kutta;
    using Row        = std::array<double, rk::n_stages>;
    const auto times = [](const Row &x) {
      Row y{};
      for (std::size_t i = 0; i < rk::n_stages; ++i)
        for (std::size_t j = 0; j < rk::n_stages; ++j)
          y[i] += rk::weights[i][j] * x[j];
      return y;
    };
    const auto product = [](Row x, const Row &y) {
      for (std::size_t i = 0; i < x.size(); ++i)
        x[i] *= y[i];
      return x;
    };
    const auto sum = [](const Row &b, const Row &x) {
      double s = 0.;
      for (std::size_t i = 0; i < b.size(); ++i)
        s += b[i] * x[i];
      return s;
    };
    Row one;
    one.fill(1.);
    const Row c = times(one), c2 = product(c, c), c3 = product(c2, c), Ac = times(c),
              Ac2          = times(c2);
    const double tolerance = 1e-15;
    for (std::size_t i = 0; i < c.size(); ++i)
      EXPECT_NEAR(c[i], rk::abscissae[i], tolerance);
    for (const Row &b : {rk::weights.back(), rk::embedded})
      {
        EXPECT_NEAR(sum(b, one), 1., tolerance);
        EXPECT_NEAR(sum(b, c), 1. / 2., tolerance);
        EXPECT_NEAR(sum(b, c2), 1. / 3., tolerance);
        EXPECT_NEAR(sum(b, Ac), 1. / 6., tolerance);
        EXPECT_NEAR(sum(b, c3), 1. / 4., tolerance);
        EXPECT_NEAR(sum(b, product(c, Ac)), 1. / 8., tolerance);
        EXPECT_NEAR(sum(b, Ac2), 1. / 12., tolerance);
        EXPECT_NEAR(sum(b, times(Ac)), 1. / 24., tolerance);
      }
    const Row &b = rk::weights.back();
    EXPECT_NEAR(sum(b, product(c2, c2)), 1. / 5., tolerance);
    EXPECT_NEAR(sum(b, product(c2, Ac)), 1. / 10., tolerance);
    EXPECT_NEAR(sum(b, product(Ac, Ac)), 1. / 20., tolerance);
    EXPECT_NEAR(sum(b, product(c, Ac2)), 1. / 15., tolerance);
    EXPECT_NEAR(sum(b, times(c3)), 1. / 20., tolerance);
    EXPECT_NEAR(sum(b, product(c, times(Ac))), 1. / 30., tolerance);
    EXPECT_NEAR(sum(b, times(product(c, Ac))), 1. / 40., tolerance);
    EXPECT_NEAR(sum(b, times(Ac2)), 1. / 60., tolerance);
    EXPECT_NEAR(sum(b, times(times(Ac))), 1. / 120., tolerance);
  }

  // A bar that was stressed along y until it slipped and is then driven along x: the end of a
  // spring that drags a weight follows a tractrix, tan(φ/2) = tan(φ0/2) e^{-x/r}, r = f N/k.
  TEST(ConePath, DirectionFollowsTheTractrix)
  {
    const double K = 8., rho = 0.125, f = 0.5, N = 2.;
    const double k = 1. / (1. / K + rho), r = f * N / k;
    const ToySystem system = driven_element(K);
    const ConeJoint joint(1, 1., make_linear_law(rho), make_linear_law(rho), f);
    // Loads: N, u1, u2. Stage 2 drags to twice the limit along y, stage 3 by 6 r along x.
    const LoadHistory history({0., 1., 2., 3.},
                              {{0., 0., 0.}, {N, 0., 0.}, {N, 0., 2. * r}, {N, 6. * r, 2. * r}});
    const std::vector<double> levels = {2., 2.01, 2.1, 2.25, 2.5, 2.75, 3.};
    const ConeRun run(system, joint.elements, history, levels);
    ASSERT_EQ(run.result.verdict, Verdict::done);
    ASSERT_EQ(run.record.levels.size(), levels.size());
    for (const JointState &state : run.record.levels)
      {
        const double x   = 6. * r * (state.t - 2.);
        const double phi = 2. * std::atan(std::tan(pi / 4.) * std::exp(-x / r));
        EXPECT_NEAR(angle_to_first_tangent(state), phi, 1e-9) << state.t;
        EXPECT_NEAR(std::hypot(state.forces[1], state.forces[2]), f * N, 1e-12);
      }
    EXPECT_LT(run.record.worst.worst(), 1e-8);
    EXPECT_EQ(run.result.n_events, 1u); // stick to slip
  }

  // The same, dragged so far that 1e-6 of the stage doubles its slip a hundred times while no force
  // changes: the load moves the spring's end and nothing else, which is no limit.
  TEST(ConePath, LongWayIsNoLimit)
  {
    const double K = 8., rho = 0.125, f = 0.5, N = 2.;
    const double r = f * N / (1. / (1. / K + rho)), far = 1e9 * r;
    const ToySystem system = driven_element(K);
    const ConeJoint joint(1, 1., make_linear_law(rho), make_linear_law(rho), f);
    const LoadHistory history({0., 1., 2., 3.},
                              {{0., 0., 0.}, {N, 0., 0.}, {N, 0., 2. * r}, {N, far, 2. * r}});
    const ConeRun run(system, joint.elements, history, {3.});
    ASSERT_EQ(run.result.verdict, Verdict::done);
    const JointState &state = run.record.levels.back();
    // e^{-x/r} is zero: the force, f N, points along x. It is a difference of terms of the size of
    // K times the way.
    const double rounding = 1e-15 * K * far;
    EXPECT_NEAR(state.forces[1], f * N, rounding);
    EXPECT_NEAR(state.forces[2], 0., rounding);
    EXPECT_NEAR(state.dislocations[1], far - r, rounding / K);
  }

  // Stressed along y below the limit: slip begins where |T| = f N, at tan φ0 = T2/T1, and every
  // level leaves the path alone.
  TEST(ConePath, TractrixBeginsOnTheCone)
  {
    const double K = 3., f = 0.4, N = 1.;
    const double r         = f * N / K;
    const ToySystem system = driven_element(K);
    const ConeJoint joint(1, 1., make_rigid_law(), make_rigid_law(), f);
    const double stressed = 0.6 * r, driven = 4. * r;
    const LoadHistory history(
      {0., 1., 2., 3.}, {{0., 0., 0.}, {N, 0., 0.}, {N, 0., stressed}, {N, driven, stressed}});
    const ConeRun run(system, joint.elements, history, {3.});
    const double first_slip = std::sqrt(r * r - stressed * stressed); // 0.8 r
    ASSERT_EQ(run.record.events.size(), 1u);
    EXPECT_NEAR(run.record.events[0].t, 2. + first_slip / driven, 1e-14);
    const double phi0 = std::asin(stressed / r);
    const double phi  = 2. * std::atan(std::tan(phi0 / 2.) * std::exp(-(driven - first_slip) / r));
    EXPECT_NEAR(angle_to_first_tangent(run.record.levels.back()), phi, 1e-9);

    std::vector<double> many;
    for (int i = 1; i <= 40; ++i)
      many.push_back(2. + i / 40.);
    const ConeRun watched(system, joint.elements, history, many);
    EXPECT_EQ(watched.record.levels.back().forces, run.record.levels.back().forces);
    EXPECT_LT(watched.record.worst.worst(), 1e-8);
  }

  // A block on an incline that leaves it at rest (tan α < f) is pushed sideways: it slides at the
  // push for which the resultant of push and weight along the incline is f N, in its direction.
  TEST(ConePath, BlockOnAnInclineIsPushedSideways)
  {
    const double W = 3., alpha = 0.3, f = 0.5;
    // One rigid body that only translates, on four elements.
    ToySystem system;
    const std::size_t n = 4;
    system.S            = DenseMatrix(3, 3);
    system.B            = DenseMatrix(3 * n, 3);
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i < 3; ++i)
        system.B(3 * k + i, i) = 1.;
    system.F            = DenseMatrix(3, 2);
    system.F(0, 0)      = -W * std::cos(alpha);
    system.F(2, 0)      = -W * std::sin(alpha); // down the incline, along -t2
    system.F(1, 1)      = 1.;
    system.motions      = system.B;
    system.motion_loads = system.F;
    const ConeJoint joint(n, 0.25, make_linear_law(1e-3), make_linear_law(2e-3), f);
    const double push = 2. * W;
    const LoadHistory history({0., 1., 2.}, {{0., 0.}, {1., 0.}, {1., push}});
    const ConeRun run(system, joint.elements, history, {});
    EXPECT_EQ(run.result.verdict, Verdict::limit_load);
    EXPECT_EQ(run.result.mechanism, MechanismKind::sliding);
    const double limit =
      W * std::sqrt(f * f * std::cos(alpha) * std::cos(alpha) - std::sin(alpha) * std::sin(alpha));
    EXPECT_NEAR(run.result.t, 1. + limit / push, 1e-12);
    ASSERT_FALSE(run.result.mechanism_jumps.empty());
    const double direction =
      std::atan2(run.result.mechanism_jumps[2], run.result.mechanism_jumps[1]);
    EXPECT_NEAR(direction, -std::atan2(W * std::sin(alpha), limit), 1e-9);
    EXPECT_LT(run.record.worst.worst(), 1e-8);
  }

  // Torsion of a rigid circular stamp under uniform pressure p on a compliant joint: an element at
  // the distance r from the axis slips at θ = f p/(k_t r); M = Σ A r min(k_t θ r, f p). For many
  // elements M(θ) of the continuum: with b = f p/(k_t θ) < a, M = 2π f p (a³/3 - b³/12).
  TEST(ConePath, TorsionOfAStamp)
  {
    const double a = 2., p = 3., f = 0.4, rho_t = 0.01, K = 1e4;
    const std::size_t n_rings = 24, n_around = 12, n = n_rings * n_around;
    ToySystem system;
    system.S = DenseMatrix(4, 4);
    system.B = DenseMatrix(3 * n, 4);
    ConeJoint joint(n, 1., make_linear_law(0.005), make_linear_law(rho_t), f);
    Vector radii(n);
    for (std::size_t i = 0; i < n_rings; ++i)
      for (std::size_t j = 0; j < n_around; ++j)
        {
          const std::size_t k    = i * n_around + j;
          const double inner     = a * static_cast<double>(i) / n_rings,
                       outer     = a * static_cast<double>(i + 1) / n_rings;
          const double r         = 0.5 * (inner + outer);
          const double phi       = 2. * pi * (static_cast<double>(j) + 0.3) / n_around;
          radii[k]               = r;
          joint.elements[k].area = pi * (outer * outer - inner * inner) / n_around;
          // Motions: settlement, two shifts, rotation about the normal; all tangents the same.
          system.B(3 * k, 0)     = 1.;
          system.B(3 * k + 1, 1) = system.B(3 * k + 2, 2) = 1.;
          system.B(3 * k + 1, 3)                          = -r * std::sin(phi);
          system.B(3 * k + 2, 3)                          = r * std::cos(phi);
        }
    // The rotation is driven through a spring.
    system.S(3, 3) = K;
    system.F       = DenseMatrix(4, 2);
    system.F(0, 0) = -p * pi * a * a;
    system.F(3, 1) = K;
    system.S(1, 1) = system.S(2, 2) = 1.;
    const double last               = 0.02;
    const LoadHistory history({0., 1., 2.}, {{0., 0.}, {1., 0.}, {1., last}});
    std::vector<double> levels;
    for (int i = 1; i <= 10; ++i)
      levels.push_back(1. + 0.1 * i);
    const ConeRun run(system, joint.elements, history, levels);
    ASSERT_EQ(run.result.verdict, Verdict::done);

    const auto moment_of = [&](const double theta) {
      double M = 0.;
      for (std::size_t k = 0; k < n; ++k)
        M += joint.elements[k].area * radii[k] * std::min(theta * radii[k] / rho_t, f * p);
      return M;
    };
    double last_moment = 0., last_theta = 0.;
    for (const JointState &state : run.record.levels)
      {
        double M = 0.;
        for (std::size_t k = 0; k < n; ++k)
          M += state.forces[3 * k + 1] * system.B(3 * k + 1, 3) +
               state.forces[3 * k + 2] * system.B(3 * k + 2, 3);
        const double theta = last * (state.t - 1.) - M / K;
        EXPECT_NEAR(M, moment_of(theta), 1e-9 * M) << state.t;
        last_moment = M;
        last_theta  = theta;
      }
    const double b = f * p * rho_t / last_theta;
    ASSERT_LT(b, a);
    // The rule of midpoints on 24 rings is off by some 1/(4 * 24²).
    EXPECT_NEAR(
      last_moment, 2. * pi * f * p * (a * a * a / 3. - b * b * b / 12.), 1e-3 * last_moment);
    // First slip: the outermost ring, all around at once.
    ASSERT_GE(run.record.events.size(), n_around);
    const double theta1 = f * p * rho_t / radii.back();
    const double t1     = 1. + (theta1 + moment_of(theta1) / K) / last;
    for (std::size_t i = 0; i < n_around; ++i)
      {
        EXPECT_NEAR(run.record.events[i].t, t1, 1e-11);
        EXPECT_GE(run.record.events[i].element, n - n_around);
      }
    EXPECT_LT(run.record.worst.worst(), 1e-8);
  }

  // Oblique push on a block that rests on compliant bars: equal pressures, so all bars slip
  // together at H = f N, whatever the direction.
  TEST(ConePath, LimitLoadOfABlockInAnObliqueDirection)
  {
    const double N = 5., f = 0.35;
    for (const double direction : {0., 0.4, 2., -1.3})
      {
        ToySystem system;
        const std::size_t n = 9;
        system.S            = DenseMatrix(6, 6);
        system.B            = DenseMatrix(3 * n, 6);
        for (std::size_t k = 0; k < n; ++k)
          {
            const double x = static_cast<double>(k % 3) - 1., y = static_cast<double>(k / 3) - 1.;
            for (std::size_t i = 0; i < 3; ++i)
              system.B(3 * k + i, i) = 1.;
            system.B(3 * k, 3)     = x;
            system.B(3 * k, 4)     = y;
            system.B(3 * k + 1, 5) = -y;
            system.B(3 * k + 2, 5) = x;
          }
        system.F            = DenseMatrix(6, 2);
        system.F(0, 0)      = -N;
        system.F(1, 1)      = std::cos(direction);
        system.F(2, 1)      = std::sin(direction);
        system.motions      = system.B;
        system.motion_loads = system.F;
        const ConeJoint joint(n, 1., make_linear_law(0.1), make_linear_law(0.2), f);
        const LoadHistory history({0., 1., 2.}, {{0., 0.}, {1., 0.}, {1., N}});
        const ConeRun run(system, joint.elements, history, {});
        EXPECT_EQ(run.result.verdict, Verdict::limit_load);
        EXPECT_EQ(run.result.mechanism, MechanismKind::sliding);
        EXPECT_NEAR(run.result.t, 1. + f, 1e-12);
        EXPECT_NEAR(run.result.mechanism_jumps[2] * std::cos(direction),
                    run.result.mechanism_jumps[1] * std::sin(direction),
                    1e-9);
        EXPECT_LT(run.record.worst.worst(), 1e-8);
      }
  }

  // Four springs under a rigid square plate with a horizontal force that does not pass through its
  // centre: the slip directions turn towards those of a rotation about a point, and the limit is
  // reached as the slips grow beyond all bounds. Limit by the kinematic theorem: with the plate
  // rotating about the point c, H = f Σ N_i |x_i - c| / arm, at its minimum over c.
  TEST(ConePath, LimitLoadOfAnEccentricallyPushedPlate)
  {
    const double N = 1., f = 0.5, offset = 0.7;
    ToySystem system;
    const std::array<std::array<double, 2>, 4> at = {
      {{{-1., -1.}}, {{1., -1.}}, {{1., 1.}}, {{-1., 1.}}}};
    system.S = DenseMatrix(6, 6);
    system.B = DenseMatrix(12, 6);
    for (std::size_t k = 0; k < 4; ++k)
      {
        for (std::size_t i = 0; i < 3; ++i)
          system.B(3 * k + i, i) = 1.;
        system.B(3 * k, 3)     = at[k][0];
        system.B(3 * k, 4)     = at[k][1];
        system.B(3 * k + 1, 5) = -at[k][1];
        system.B(3 * k + 2, 5) = at[k][0];
      }
    system.F       = DenseMatrix(6, 2);
    system.F(0, 0) = -4. * N;
    // Along x at y = offset: moment about the normal -offset.
    system.F(1, 1)      = 1.;
    system.F(5, 1)      = -offset;
    system.motions      = system.B;
    system.motion_loads = system.F;
    const ConeJoint joint(4, 1., make_linear_law(0.1), make_linear_law(0.1), f);
    const double last = 4. * f * N;
    const LoadHistory history({0., 1., 2.}, {{0., 0.}, {1., 0.}, {1., last}});
    const ConeRun run(system, joint.elements, history, {});
    EXPECT_EQ(run.result.verdict, Verdict::limit_load);
    EXPECT_EQ(run.result.mechanism, MechanismKind::sliding);
    EXPECT_LT(run.record.worst.worst(), 1e-8);
    // By symmetry the centre lies on x = 0 at y = -c; velocity of the force's line: c + offset.
    double limit = last;
    for (double c = 0.01; c < 20.; c += 1e-4)
      {
        double dissipation = 0.;
        for (const auto &x : at)
          dissipation += f * N * std::hypot(x[0], x[1] + c);
        limit = std::min(limit, dissipation / (c + offset));
      }
    // The path ends where a millionth of the load more would double the jumps, below the limit.
    EXPECT_NEAR((run.result.t - 1.) * last, limit, 1e-6);
  }

  // A block that something elastic presses outwards on four faces, forwards by 0.8 on two and
  // backwards on two, under N = 1 on each: f N = 0.5 holds back, the rest stretches the spring,
  // which does not resist a translation. The block may slide along as a whole until one of its
  // faces sticks, which only their order decides.
  TEST(ConePath, FacesThatSlipApartLeaveTheBlockWhereOneOfThemSticks)
  {
    constexpr std::size_t n   = 4;
    constexpr double k_normal = 10., k_along = 4., compliance = 1e-3, push = 0.8, friction = 0.5;
    ToySystem system;
    system.S = DenseMatrix(3 * n, 3 * n);
    system.F = DenseMatrix(3 * n, 1);
    for (std::size_t k = 0; k < n; ++k)
      {
        system.S(3 * k, 3 * k) = k_normal;
        for (std::size_t j = 0; j < n; ++j)
          system.S(3 * k + 1, 3 * j + 1) = k_along * ((j == k ? 1. : 0.) - 1. / n);
        system.S(3 * k + 2, 3 * k + 2) = 3.;
        system.F(3 * k, 0)             = -1.;
        system.F(3 * k + 1, 0)         = k < 2 ? push : -push;
      }
    const ConeJoint joint(
      n, 1., make_linear_law(compliance), make_linear_law(compliance), friction);
    const ConeRun run(system, joint.elements, LoadHistory({0., 1.}, {{0.}, {1.}}), {1.});
    ASSERT_EQ(run.result.verdict, Verdict::done);
    EXPECT_LT(run.record.worst.worst(), 1e-14);
    const JointState &end = run.record.levels[0];
    const double N = 1. / (1. + k_normal * compliance), T = friction * N;
    double shortest = 1.;
    for (std::size_t k = 0; k < n; ++k)
      {
        EXPECT_NEAR(end.forces[3 * k], -N, 1e-13);
        EXPECT_NEAR(length(tangential(joint.elements[k], end.forces)), T, 1e-13);
        shortest = std::min(shortest, length(end.slips[k]));
      }
    // The springs are stretched by slips and layers.
    EXPECT_NEAR(
      end.slips[0][0] - end.slips[2][0], 2. * ((push - T) / k_along - compliance * T), 1e-13);
    EXPECT_LT(shortest, 1e-13);
  }
} // namespace fuga::tests
