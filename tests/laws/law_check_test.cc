// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/laws/cubic_root_law.h>
#include <fuga/laws/exponential_law.h>
#include <fuga/laws/hyperbolic_law.h>
#include <fuga/laws/law_check.h>
#include <fuga/laws/power_law.h>
#include <fuga/laws/tabular_law.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

using namespace fuga;

namespace
{
  constexpr double largest_stress = 30.;

  std::vector<std::shared_ptr<ComplianceLaw>>
  all_laws()
  {
    const std::vector<TabularLaw::Point> table = {
      {0., 0.}, {1e-4, 0.12}, {2.5e-4, 0.5}, {5e-4, 1.9}, {9e-4, 6.5}};
    std::vector<std::shared_ptr<ComplianceLaw>> laws = {
      make_linear_law(1.25e-4),
      std::make_unique<CubicRootLaw>(1.25e-4, 2e-3),
      std::make_unique<CubicRootTangentLaw>(1.25e-4, 2e-3),
      std::make_shared<HyperbolicLaw>(1.25e-4, 2e-3),
      std::make_shared<ExponentialLaw>(1e-3, 4.),
      std::make_shared<TabularLaw>(table, TableInterpolation::monotone_spline),
      std::make_shared<TabularLaw>(table, TableInterpolation::piecewise_linear)};
    for (const double m : {0.2, 0.5, 1., 1.5, 1.6, 2., 3., 4.2, 5.})
      laws.push_back(std::make_shared<PowerLaw>(5e-4, 2., m));
    return laws;
  }

  /** Simpson's rule on intervals that shrink towards both ends and meet at the knots. */
  double
  quadrature(const ComplianceLaw &law, const double w)
  {
    std::vector<double> ends = {0., w};
    for (const double knot : law.knots())
      if (knot < w)
        ends.push_back(knot);
    std::sort(ends.begin(), ends.end());
    double sum  = 0.;
    const int n = 4000;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      {
        const double a = ends[i], b = ends[i + 1];
        // w = a + (b - a) s³ weakens the root in law (9).
        const auto f = [&](const double s) {
          return law.stress(a + (b - a) * s * s * s) * 3. * s * s * (b - a);
        };
        for (int k = 0; k < n; ++k)
          sum += (f(double(k) / n) + 4. * f((k + 0.5) / n) + f((k + 1.) / n)) / (6. * n);
      }
    return sum;
  }

  /** A linear law σ = w with one property spoiled. */
  class SpoiledLaw : public ComplianceLaw
  {
  public:
    std::function<double(double)> spoiled_stress, spoiled_tangent, spoiled_energy, spoiled_inverse;
    double limit = std::numeric_limits<double>::infinity();

    ComplianceKind
    kind() const override
    {
      return ComplianceKind::nonlinear;
    }
    double
    initial_compliance() const override
    {
      return 1. / tangent(0.);
    }
    double
    stress(const double w) const override
    {
      return spoiled_stress ? spoiled_stress(w) : w;
    }
    double
    tangent(const double w) const override
    {
      return spoiled_tangent ? spoiled_tangent(w) : 1.;
    }
    double
    secant(const double w) const override
    {
      return stress(w) / w;
    }
    double
    energy(const double w) const override
    {
      return spoiled_energy ? spoiled_energy(w) : 0.5 * w * w;
    }
    double
    deformation(const double sigma) const override
    {
      return spoiled_inverse ? spoiled_inverse(sigma) : sigma;
    }
    double
    deformation_limit() const override
    {
      return limit;
    }
    std::string
    description() const override
    {
      return "spoiled";
    }
  };
} // namespace

TEST(LawCheck, AllLawsAreAccepted)
{
  for (const auto &law : all_laws())
    {
      const auto problem = check_law(*law, largest_stress);
      EXPECT_FALSE(problem) << law->description() << ": " << (problem ? problem->text : "")
                            << " at " << (problem ? problem->deformation : 0.);
    }
  EXPECT_FALSE(check_law(*make_rigid_law(), largest_stress));
}

// The energy against independent quadrature. Simpson's error on 4000 intervals of smooth pieces is
// below 1e-11; law (9) has a root at zero, weakened by the substitution.
TEST(LawCheck, EnergiesByQuadrature)
{
  for (const auto &law : all_laws())
    for (const double share : {1e-4, 0.02, 0.3, 1.})
      {
        const double w = share * range_of_interest(*law, largest_stress);
        EXPECT_NEAR(law->energy(w) / quadrature(*law, w), 1., 1e-10)
          << law->description() << " at " << w;
      }
}

// Stress and back. Where the curve is flat (m = 0.2: dw/w = 5 dσ/σ) or near a limit the deformation
// is known less well than the stress, by less than a factor 100 here.
TEST(LawCheck, InverseRoundTrips)
{
  for (const auto &law : all_laws())
    for (double share = 1e-7; share <= 1.; share *= 1.7)
      {
        const double w = share * range_of_interest(*law, largest_stress);
        EXPECT_NEAR(law->deformation(law->stress(w)) / w, 1., 1e-13)
          << law->description() << " at " << w;
      }
}

// Every property the check promises to test, spoiled; the place is where it fails first.
TEST(LawCheck, SpoiledLawsAreRefused)
{
  const auto expect = [](const SpoiledLaw &law, const std::string &words) {
    const auto problem = check_law(law, 1.);
    ASSERT_TRUE(problem) << words;
    EXPECT_NE(problem->text.find(words), std::string::npos) << problem->text;
  };
  EXPECT_FALSE(check_law(SpoiledLaw(), 1.));
  SpoiledLaw offset;
  offset.spoiled_stress = [](const double w) { return w + 0.1; };
  expect(offset, "without deformation is 0.1");
  SpoiledLaw flat;
  flat.spoiled_stress  = [](const double w) { return w * w; };
  flat.spoiled_tangent = [](const double w) { return 2. * w; };
  expect(flat, "tangent is 0");
  SpoiledLaw steep;
  steep.spoiled_stress  = [](const double w) { return std::sqrt(w); };
  steep.spoiled_tangent = [](const double w) { return 0.5 / std::sqrt(w); };
  expect(steep, "tangent is inf");
  SpoiledLaw falling;
  falling.spoiled_stress  = [](const double w) { return w * (1. - w); };
  falling.spoiled_tangent = [](const double w) { return 1. - 2. * w; };
  falling.spoiled_inverse = [](const double s) { return 0.5 - std::sqrt(0.25 - s); };
  falling.spoiled_energy  = [](const double w) { return w * w * (0.5 - w / 3.); };
  expect(falling, "positive");
  SpoiledLaw wrong_tangent;
  wrong_tangent.spoiled_tangent = [](const double w) { return 1. + w; };
  expect(wrong_tangent, "grows by");
  SpoiledLaw jump;
  jump.spoiled_stress  = [](const double w) { return w < 0.3 ? w : w + 0.01; };
  jump.spoiled_inverse = [](const double s) { return s < 0.3 ? s : s - 0.01; };
  expect(jump, "jumps");
  SpoiledLaw energy;
  energy.spoiled_energy = [](const double w) { return w * w; };
  expect(energy, "energy");
  SpoiledLaw inverse;
  inverse.spoiled_inverse = [](const double s) { return 1.1 * s; };
  expect(inverse, "comes out as");
  SpoiledLaw bounded;
  bounded.limit = 0.5;
  expect(bounded, "without bound");
}
