// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/laws/cubic_root_law.h>
#include <fuga/laws/hyperbolic_law.h>
#include <fuga/laws/shear_coupling.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;

namespace
{
  std::vector<ShearCoupling>
  couplings(const ComplianceLaw &normal)
  {
    std::vector<ShearCoupling> all;
    for (const auto kind : {ShearCoupling::Kind::closure, ShearCoupling::Kind::pressure})
      for (const double m : {0.3, 1.})
        all.emplace_back(kind, normal, 0.5, 3., m);
    return all;
  }
} // namespace

// The stresses are the derivatives of the stored energy, by central differences: error O(h²) of the
// third derivatives, which are of order one here.
TEST(ShearCoupling, StressesDeriveFromOnePotential)
{
  const double h                              = 1e-5;
  const auto linear                           = make_linear_law(0.25);
  const std::unique_ptr<ComplianceLaw> curved = std::make_unique<CubicRootLaw>(0.25, 4.);
  for (const auto *normal : {linear.get(), curved.get()})
    for (const ShearCoupling &layer : couplings(*normal))
      for (const double w : {0.1, 0.5, 1.})
        for (const double e : {-0.3, 0., 0.05, 0.3})
          {
            const auto r = layer.response(w, e);
            EXPECT_NEAR((layer.energy(w + h, e) - layer.energy(w - h, e)) / (2 * h), r.sigma, 1e-8);
            EXPECT_NEAR((layer.energy(w, e + h) - layer.energy(w, e - h)) / (2 * h), r.tau, 1e-8);
            const auto a = layer.response(w + h, e), b = layer.response(w - h, e);
            const auto c = layer.response(w, e + h), d = layer.response(w, e - h);
            EXPECT_NEAR((a.sigma - b.sigma) / (2 * h), r.dsigma_dw, 1e-7);
            EXPECT_NEAR((c.sigma - d.sigma) / (2 * h), r.dsigma_de, 1e-7);
            EXPECT_NEAR((a.tau - b.tau) / (2 * h), r.dsigma_de, 1e-7);
            EXPECT_NEAR((c.tau - d.tau) / (2 * h), r.dtau_de, 1e-7);
            // Stable: the tangent is positive definite.
            EXPECT_GT(r.dsigma_dw * r.dtau_de - r.dsigma_de * r.dsigma_de, 0.);
          }
}

// deformation() inverts response(); shear_deformation() does at a known closure. Both by iterations
// that end at rounding.
TEST(ShearCoupling, InversesReturn)
{
  const auto linear = make_linear_law(0.25);
  for (const ShearCoupling &layer : couplings(*linear))
    for (const double w : {-0.05, 0., 0.2, 1.})
      for (const double e : {-0.4, 0., 0.1})
        {
          const auto r    = layer.response(w, e);
          const auto back = layer.deformation(r.sigma, r.tau);
          EXPECT_NEAR(back.closure, w, 1e-13);
          EXPECT_NEAR(back.shear, e, 1e-13);
          EXPECT_NEAR(layer.shear_deformation(w, r.tau), e, 1e-13);
        }
}

// Shear alone keeps the layer pressed, however far its faces are apart: beyond the tension 0.9·3,
// at w = -0.675, where the shear stiffness stops falling. By eq. 9b from given stresses.
TEST(ShearCoupling, PressedByShearWhileFacesPart)
{
  const double rho_n = 0.25, rho_t = 0.5, sigma_r = 3., m = 0.3;
  const auto linear = make_linear_law(rho_n);
  const ShearCoupling layer(ShearCoupling::Kind::pressure, *linear, rho_t, sigma_r, m);
  for (const double sigma : {-1., 1e-3, 0.5, 2.})
    for (const double e : {-5., 5., 40.})
      {
        const double k = std::pow(1. + sigma / sigma_r, m) / rho_t;
        const double w = rho_n * sigma - 0.5 * m * k / (sigma_r + sigma) * e * e;
        ASSERT_LT(w, -0.9 * sigma_r * rho_n);
        const auto r = layer.response(w, e);
        EXPECT_NEAR(r.sigma, sigma, 1e-12 * std::abs(w / rho_n));
        EXPECT_NEAR(r.tau, k * e, 1e-12 * std::abs(w / rho_n));
        EXPECT_NEAR(layer.shear_deformation(w, k * e), e, 1e-12 * std::abs(e));
      }
  EXPECT_EQ(layer.response(-0.8, 0.).sigma, -3.2);
}

// So much shear that the layer would be wider than its closure limit lets it be, were it not for
// the pressure that this causes: w + widening(σ_n(w)) = 0.9 + 0.27 is beyond the limit 1. The
// inverse of a pressure is explicit.
TEST(ShearCoupling, WidenedBeyondItsClosureLimit)
{
  const HyperbolicLaw hyperbola(0.25, 1.);
  const ShearCoupling layer(ShearCoupling::Kind::pressure, hyperbola, 0.5, 3., 0.3);
  for (const double e : {1., 4., -8.})
    {
      const auto r = layer.response(0.9, e);
      EXPECT_GT(r.sigma, hyperbola.stress(0.9));
      const auto back = layer.deformation(r.sigma, r.tau);
      EXPECT_NEAR(back.closure, 0.9, 1e-12);
      EXPECT_NEAR(back.shear, e, 1e-12);
    }
}

// Sheared lips under more pressure than the linear normal law needs for the closure 3, at which the
// shear stiffness is infinite: σ = 4w + ½k_t'e², τ = k_t e, by hand.
TEST(ShearCoupling, ShearKeepsTheLipsFromTheLimit)
{
  const auto linear = make_linear_law(0.25);
  for (const double m : {0.3, 0.9})
    for (const double rest : {0.5, 1e-2, 1e-5, 1e-8})
      {
        const ShearCoupling layer(ShearCoupling::Kind::closure, *linear, 0.5, 3., m);
        const double w = 3. - rest, k = 2. * std::pow(rest / 3., -m);
        const double e     = std::sqrt(8. * rest / (m * k)); // σ = 4w + 4 > 12
        const double sigma = 4. * w + 0.5 * m * k / rest * e * e;
        const auto back    = layer.deformation(sigma, k * e);
        EXPECT_NEAR(back.closure, w, 2e-15 * 3. / (1. - m));
        EXPECT_NEAR(layer.energy(back.closure, back.shear), 2. * w * w + 0.5 * k * e * e, 1e-6);
      }
}

// The definitions at hand-made numbers: k_t = (1 - 1/3)^{-1}/0.5 = 3 at w = 1, w_c = 3, m = 1; its
// derivative 3/2. k_t = (1 + σ/3)/0.5 with σ_n = 4w: at w = 1, e = 0.3: σ = 4(1 + ½(2/3)0.09).
TEST(ShearCoupling, Values)
{
  const auto linear = make_linear_law(0.25);
  const auto closure =
    ShearCoupling(ShearCoupling::Kind::closure, *linear, 0.5, 3., 1.).response(1., 0.3);
  EXPECT_NEAR(closure.tau, 0.9, 1e-14);
  EXPECT_NEAR(closure.sigma, 4. + 0.5 * 1.5 * 0.09, 1e-14);
  const auto pressure =
    ShearCoupling(ShearCoupling::Kind::pressure, *linear, 0.5, 3., 1.).response(1., 0.3);
  EXPECT_NEAR(pressure.sigma, 4.12, 1e-14);
  EXPECT_NEAR(pressure.tau, 2. * (1. + 4.12 / 3.) * 0.3, 1e-14);
}
