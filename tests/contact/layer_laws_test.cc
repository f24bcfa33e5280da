// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/toy_system.h"

#include <fuga/base/errors.h>
#include <fuga/laws/cubic_root_law.h>
#include <fuga/laws/exponential_law.h>
#include <fuga/laws/hyperbolic_law.h>
#include <fuga/laws/power_law.h>
#include <fuga/laws/tabular_law.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  using Maker = std::function<std::unique_ptr<ComplianceLaw>()>;

  /** A law with the closures that the pressures 0.3 and 0.05 cause, from the closed form by hand.
   */
  struct LawCase
  {
    std::string name;
    Maker make;
    double closure, light_closure;
    bool in_shear = true;
  };

  // All with stresses and closures of order one.
  const LawCase cases[] = {
    // w = σ V_m/(K V_m + σ).
    {"hyperbolic",
     [] { return std::make_unique<HyperbolicLaw>(1., 1.); },
     0.3 / 1.3,
     0.05 / 1.05,
     false},
    // w = c0 (1 + ln(σ/p0)/ln 100), c0 = 1, p0 = 0.6.
    {"exponential",
     [] { return std::make_unique<ExponentialLaw>(1., 0.6); },
     1. - std::log(2.) / std::log(100.),
     1. - std::log(12.) / std::log(100.),
     false},
    // Law (9) as a tangent at q = 1/2: σ = 3 ζ0/ρ (ln 2 - 5/8), w = ζ0/8.
    {"cubic root tangent",
     [] { return std::make_unique<CubicRootTangentLaw>(1., 0.1 / (std::log(2.) - 0.625)); },
     0.0125 / (std::log(2.) - 0.625),
     std::nan("")}, // by the series only
    // w = σ^(1/m).
    {"power 0.2",
     [] { return std::make_unique<PowerLaw>(1., 1., 0.2); },
     std::pow(0.3, 5.),
     std::nan("")}, // in the foot
    {"power 0.5", [] { return std::make_unique<PowerLaw>(1., 1., 0.5); }, 0.09, 0.0025},
    {"power 1.5",
     [] { return std::make_unique<PowerLaw>(1., 1., 1.5); },
     std::pow(0.3, 2. / 3.),
     std::pow(0.05, 2. / 3.)},
    {"power 3",
     [] { return std::make_unique<PowerLaw>(1., 1., 3.); },
     std::cbrt(0.3),
     std::cbrt(0.05)},
    {"power 5",
     [] { return std::make_unique<PowerLaw>(1., 1., 5.); },
     std::pow(0.3, 0.2),
     std::pow(0.05, 0.2)},
    // Both pressures are points of the table.
    {"spline",
     [] {
       return std::make_unique<TabularLaw>(
         std::vector<TabularLaw::Point>{
           {0., 0.}, {0.1, 0.05}, {0.2, 0.15}, {0.3, 0.3}, {0.4, 0.6}, {0.5, 1.2}},
         TableInterpolation::monotone_spline);
     },
     0.3,
     0.1},
    // Both pressures are half way between two points.
    {"lines",
     [] {
       return std::make_unique<TabularLaw>(
         std::vector<TabularLaw::Point>{{0., 0.}, {0.2, 0.1}, {0.4, 0.5}, {0.5, 1.2}},
         TableInterpolation::piecewise_linear);
     },
     0.3,
     0.1}};

  struct BlockRun
  {
    PathResult result;
    Certificate certificate;
    std::vector<JointState> levels;
    std::vector<Vector> jumps;
    std::size_t n_events = 0;
    IterationCount iterations;
  };

  const Maker linear = [] { return make_linear_law(1.); };

  /** A block of base 1, with friction 0.3, under horizontal force, vertical force and moment. */
  BlockRun
  run_block(const Maker &normal,
            const Maker &shear,
            const std::vector<Vector> &loads,
            const PathOptions &options = {})
  {
    const std::size_t n    = 8;
    const ToyJoint joint   = rigid_block_joint(n, 1., normal(), shear(), {0.3, 0.});
    const ToySystem system = rigid_block(n, 1.);
    const LayeredSystem layered(system, joint.elements);
    Vector times(1, 0.), levels;
    for (std::size_t i = 1; i < loads.size(); ++i)
      {
        times.push_back(static_cast<double>(i));
        levels.push_back(times.back());
      }
    const LoadHistory history(times, loads);
    EventPath path(joint.elements, layered, history, options);
    Record record(system, joint.elements, history);
    BlockRun run;
    run.result      = path.run(levels, record);
    run.certificate = record.worst;
    run.levels      = record.levels;
    for (const JointState &level : record.levels)
      run.jumps.push_back(layered.jumps(level.dislocations, level.forces));
    run.n_events   = record.events.size();
    run.iterations = path.iterations();
    return run;
  }

  void
  PrintTo(const LawCase &law, std::ostream *stream)
  {
    *stream << law.name;
  }

  class LayerLaws : public testing::TestWithParam<LawCase>
  {
  };

  std::string
  name_of(const testing::TestParamInfo<LawCase> &info)
  {
    std::string name = info.param.name;
    for (char &c : name)
      c = c == ' ' || c == '.' ? '_' : c;
    return name;
  }
} // namespace

