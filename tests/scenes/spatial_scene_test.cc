// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Bodies in space, from parameter file to results.

#include "known_answer.h"
#include "scenes/grid_mesh.h"
#include "scenes/known_scenes.h"
#include "scenes/refined_run.h"
#include "scenes/rough_blocks.h"

#include <fuga/base/errors.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  using Json = nlohmann::ordered_json;

  constexpr double E = 3000., p = 2., rho_n = 1e-3;
  // Of the joint of meshes/patch_3d.geo, which rises by 0.3 in x and by 0.2 in y.
  const double steepness = std::sqrt(1. + 0.3 * 0.3 + 0.2 * 0.2);

  /** Two blocks with ν = 0 under σ = -p n ⊗ n by tractions on all sides; n: normal of the joint. */
  std::string
  patch_file(const std::string &mesh, const unsigned int degree)
  {
    const std::array<double, 3> n = {{-0.3 / steepness, -0.2 / steepness, 1. / steepness}};
    Json scene;
    scene["Dimension"]                      = 3;
    scene["Mesh"]["File"]                   = std::string(FUGA_SOURCE_DIR) + "/meshes/" + mesh;
    scene["Mesh"]["Polynomial degree"]      = degree;
    const Json material                     = {{"Young modulus", E}, {"Poisson ratio", 0}};
    scene["Bodies"]["lower"]                = material;
    scene["Bodies"]["upper"]                = material;
    scene["Joints"]["joint"]                = {{"Line", "joint"},
                                               {"Plus body", "upper"},
                                               {"Minus body", "lower"},
                                               {"Normal compliance", rho_n}};
    scene["Boundaries"]["lower_1"]["Fixed"] = "all";
    scene["Boundaries"]["lower_2"]["Fixed"] = "y, z";
    scene["Boundaries"]["lower_3"]["Fixed"] = "z";
    scene["Boundaries"]["upper_1"]["Fixed"] = "x, y";
    scene["Boundaries"]["upper_2"]["Fixed"] = "y";
    const std::pair<const char *, std::array<double, 3>> sides[] = {{"bottom", {{0., 0., -1.}}},
                                                                    {"top", {{0., 0., 1.}}},
                                                                    {"front", {{0., -1., 0.}}},
                                                                    {"back", {{0., 1., 0.}}},
                                                                    {"left", {{-1., 0., 0.}}},
                                                                    {"right", {{1., 0., 0.}}}};
    std::string histories;
    for (const auto &[side, m] : sides)
      {
        const double s       = -p * (n[0] * m[0] + n[1] * m[1] + n[2] * m[2]);
        scene["Loads"][side] = {
          {"Type", "traction"},
          {"Boundaries", side},
          {"Value", fmt::format("{:.17g}; {:.17g}; {:.17g}", s * n[0], s * n[1], s * n[2])}};
        histories += fmt::format("{}{}: t", histories.empty() ? "" : "; ", side);
      }
    scene["Stages"]["all"]["Loads"] = histories;
    const std::string name          = temporary_directory() + "/patch.json";
    std::ofstream(name) << scene.dump(1);
    return name;
  }

  class SpatialPatch : public testing::TestWithParam<Patch>
  {
  };
} // namespace

// V2 in space, closed form: every element carries N = -pA and closes by ρn p; the areas sum up to
// 3 x 2 m times the slope of the joint; the resultant stands in the middle of the joint.
// Everything is linear: 1e-10 relative leaves 4 digits for the condition.
TEST_P(SpatialPatch, UniformPressure)
{
  const Patch &patch = GetParam();
  const SceneRun run = run_patch(patch_file(patch.mesh, patch.degree), patch);
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9);
  const Vector A = run.values("area", 1.), N = run.values("N", 1.), w = run.values("jump_n", 1.);
  double sum = 0., worst = 0.;
  for (std::size_t k = 0; k < A.size(); ++k)
    {
      EXPECT_GT(A[k], 0.);
      sum += A[k];
      worst = std::max({worst, std::abs(N[k] + p * A[k]) / p, std::abs(w[k] + rho_n * p) / rho_n});
    }
  const double area = 6. * steepness;
  EXPECT_NEAR(sum, area, 1e-10 * area);
  std::ostringstream name;
  name << patch << ": largest error of N and of the jump, relative";
  expect_answer({"V2 patch test in space", name.str(), 0., "closed form"}, worst, 1e-10);
  EXPECT_NEAR(run.resultant("N", 1.), -p * area, 1e-9);
  for (const auto &[column, value] : {std::pair("position_x", 1.5),
                                      {"position_y", 1.},
                                      {"position_z", 2.},
                                      {"T", 0.},
                                      {"T2", 0.},
                                      {"Mn", 0.},
                                      {"normal_x", -0.3 / steepness},
                                      {"normal_z", 1. / steepness}})
    EXPECT_NEAR(run.resultant(column, 1.), value, 1e-9) << column;
}

