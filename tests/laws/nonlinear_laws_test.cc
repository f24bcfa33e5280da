// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/laws/exponential_law.h>
#include <fuga/laws/hyperbolic_law.h>
#include <fuga/laws/power_law.h>
#include <fuga/laws/tabular_law.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace fuga;

namespace
{
  constexpr double rho = 1.25e-4, limit = 2e-3;
  /** A few roundings of numbers of order one. */
  constexpr double rounding = 1e-13;

  /** Compares relative to the expected number. */
  void
  expect_close(const double value, const double expected, const double tolerance)
  {
    EXPECT_NEAR(value / expected, 1., tolerance) << value << " instead of " << expected;
  }
} // namespace

// V11: σ = K_ni w/(1 - w/V_m). At w = V_m/2: σ = K V_m, tangent 4K, secant 2K, energy
// K V_m² (ln 2 - 1/2); at w = 0.9 V_m: 9 K V_m, 100 K, 10 K, K V_m² (ln 10 - 0.9).
TEST(HyperbolicLaw, ClosedForms)
{
  const HyperbolicLaw law(rho, limit);
  const double K = 1. / rho;
  expect_close(law.stress(0.5 * limit), K * limit, rounding);
  expect_close(law.tangent(0.5 * limit), 4. * K, rounding);
  expect_close(law.secant(0.5 * limit), 2. * K, rounding);
  expect_close(law.energy(0.5 * limit), K * limit * limit * (std::log(2.) - 0.5), rounding);
  expect_close(law.stress(0.9 * limit), 9. * K * limit, 10. * rounding);
  expect_close(law.tangent(0.9 * limit), 100. * K, 10. * rounding);
  expect_close(law.secant(0.9 * limit), 10. * K, 10. * rounding);
  expect_close(law.energy(0.9 * limit), K * limit * limit * (std::log(10.) - 0.9), rounding);
  EXPECT_EQ(law.initial_compliance(), rho);
  EXPECT_EQ(law.deformation_limit(), limit);
}

// w = σ V_m/(K V_m + σ): σ = 3 K V_m gives 3/4 V_m. No stress reaches the limit.
TEST(HyperbolicLaw, Inverse)
{
  const HyperbolicLaw law(rho, limit);
  expect_close(law.deformation(3. * limit / rho), 0.75 * limit, rounding);
  EXPECT_LT(law.deformation(1e9 * limit / rho), limit);
  EXPECT_EQ(law.deformation(0.), 0.);
}

// The energy is K w² (1/2 + u/3 + u²/4 + ...), u = w/V_m: the closed form would have lost all
// digits at u = 1e-8, and one at 0.31.
TEST(HyperbolicLaw, EnergyBySeries)
{
  const HyperbolicLaw law(rho, limit);
  for (const double u : {1e-12, 1e-8, 1e-4, 1e-2, 0.29, 0.31, 0.5})
    {
      double series = 0.;
      for (int k = 100; k >= 2; --k)
        series += std::pow(u, k - 2) / k;
      expect_close(law.energy(u * limit), u * u * limit * limit / rho * series, rounding);
    }
}

// The linear system has what lies between the beginning of a law and the point that it is made for,
// by its own data. m = 2.5: the foot ends at w_r/100 with 1e-5 σ_r, its first slope is 0.28e-3
// σ_r/w_r. The first interval of a table of straight lines has the slope of that.
TEST(NonlinearLaws, LinearPart)
{
  expect_close(
    PowerLaw(2e-3, 0.5, 2.5).reference_compliance(), 4e-3 / std::sqrt(0.28e-3), rounding);
  const double slope = std::log(100.) / 20.;
  expect_close(ExponentialLaw(1e-3, 4.).reference_compliance(),
               2.5e-4 /
                 std::sqrt((3. - 2. * slope + 0.5 * slope * slope) * 20. * std::pow(100., -0.95)),
               rounding);
  const TabularLaw table({{0., 0.}, {1e-3, 0.1}, {2e-3, 1.}}, TableInterpolation::piecewise_linear);
  expect_close(table.reference_compliance(), std::sqrt(1e-2 * 2e-3), rounding);
  const PowerLaw begins_stiffly(2e-3, 0.5, 0.5);
  EXPECT_EQ(begins_stiffly.reference_compliance(), begins_stiffly.initial_compliance());
  EXPECT_EQ(HyperbolicLaw(rho, limit).reference_compliance(), rho);
}

