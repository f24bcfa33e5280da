// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/mesh_variants.h"
#include "scenes/scene_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  // A dam on a rigid plane: base -4 <= x <= 4, height 10, upstream face x = -4 + 0.1 y, crest to
  // x = -1, downstream face straight. Units kN, m.
  constexpr double height = 10., slope = 0.1, concrete = 24., water = 9.81;
  constexpr int n_x = 8, n_y = 7;

  double
  upstream(const double y)
  {
    return -4. + slope * y;
  }

  double
  downstream(const double y)
  {
    return 4. - 0.5 * y;
  }

  std::string
  dam_mesh()
  {
    GmshMesh mesh;
    mesh.dimension      = 2;
    mesh.physical_names = {
      {{2, 1}, "dam"}, {{1, 2}, "base"}, {{1, 3}, "crest"}, {{1, 4}, "upstream"}, {{1, 5}, "air"}};
    const auto vertex = [](const int i, const int j) {
      return static_cast<unsigned int>(i + (n_x + 1) * j);
    };
    for (int j = 0; j <= n_y; ++j)
      for (int i = 0; i <= n_x; ++i)
        {
          const double y = height * j / n_y, s = double(i) / n_x;
          mesh.vertices.push_back({{(1. - s) * upstream(y) + s * downstream(y), y, 0.}});
        }
    for (int j = 0; j < n_y; ++j)
      {
        mesh.faces.push_back({CellShape::line, {{vertex(0, j), vertex(0, j + 1)}}, 4});
        mesh.faces.push_back({CellShape::line, {{vertex(n_x, j), vertex(n_x, j + 1)}}, 5});
        for (int i = 0; i < n_x; ++i)
          mesh.cells.push_back(
            {CellShape::quadrilateral,
             {{vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)}},
             1});
      }
    for (int i = 0; i < n_x; ++i)
      {
        mesh.faces.push_back({CellShape::line, {{vertex(i, 0), vertex(i + 1, 0)}}, 2});
        mesh.faces.push_back({CellShape::line, {{vertex(i, n_y), vertex(i + 1, n_y)}}, 3});
      }
    return write_mesh(mesh);
  }

  /** Weight in the first stage, then @p second. @p loads: subsections of Loads. */
  SceneRun
  run_dam(const std::string &loads,
          const std::string &second,
          const unsigned int levels,
          const double friction = 0.7)
  {
    const std::string name = temporary_directory() + "/dam.prm";
    std::ofstream(name) << "subsection Mesh\nset File = " << dam_mesh()
                        << "\nend\nsubsection Bodies\nsubsection dam\nset Young modulus = 3e7\n"
                           "set Poisson ratio = 0.2\nset Weight density = "
                        << concrete
                        << "\nset Thermal expansion = 1e-5\nend\nend\nsubsection Joints\n"
                           "subsection base\nset Plus lip = base\nset Minus lip = rigid\n"
                           "set Normal stiffness = 1e6\nset Shear stiffness = 5e5\n"
                           "set Friction coefficient = "
                        << friction
                        << "\nend\nend\nsubsection Boundaries\n"
                           "subsection crest\nset Fixed = free\nend\n"
                           "subsection air\nset Fixed = free\nend\n"
                        << (loads.find("upstream") == std::string::npos
                              ? "subsection upstream\nset Fixed = free\nend\n"
                              : "")
                        << "end\nsubsection Loads\nsubsection weight\nset Type = weight\nend\n"
                        << loads
                        << "end\nsubsection Stages\nsubsection weight\nset Loads = weight: t\nend\n"
                           "subsection second\nset Loads = "
                        << second << "\nset Levels = " << levels << "\nend\nend\n";
    return run_scene(name);
  }

  /** Force and moment about the origin. */
  struct Resultant
  {
    double x = 0., y = 0., moment = 0.;
  };

  /** Area times density, and centroid, of the trapezoid by its two triangles. */
  Resultant
  weight_of_dam(const double k_x, const double k_y)
  {
    const double a[2] = {-4., 0.}, b[2] = {4., 0.}, c[2] = {-1., height}, d[2] = {-3., height};
    Resultant sum;
    for (const auto &[p, q, r] : {std::tuple(a, b, c), {a, c, d}})
      {
        const double W =
          concrete / 2. * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
        const double x = (p[0] + q[0] + r[0]) / 3., y = (p[1] + q[1] + r[1]) / 3.;
        sum.x += k_x * W;
        sum.y += k_y * W;
        sum.moment += x * k_y * W - y * k_x * W;
      }
    return sum;
  }

  /** Still water: dF = γ(h-y)(1, -slope) dy at (-4 + slope y, y). */
  Resultant
  water_force(const double h)
  {
    const double force = water * h * h / 2., first_moment = water * h * h * h / 6.;
    return {force, -slope * force, 4. * slope * force - (1. + slope * slope) * first_moment};
  }

  /** N, T and M of the joint against loads by equilibrium, see doc/notation.md. */
  void
  expect_equilibrium(const SceneRun &run, const double t, const Resultant &a, const Resultant &b)
  {
    const double tolerance = 1e-10 * concrete * 80.; // of the weight, and of 1 m times the weight
    EXPECT_NEAR(run.resultant("N", t), a.y + b.y, tolerance) << t;
    EXPECT_NEAR(run.resultant("T", t), a.x + b.x, tolerance) << t;
    EXPECT_NEAR(run.resultant("M", t), -(a.moment + b.moment), tolerance) << t;
  }

  const std::string rising = "subsection water\nset Type = hydrostatic\n"
                             "set Boundaries = upstream\nset Level = 1: 0; 2: 10\n"
                             "set Unit weight = 9.81\nend\n";
} // namespace

