// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "known_answer.h"
#include "scenes/scene_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace fuga;
using namespace fuga::tests;
using nlohmann::json;

namespace
{
  /** The mesh with n contact nodes: from the repository, or made now. */
  std::string
  scene_g_mesh(const int n)
  {
    const std::string meshes = std::string(FUGA_SOURCE_DIR) + "/meshes/";
    if (n <= 129)
      return fmt::format("{}scene_g_{}.msh", meshes, n);
    static std::map<int, std::string> made;
    if (made.count(n) == 0)
      {
        made[n] = temporary_directory() + "/mesh.msh";
        const std::string command =
          fmt::format("/usr/bin/python3 {}scene_g.py {} {} > /dev/null", meshes, n, made[n]);
        if (std::system(command.c_str()) != 0)
          throw std::runtime_error(command);
      }
    return made[n];
  }

  /** Overrides that turn scene_g_f02.prm into a case of reference/README.md. */
  std::vector<std::string>
  scene_g(const int n, const double f, const double last_factor, const json &law)
  {
    std::vector<std::string> sets = {
      "Mesh/File=" + scene_g_mesh(n),
      fmt::format("Joints/base/Friction coefficient={}", f),
      fmt::format("Stages/water/Loads=water: {}*t", last_factor),
      "Stages/water/Levels=1",
    };
    const auto joint = [&](const std::string &entry, const std::string &value) {
      sets.push_back("Joints/base/" + entry + "=" + value);
    };
    if (law.is_null())
      {
        joint("Normal stiffness", "");
        joint("Shear stiffness", "");
        joint("Normal law", "rigid");
        joint("Shear law", "rigid");
        return sets;
      }
    joint("Shear stiffness", fmt::format("{}", law.at("Ct").get<double>()));
    if (law.contains("Cn"))
      joint("Normal stiffness", fmt::format("{}", law.at("Cn").get<double>()));
    else
      {
        joint("Normal stiffness", "");
        joint("Normal law", "cubic root");
        joint("Normal compliance", fmt::format("{}", law.at("rho0").get<double>()));
        joint("Thickness", fmt::format("{}", law.at("zeta0").get<double>()));
      }
    return sets;
  }

  class SceneG : public testing::TestWithParam<const char *>
  {
  };

  /** (x, λ, to) of all events of stage 2, by λ and x. The λ of one list may tie. */
  struct Event
  {
    double lambda, x;
    std::string to;
  };

  std::vector<Event>
  reference_events(const json &list, const json &x)
  {
    std::vector<Event> result;
    for (const json &event : list)
      for (const json &change : event.at(2))
        result.push_back({event.at(1).get<double>(),
                          x.at(change.at(0).get<std::size_t>()).get<double>(),
                          change.at(1).get<std::string>()});
    return result;
  }

  // Without what happens at the very start of a stage, which the reference does not list.
  std::vector<Event>
  run_events(const SceneRun &run, const double last_factor)
  {
    std::vector<Event> result;
    for (std::size_t r = 0; r < run.events.rows.size(); ++r)
      if (run.events.number(r, "t") > 1.)
        result.push_back({(run.events.number(r, "t") - 1.) * last_factor,
                          run.events.number(r, "x"),
                          run.events.text(r, "to")});
    return result;
  }

  void
  expect_equal(const std::vector<Event> &found,
               const std::vector<Event> &expected,
               const double tolerance)
  {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      {
        EXPECT_NEAR(found[i].lambda, expected[i].lambda, tolerance) << i;
        EXPECT_NEAR(found[i].x, expected[i].x, 1e-9) << i;
        EXPECT_EQ(found[i].to, expected[i].to) << i;
      }
  }
} // namespace

// V12, all cases of reference/: states, jumps, slips and forces at the end of both stages, relative
// to the largest of their kind, and every event with its load, its place and its new state. The
// reference states a residual of 2e-11 (n = 513: 4e-10, to be compared to 1e-6): the bound 1e-8
// leaves two to three digits for the condition of the problem.
TEST_P(SceneG, EqualsTheReference)
{
  const json reference =
    json::parse(file_text(std::string(FUGA_SOURCE_DIR) + "/tests/scenes/reference/" + GetParam()));
  const int n           = reference.at("n").get<int>();
  const double last     = reference.at("L").get<double>();
  const double relative = n > 129 ? 1e-6 : 1e-8;
  const SceneRun run    = run_scene(
    "scene_g_f02.prm", scene_g(n, reference.at("f").get<double>(), last, reference.at("law")));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9);

  const char *const names[6] = {"open", "stick", "slip", "slip"};
  for (unsigned int stage = 0; stage < 2; ++stage)
    {
      SCOPED_TRACE(fmt::format("stage {}", stage + 1));
      const json &end    = reference.at("stages").at(stage);
      const double t     = stage + 1.;
      const auto compare = [&](const char *ours, const char *theirs, const double sign) {
        expect_answer(
          {"V12 scene G",
           fmt::format("{}, end of stage {}: largest deviation of {}", GetParam(), stage + 1, ours),
           0.,
           "reference solution"},
          deviation(run.values(ours, t), end.at(theirs).get<Vector>(), sign),
          relative);
      };
      compare("jump_n", "g_n", 1.);
      compare("jump_t1", "g_t", 1.);
      compare("N", "N", -1.);
      compare("T1", "T", -1.);
      compare("slip1", "slip", 1.);
      const auto states = run.states(t);
      const Vector T    = run.values("T1", t);
      ASSERT_EQ(states.size(), static_cast<std::size_t>(n));
      for (std::size_t k = 0; k < states.size(); ++k)
        {
          const int code = end.at("state").at(k).get<int>();
          EXPECT_EQ(states[k], names[code]) << k;
          if (code >= 2)
            {
              EXPECT_EQ(T[k] < 0., code == 2) << k;
            }
        }
    }

  expect_equal(
    run_events(run, last), reference_events(reference.at("events"), reference.at("x")), relative);
}

