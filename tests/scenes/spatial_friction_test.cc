// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// V2 in space with friction: uniform stresses in the two blocks of meshes/patch_3d.geo, 3 x 2 m
// wide and together 4 m high, whose joint is oblique to all axes.

#include "known_answer.h"
#include "scenes/refined_run.h"
#include "scenes/rough_blocks.h"

#include <deal.II/base/tensor.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

using namespace fuga;
using namespace fuga::tests;
using dealii::outer_product;

namespace
{
  using Json    = nlohmann::ordered_json;
  using Point3  = dealii::Tensor<1, 3>;
  using Tensor3 = dealii::Tensor<2, 3>;

  constexpr const char *problem = "V2 patch test in space with friction";
  constexpr double E_lower = 3000., E_upper = 5000., p = 2., rho_n = 1e-3, rho_t = 2e-3, f = 0.3;
  constexpr double dip_x = 0.3, dip_y = 0.2, height = 4.;
  const double slope = std::hypot(dip_x, dip_y); // tan α
  const Point3 normal({-dip_x / std::hypot(1., slope),
                       -dip_y / std::hypot(1., slope),
                       1. / std::hypot(1., slope)});
  const Point3 middle({1.5, 1., 2.}); // of the joint

  /** Tangents by definition: the direction of x in the joint, and n x t1. */
  Point3
  tangent(const int number)
  {
    Point3 t({1., 0., 0.});
    t -= normal[0] * normal;
    t /= t.norm();
    return number == 1 ? t : dealii::cross_product_3d(normal, t);
  }

  const std::vector<std::pair<const char *, Point3>> sides = {{"left", Point3({-1., 0., 0.})},
                                                              {"right", Point3({1., 0., 0.})},
                                                              {"front", Point3({0., -1., 0.})},
                                                              {"back", Point3({0., 1., 0.})}};

  /** A scene in parts: loads that act together get the same history. */
  class PatchScene
  {
  public:
    PatchScene(const Patch &its_patch) : patch(its_patch)
    {
      scene["Dimension"]                 = 3;
      scene["Mesh"]["File"]              = std::string(FUGA_SOURCE_DIR) + "/meshes/" + patch.mesh;
      scene["Mesh"]["Polynomial degree"] = patch.degree;
      scene["Bodies"]["lower"]           = {{"Young modulus", E_lower}, {"Poisson ratio", 0}};
      scene["Bodies"]["upper"]           = {{"Young modulus", E_upper}, {"Poisson ratio", 0}};
      scene["Joints"]["joint"]           = {{"Line", "joint"},
                                            {"Plus body", "upper"},
                                            {"Minus body", "lower"},
                                            {"Normal compliance", rho_n},
                                            {"Shear compliance", rho_t},
                                            {"Friction coefficient", f}};
    }

    /** Tractions σm on a side with the outer normal m, as a part of @p loads. */
    void
    add_traction(const std::string &loads, const char *side, const Point3 &m, const Tensor3 &sigma)
    {
      const Point3 q = sigma * m;
      add(loads, "traction", side, fmt::format("{:.17g}; {:.17g}; {:.17g}", q[0], q[1], q[2]));
    }

    void
    add_side_tractions(const std::string &loads, const Tensor3 &sigma)
    {
      for (const auto &[side, m] : sides)
        add_traction(loads, side, m, sigma);
    }

    /** Displacements u = a + Gx of a held boundary. */
    void
    add_displacement(const std::string &loads, const char *side, const Point3 &a, const Tensor3 &G)
    {
      std::string value;
      for (unsigned int i = 0; i < 3; ++i)
        value += fmt::format("{}{:.17g} + {:.17g}*x + {:.17g}*y + {:.17g}*z",
                             i == 0 ? "" : "; ",
                             a[i],
                             G[i][0],
                             G[i][1],
                             G[i][2]);
      add(loads, "displacement", side, value);
    }

    void
    add_stage(const std::string &loads, const unsigned int levels)
    {
      scene["Stages"][loads] = {{"Loads", histories.at(loads)}, {"Levels", levels}};
    }

    SceneRun
    run() const
    {
      const std::string name = temporary_directory() + "/patch.json";
      std::ofstream(name) << scene.dump(1);
      return run_patch(name, patch);
    }