// V11: p = p0 exp(-β g), β = ln(100)/c0, g = c0 - w. p0 at w = c0, p0/10 at c0/2, 10 p0 at 3/2 c0;
// the tangent is β p. Less than c0/20 of closure: the foot, whose cubic is fixed by (0, 0) and by
// value, slope and curvature at its end; its initial slope by hand in units of p(c0/20)/(c0/20),
// with x = ln(100)/20: 3 - 2x + x²/2.
TEST(ExponentialLaw, ClosedForms)
{
  const double c0 = 1e-3, p0 = 4., beta = std::log(100.) / c0;
  const ExponentialLaw law(c0, p0);
  for (const auto &[w, p] :
       {std::pair<double, double>(c0, p0), {0.5 * c0, 0.1 * p0}, {1.5 * c0, 10. * p0}})
    {
      expect_close(law.stress(w), p, rounding);
      expect_close(law.tangent(w), beta * p, rounding);
      expect_close(law.deformation(p), w, rounding);
    }
  // The energy between two closures beyond the foot is (p2 - p1)/β.
  expect_close(law.energy(c0) - law.energy(0.5 * c0), 0.9 * p0 / beta, rounding);
  const double x = std::log(100.) / 20., end = 0.05 * c0;
  const double p_end = p0 * std::exp(-0.95 * std::log(100.));
  expect_close(law.tangent(0.), p_end / end * (3. - 2. * x + 0.5 * x * x), rounding);
  // Value, slope and curvature are continuous at its end.
  const double h = 1e-6 * end;
  expect_close(law.stress(end * (1. - 1e-15)), p_end, rounding);
  expect_close(law.tangent(end * (1. - 1e-15)), beta * p_end, rounding);
  expect_close((law.tangent(end) - law.tangent(end - h)) / h, beta * beta * p_end, 1e-4);
  // The energy of the foot: σ1 w1 (a/2 + b/3 + c/4), with a + b + c = 1, a + 2b + 3c = x.
  const double a = 3. - 2. * x + 0.5 * x * x, c = x - a - 2. * (1. - a), b = 1. - a - c;
  expect_close(law.energy(end), p_end * end * (a / 2. + b / 3. + c / 4.), rounding);
}

// σ_r (w/w_r)^m: at 4 w_r with m = 1.5 it is 8 σ_r with the tangent 3 σ_r/w_r; the foot adds to the
// energy less than its own stress times its length, (w1/w_r)^(m+1) of σ_r w_r.
TEST(PowerLaw, ClosedForms)
{
  const double w_r = 5e-4, sigma_r = 2.;
  const PowerLaw law(w_r, sigma_r, 1.5);
  expect_close(law.stress(w_r), sigma_r, rounding);
  expect_close(law.stress(4. * w_r), 8. * sigma_r, rounding);
  expect_close(law.tangent(4. * w_r), 3. * sigma_r / w_r, rounding);
  expect_close(law.deformation(8. * sigma_r), 4. * w_r, rounding);
  EXPECT_NEAR(law.energy(4. * w_r), sigma_r * w_r * 32. / 2.5, 5e-8 * sigma_r * w_r);
  const PowerLaw root(w_r, sigma_r, 0.5);
  expect_close(root.stress(4. * w_r), 2. * sigma_r, rounding);
  expect_close(root.tangent(4. * w_r), sigma_r / (4. * w_r), rounding);
  EXPECT_NEAR(root.energy(4. * w_r), sigma_r * w_r * 8. / 1.5, 2e-9 * sigma_r * w_r);
  // An exponent of 1 is the linear law, foot included.
  const PowerLaw line(w_r, sigma_r, 1.);
  for (const double w : {1e-7 * w_r, 5e-4 * w_r, 0.3 * w_r})
    expect_close(line.stress(w), sigma_r * w / w_r, rounding);
}

// The foot for every exponent: positive tangents, and at its end value and tangent of the power.
TEST(PowerLaw, FootOfEveryExponent)
{
  for (double m = 0.2; m <= 5.; m += 0.0501)
    {
      const PowerLaw law(1., 1., m);
      const double end   = law.knots().front();
      const double share = std::pow(10., -3. / std::abs(m - 1.));
      EXPECT_NEAR(end / std::max(share, m < 1. ? 1e-6 : 1e-3), 1., 1e-12) << m;
      const double unit = std::pow(end, m - 1.);
      for (int i = 0; i < 1000; ++i)
        ASSERT_GT(law.tangent(end * i / 1000.), 0.05 * unit) << m;
      const double below = end * (1. - 1e-15);
      EXPECT_NEAR(law.stress(below) / std::pow(end, m), 1., 1e-12) << m;
      EXPECT_NEAR(law.tangent(below) / (m * unit), 1., 1e-12) << m;
      // The layer in the linear system is not much softer or stiffer than the reference secant.
      EXPECT_LT(law.initial_compliance(), 4000.) << m;
      EXPECT_GT(law.initial_compliance(), 1. / 4000.) << m;
    }
}

