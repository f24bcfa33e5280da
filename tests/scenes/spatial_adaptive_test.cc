// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Section Target accuracy in space.

#include "scenes/grid_mesh.h"
#include "scenes/known_scenes.h"
#include "scenes/rough_blocks.h"
#include "scenes/scene_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  using Json = nlohmann::ordered_json;

  double
  estimate(const SceneRun &run)
  {
    return run.summary.at("accuracy").at("estimated_error").get<double>();
  }

  std::size_t
  n_unknowns(const SceneRun &run)
  {
    return run.summary.at("sizes").at("degrees_of_freedom").get<std::size_t>();
  }

  /** V7: a quarter of a block of 16 x 16 x 16 on a rigid plane, 4 x 4 x 4 cubes, with the roundness
   * of a sphere between them; radius of the contact 1. */
  struct Sphere
  {
    static constexpr double E = 1000., nu = 0.3, R = 50., a = 1., size = 16.;
    const double reduced = E / (1. - nu * nu);

    std::string
    file(const unsigned int degree) const
    {
      const Axis axis                      = uniform(0., size, 4);
      const double P                       = 4. * reduced * a * a * a / (3. * R);
      Json scene                           = pressed_sphere(E, nu, degree, P / 4. / (size * size));
      scene["Target accuracy"]["Quantity"] = "contact pressure";
      return write_scene(extruded(block_mesh(axis, axis, size), axis), scene);
    }

    /** A certified run that reached its target, here 5 %, and estimated its error within a factor
     * of two or three. Returns the error. */
    double
    check_adapted(const SceneRun &run) const
    {
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_LE(run.certificate(), 1e-9);
      EXPECT_TRUE(run.summary.at("accuracy").at("reached").get<bool>());
      const double true_error = error(run);
      EXPECT_LE(true_error, 0.05);
      EXPECT_GT(estimate(run), 0.5 * true_error);
      EXPECT_LT(estimate(run), 3. * true_error);
      return true_error;
    }

    /** Of the pressure of a run, root of the mean square over the area. */
    double
    error(const SceneRun &run) const
    {
      const double p0 = 2. * reduced * a / (M_PI * R);
      const Vector x = run.values("x", 1.), z = run.values("z", 1.), p = run.values("pressure", 1.),
                   A = run.values("area", 1.);
      double square = 0., sum = 0.;
      for (std::size_t k = 0; k < x.size(); ++k)
        {
          const double r     = std::hypot(x[k], z[k]) / a;
          const double exact = p0 * std::sqrt(std::max(0., 1. - r * r));
          square += A[k] * std::pow(p[k] - exact, 2);
          sum += A[k] * exact * exact;
        }
      return std::sqrt(square / sum);
    }
  };

  /** V9, the block of Raous et al., as a slice of its depth 10 between planes that hold both ends
   *  across: plane strain. Friction along two tangents within. */
  std::string
  raous_slice()
  {
    Json scene         = raous_block();
    scene["Dimension"] = 3;
    for (const char *end : {"front", "back"})
      scene["Boundaries"][end]["Fixed"] = "z";
    scene["Monitors"]["edge"]["Point"] = "0, 0, 5";
    scene["Target accuracy"]           = {
                {"Quantity", "monitor"}, {"Components", "x"}, {"Relative error", 0.004}};
    return write_scene(
      extruded(block_mesh(uniform(0., 40., 4), uniform(0., 40., 4), 40.), {0., 10.}), scene);
  }

  /** Two blocks with rough, compliant joints under an oblique push. */
  Json
  pushed_blocks()
  {
    Json scene = in_space(rough_blocks(), "free");
    add_load(scene, "press", "pressure", "top", "1");
    add_load(scene, "push", "traction", "top", "0.3; 0; 0.15");
    scene["Stages"]["press"]["Loads"] = "press: t";
    scene["Stages"]["push"]["Loads"]  = "push: t";
    return scene;
  }
} // namespace


// The pressure is that of Hertz to 5 %, and the estimate between 0.5 and 3 times the true error; a
// uniform refinement with more than eight times the unknowns has ten times the error. By
// (a/16)³ = 2e-4 the block is no half-space.
TEST(SpatialAdaptive, Sphere)
{
  const Sphere sphere;
  const std::string file = sphere.file(1);
  const SceneRun run     = run_scene(file, {"Target accuracy/Relative error=0.05"});
  const double error     = sphere.check_adapted(run);
  const SceneRun uniform_run =
    run_scene(file, {"Target accuracy/Quantity=none", "Mesh/Refinements=2"});
  EXPECT_GT(n_unknowns(uniform_run), 8 * n_unknowns(run));
  EXPECT_GT(sphere.error(uniform_run), 10. * error);
}


