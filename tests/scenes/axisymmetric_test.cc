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
  // Lengths in contact radii a. The body is 30 wide and high, elements near the contact are 1/16.
  constexpr int n_fine = 24, n_coarse = 18;
  constexpr double fine = 1. / 16., extent = 30.;

  /** Even up to 1.5, then growing to the extent. */
  double
  coordinate(const int i)
  {
    if (i <= n_fine)
      return fine * i;
    const double s = double(i - n_fine) / n_coarse;
    return fine * n_fine * std::pow(extent / (fine * n_fine), s);
  }

  std::string
  quarter_mesh()
  {
    constexpr int n = n_fine + n_coarse;
    GmshMesh mesh;
    mesh.dimension      = 2;
    mesh.physical_names = {
      {{2, 1}, "body"}, {{1, 2}, "base"}, {{1, 3}, "top"}, {{1, 4}, "axis"}, {{1, 5}, "rim"}};
    const auto vertex = [](const int i, const int j) {
      return static_cast<unsigned int>(i + (n + 1) * j);
    };
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        mesh.vertices.push_back({{coordinate(i), coordinate(j), 0.}});
    for (int j = 0; j < n; ++j)
      {
        mesh.faces.push_back({CellShape::line, {{vertex(j, 0), vertex(j + 1, 0)}}, 2});
        mesh.faces.push_back({CellShape::line, {{vertex(j, n), vertex(j + 1, n)}}, 3});
        mesh.faces.push_back({CellShape::line, {{vertex(0, j), vertex(0, j + 1)}}, 4});
        mesh.faces.push_back({CellShape::line, {{vertex(n, j), vertex(n, j + 1)}}, 5});
        for (int i = 0; i < n; ++i)
          mesh.cells.push_back(
            {CellShape::quadrilateral,
             {{vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)}},
             1});
      }
    return write_mesh(mesh);
  }

  class Hertz : public testing::TestWithParam<unsigned int>
  {
  };
} // namespace

// Sphere on a rigid plane without friction: a³ = 3PR/(4E*), p = p0 √(1 - r²/a²), p0 = 3P/(2πa²) (K.
// L. Johnson, Contact Mechanics, 1985, eq. 4.22 to 4.24), with R from a = 1. The curvature is the
// initial gap, less a constant such that the body stands: for degree 2 there is no element on the
// axis, the first one is at 1/32. Tolerances: the edge of the contact lies within an element
// (1/16), pressures inside have the error of the interpolated gap and of the finite body, (a/30)²
// and 1/16² times a few.
TEST_P(Hertz, Sphere)
{
  const double E = 1000., nu = 0.3, R = 20., E_star = E / (1. - nu * nu);
  const double P = 4. * E_star / (3. * R), p0 = 3. * P / (2. * M_PI);
  const std::string name = temporary_directory() + "/sphere.prm";
  std::ofstream(name) << "subsection Mesh\nset File = " << quarter_mesh()
                      << "\nset Assumption = axisymmetric\nset Polynomial degree = " << GetParam()
                      << "\nend\nsubsection Bodies\nsubsection body\nset Young modulus = 1000\n"
                         "set Poisson ratio = 0.3\nend\nend\nsubsection Joints\nsubsection base\n"
                         "set Plus lip = base\nset Minus lip = rigid\nset Normal law = rigid\n"
                         "set Initial gap = max(x^2 - "
                      << (GetParam() == 1 ? "0" : "1/1024")
                      << ", 0)/40\nend\nend\n"
                         "subsection Boundaries\nsubsection axis\nset Fixed = x\nend\n"
                         "subsection rim\nset Fixed = free\nend\nend\n"
                         "subsection Loads\nsubsection press\nset Type = pressure\n"
                         "set Boundaries = top\nset Value = "
                      << fmt::format("{:.17g}", P / (M_PI * extent * extent))
                      << "\nend\nend\nsubsection Stages\nsubsection press\nset Loads = press: t\n"
                         "end\nend\nsubsection Output\nset Fields = end\nend\n";
  const SceneRun run = run_scene(name);
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9) << run.summary.at("certificate").dump(1);
  EXPECT_NEAR(run.resultant("N", 1.), -P, 1e-10 * P);
  const Vector radii = run.values("x", 1.), pressures = run.values("pressure", 1.);
  double edge = 0.;
  for (std::size_t k = 0; k < radii.size(); ++k)
    {
      if (pressures[k] > 0.)
        edge = radii[k];
      if (radii[k] < 0.9)
        {
          EXPECT_NEAR(pressures[k], p0 * std::sqrt(1. - radii[k] * radii[k]), 0.02 * p0)
            << radii[k];
        }
    }
  EXPECT_NEAR(edge, 1., fine);
}

INSTANTIATE_TEST_SUITE_P(Degrees, Hertz, testing::Values(1u, 2u));
