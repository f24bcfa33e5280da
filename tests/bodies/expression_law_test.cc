// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/bodies/expression_law.h>
#include <fuga/laws/cubic_root_law.h>
#include <fuga/laws/hyperbolic_law.h>
#include <fuga/laws/law_check.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;

namespace
{
  constexpr double never = std::numeric_limits<double>::infinity();
} // namespace

// The hyperbola written down as expressions is the built-in law: stress and tangent to rounding,
// the energy to the tolerance of the quadrature, the inverse to rounding.
TEST(ExpressionLaw, EqualsTheBuiltInHyperbola)
{
  const ExpressionLaw law(
    "w/(rho*(1 - w/V))", "1/(rho*(1 - w/V)^2)", 2e-3, {{"rho", 1.25e-4}, {"V", 2e-3}}, "test");
  const HyperbolicLaw hyperbola(1.25e-4, 2e-3);
  EXPECT_NEAR(law.initial_compliance(), 1.25e-4, 1e-18);
  EXPECT_EQ(law.deformation_limit(), 2e-3);
  for (const double share : {1e-6, 1e-3, 0.1, 0.5, 0.9, 0.999})
    {
      const double w = share * 2e-3;
      EXPECT_NEAR(law.stress(w) / hyperbola.stress(w), 1., 1e-12);
      EXPECT_NEAR(law.tangent(w) / hyperbola.tangent(w), 1., 1e-12);
      EXPECT_NEAR(law.energy(w) / hyperbola.energy(w), 1., 1e-12) << share;
      EXPECT_NEAR(law.deformation(hyperbola.stress(w)) / w, 1., 1e-12) << share;
    }
  EXPECT_FALSE(check_law(law, 30.));
}

// sinh: no limit, energy cosh - 1, inverse asinh; from stresses far below one to far above.
TEST(ExpressionLaw, HyperbolicSine)
{
  const ExpressionLaw law("2*sinh(w)", "2*cosh(w)", never, {}, "test");
  for (const double w : {1e-3, 0.5, 3., 20.})
    {
      EXPECT_NEAR(law.energy(w) / (4. * std::pow(std::sinh(0.5 * w), 2)), 1., 1e-12) << w;
      EXPECT_NEAR(law.deformation(2. * std::sinh(w)) / w, 1., 1e-13) << w;
    }
  EXPECT_FALSE(check_law(law, 1000.));
}

// The first bracket of the inverse is halved to w = 710 w0, where the slope overflows and the
// stress does not.
TEST(ExpressionLaw, AnInverseFromWhereTheSlopeOverflows)
{
  const double s = 1e-3, w0 = 1e-4, sigma = 1.42;
  const ExpressionLaw law("1e-3*sinh(w/1e-4)", "10*cosh(w/1e-4)", never, {}, "test");
  ASSERT_TRUE(std::isfinite(law.stress(0.5 * sigma * w0 / s)));
  ASSERT_FALSE(std::isfinite(law.tangent(0.5 * sigma * w0 / s)));
  EXPECT_NEAR(law.deformation(sigma) / (w0 * std::asinh(sigma / s)), 1., 1e-13);
}

// √(1 + x) - 1 = x/(√(1 + x) + 1), whose right side cancels nothing: all digits of the stress, and
// of its inverse, down to the smallest closures. The tangent changes by a hundredth at x = 0.02.
TEST(ExpressionLaw, KeepsItsDigitsWhereItsTermsCancel)
{
  const ExpressionLaw law("3*(sqrt(1 + w/2e-4) - 1)", "7500/sqrt(1 + w/2e-4)", never, {}, "test");
  for (const double x : {1e-14, 1e-9, 1e-5, 1e-3, 0.0199, 0.0201, 0.03})
    {
      const double w = 2e-4 * x, sigma = 3. * x / (std::sqrt(1. + x) + 1.);
      EXPECT_NEAR(law.stress(w) / sigma, 1., 2e-14) << x;
      EXPECT_NEAR(law.deformation(sigma) / w, 1., 2e-14) << x;
    }
}

// Law (9) as a tangent cancels near w = 0, to 1e-16 of numbers of order one where q³ is left: its
// energy is known to some 1e-15/q³ and no better, and the quadrature must not look for more.
TEST(ExpressionLaw, EnergyDownToItsNoise)
{
  const ExpressionLaw law("3*Z/rho*(-(w/Z)^(2/3)/2 - (w/Z)^(1/3) - ln(1 - (w/Z)^(1/3)))",
                          "1/(rho*(1 - (w/Z)^(1/3)))",
                          2e-3,
                          {{"rho", 1.25e-4}, {"Z", 2e-3}},
                          "test");
  const CubicRootTangentLaw built_in(1.25e-4, 2e-3);
  for (const double q : {1e-4, 1e-3, 0.01, 0.1, 0.5, 0.9, 0.999})
    {
      const double w = 2e-3 * q * q * q;
      EXPECT_NEAR(law.energy(w) / built_in.energy(w), 1., 1e-12 + 1e-15 / (q * q * q)) << q;
    }
  EXPECT_TRUE(std::isfinite(law.energy(1e-30)));
}

// What check_law() is for: a derivative with a wrong sign, and a tangent that is infinite at zero.
TEST(ExpressionLaw, WrongExpressions)
{
  EXPECT_TRUE(check_law(ExpressionLaw("w + w^2", "1 - 2*w", never, {}, "test"), 10.));
  EXPECT_TRUE(check_law(ExpressionLaw("sqrt(w)", "0.5/sqrt(w)", never, {}, "test"), 10.));
  EXPECT_TRUE(check_law(ExpressionLaw("1 + w", "1", never, {}, "test"), 10.));
  EXPECT_THROW(ExpressionLaw("2*v", "2", never, {}, "test"), InputError);
}