    Json scene;

  private:
    const Patch patch;

    void
    add(const std::string &loads, const char *type, const char *side, const std::string &value)
    {
      const std::string name = loads + "_" + side;
      add_load(scene, name, type, side, value);
      std::string &history = histories[loads];
      history += (history.empty() ? "" : "; ") + name + ": t";
    }

    std::map<std::string, std::string> histories;
  };

  /** Largest difference of a column from one value. */
  double
  largest_difference(const Vector &values, const double value)
  {
    double worst = 0.;
    for (const double v : values)
      worst = std::max(worst, std::abs(v - value));
    return worst;
  }

  /** Relative to p: N/A = n·σn, T_i/A = t_i·σn; jumps by the layer and the slip @p s along the
   * joint, relative to ρt p. */
  double
  worst_error(const SceneRun &run, const double t, const Tensor3 &sigma, const Point3 &s)
  {
    const Vector A = run.values("area", t);
    Vector N = run.values("N", t), T1 = run.values("T1", t), T2 = run.values("T2", t);
    for (std::size_t k = 0; k < A.size(); ++k)
      {
        N[k] /= A[k];
        T1[k] /= A[k];
        T2[k] /= A[k];
      }
    const Point3 q = sigma * normal;
    double worst   = std::max({largest_difference(N, q * normal),
                               largest_difference(T1, q * tangent(1)),
                               largest_difference(T2, q * tangent(2))}) /
                   p;
    for (const auto &[column, value] : {std::pair("jump_n", rho_n * (q * normal)),
                                        {"jump_t1", rho_t * (q * tangent(1)) + s * tangent(1)},
                                        {"jump_t2", rho_t * (q * tangent(2)) + s * tangent(2)},
                                        {"slip1", s * tangent(1)},
                                        {"slip2", s * tangent(2)}})
      worst = std::max(worst, largest_difference(run.values(column, t), value) / (rho_t * p));
    return worst;
  }

  class SpatialFriction : public testing::TestWithParam<Patch>
  {
  };
} // namespace

// Pressed by σ = -p n ⊗ n, and then by -q ez ⊗ ez in addition: the traction on the joint turns
// towards the vertical, T/N = q nz √(1 - nz²)/(p + q nz²) down the dip. The joint sticks as long as
// this is less than f, and the upper block, which nothing else holds, slides down the dip from
// q = f p/(nz √(1 - nz²) - f nz²) on. Both blocks have the same modulus, since their lips would
// differ in length. Everything is linear: 1e-10 leaves 4 digits for the condition.
TEST_P(SpatialFriction, ColumnSlidesDownTheDip)
{
  const double nz = normal[2], along = std::sqrt(1. - nz * nz);
  const double q_limit = f * p / (nz * along - f * nz * nz), q_end = 1.6 * q_limit;
  const Point3 ez({0., 0., 1.});
  const Tensor3 pressing = -p * outer_product(normal, normal), column = -outer_product(ez, ez);
  PatchScene patch(GetParam());
  patch.scene["Bodies"]["upper"]["Young modulus"] = E_lower;
  // Statically determinate supports of the lower block.
  patch.scene["Boundaries"]["lower_1"]["Fixed"] = "all";
  patch.scene["Boundaries"]["lower_2"]["Fixed"] = "y, z";
  patch.scene["Boundaries"]["lower_3"]["Fixed"] = "z";
  patch.add_side_tractions("press", pressing);
  for (const auto &[loads, sigma] : {std::pair("press", pressing), {"column", q_end * column}})
    {
      patch.add_traction(loads, "top", ez, sigma);
      patch.add_traction(loads, "bottom", -ez, sigma);
    }
  patch.add_stage("press", 1);
  patch.add_stage("column", 2);
  const SceneRun run = patch.run();
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(run.summary.at("verdict"), "limit load");
  EXPECT_EQ(run.summary.at("limit_load").at("mechanism"), "sliding");
  EXPECT_LE(run.certificate(), 1e-9);
  std::ostringstream name;
  name << GetParam();
  expect_answer({problem, name.str() + ": q at sliding / p", q_limit / p, "equilibrium"},
                (run.last_t() - 1.) * q_end / p,
                1e-10 * q_limit / p);
  double worst = 0.;
  for (const double t : {1., 1.5, run.last_t()})
    worst = std::max(worst, worst_error(run, t, pressing + (t - 1.) * q_end * column, Point3()));
  expect_answer(
    {problem, name.str() + ": until it slides, largest error", 0., "closed form"}, worst, 1e-10);
  EXPECT_EQ(run.count("stick", 1.5), run.values("N", 1.).size());
  // All reach the cone at once, with the force down the dip.
  EXPECT_EQ(run.event_times(0.).size(), run.values("N", 1.).size());
  const double T1 = run.resultant("T", run.last_t()), T2 = run.resultant("T2", run.last_t());
  const Point3 down = -1. * ez + nz * normal;
  EXPECT_NEAR(T1 * (down * tangent(2)), T2 * (down * tangent(1)), 1e-10 * std::hypot(T1, T2));
}