// The same with quadratic elements.
TEST(LargeSpatialAdaptive, SphereOfDegreeTwo)
{
  const Sphere sphere;
  sphere.check_adapted(run_scene(sphere.file(2), {"Target accuracy/Relative error=0.05"}));
}


// The displacement of the corner of V9 in the plane, 28.603 µm (see Adaptive.RaousBlock), from
// meshes that are refined across the plane too. The tolerance is the target.
TEST(SpatialAdaptive, SliceOfRaousBlock)
{
  const SceneRun run = run_scene(raous_slice());
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9);
  EXPECT_TRUE(run.summary.at("accuracy").at("reached").get<bool>());
  EXPECT_GT(run.summary.at("accuracy").at("rounds").size(), 2u);
  EXPECT_GT(run.count("slip", 1.), 0u);
  EXPECT_GT(run.count("stick", 1.), 0u);
  EXPECT_NEAR(run.monitors.number(run.monitors.rows.size() - 1, "ux"), 28.603e-3, 28.6e-3 * 0.004);
}


// All six resultants, both lips bodies, friction along two tangents: by equilibrium they are known
// on every mesh, so that the first one is good enough. Forces: of the tractions; moments about the
// middle of the joint, 1/2 below the top.
TEST(SpatialAdaptive, ResultantsThatEquilibriumFixes)
{
  const GmshMesh mesh =
    extruded(two_blocks_mesh(uniform(0., 2., 4), uniform(0., 0.5, 2)), uniform(0., 1.5, 3));
  Json scene               = pushed_blocks();
  scene["Target accuracy"] = {
    {"Quantity", "resultant"}, {"Components", "N, T, T2, M, M1, Mn"}, {"Relative error", 1e-6}};
  const SceneRun run = run_scene(write_scene(mesh, scene));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.summary.at("accuracy").at("rounds").size(), 1u);
  EXPECT_TRUE(run.summary.at("accuracy").at("reached").get<bool>());
  EXPECT_NEAR(run.resultant("N", 2.), -3., 1e-8);
  EXPECT_NEAR(run.resultant("T", 2.), 0.9, 1e-8);
}


// Lips of two bodies with friction: they remain alike over all rounds, and equilibrium holds on the
// last mesh. Meshes grow by less than the eight times of a uniform refinement, and the estimate
// falls to half.
TEST(LargeSpatialAdaptive, RoughBlocks)
{
  const GmshMesh mesh =
    extruded(two_blocks_mesh(uniform(0., 2., 4), uniform(0., 0.5, 2)), uniform(0., 1.5, 3));
  Json scene               = pushed_blocks();
  scene["Target accuracy"] = {
    {"Quantity", "contact pressure"}, {"Relative error", 0.001}, {"Largest number of rounds", 3}};
  const SceneRun run = run_scene(write_scene(mesh, scene));
  const auto &rounds = run.summary.at("accuracy").at("rounds");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-8);
  ASSERT_EQ(rounds.size(), 3u);
  EXPECT_LT(rounds[1].at("cells").get<int>(), 6 * rounds[0].at("cells").get<int>());
  EXPECT_LT(estimate(run), 0.5 * rounds[0].at("estimated_error").get<double>());
  EXPECT_NEAR(run.resultant("N", 2.), -3., 1e-8);
}


// Tetrahedra are refined as a whole.
TEST(SpatialAdaptive, Tetrahedra)
{
  Json scene                      = pushed_blocks();
  scene["Mesh"]["File"]           = std::string(FUGA_SOURCE_DIR) + "/meshes/patch_tet.msh";
  scene["Loads"]["push"]["Value"] = "0.1; 0.1; 0";
  scene["Target accuracy"]        = {
           {"Quantity", "contact pressure"}, {"Relative error", 1e-6}, {"Largest number of rounds", 2}};
  const std::string name = temporary_directory() + "/tetrahedra.json";
  std::ofstream(name) << scene.dump(1);
  const SceneRun run = run_scene(name);
  const auto &rounds = run.summary.at("accuracy").at("rounds");
  EXPECT_EQ(run.exit_code, 0);
  ASSERT_EQ(rounds.size(), 2u);
  EXPECT_EQ(rounds[1].at("cells").get<int>(), 8 * rounds[0].at("cells").get<int>());
  EXPECT_LT(rounds[1].at("estimated_error").get<double>(),
            rounds[0].at("estimated_error").get<double>());
}