INSTANTIATE_TEST_SUITE_P(Meshes, SpatialPatch, all_patches());

// One element deep, with both ends held across: plane strain. Bars at the front and at the back
// carry half each; events come at the same loads. The tangent of such elements is the direction
// that the supports leave, so that friction has one direction as in the plane. 1e-9 of the largest
// value.
TEST(SpatialScenes, ExtrudedSceneEqualsThePlaneOne)
{
  const GmshMesh plane = two_blocks_mesh(uniform(0., 2., 8), uniform(0., 1., 4));
  Json scene           = rough_blocks();
  add_load(scene, "press", "pressure", "top", "1 + 0.3*x");
  add_load(scene, "push", "traction", "top", "1; 0.4*(1 - x)");
  scene["Stages"]["press"]["Loads"] = "press: t";
  scene["Stages"]["push"]           = {{"Loads", "push: t"}, {"Levels", 3}};
  const SceneRun flat               = run_scene(write_scene(plane, scene));

  scene["Loads"]["push"]["Value"] = "1; 0.4*(1 - x); 0";
  const SceneRun deep = run_scene(write_scene(extruded(plane, {0., 1.}), in_space(scene, "z")));
  EXPECT_EQ(flat.exit_code, deep.exit_code);
  EXPECT_LE(deep.certificate(), 1e-9);
  ASSERT_GT(flat.events.rows.size(), 3u); // the scene is worth comparing

  EXPECT_EQ(deep.events.rows.size(), 2 * flat.events.rows.size());

  const double end = flat.last_t();
  EXPECT_NEAR(deep.last_t(), end, 1e-9);
  for (const char *column : {"N", "T1", "pressure", "shear1", "slip1", "jump_n", "jump_t1"})
    for (const double t : {1., 4. / 3., end})
      EXPECT_LE(difference_from_plane(deep, 2, flat, column, t, 1e-12), 1e-9)
        << column << " t = " << t;
  for (const char *column : {"N", "T", "M", "eccentricity", "share_slip", "sliding_safety"})
    EXPECT_NEAR(deep.resultant(column, end), flat.resultant(column, end), 1e-9) << column;
}

// V7, sphere: a body with E on a rigid plane, without friction, a quarter model between planes of
// symmetry, the sphere as initial gap r²/2R. Hertz: E* = E/(1 - ν²), a³ = 3PR/(4E*),
// p0 = 3P/(2πa²); and ∫p r² dA = 2/5 P a². The body is 16 a large in all directions: the relative
// displacements in the contact that its boundary adds are of the order (a/L)³ = 2e-4. Quadratic
// elements: both errors are of second order in h/a = 1/4, because the rim lies between nodes; the
// factors 0.1 and 0.3 of (h/a)² are no theory but bounds for the size of such errors.
TEST(LargeSpatialScenes, HertzSphere)
{
  constexpr double modulus = 1000., nu = 0.3, R = 50., a = 1., level = 4., size = 16. * a;
  const double reduced = modulus / (1. - nu * nu);
  const double P       = 4. * reduced * a * a * a / (3. * R);
  const double p0      = 3. * P / (2. * M_PI * a * a);
  const Axis axis      = joined(uniform(0., 1.25 * a, 5), growing(1.25 * a, size, a / level, 1.8));
  const Json scene     = pressed_sphere(modulus, nu, 2, P / 4. / (size * size));
  const SceneRun run   = run_scene(
    write_scene(extruded(block_mesh(axis, growing(0., size, a / level, 1.8), size), axis), scene));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9);
  const Vector x = run.values("x", 1.), z = run.values("z", 1.), N = run.values("N", 1.);
  double force = 0., moment = 0.;
  for (std::size_t k = 0; k < x.size(); ++k)
    {
      force -= N[k];
      moment -= N[k] * (x[k] * x[k] + z[k] * z[k]);
    }
  EXPECT_NEAR(force, P / 4., 1e-9 * P);
  const double h = 1. / level;
  expect_answer({"V7 sphere", "a, h = a/4, degree 2", a, "Hertz"},
                std::sqrt(2.5 * moment / force),
                0.1 * h * h);
  expect_answer({"V7 sphere", "p0, h = a/4, degree 2", p0, "Hertz"},
                run.values("pressure", 1.)[0],
                0.3 * h * h * p0);
}

