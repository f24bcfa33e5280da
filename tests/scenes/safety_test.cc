// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/scene_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  const std::vector<std::string> both = {"Safety/Strength reduction=yes",
                                         "Safety/Load factor=water"};

  const std::vector<std::string> reduction_only = {"Safety/Strength reduction=yes"};

  std::vector<std::string>
  with(std::vector<std::string> first, const std::vector<std::string> &more)
  {
    first.insert(first.end(), more.begin(), more.end());
    return first;
  }

  nlohmann::json
  safety(const SceneRun &run, const std::string &method)
  {
    return run.summary.at("safety").at(method);
  }
} // namespace

// A block on an elastic foundation under its weight N and water T (scene G, with and without
// opening before the end; many elements slip at the start of the search). Its plane base is lost by
// sliding, so that equilibrium alone gives both factors: f N/T. The resultants of level t = 2 are
// given by the loads. Tolerance: rounding of the condensed forces, 1e-13 of them.
TEST(Safety, SlidingBlockOnAFoundation)
{
  for (const auto &[file, f] : {std::pair("scene_g_f02.prm", 0.2), {"scene_g_f06.prm", 0.6}})
    {
      SCOPED_TRACE(file);
      const SceneRun run = run_scene(parameter_path(file), both);
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_EQ(run.summary.at("verdict"), "done");
      EXPECT_EQ(run.summary.at("t"), 2.);
      const double expected =
        f * std::abs(run.resultant("N", 2.)) / std::abs(run.resultant("T", 2.));
      for (const char *method : {"strength_reduction", "load_factor"})
        {
          const nlohmann::json found = safety(run, method);
          EXPECT_NEAR(found.at("factor").get<double>(), expected, 1e-11);
          EXPECT_EQ(found.at("verdict"), "limit load");
          EXPECT_EQ(found.at("mechanism"), "sliding");
          EXPECT_EQ(found.at("mechanism_joints"), nlohmann::json({"base"}));
        }
      EXPECT_EQ(safety(run, "strength_reduction").at("joints"), nlohmann::json({"base"}));
      EXPECT_EQ(safety(run, "load_factor").at("loads"), nlohmann::json({"water"}));
      EXPECT_LE(run.certificate(), 1e-10);

      // Both searches begin with the state at t = 2, and have stages, events and a last state of
      // their own, in which every closed element slides.
      double last = 0.;
      for (std::size_t r = 0; r < run.events.rows.size(); ++r)
        {
          const double t = run.events.number(r, "t");
          EXPECT_GE(t, last);
          last = t;
          if (t > 2.)
            {
              EXPECT_EQ(run.events.text(r, "stage"), t < 3. ? "strength reduction" : "load factor");
            }
        }
      EXPECT_EQ(run.last_t(), safety(run, "load_factor").at("t"));
      for (const char *method : {"strength_reduction", "load_factor"})
        {
          const double t = safety(run, method).at("t");
          EXPECT_EQ(run.count("stick", t), 0u);
          EXPECT_NEAR(
            run.resultant("T", t) / run.resultant("T", 2.), *method == 's' ? 1. : expected, 1e-11);
        }
    }
}

// Each search alone gives the factor that both together give; without any nothing is said and
// nothing computed besides.
TEST(Safety, SearchesDoNotDisturbEachOther)
{
  const std::string file   = parameter_path("scene_g_f06.prm");
  const SceneRun together  = run_scene(file, both);
  const SceneRun reduction = run_scene(file, {"Safety/Strength reduction=yes"});
  const SceneRun loads     = run_scene(file, {"Safety/Load factor=water"});
  const SceneRun none      = run_scene(file);
  EXPECT_EQ(safety(together, "strength_reduction"), safety(reduction, "strength_reduction"));
  EXPECT_EQ(safety(together, "load_factor").at("factor"),
            safety(loads, "load_factor").at("factor"));
  EXPECT_FALSE(safety(reduction, "strength_reduction").is_null());
  EXPECT_FALSE(reduction.summary.at("safety").contains("load_factor"));
  EXPECT_FALSE(none.summary.contains("safety"));
  EXPECT_EQ(none.last_t(), 2.);
  for (std::size_t r = 0; r < none.events.rows.size(); ++r)
    EXPECT_EQ(none.events.rows[r], together.events.rows[r]);
}

