// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "known_answer.h"
#include "scenes/mesh_variants.h"
#include "scenes/scene_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  constexpr int n         = 8; // elements of the base b = 1, -1/2 <= x <= 1/2
  constexpr double height = 2.;

  /** Squares of 1/8. */
  std::string
  block_mesh()
  {
    GmshMesh mesh;
    mesh.dimension      = 2;
    mesh.physical_names = {{{2, 1}, "block"}, {{1, 2}, "base"}, {{1, 3}, "top"}, {{1, 4}, "sides"}};
    const int n_y       = static_cast<int>(height * n);
    const auto vertex   = [](const int i, const int j) {
      return static_cast<unsigned int>(i + (n + 1) * j);
    };
    for (int j = 0; j <= n_y; ++j)
      for (int i = 0; i <= n; ++i)
        mesh.vertices.push_back({{double(i) / n - 0.5, double(j) / n, 0.}});
    for (int j = 0; j < n_y; ++j)
      for (const int i : {0, n})
        mesh.faces.push_back({CellShape::line, {{vertex(i, j), vertex(i, j + 1)}}, 4});
    for (int i = 0; i < n; ++i)
      {
        for (int j = 0; j < n_y; ++j)
          mesh.cells.push_back(
            {CellShape::quadrilateral,
             {{vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)}},
             1});
        mesh.faces.push_back({CellShape::line, {{vertex(i, 0), vertex(i + 1, 0)}}, 2});
        mesh.faces.push_back({CellShape::line, {{vertex(i, n_y), vertex(i + 1, n_y)}}, 3});
      }
    return write_mesh(mesh);
  }

  /** The nearly rigid block on a soft joint above a rigid plane. @p loads: subsections of Loads. */
  SceneRun
  run_block(const double stiff,
            const double f,
            const std::string &loads,
            const std::string &first,
            const std::string &second,
            const std::vector<std::string> &overrides = {})
  {
    const std::string name = temporary_directory() + "/block.prm";
    std::ofstream(name) << "subsection Mesh\nset File = " << block_mesh()
                        << "\nend\nsubsection Bodies\nsubsection block\nset Young modulus = "
                        << fmt::format("{}", stiff)
                        << "\nset Poisson ratio = 0\nset Weight density = 0.5\nend\nend\n"
                           "subsection Joints\nsubsection base\nset Plus lip = base\n"
                           "set Minus lip = rigid\nset Normal stiffness = 1\n"
                           "set Shear stiffness = 1\nset Friction coefficient = "
                        << fmt::format("{}", f)
                        << "\nend\nend\nsubsection Boundaries\n"
                           "subsection sides\nset Fixed = free\nend\n"
                        << (loads.find("= top") == std::string::npos
                              ? "subsection top\nset Fixed = free\nend\n"
                              : "")
                        << "end\nsubsection Loads\n"
                        << loads
                        << "end\nsubsection Stages\nsubsection first\nset Loads = " << first
                        << ": t\nend\nsubsection second\nset Loads = " << second << "\nend\nend\n";
    return run_scene(name, overrides);
  }

  std::vector<double>
  openings(const SceneRun &run)
  {
    std::vector<double> result;
    for (std::size_t r = 0; r < run.events.rows.size(); ++r)
      if (run.events.text(r, "to") == "open")
        result.push_back(run.events.number(r, "t") - 1.);
    return result;
  }

  /** E/(k_n b). The flexibility of the block moves events by a share of k_n h/E. */
  class RigidBlock : public testing::TestWithParam<double>
  {
  protected:
    static double
    tolerance()
    {
      return 1e-9 + height / GetParam();
    }
  };
} // namespace

// V3 through finite elements: N = 1 at an eccentricity e that grows to 0.6 b. Nine bars open at the
// listed e/b (exact for a rigid block, nine digits), overturning at e = b/2, exact by equilibrium.
// Tolerance: the digits given (limits: 1e-9 as well) and the flexibility of the block.
TEST_P(RigidBlock, EccentricLoad)
{
  const SceneRun run = run_block(GetParam(),
                                 0.5,
                                 "subsection press\nset Type = pressure\nset Boundaries = top\n"
                                 "set Value = 1\nend\n"
                                 "subsection turn\nset Type = pressure\nset Boundaries = top\n"
                                 "set Value = 12*x\nend\n",
                                 "press",
                                 "turn: 0.6*t");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_LE(run.certificate(), 1e-9) << run.summary.at("certificate").dump(1);
  const double expected[] = {0.171875, 0.214285714, 0.256944444, 0.3, 0.34375, 0.388888889, 0.4375};
  const auto found        = openings(run);
  ASSERT_GE(found.size(), 7u);
  for (unsigned int i = 0; i < 7; ++i)
    expect_answer(
      {"V3 rigid block, eccentric load",
       fmt::format("finite elements, E = {:g} k_n b: e/b of opening {}", GetParam(), i + 1),
       expected[i],
       "closed form"},
      0.6 * found[i],
      tolerance());
  ASSERT_TRUE(run.summary.contains("limit_load"));
  EXPECT_EQ(run.summary.at("limit_load").at("mechanism"), "overturning");
  EXPECT_NEAR(run.summary.at("limit_load").at("load_factors").at("turn").get<double>(), 0.5, 1e-9);
}

