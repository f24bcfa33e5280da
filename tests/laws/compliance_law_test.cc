// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "known_answer.h"

#include <fuga/laws/compliance_law.h>
#include <fuga/laws/friction_law.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;

namespace
{
  /** A few roundings of numbers of order one. */
  constexpr double rounding = 1e-14;

  constexpr double rho  = 1.25e-4;
  constexpr double zeta = 2e-3;

  /** Law (9) at q = (w/ζ0)^{1/3}. */
  struct Row
  {
    double q, stress, secant, tangent;
  };

  // Closed forms of law (9); the tangents (1 - 2q/3)/(1 - q)² as fractions.
  const Row rows[] = {{0.1, 1. / 900., 10. / 9., 28. / 24.3},
                      {0.2, 0.01, 1.25, 65. / 48.},
                      {0.5, 0.25, 2., 8. / 3.},
                      {0.6, 0.54, 2.5, 3.75}};

  double
  closure(const double q)
  {
    return zeta * q * q * q;
  }
} // namespace

// V11: stress, secant and tangent of law (9) at four closures, closed form; exact up to rounding.
// The printed digits of the two tangents that are no short fractions are checked as well.
TEST(CubicRootLaw, StressSecantAndTangent)
{
  const auto law = make_cubic_root_law(rho, zeta);
  EXPECT_EQ(law->kind(), ComplianceKind::nonlinear);
  EXPECT_EQ(law->initial_compliance(), rho);
  EXPECT_EQ(law->deformation_limit(), zeta);
  for (const Row &row : rows)
    {
      const double w    = closure(row.q);
      const auto expect = [&](const char *name, const double known, const double ours) {
        fuga::tests::expect_answer(
          {"V11 law (9)", fmt::format("{} at q = {}", name, row.q), known, "closed form"},
          ours,
          4. * rounding * known);
      };
      expect("σρ/ζ", row.stress, law->stress(w) * rho / zeta);
      expect("C_sec ρ", row.secant, law->secant(w) * rho);
      expect("C_tan ρ", row.tangent, law->tangent(w) * rho);
    }
  EXPECT_NEAR(law->tangent(closure(0.1)) * rho, 1.1522634, 5e-8);
  EXPECT_NEAR(law->tangent(closure(0.2)) * rho, 1.3541667, 5e-8);
}

// V11: the stored energy of law (9), closed form, where it does not cancel (q ≥ 0.1: the formula
// itself loses six digits at q = 0.1, hence 1e-8 there); for small closures its first two terms
// (3ζ²/ρ)(q⁶/6 + q⁷/7 + q⁸/8 + ...) are summed instead, as a series.
TEST(CubicRootLaw, Energy)
{
  const auto law   = make_cubic_root_law(rho, zeta);
  const double c   = 3. * zeta * zeta / rho;
  const auto exact = [c](const double q) {
    return c * (-std::log(1. - q) - q - q * q / 2. - std::pow(q, 3) / 3. - std::pow(q, 4) / 4. -
                std::pow(q, 5) / 5.);
  };
  for (const Row &row : rows)
    EXPECT_NEAR(law->energy(closure(row.q)) / exact(row.q), 1., row.q < 0.3 ? 1e-8 : 1e-12);
  for (const double q : {1e-4, 1e-3, 0.01, 0.1, 0.2, 0.5})
    {
      double series = 0.;
      for (int k = 200; k >= 6; --k)
        series += std::pow(q, k) / k;
      EXPECT_NEAR(law->energy(closure(q)) / (c * series), 1., 1e-12) << q;
    }
  EXPECT_EQ(law->energy(0.), 0.);
}

// The inverse must give the closure back; at 1 - q = 1e-6 the stress knows the closure better than
// the closure the stress, so that only the stress is compared there.
TEST(CubicRootLaw, Inverse)
{
  const auto law = make_cubic_root_law(rho, zeta);
  for (const Row &row : rows)
    EXPECT_NEAR(law->deformation(row.stress * zeta / rho) / closure(row.q), 1., 8. * rounding);
  for (const double q : {1e-6, 1e-4, 1e-2, 0.3, 0.9, 0.99})
    EXPECT_NEAR(law->deformation(law->stress(closure(q))) / closure(q), 1., 1e-13) << q;
  const double extreme = 1e6 * zeta / rho;
  EXPECT_NEAR(law->stress(law->deformation(extreme)) / extreme, 1., 1e-8);
  EXPECT_LT(law->deformation(extreme), zeta);
  EXPECT_EQ(law->deformation(0.), 0.);
}

// Derivatives by central differences: dE/dw = σ, dσ/dw = the tangent. The truncation error of the
// difference is (h²/6)|f'''| ≤ 2e-8 relative at these points, rounding 1e-10.
TEST(CubicRootLaw, DerivativesAgree)
{
  const auto law = make_cubic_root_law(rho, zeta);
  for (const double q : {0.2, 0.5, 0.8})
    {
      const double w = closure(q), h = 1e-4 * w * (1. - q);
      EXPECT_NEAR((law->energy(w + h) - law->energy(w - h)) / (2. * h * law->stress(w)), 1., 1e-7);
      EXPECT_NEAR((law->stress(w + h) - law->stress(w - h)) / (2. * h * law->tangent(w)), 1., 1e-7);
    }
}

// σ = w/ρ: by definition, up to rounding.
TEST(LinearLaw, EverythingByDefinition)
{
  const auto law = make_linear_law(rho);
  const double w = 3e-4;
  EXPECT_EQ(law->kind(), ComplianceKind::linear);
  EXPECT_EQ(law->initial_compliance(), rho);
  EXPECT_NEAR(law->stress(w), 2.4, rounding * 2.4);
  EXPECT_NEAR(law->secant(w), 8000., rounding * 8000.);
  EXPECT_NEAR(law->tangent(w), 8000., rounding * 8000.);
  EXPECT_NEAR(law->energy(w), 3.6e-4, rounding);
  EXPECT_NEAR(law->deformation(2.4), w, rounding * w);
  EXPECT_TRUE(std::isinf(law->deformation_limit()));
}

// ρ = 0, by definition.
TEST(RigidLaw, HasNoCompliance)
{
  const auto law = make_rigid_law();
  EXPECT_EQ(law->kind(), ComplianceKind::rigid);
  EXPECT_EQ(law->initial_compliance(), 0.);
}