// Equilibrium does not ask for the stiffness of the layer: f N/T also with a larger friction, with
// a nonlinear normal layer, or where the shear stiffness grows with the closure. Tolerance: of the
// iterations.
TEST(Safety, NonlinearLayers)
{
  const std::string file = parameter_path("scene_g_f06.prm");
  for (const auto &[f, changes] :
       {std::pair<double, std::vector<std::string>>{0.9, {"Joints/base/Friction coefficient=0.9"}},
        {0.6, {"Joints/base/Normal law=cubic root", "Joints/base/Thickness=0.01"}},
        {0.6,
         {"Joints/base/Shear stiffness grows with=closure",
          "Joints/base/Shear growth closure=0.05",
          "Joints/base/Shear growth exponent=0.5"}}})
    {
      SCOPED_TRACE(changes.front());
      const SceneRun run = run_scene(file, with(reduction_only, changes));
      EXPECT_LE(run.certificate(), 1e-9) << run.summary.at("certificate").dump(1);
      const nlohmann::json found = safety(run, "strength_reduction");
      EXPECT_EQ(found.at("verdict"), "limit load");
      EXPECT_NEAR(found.at("factor").get<double>(),
                  f * std::abs(run.resultant("N", 2.) / run.resultant("T", 2.)),
                  1e-9);
    }
}

// Cohesion is lost where the lips part, before or during the search, and reduced elsewhere: with
// the area A of the elements that never opened the factor is (c A + f N)/T.
TEST(Safety, CohesionThatIsLostByOpening)
{
  constexpr double c = 50.;
  const SceneRun run = run_scene(parameter_path("scene_g_f06.prm"),
                                 with(reduction_only, {fmt::format("Joints/base/Cohesion={}", c)}));
  EXPECT_LE(run.certificate(), 1e-9);
  std::set<double> opened;
  for (std::size_t r = 0; r < run.events.rows.size(); ++r)
    if (run.events.text(r, "to") == "open")
      opened.insert(run.events.number(r, "element"));
  double A = 0.;
  for (std::size_t r = 0; r < run.history.rows.size(); ++r)
    if (run.history.number(r, "t") == 2. && opened.count(run.history.number(r, "element")) == 0)
      A += run.history.number(r, "area");
  EXPECT_FALSE(opened.empty());
  EXPECT_NEAR(safety(run, "strength_reduction").at("factor").get<double>(),
              (c * A + 0.6 * std::abs(run.resultant("N", 2.))) / std::abs(run.resultant("T", 2.)),
              1e-10);
}

// Friction that falls from f to f_r at the first slip, a bond that breaks there: the last elements
// hold with their whole strength what the others have given up, so that the factor lies between
// those of residual and of peak strength.
TEST(Safety, StrengthThatIsLostBySlip)
{
  const SceneRun run =
    run_scene(parameter_path("scene_g_f06.prm"),
              with(reduction_only, {"Joints/base/Residual friction coefficient=0.5"}));
  EXPECT_LE(run.certificate(), 1e-9);
  const double ratio  = std::abs(run.resultant("N", 2.) / run.resultant("T", 2.));
  const double factor = safety(run, "strength_reduction").at("factor");
  EXPECT_GT(factor, 0.5 * ratio);
  EXPECT_LT(factor, 0.6 * ratio);
}

// Nothing is lost without a load along the joint, and the search ends at the largest factor.
TEST(Safety, LargestFactor)
{
  const SceneRun run =
    run_scene(parameter_path("scene_g_f06.prm"),
              with(reduction_only, {"Loads/water/Value=0", "Safety/Largest factor=7"}));
  EXPECT_EQ(run.exit_code, 0);
  const nlohmann::json found = safety(run, "strength_reduction");
  EXPECT_TRUE(found.at("factor").is_null());
  EXPECT_EQ(found.at("verdict"), "largest factor reached");
  EXPECT_NEAR(found.at("factor_at_least").get<double>(), 7., 1e-12);
}

// Loads that are not carried have no factor of safety.
TEST(Safety, NotWithoutEquilibrium)
{
  const SceneRun run =
    run_scene(parameter_path("scene_g_f06.prm"), with(both, {"Stages/water/Loads=water: 2*t"}));
  EXPECT_EQ(run.exit_code, 3);
  for (const char *method : {"strength_reduction", "load_factor"})
    {
      EXPECT_TRUE(safety(run, method).at("factor").is_null());
      EXPECT_EQ(safety(run, method).at("verdict"), "not computed");
    }
}
