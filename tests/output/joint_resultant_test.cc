// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/results/joint_resultant.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;

// Statics of given forces, by hand. Tolerance 1e-13: sums of a few dozen numbers of order one.
namespace
{
  constexpr double tolerance = 1e-13;

  /** A joint made by hand. */
  struct Joint
  {
    std::vector<ContactElement> elements;
    std::vector<std::array<double, 3>> normals;
    std::vector<ElementResult> results;
    Vector dissipation;
    AcrossPlane across_plane;

    void
    add(const std::array<double, 2> &at,
        const std::array<double, 2> &normal,
        const double area,
        const double N,
        const double T           = 0.,
        const ContactState state = ContactState::stick)
    {
      ContactElement element;
      element.number   = static_cast<unsigned int>(elements.size());
      element.position = {{at[0], at[1], 0.}};
      element.area     = area;
      elements.push_back(element);
      normals.push_back({{normal[0], normal[1], 0.}});
      ElementResult result;
      result.state    = state;
      result.N        = N;
      result.T        = T;
      result.pressure = -N / area;
      result.shear    = T / area;
      results.push_back(result);
      dissipation.push_back(0.);
    }

    JointResultant
    resultant() const
    {
      return joint_resultants(1, elements, normals, results, dissipation, across_plane)[0];
    }
  };

  /** n equal parts of the base -b/2 ≤ s ≤ b/2, turned by @p angle about the centroid (x, y), under
   * the pressure p0 + p1 s and the shear τ. */
  Joint
  straight(const double b,
           const int n,
           const double p0,
           const double p1,
           const double tau,
           const double angle,
           const std::array<double, 2> &centroid)
  {
    Joint joint;
    const double c = std::cos(angle), s = std::sin(angle);
    for (int i = 0; i <= n; ++i)
      {
        const double along = b * (static_cast<double>(i) / n - 0.5);
        const double A     = b / n * (i == 0 || i == n ? 0.5 : 1.);
        joint.add({{centroid[0] + along * c, centroid[1] + along * s}},
                  {{-s, c}},
                  A,
                  -(p0 + p1 * along) * A,
                  tau * A);
      }
    return joint;
  }
} // namespace

// A pressure that is linear along the base: N = -p0 b, T = τ b, M = p1 I with I = b³/12 (1 + 2/n²),
// the trapezoidal rule of ∫s² ds; e = M/|N|, whatever the direction of the joint.
TEST(JointResultant, TrapezoidalPressure)
{
  const double b = 3., p0 = 2., p1 = 0.7, tau = 0.4;
  for (const double angle : {0., 0.5, -2., M_PI / 2.})
    for (const int n : {1, 4, 17})
      {
        const JointResultant r = straight(b, n, p0, p1, tau, angle, {{5., -3.}}).resultant();
        const double I = b * b * b / 12. * (1. + 2. / (n * n)), e = p1 * I / (p0 * b);
        EXPECT_NEAR(r.N, -p0 * b, tolerance);
        EXPECT_NEAR(r.T, tau * b, tolerance);
        EXPECT_NEAR(r.M, p1 * I, 10. * tolerance);
        EXPECT_NEAR(r.eccentricity, e, tolerance);
        EXPECT_NEAR(r.position[0], 5. + e * std::cos(angle), 10. * tolerance);
        EXPECT_NEAR(r.position[1], -3. + e * std::sin(angle), 10. * tolerance);
        EXPECT_NEAR(r.largest_pressure, p0 + p1 * b / 2., tolerance);
        EXPECT_NEAR(r.smallest_pressure, p0 - p1 * b / 2., tolerance);
        EXPECT_NEAR(r.share_compression, 1., tolerance);
        EXPECT_NEAR(r.overturning_safety, b / 2. / e, 10. * tolerance * b / 2. / e);
      }
}