// V3 on an incline: weight 1 and a horizontal share tan α of it at mid-height. First opening at
// tan α = b(1 + 2/n²)/(3h), toppling at b/h = 1/2, sliding at f; f = b/h is a double event, whose
// mechanism is not determined. Limits follow from equilibrium, whatever E: 1e-9.
// E ≥ 1e5 k_n b: very soft joints near collapse, where a rigid rotation loses the last digits.
TEST_P(RigidBlock, OnAnIncline)
{
  const std::string loads = "subsection down\nset Type = weight\nset Value = 0; -1\nend\n"
                            "subsection along\nset Type = weight\nset Value = 1; 0\nend\n";
  for (const auto &[f, limit, mechanism] :
       {std::tuple(0.3, 0.3, "sliding"), {0.8, 0.5, "overturning"}, {0.5, 0.5, ""}})
    {
      SCOPED_TRACE(fmt::format("f = {}", f));
      const SceneRun run = run_block(GetParam(), f, loads, "down", "along: t");
      EXPECT_EQ(run.exit_code, 3);
      EXPECT_LE(run.certificate(), 1e-9) << run.summary.at("certificate").dump(1);
      const auto found = openings(run);
      ASSERT_FALSE(found.empty());
      EXPECT_NEAR(found[0], (1. + 2. / 64.) / (3. * height), tolerance());
      ASSERT_TRUE(run.summary.contains("limit_load"));
      const auto &result = run.summary.at("limit_load");
      expect_answer(
        {"V3 rigid block on an incline",
         fmt::format("finite elements, E = {:g} k_n b, f = {}: tan α at the limit", GetParam(), f),
         limit,
         "equilibrium"},
        result.at("load_factors").at("along").get<double>(),
        1e-9);
      if (*mechanism != '\0')
        {
          EXPECT_EQ(result.at("mechanism"), mechanism);
        }
    }
}

// Factors of safety on an incline. Strength reduction: (f + c b/N)/tan α by sliding, whatever slips
// or has opened before (cohesion: below the first opening, where bonds would be lost); load factor
// of the share along the base: sliding as well, or toppling at tan α = b/h. By equilibrium, exact.
TEST_P(RigidBlock, SafetyOnAnIncline)
{
  const std::string loads = "subsection down\nset Type = weight\nset Value = 0; -1\nend\n"
                            "subsection along\nset Type = weight\nset Value = 1; 0\nend\n";
  for (const auto &[f, c, slope, share, mechanism] : {std::tuple(0.3, 0., 0.2, 0.3, "sliding"),
                                                      {0.21, 0., 0.2, 0.21, "sliding"},
                                                      {0.3, 0.1, 0.15, 0., ""},
                                                      {0.8, 0., 0.2, 0.5, "overturning"}})
    {
      SCOPED_TRACE(fmt::format("f = {}, c = {}", f, c));
      const SceneRun run = run_block(GetParam(),
                                     f,
                                     loads,
                                     "down",
                                     fmt::format("along: {}*t", slope),
                                     {"Safety/Strength reduction=yes",
                                      "Safety/Load factor=along",
                                      fmt::format("Joints/base/Cohesion={}", c)});
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_LE(run.certificate(), 1e-9) << run.summary.at("certificate").dump(1);
      const auto &reduction = run.summary.at("safety").at("strength_reduction");
      EXPECT_NEAR(reduction.at("factor").get<double>(), (f + c) / slope, 1e-12);
      EXPECT_EQ(reduction.at("mechanism"), "sliding");
      if (*mechanism == '\0')
        continue;
      const auto &load_factor = run.summary.at("safety").at("load_factor");
      EXPECT_NEAR(load_factor.at("factor").get<double>(), share / slope, 1e-9);
      EXPECT_EQ(load_factor.at("mechanism"), mechanism);
    }
}

INSTANTIATE_TEST_SUITE_P(Stiffness, RigidBlock, testing::Values(1e3, 1e4, 1e5, 1e6, 1e9));
