// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "known_answer.h"

#include <fuga/laws/compliance_law.h>
#include <fuga/laws/cubic_root_law.h>
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
  const CubicRootLaw law(rho, zeta);
  EXPECT_EQ(law.kind(), ComplianceKind::nonlinear);
  EXPECT_EQ(law.initial_compliance(), rho);
  EXPECT_EQ(law.deformation_limit(), zeta);
  for (const Row &row : rows)
    {
      const double w    = closure(row.q);
      const auto expect = [&](const char *name, const double known, const double ours) {
        fuga::tests::expect_answer(
          {"V11 law (9)", fmt::format("{} at q = {}", name, row.q), known, "closed form"},
          ours,
          4. * rounding * known);
      };
      expect("σρ/ζ", row.stress, law.stress(w) * rho / zeta);
      expect("C_sec ρ", row.secant, law.secant(w) * rho);
      expect("C_tan ρ", row.tangent, law.tangent(w) * rho);
    }
  EXPECT_NEAR(law.tangent(closure(0.1)) * rho, 1.1522634, 5e-8);
  EXPECT_NEAR(law.tangent(closure(0.2)) * rho, 1.3541667, 5e-8);
}

// V11: the stored energy of law (9), closed form, where it does not cancel (q ≥ 0.1: the formula
// itself loses six digits at q = 0.1, hence 1e-8 there), and its series (3ζ²/ρ)(q⁶/6 + q⁷/7 + ...)
// to all digits but those that a rounding of q changes.
TEST(CubicRootLaw, Energy)
{
  const CubicRootLaw law(rho, zeta);
  const double c   = 3. * zeta * zeta / rho;
  const auto exact = [c](const double q) {
    return c * (-std::log(1. - q) - q - q * q / 2. - std::pow(q, 3) / 3. - std::pow(q, 4) / 4. -
                std::pow(q, 5) / 5.);
  };
  for (const Row &row : rows)
    EXPECT_NEAR(law.energy(closure(row.q)) / exact(row.q), 1., row.q < 0.3 ? 1e-8 : 1e-12);
  for (const double q : {1e-4, 1e-3, 0.01, 0.1, 0.2, 0.29, 0.31, 0.5})
    {
      double series = 0.;
      for (int k = 200; k >= 6; --k)
        series += std::pow(q, k) / k;
      EXPECT_NEAR(law.energy(closure(q)) / (c * series), 1., rounding) << q;
    }
  EXPECT_EQ(law.energy(0.), 0.);
}

// The inverse must give the closure back; at 1 - q = 1e-6 the stress knows the closure better than
// the closure the stress, so that only the stress is compared there.
TEST(CubicRootLaw, Inverse)
{
  const CubicRootLaw law(rho, zeta);
  for (const Row &row : rows)
    EXPECT_NEAR(law.deformation(row.stress * zeta / rho) / closure(row.q), 1., 8. * rounding);
  for (const double q : {1e-6, 1e-4, 1e-2, 0.3, 0.9, 0.99})
    EXPECT_NEAR(law.deformation(law.stress(closure(q))) / closure(q), 1., 1e-13) << q;
  const double extreme = 1e6 * zeta / rho;
  EXPECT_NEAR(law.stress(law.deformation(extreme)) / extreme, 1., 1e-8);
  EXPECT_LT(law.deformation(extreme), zeta);
  EXPECT_EQ(law.deformation(0.), 0.);
}

// Derivatives by central differences: dE/dw = σ, dσ/dw = the tangent. The truncation error of the
// difference is (h²/6)|f'''| ≤ 2e-8 relative at these points, rounding 1e-10.
TEST(CubicRootLaw, DerivativesAgree)
{
  const CubicRootLaw law(rho, zeta);
  for (const double q : {0.2, 0.5, 0.8})
    {
      const double w = closure(q), h = 1e-4 * w * (1. - q);
      EXPECT_NEAR((law.energy(w + h) - law.energy(w - h)) / (2. * h * law.stress(w)), 1., 1e-7);
      EXPECT_NEAR((law.stress(w + h) - law.stress(w - h)) / (2. * h * law.tangent(w)), 1., 1e-7);
    }
}

// Law (9) as a tangent: what the paper calls C(u), 1/(1 - q), is the tangent stiffness; the stress
// 3 ∫q²/(1-q) dq in closed form, exact up to the cancellation of its four terms (q³/3 of 1 is left,
// so up to 1e3 roundings at q = 0.1).
TEST(CubicRootTangentLaw, StressAndTangent)
{
  const CubicRootTangentLaw law(rho, zeta);
  EXPECT_EQ(law.kind(), ComplianceKind::nonlinear);
  EXPECT_EQ(law.initial_compliance(), rho);
  EXPECT_EQ(law.secant(0.), 1. / rho);
  EXPECT_EQ(law.deformation_limit(), zeta);
  for (const Row &row : rows)
    {
      const double w = closure(row.q), q = row.q;
      EXPECT_NEAR(law.tangent(w) * rho / row.secant, 1., 4. * rounding) << q;
      const double stress = 3. * (-q * q / 2. - q - std::log(1. - q));
      EXPECT_NEAR(law.stress(w) * rho / zeta / stress, 1., 1e3 * rounding) << q;
      EXPECT_NEAR(law.secant(w) * w / law.stress(w), 1., rounding) << q;
    }
  // Half way to the limit in q: 3 (ln 2 - 5/8).
  EXPECT_NEAR(law.stress(closure(0.5)) * rho / zeta, 3. * (std::log(2.) - 0.625), rounding);
}

// The series Σ q^k/k, k ≥ 3, where the closed form has no digits left, and that of its integral
// over w = ζq³, 9 Σ q^(k+3)/(k (k+3)), at all closures. A rounding of q changes the energy by up
// to 14 at q = 0.9. The path measures its steps by this energy: where it lost three digits beyond
// q = 0.3, steps were shortened without end.
TEST(CubicRootTangentLaw, StressAndEnergyBySeries)
{
  const CubicRootTangentLaw law(rho, zeta);
  for (const double q : {1e-6, 1e-4, 1e-3, 0.01, 0.1, 0.29, 0.31, 0.5, 0.9})
    {
      double stress = 0., energy = 0.;
      for (int k = 600; k >= 3; --k)
        {
          stress += 3. * std::pow(q, k) / k;
          energy += 9. * std::pow(q, k + 3) / (k * (k + 3.));
        }
      EXPECT_NEAR(law.stress(closure(q)) * rho / zeta / stress, 1., rounding) << q;
      EXPECT_NEAR(law.energy(closure(q)) * rho / (zeta * zeta) / energy, 1., rounding) << q;
    }
  EXPECT_EQ(law.stress(0.), 0.);
  EXPECT_EQ(law.energy(0.), 0.);
}

// The inverse gives the closure back; no stress passes the limit: q of 30 ζ/ρ by its leading terms,
// 1 - q = exp(-10 - 3/2) but for its square.
TEST(CubicRootTangentLaw, Inverse)
{
  const CubicRootTangentLaw law(rho, zeta);
  for (const double q : {1e-6, 1e-4, 1e-2, 0.1, 0.3, 0.6, 0.9, 0.999})
    EXPECT_NEAR(law.deformation(law.stress(closure(q))) / closure(q), 1., 1e-13) << q;
  const double close = std::exp(-11.5);
  EXPECT_NEAR(law.deformation(30. * zeta / rho) / zeta, 1. - 3. * close, 10. * close * close);
  EXPECT_LE(law.deformation(1e6 * zeta / rho), zeta);
  EXPECT_EQ(law.deformation(0.), 0.);
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