namespace
{
  /** w, σ, σ', ∫σ dw. */
  struct SplineRow
  {
    double w, stress, tangent, energy;
  };
} // namespace

// Values of scipy.interpolate.PchipInterpolator (scipy 1.10.1) through the same points: a closure
// curve that hardens and a shear curve that softens. The slopes at their ends are those of the
// three-point formula.
TEST(TabularLaw, SplineAgreesWithScipy)
{
  const TabularLaw closure({{0., 0.}, {1e-4, 0.12}, {2.5e-4, 0.5}, {5e-4, 1.9}, {9e-4, 6.5}},
                           TableInterpolation::monotone_spline);
  for (const SplineRow &row :
       {SplineRow{5e-05, 0.04844961240310078, 1235.6589147286822, 1.092700258397933e-06},
        SplineRow{0.0001, 0.12, 1590.6976744186045, 5.229974160206719e-06},
        SplineRow{0.00017, 0.26377436633183315, 2496.7318103256493, 1.829211304299217e-05},
        SplineRow{0.0004, 1.2242268004712955, 6101.188672652662, 0.00017258981357386505},
        SplineRow{0.0007, 3.81033270410571, 11632.951864086834, 0.0008844857999704637},
        SplineRow{0.00089, 6.349470371932514, 14974.824003067484, 0.001839613626842661}})
    {
      expect_close(closure.stress(row.w), row.stress, rounding);
      expect_close(closure.tangent(row.w), row.tangent, rounding);
      expect_close(closure.energy(row.w), row.energy, rounding);
    }
  expect_close(closure.initial_compliance(), 1. / 666.666666666667, rounding);
  const TabularLaw shear({{0., 0.}, {1e-4, 1.}, {3e-4, 1.6}, {6e-4, 2.}},
                         TableInterpolation::monotone_spline);
  for (const SplineRow &row :
       {SplineRow{5e-05, 0.5928030303030303, 10689.39393939394, 1.5162563131313129e-05},
        SplineRow{0.0002, 1.3753588516746413, 2799.0430622009576, 0.00017671318447634238},
        SplineRow{0.0005, 1.9235867446393762, 1146.1988304093563, 0.0006810885167464116}})
    {
      expect_close(shear.stress(row.w), row.stress, rounding);
      expect_close(shear.tangent(row.w), row.tangent, rounding);
      expect_close(shear.energy(row.w), row.energy, rounding);
    }
}

// (1, 1), (2, 10): the three-point formula gives the slope (3 - 9)/2 < 0 at zero, for which PCHIP
// takes 0. A layer needs a stiffness there: a tenth of the interval's.
TEST(TabularLaw, SlopeAtTheEndsIsPositive)
{
  const TabularLaw law({{0., 0.}, {1., 1.}, {2., 10.}}, TableInterpolation::monotone_spline);
  EXPECT_NEAR(law.tangent(0.), 0.1, rounding);
  const TabularLaw mirrored({{0., 0.}, {1., 9.}, {2., 10.}}, TableInterpolation::monotone_spline);
  EXPECT_NEAR(mirrored.tangent(2.), 0.1, rounding);
}

// Beyond the last point a line with the last slope.
TEST(TabularLaw, LinearContinuation)
{
  const TabularLaw law({{0., 0.}, {1., 2.}, {3., 4.}}, TableInterpolation::piecewise_linear);
  EXPECT_NEAR(law.stress(5.), 6., rounding);
  EXPECT_NEAR(law.deformation(6.), 5., rounding);
  EXPECT_EQ(law.data_limit(), 3.);
}

// Straight lines but for 5 % of the shorter interval on both sides of a corner; there a parabola,
// whose middle lies a quarter of the half width times the difference of slopes beside the corner.
TEST(TabularLaw, RoundedCorners)
{
  const TabularLaw law({{0., 0.}, {1., 2.}, {3., 4.}}, TableInterpolation::piecewise_linear);
  EXPECT_NEAR(law.stress(0.95), 1.9, rounding);
  EXPECT_NEAR(law.stress(0.5), 1., rounding);
  EXPECT_NEAR(law.stress(1.05), 2.05, rounding);
  EXPECT_NEAR(law.stress(1.), 2. - 0.05 * (2. - 1.) / 4., rounding);
  EXPECT_NEAR(law.tangent(1.), 1.5, rounding);
  EXPECT_NEAR(law.tangent(1. - 0.05), 2., rounding);
  EXPECT_NEAR(law.tangent(1. + 0.05), 1., rounding);
  // The energy at 3: the trapezoids 1 + 6, less what the parabola of half width h cuts off, h² Δ/6.
  EXPECT_NEAR(law.energy(3.), 7. - 0.05 * 0.05 / 6., rounding);
}