// Uniform pressure up, down and up again: the closures are those of the closed form each time, the
// forces carry the weight, 1/8 of it per element and half at the ends. 1e-11 of the closures: the
// tolerance of the iteration is 1e-13, and a power of 5 has lost three digits in the linear system.
TEST_P(LayerLaws, LoadingAndUnloading)
{
  const LawCase &law = GetParam();
  const BlockRun run =
    run_block(law.make, linear, {{0., 0., 0.}, {0., -0.3, 0.}, {0., -0.05, 0.}, {0., -0.3, 0.}});
  ASSERT_EQ(run.levels.size(), 3u);
  for (std::size_t level = 0; level < 3; ++level)
    for (std::size_t k = 0; k <= 8; ++k)
      {
        const double weight  = level == 1 ? 0.05 : 0.3;
        const double closure = level == 1 ? law.light_closure : law.closure;
        if (!std::isnan(closure))
          {
            EXPECT_NEAR(run.jumps[level][2 * k], -closure, 1e-11 * law.closure) << level;
          }
        EXPECT_NEAR(run.levels[level].forces[2 * k], -weight * (k % 8 == 0 ? 1. : 2.) / 16., 1e-12);
      }
  EXPECT_LE(run.certificate.worst(), 1e-9);
}

// Weight; push and moment, so that the base opens and slides; the push reversed; nearly all taken
// away. The judge finds nothing wrong, energy included, and the steps do not crawl: law (9) takes
// some 1100 solutions for the same path.
TEST_P(LayerLaws, OpeningSlidingReversal)
{
  const LawCase &law = GetParam();
  for (const bool nonlinear_shear : {false, true})
    {
      if (nonlinear_shear && !law.in_shear)
        continue;
      const BlockRun run = run_block(
        law.make,
        nonlinear_shear ? law.make : linear,
        {{0., 0., 0.}, {0., -0.3, 0.}, {0.081, -0.3, -0.09}, {-0.081, -0.3, 0.}, {0., -0.03, 0.}});
      EXPECT_EQ(run.result.verdict, Verdict::done);
      EXPECT_GT(run.n_events, 20u);
      for (const auto &entry : run.certificate.entries())
        EXPECT_LE(entry.second, 1e-9) << entry.first;
      EXPECT_LE(run.iterations.n_solutions, 2500u);
      EXPECT_LE(run.iterations.n_iterations, 4 * run.iterations.n_solutions);
      RecordProperty(nonlinear_shear ? "both" : "normal",
                     std::to_string(run.iterations.n_iterations) + " iterations in " +
                       std::to_string(run.iterations.n_solutions) + " solutions");
    }
}

INSTANTIATE_TEST_SUITE_P(Laws, LayerLaws, testing::ValuesIn(cases), name_of);

// The iteration with the constant stiffness on the hyperbola: its tangent is twice the first one at
// w = V_m (1 - 1/√2) = 0.2929 V_m, beyond which the iteration diverges under force control.
TEST(ConstantStiffness, OnTheHyperbola)
{
  PathOptions constant;
  constant.iteration   = PathOptions::Iteration::constant_stiffness;
  const Maker law      = [] { return std::make_unique<HyperbolicLaw>(1., 1.); };
  const auto weight    = [](const double w) { return w / (1. - w); };
  const BlockRun paper = run_block(law, linear, {{0., 0., 0.}, {0., -weight(0.28), 0.}}, constant);
  EXPECT_NEAR(paper.jumps[0][0], -0.28, 1e-10);
  EXPECT_THROW(run_block(law, linear, {{0., 0., 0.}, {0., -weight(0.31), 0.}}, constant),
               NumericalFailure);
}