// Equilibrium of the block, whatever opens or slips. All levels are knots (every second of 20).
TEST(Dam, RisingWater)
{
  const SceneRun run = run_dam(rising, "water: 1", 10);
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9) << run.summary.at("certificate").dump(1);
  const Resultant weight = weight_of_dam(0., -1.);
  expect_equilibrium(run, 1., weight, {});
  for (unsigned int i = 1; i <= 10; ++i)
    expect_equilibrium(run, 1. + i / 10., weight, water_force(i));
}

// Levels are only places where results are written; what happens in between is the same. The water
// needs a mean friction of 490/1151 = 0.426 (see above): at 0.45 parts of the base slip.
TEST(Dam, LevelsDoNotMatter)
{
  const SceneRun one  = run_dam(rising, "water: 1", 1, 0.45);
  const SceneRun many = run_dam(rising, "water: 1", 97, 0.45);
  EXPECT_EQ(one.events.rows.size(), many.events.rows.size());
  for (const std::string quantity : {"N", "T1", "jump_n", "jump_t1", "slip1"})
    EXPECT_LE(deviation(one.values(quantity, 2.), many.values(quantity, 2.)), 1e-10) << quantity;
  EXPECT_EQ(one.states(2.), many.states(2.));
  EXPECT_GT(one.count("open", 2.) + one.count("slip", 2.), 0u) << "nothing happened";
}

// Body forces k times the weight, on the weight.
TEST(Dam, Earthquake)
{
  const SceneRun run = run_dam("subsection shaking\nset Type = seismic\n"
                               "set Horizontal coefficient = 0.15\nset Vertical coefficient = 0.1\n"
                               "end\n",
                               "shaking: t",
                               2);
  EXPECT_EQ(run.exit_code, 0);
  for (const double k : {0.5, 1.})
    expect_equilibrium(run, 1. + k, weight_of_dam(0., -1.), weight_of_dam(0.15 * k, 0.1 * k));
}

// A change of temperature is in equilibrium with itself.
TEST(Dam, Temperature)
{
  const SceneRun run =
    run_dam("subsection warm\nset Type = temperature\nset Value = 30\nend\n", "warm: t", 1);
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9) << run.summary.at("certificate").dump(1);
  expect_equilibrium(run, 2., weight_of_dam(0., -1.), {});
}