// The block of a dam, statics by hand (15 m of it, moments about the middle of its base, level h =
// 27 m): weight 24 (24 + 4)/2 30 15 at x = (240 + 3200)/420; thrust 15 γh²/2 at h/3; uplift 15 γh
// (1.4375/2 3 + 0.4375/2 21) with the drains at 3 m of 24. On a plane joint all slip is along x,
// and by symmetry nothing twists or tilts across.
TEST(SpatialScenes, DamBlockWithUplift)
{
  constexpr double gamma = 9.81, h = 27., weight = 24. * 14. * 30. * 15.;
  constexpr double thrust = 15. * gamma * h * h / 2.;
  constexpr double first  = 15. * gamma * h * 1.4375 / 2. * 3.,
                   second = 15. * gamma * h * 0.4375 / 2. * 21.;
  // Of a trapezium from 1 to 0.4375 over 3 m, and of a triangle over 21 m.
  const double first_x = (1. + 2. * 0.4375) / (3. * 1.4375) * 3., second_x = 3. + 7.;
  const double weight_moment = -weight * (12. - 3440. / 420.);
  const SceneRun run         = run_scene("dam_block_3d.prm");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9);
  EXPECT_GT(run.count("slip", 2.), 0u);
  const double scale = 1e-9 * weight;
  EXPECT_NEAR(run.resultant("N", 1.), -weight, scale);
  EXPECT_NEAR(run.resultant("M", 1.), weight_moment, 12. * scale);
  EXPECT_NEAR(run.resultant("water", 2.), first + second, scale);
  EXPECT_NEAR(run.resultant("N", 2.), first + second - weight, scale);
  EXPECT_NEAR(run.resultant("T", 2.), thrust, scale);
  EXPECT_NEAR(run.resultant("M", 2.),
              weight_moment + thrust * h / 3. + first * (12. - first_x) + second * (12. - second_x),
              12. * scale);
  for (const char *column : {"T2", "M1", "Mn"})
    EXPECT_NEAR(run.resultant(column, 2.), 0., 12. * scale) << column;

  // How many times this thrust the friction of the base, 0.7, bears. The search ends where 1e-6 of
  // its stage, which goes up to the factor 10, would double the slips.
  const double limit     = 0.7 * (weight - first - second) / thrust;
  const SceneRun further = run_scene("dam_block_3d.prm", {"Safety/Load factor=water"});
  const auto &found      = further.summary.at("safety").at("load_factor");
  EXPECT_EQ(found.at("verdict"), "limit load");
  EXPECT_EQ(further.count("stick", further.last_t()), 0u);
  expect_answer(
    {"Block of a dam in space", "load factor of the water at sliding", limit, "statics"},
    found.at("factor").get<double>(),
    9e-6);
}

namespace
{
  std::string
  complaint_about(const std::string &file, const std::vector<std::string> &overrides)
  {
    try
      {
        run_scene(file, overrides);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "none";
  }
} // namespace

TEST(SpatialScenes, WhatDoesNotWorkSaysSo)
{
  const std::string patch = patch_file("patch_hex.msh", 1);
  using Overrides         = std::vector<std::string>;
  for (const auto &[overrides, message] :
       {std::pair(Overrides{"Dimension=2"}, "'y, z'"),
        {{"Mesh/Thickness=2"}, "nothing across it"},
        {{"Loads/top/Value=0; 1"}, "2 expression(s) separated by ';' instead of 3"},
        {{"Boundaries/lower_3/Fixed=free",
          "Boundaries/upper_1/Fixed=free",
          "Boundaries/upper_2/Fixed=free"},
         "free to rotate about an axis in the direction (1, "}})
    EXPECT_NE(complaint_about(patch, overrides).find(message), std::string::npos)
      << overrides.front() << "\n"
      << complaint_about(patch, overrides);
  EXPECT_NE(
    complaint_about(patch_file("patch_tet.msh", 2), {}).find("on tetrahedra the degrees 1 to 1"),
    std::string::npos);
  const GmshMesh plane          = two_blocks_mesh(uniform(0., 2., 2), uniform(0., 1., 2));
  Json scene                    = rough_blocks();
  scene["Dimension"]            = 3;
  scene["Loads"]["w"]           = {{"Type", "pressure"}, {"Boundaries", "top"}, {"Value", "1 + z"}};
  scene["Stages"]["w"]["Loads"] = "w: t";
  EXPECT_NE(complaint_about(write_scene(plane, scene), {}).find("Dimension = 2"),
            std::string::npos);
}
