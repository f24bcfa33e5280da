// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/mesh_variants.h"
#include "scenes/scene_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  /** One square element, clamped on its left and upper side, the lower one on a rigid plane; and
   * another one that touches nothing, so that the bodies have unknowns besides the contact. */
  std::string
  one_element_mesh()
  {
    GmshMesh mesh;
    mesh.dimension      = 2;
    mesh.physical_names = {{{2, 1}, "block"},
                           {{1, 2}, "base"},
                           {{1, 3}, "clamped"},
                           {{1, 4}, "right"},
                           {{1, 5}, "free"}};
    for (const double x : {0., 2.})
      for (const auto &corner :
           {std::array<double, 2>{{0., 0.}}, {{1., 0.}}, {{1., 1.}}, {{0., 1.}}})
        mesh.vertices.push_back({{x + corner[0], corner[1], 0.}});
    mesh.cells.push_back({CellShape::quadrilateral, {{0, 1, 2, 3}}, 1});
    mesh.cells.push_back({CellShape::quadrilateral, {{4, 5, 6, 7}}, 1});
    mesh.faces.push_back({CellShape::line, {{0, 1}}, 2});
    mesh.faces.push_back({CellShape::line, {{7, 4}}, 3});
    mesh.faces.push_back({CellShape::line, {{4, 5}}, 5});
    mesh.faces.push_back({CellShape::line, {{5, 6}}, 5});
    mesh.faces.push_back({CellShape::line, {{6, 7}}, 5});
    mesh.faces.push_back({CellShape::line, {{3, 0}}, 3});
    mesh.faces.push_back({CellShape::line, {{2, 3}}, 3});
    mesh.faces.push_back({CellShape::line, {{1, 2}}, 4});
    return write_mesh(mesh);
  }

  /**
   * The free corner at (1, 0) is pressed down by 1 and then sheared to the right. Its stiffnesses
   * are those of the bilinear element: S_tt ∝ 1/2 - ν'/6, S_tn ∝ -(1 + ν')/8 with ν' = ν/(1 - ν) in
   * plane strain, so f_c = S_tt/|S_tn| = 4 - 16 ν/3 = 2.4 for ν = 0.3 (rigid joint).
   */
  SceneRun
  run_corner(const double f,
             const std::string &second,
             const std::string &third,
             const std::vector<std::string> &overrides = {})
  {
    const std::string name = temporary_directory() + "/corner.prm";
    std::ofstream(name)
      << "subsection Mesh\nset File = " << one_element_mesh()
      << "\nend\nsubsection Bodies\nsubsection block\nset Young modulus = 1\n"
         "set Poisson ratio = 0.3\nend\nend\nsubsection Joints\nsubsection base\nset Plus lip = "
         "base\n"
         "set Minus lip = rigid\nset Normal law = rigid\nset Shear law = rigid\n"
         "set Friction coefficient = "
      << fmt::format("{}", f)
      << "\nend\nend\nsubsection Boundaries\nsubsection clamped\nset Fixed = all\nend\n"
         "subsection free\nset Fixed = free\nend\nend\n"
         "subsection Loads\n"
         "subsection press\nset Type = traction\nset Boundaries = right\nset Value = 0; -2\nend\n"
         "subsection shear\nset Type = traction\nset Boundaries = right\nset Value = 2; "
         "0\nend\nend\n"
         "subsection Stages\nsubsection first\nset Loads = press: t\nend\n"
         "subsection second\nset Loads = shear: "
      << second << "\nend\nsubsection third\nset Loads = shear: " << third << "\nend\nend\n";
    return run_scene(name, overrides);
  }
} // namespace

// V10 on a finite element: no continuation at F_t = f just above f_c, an ordinary slip just below.
TEST(CriticalFriction, OfOneFiniteElement)
{
  const SceneRun below = run_corner(2.399, "3*t", "3");
  EXPECT_EQ(below.exit_code, 0);
  EXPECT_FALSE(below.summary.contains("friction_beyond_critical"));

  const SceneRun above = run_corner(2.401, "3*t", "3");
  EXPECT_EQ(above.exit_code, 3);
  EXPECT_EQ(above.summary.at("verdict"), "no continuation");
  EXPECT_NEAR(above.summary.at("t").get<double>(), 1. + 2.401 / 3., 1e-12);
  const auto &place = above.summary.at("friction_beyond_critical");
  EXPECT_EQ(place.at("continuations"), 0);
  EXPECT_EQ(place.at("determinant_signs"), nlohmann::json({-1}));
  ASSERT_EQ(place.at("elements").size(), 1u);
  EXPECT_EQ(place.at("elements")[0].at("x"), 1.);
  EXPECT_EQ(place.at("elements")[0].at("y"), 0.);
}