// The kern of a rectangle: |e| < b/6 and not beyond; with e to the left the left edge counts.
TEST(JointResultant, MiddleThirdAndEdge)
{
  for (const double e : {-0.49, -0.168, -0.166, 0., 0.166, 1. / 6., 0.168, 0.49})
    {
      Joint joint;
      joint.add({{-0.5, 0.}}, {{0., 1.}}, 0.5, -(0.5 - e));
      joint.add({{0.5, 0.}}, {{0., 1.}}, 0.5, -(0.5 + e));
      const JointResultant r = joint.resultant();
      EXPECT_NEAR(r.eccentricity, e, tolerance);
      EXPECT_EQ(r.in_middle_third, std::abs(e) < 0.167 ? 1. : 0.) << e;
      if (e == 0.)
        EXPECT_TRUE(std::isinf(r.overturning_safety));
      else
        EXPECT_NEAR(r.overturning_safety, 0.5 / std::abs(e), 100. * tolerance);
    }
}

// A quarter of a circle under a uniform pressure from its centre O: all forces pass through O, and
// so does the resultant, in the direction (1, 1) of the mean normal. The line along the mean
// tangent through the centroid is cut on the bisector itself: e = 0. With the pressure on the outer
// third only, the line of action has the direction of 15°, and cuts it where y = x tan 15° and
// x + y = const of the centroid meet.
TEST(JointResultant, QuarterOfACircle)
{
  const int n    = 30;
  const double R = 2., angle = M_PI / 12.;
  Joint whole, third;
  double sum = 0.;
  for (int i = 0; i < n; ++i)
    {
      const double phi                   = (i + 0.5) / n * M_PI / 2.;
      const std::array<double, 2> normal = {{std::cos(phi), std::sin(phi)}};
      const std::array<double, 2> at     = {{R * normal[0], R * normal[1]}};
      whole.add(at, normal, 0.1, -0.2);
      third.add(at, normal, 0.1, i < n / 3 ? -0.2 : 0.);
      sum += (at[0] + at[1]) / n;
    }
  const JointResultant w = whole.resultant(), t = third.resultant();
  EXPECT_NEAR(w.T, 0., tolerance);
  EXPECT_NEAR(w.M, 0., 10. * tolerance);
  EXPECT_NEAR(w.eccentricity, 0., 10. * tolerance);
  EXPECT_NEAR(w.position[0], sum / 2., 10. * tolerance);
  EXPECT_NEAR(w.position[1], sum / 2., 10. * tolerance);

  const double x = sum / (1. + std::tan(angle)), y = x * std::tan(angle);
  EXPECT_NEAR(t.position[0], x, 10. * tolerance);
  EXPECT_NEAR(t.position[1], y, 10. * tolerance);
  EXPECT_NEAR(t.eccentricity, (x - y) / std::sqrt(2.), 10. * tolerance);
  // The edge is the first element, at 1.5°.
  const double edge = R * (std::cos(M_PI / 120.) - std::sin(M_PI / 120.)) / std::sqrt(2.);
  EXPECT_NEAR(t.overturning_safety, edge / t.eccentricity, 100. * tolerance);
  EXPECT_NEAR(t.share_compression, 1. / 3., tolerance);
}

// A ring under pressure from inside carries nothing as a whole; T is measured in the global axes.
TEST(JointResultant, Ring)
{
  Joint ring;
  for (int i = 0; i < 12; ++i)
    {
      const double phi = i * M_PI / 6.;
      ring.add({{std::cos(phi), std::sin(phi)}}, {{std::cos(phi), std::sin(phi)}}, 0.5, -1.);
    }
  ring.results[0].N      = -3.; // at (1, 0), normal (1, 0): two more along x
  const JointResultant r = ring.resultant();
  EXPECT_NEAR(r.N, 0., tolerance);
  EXPECT_NEAR(r.T, -2., tolerance);
  EXPECT_NEAR(r.M, 0., tolerance);
}