// Pressed by σ = -p n ⊗ n, sheared by τ(n ⊗ m + m ⊗ n) with m along neither tangent until τ = f p
// at the end of the stage; then the top of the upper block moves on by D along m, and with it the
// whole block: slip D, stresses as before. The bodies have different moduli: with G the strains
// plus the rotation of the upper block for which its lip follows the lower one,
// c = (1/E_upper - 1/E_lower) τ about m x n.
TEST_P(SpatialFriction, BlockIsPushedAlong)
{
  constexpr double D     = 0.01;
  const Point3 m         = 0.6 * tangent(1) + 0.8 * tangent(2);
  const Tensor3 pressing = -p * outer_product(normal, normal);
  const Tensor3 shearing = f * p * (outer_product(normal, m) + outer_product(m, normal));
  const Tensor3 rotation =
    (1. / E_upper - 1. / E_lower) * f * p * (outer_product(m, normal) - outer_product(normal, m));
  PatchScene patch(GetParam());
  patch.scene["Boundaries"]["top"]["Fixed"]       = "all";
  patch.scene["Boundaries"]["bottom"]["Fixed"]    = "all";
  patch.scene["Monitors"]["edge"]                 = {{"Point", "0, 0, 1.35"}, {"Body", "upper"}};
  const std::pair<const char *, Tensor3> stages[] = {{"press", pressing}, {"shear", shearing}};
  Point3 edge;
  for (const auto &[stage, sigma] : stages)
    {
      const bool shears   = stage[0] == 's';
      const Point3 jump   = shears ? f * p * rho_t * m : -p * rho_n * normal;
      const Tensor3 upper = shears ? sigma / E_upper + rotation : sigma / E_upper;
      const Point3 shift  = jump + (sigma / E_lower - upper) * middle;
      patch.add_side_tractions(stage, sigma);
      patch.add_displacement(stage, "bottom", Point3(), sigma / E_lower);
      patch.add_displacement(stage, "top", shift, upper);
      patch.add_stage(stage, 2);
      edge += shift + upper * Point3({0., 0., 1.35});
    }
  patch.add_displacement("slide", "top", D * m, Tensor3());
  patch.add_stage("slide", 2);
  edge += D * m;

  const SceneRun run = patch.run();
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9);
  double worst = 0.;
  for (const auto &[t, share, s] : {std::tuple(0.5, 0., 0.),
                                    {1., 0., 0.},
                                    {1.5, 0.5, 0.},
                                    {2., 1., 0.},
                                    {2.5, 1., 0.5 * D},
                                    {3., 1., D}})
    worst =
      std::max(worst, worst_error(run, t, std::min(t, 1.) * pressing + share * shearing, s * m));
  std::ostringstream name;
  name << GetParam() << ": pushed along, largest error";
  expect_answer({problem, name.str(), 0., "closed form"}, worst, 1e-10);
  EXPECT_EQ(run.count("stick", 1.5), run.values("N", 1.).size());
  EXPECT_EQ(run.count("slip", 2.5), run.values("N", 1.).size());
  const std::size_t last = run.monitors.rows.size() - 1;
  for (unsigned int i = 0; i < 3; ++i)
    EXPECT_NEAR(run.monitors.number(last, std::string("u") + "xyz"[i]), edge[i], 1e-10 * D);
}

INSTANTIATE_TEST_SUITE_P(Meshes, SpatialFriction, all_patches());