// V12, all events up to the limit load of sliding, and the limit itself. The last event is
// the loss of equilibrium: its element goes where the mechanism moves it. Bound: as above;
// the reference's own limit is 4e-11 off the exact one for n = 129.
TEST_P(SceneG, EventsUpToTheLimit)
{
  const json reference =
    json::parse(file_text(std::string(FUGA_SOURCE_DIR) + "/tests/scenes/reference/" + GetParam()));
  if (!reference.contains("limit_events"))
    GTEST_SKIP();
  const double f = reference.at("f").get<double>(), factor = f < 0.5 ? 1. : 2.;
  const SceneRun run = run_scene(
    "scene_g_f02.prm", scene_g(reference.at("n").get<int>(), f, factor, reference.at("law")));
  const auto expected = reference_events(reference.at("limit_events"), reference.at("x"));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NEAR((run.summary.at("t").get<double>() - 1.) * factor, expected.back().lambda, 1e-8);
  expect_equal(run_events(run, factor), expected, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Cases,
                         SceneG,
                         testing::Values("lin_f0.2_n9.json",
                                         "lin_f0.6_n33.json",
                                         "lin_f0.6_n129.json",
                                         "lin_f0.2_n513.json",
                                         "lin_f0.6_n513.json",
                                         "nlsec_f0.2_n9.json",
                                         "nlsec_f0.6_n33.json",
                                         "rigid_f0.2_n9.json",
                                         "rigid_f0.6_n33.json",
                                         "stiff1e10_f0.6_n9.json"),
                         [](const testing::TestParamInfo<const char *> &parameter) {
                           std::string name = parameter.param;
                           name.resize(name.rfind('.'));
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

// Limit of sliding, by hand: λ·9.81·40²/2 = f·24·20·40, λ = f·19200/7848, for any mesh and any
// layer. 1e-9: an event load is one division away from forces known to about 1e-13.
TEST(SceneGLimits, SlidingLimit)
{
  const json layers[] = {{{"Cn", 1e6}, {"Ct", 5e5}}, nullptr};
  for (const auto &[f, factor] : {std::pair(0.2, 1.), std::pair(0.6, 2.)})
    for (const int n : {9, 33})
      for (const json &law : layers)
        {
          SCOPED_TRACE(fmt::format("f = {}, n = {}, {}", f, n, law.dump()));
          const SceneRun run = run_scene("scene_g_f02.prm", scene_g(n, f, factor, law));
          const double exact = f * 19200. / 7848.;
          EXPECT_EQ(run.exit_code, 3);
          EXPECT_EQ(run.summary.at("verdict"), "limit load");
          ASSERT_TRUE(run.summary.contains("limit_load"));
          const json &limit = run.summary.at("limit_load");
          EXPECT_EQ(limit.at("mechanism"), "sliding");
          EXPECT_EQ(limit.at("stage"), "water");
          expect_answer(
            {"V12 scene G",
             fmt::format(
               "sliding limit, f = {}, n = {}, {}", f, n, law.is_null() ? "rigid" : "compliant"),
             exact,
             "equilibrium"},
            limit.at("load_factors").at("water").get<double>(),
            1e-9);
          EXPECT_NEAR(exact, f == 0.2 ? 0.48929663608563 : 1.46788990825688, 5e-15);
          EXPECT_LE(run.certificate(), 1e-9);
          // The last state in equilibrium is written like a level.
          EXPECT_NEAR((run.last_t() - 1.) * factor, exact, 1e-9);
          // Every closed element is at its strength there.
          const Vector N = run.values("N", run.last_t()), T = run.values("T1", run.last_t());
          for (std::size_t k = 0; k < N.size(); ++k)
            EXPECT_NEAR(std::abs(T[k]), f * std::abs(N[k]), 1e-9 * 19200.) << k;
        }
}

// The limit λ = 1.834862385 of overturning (λ·9.81·40³/6 = 19200·10) at f = 1: the
// discrete block topples about its last node, at x = 20. Tolerance as above, but nine digits given.
TEST(SceneGLimits, OverturningLimit)
{
  const SceneRun run = run_scene("scene_g_f02.prm", scene_g(9, 1., 2., {{"Cn", 1e6}, {"Ct", 5e5}}));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(run.summary.at("limit_load").at("mechanism"), "overturning");
  EXPECT_NEAR(run.summary.at("limit_load").at("load_factors").at("water").get<double>(),
              19200. * 10. / (9.81 * 64000. / 6.),
              1e-9);
}