// Open from both ends and in the middle; lengths are areas over the thickness.
TEST(JointResultant, CrackedLength)
{
  Joint joint;
  joint.across_plane.thickness = 2.;
  const std::string states     = "oo-o--ooo";
  const std::vector<double> bs = {0.5, 1., 1., 3., 1., 1., 0.25, 0.25, 0.5};
  for (std::size_t i = 0; i < states.size(); ++i)
    {
      const bool open = states[i] == 'o';
      joint.add({{static_cast<double>(i), 0.}},
                {{0., 1.}},
                2. * bs[i],
                open ? 0. : -1.,
                0.,
                open     ? ContactState::open
                : i == 4 ? ContactState::slip_forward
                         : ContactState::stick);
    }
  const JointResultant r = joint.resultant();
  EXPECT_NEAR(r.cracked_length, 5.5, tolerance);
  EXPECT_NEAR(r.crack_from_first, 1.5, tolerance);
  EXPECT_NEAR(r.crack_from_last, 1., tolerance);
  EXPECT_NEAR(r.share_open, 5.5 / 8.5, tolerance);
  EXPECT_NEAR(r.share_slip, 1. / 8.5, tolerance);
  EXPECT_NEAR(r.share_stick, 2. / 8.5, tolerance);
  EXPECT_NEAR(r.share_compression, 3. / 8.5, tolerance);
  EXPECT_EQ(r.smallest_pressure, 0.);
}

// Σ(f|N| + cA)/|T| with the strength of each element; none without shear. A joint without force has
// no place where its resultant stands, and is open all along.
TEST(JointResultant, SafetyAndNoForce)
{
  Joint joint;
  joint.add({{0., 0.}}, {{0., 1.}}, 1., -2., 0.5);
  joint.add({{1., 0.}}, {{0., 1.}}, 1., -4., -0.1);
  joint.results[0].strength = 0.5 * 2. + 0.1;
  joint.results[1].strength = 0.5 * 4. + 0.1;
  joint.dissipation         = {0.3, 0.4};
  EXPECT_NEAR(joint.resultant().sliding_safety, 3.2 / 0.4, 10. * tolerance);
  EXPECT_NEAR(joint.resultant().dissipation, 0.7, tolerance);
  joint.results[1].T = -0.5;
  EXPECT_TRUE(std::isinf(joint.resultant().sliding_safety));

  Joint open;
  for (const double x : {0., 1.})
    open.add({{x, 0.}}, {{0., 1.}}, 1., 0., 0., ContactState::open);
  const JointResultant r = open.resultant();
  EXPECT_TRUE(std::isnan(r.eccentricity));
  EXPECT_TRUE(std::isnan(r.position[0]));
  EXPECT_TRUE(std::isnan(r.overturning_safety));
  EXPECT_EQ(r.in_middle_third, 0.);
  EXPECT_EQ(r.crack_from_first, 2.);
  EXPECT_EQ(r.crack_from_last, 2.);
}

// Axisymmetric, radii 0, 1, 3, 4: the elements stand for 0.5, 1.5, 1.5 and 0.5 of the radius. N is
// the sum over the circle; a place in the half-plane has no meaning.
TEST(JointResultant, Axisymmetric)
{
  Joint joint;
  joint.across_plane.axisymmetric = true;
  for (const double r : {0., 1., 3., 4.})
    {
      const bool open = r >= 3.;
      joint.add({{r, 0.}},
                {{0., 1.}},
                1. + r,
                open ? 0. : -2.,
                0.,
                open ? ContactState::open : ContactState::stick);
    }
  const JointResultant r = joint.resultant();
  EXPECT_EQ(r.N, -4.);
  EXPECT_NEAR(r.cracked_length, 2., tolerance);
  EXPECT_NEAR(r.crack_from_last, 2., tolerance);
  EXPECT_EQ(r.crack_from_first, 0.);
  for (const double nothing : {r.M, r.eccentricity, r.position[0], r.overturning_safety})
    EXPECT_TRUE(std::isnan(nothing));
  EXPECT_EQ(r.in_middle_third, 0.);
}

// Joints are told apart, and one without elements is no division by zero.
TEST(JointResultant, TwoJoints)
{
  Joint joint;
  joint.add({{0., 0.}}, {{0., 1.}}, 1., -2.);
  joint.add({{0., 0.}}, {{1., 0.}}, 1., -3.);
  joint.elements[1].joint = 1;
  const auto r            = joint_resultants(
    3, joint.elements, joint.normals, joint.results, joint.dissipation, joint.across_plane);
  EXPECT_EQ(r[0].N, -2.);
  EXPECT_EQ(r[1].N, -3.);
  EXPECT_EQ(r[2].N, 0.);
  EXPECT_EQ(r[2].largest_pressure, 0.);
  EXPECT_EQ(r[2].smallest_pressure, 0.);
}