// Where the shear goes back from the strength, stick and slip are both admissible: reported, or
// followed on request.
// Where the corner cannot go on slowly it snaps off the plane, and rests in the equilibrium of the
// element alone: K u = F with K_tt = K_nn = (D11 + G)/3 and K_tn = -(D12 + G)/4 of the bilinear
// element.
TEST(CriticalFriction, SnapOfOneFiniteElement)
{
  const SceneRun run = run_corner(3.,
                                  "4*t",
                                  "4",
                                  {"Bodies/block/Weight density=1",
                                   "Joints/base/Normal law=linear",
                                   "Joints/base/Normal stiffness=1000",
                                   "Joints/base/Shear law=linear",
                                   "Joints/base/Shear stiffness=1000",
                                   "Solver/Beyond limit load=dynamic",
                                   "Dynamics/Time step=0.01",
                                   "Dynamics/Gravity=10",
                                   "Dynamics/Damping ratio=0.1",
                                   "Dynamics/Damping frequencies=0.5; 2",
                                   "Dynamics/Longest continuation=100"});
  ASSERT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9);
  const auto &snap = run.summary.at("continuations").at(0);
  EXPECT_EQ(snap.at("cause"), "no continuation");
  EXPECT_NEAR(snap.at("t").get<double>(), 1.75, 1e-3); // the layer gives a little
  EXPECT_TRUE(snap.at("comes_to_rest"));
  const double nu = 0.3, G = 0.5 / (1. + nu), D12 = nu / ((1. + nu) * (1. - 2. * nu)),
               D11 = D12 + 2. * G, a = (D11 + G) / 3., b = (D12 + G) / 4.;
  for (const double t : {2., 3.})
    {
      EXPECT_EQ(run.states(t).back(), "open");
      EXPECT_NEAR(run.values("gap", t).back(), (4. * b - a) / (a * a - b * b), 1e-9);
    }
}

TEST(CriticalFriction, TwoContinuationsOfOneFiniteElement)
{
  const std::string up = "2.5*t", back = "2.5 - t";
  const SceneRun stop = run_corner(2.5, up, back);
  EXPECT_EQ(stop.exit_code, 3);
  EXPECT_EQ(stop.summary.at("verdict"), "non-unique continuation");
  EXPECT_EQ(stop.summary.at("t"), 2.);
  const auto &place = stop.summary.at("friction_beyond_critical");
  EXPECT_EQ(place.at("continuations"), 2);
  EXPECT_EQ(place.at("all_counted"), true);
  std::vector<int> signs = place.at("determinant_signs").get<std::vector<int>>();
  std::sort(signs.begin(), signs.end());
  EXPECT_EQ(signs, (std::vector<int>{-1, 1}));
  EXPECT_LE(stop.certificate(), 1e-12);

  const SceneRun first = run_corner(2.5, up, back, {"Solver/Non-unique=first"});
  EXPECT_EQ(first.exit_code, 0);
  EXPECT_EQ(first.summary.at("warnings").size(), 1u);
  EXPECT_NEAR(first.values("T1", 3.).back(), 1.5, 1e-12); // stuck
  const SceneRun most = run_corner(2.5, up, back, {"Solver/Non-unique=largest dissipation"});
  EXPECT_EQ(most.exit_code, 0);
  EXPECT_EQ(most.events.text(0, "to"), "slip");
  EXPECT_EQ(most.events.text(0, "continuations"), "2");
  EXPECT_LE(most.certificate(), 1e-12);
}

// S0 slides at q = f · 1.152/12 = 0.0192; beyond it the shear stays at f N and t stays, while the
// path grows by the length that was asked for.
TEST(BeyondLimit, PlateauOfFiniteElements)
{
  const SceneRun run = run_scene("paper_2_linear.prm",
                                 {"Loads/push/Value=0.03",
                                  "Solver/Beyond limit load=arc length",
                                  "Solver/Largest jump beyond limit=0.01"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(run.summary.at("verdict"), "limit load");
  EXPECT_EQ(run.summary.at("beyond_limit").at("end"), "largest jump");
  EXPECT_NEAR(run.summary.at("beyond_limit").at("path_length").get<double>(), 0.01, 1e-12);
  const std::size_t last = run.resultants.rows.size() - 1;
  EXPECT_NEAR(run.resultants.number(last, "path_length"), 0.01, 1e-12);
  EXPECT_NEAR(run.resultants.number(last, "t"), run.summary.at("t").get<double>(), 1e-12);
  EXPECT_NEAR(std::abs(run.resultants.number(last, "T")),
              0.2 * std::abs(run.resultants.number(last, "N")),
              1e-9);
  EXPECT_GE(run.resultants.number(last, "largest_slip"), 0.01);
  EXPECT_LE(run.certificate(), 1e-9);
}
