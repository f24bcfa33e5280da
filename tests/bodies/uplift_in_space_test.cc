// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Water in a joint in space whose ends are inclined and oblique: the joint rises by 0.5 across the
// flow, as on the bank of a valley, and is a trapezoid in plan,
//   0 <= y <= 2,  b(y) = 0.4 y <= x <= b(y) + L(y),  L = 3 (1 + y/4),  z = 2 + y/2.
// On every line in the direction x the rules of doc/uplift.md draw straight lines between its own
// ends, of the heads h - z(y).

#include "block_mesh.h"
#include "spatial_patch.h"

#include <deal.II/base/quadrature_lib.h>

#include <fuga/base/errors.h>
#include <fuga/bodies/loads/uplift_assembly.h>
#include <fuga/mesh/gmsh_mesh.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

using namespace fuga;
using namespace fuga::test;
using fuga::tests::all_patches;
using fuga::tests::Patch;

namespace
{
  constexpr double gamma_w = 9.81, rise = 0.5, width = 2.;

  double
  begin_of(const double y)
  {
    return 0.4 * y;
  }

  double
  length_of(const double y)
  {
    return 3. * (1. + y / 4.);
  }

  double
  height_of(const double y)
  {
    return 2. + rise * y;
  }

  /** ∫ u dA, ∫ u x dA, ∫ u y dA; a pressure given by values at distances from the upstream end,
   * straight in between. */
  using Sums    = std::array<double, 3>;
  using Profile = std::function<std::vector<std::array<double, 2>>(double y)>;

  /** @p corners: coordinates y at which the profile changes its form. */
  Sums
  integral(const Profile &profile, const std::vector<double> &corners = {})
  {
    const dealii::QGauss<1> rule(20);
    std::vector<double> ends = {0.};
    ends.insert(ends.end(), corners.begin(), corners.end());
    ends.push_back(width);
    Sums sums{};
    const double area = std::hypot(1., rise);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const double y    = ends[i] + (ends[i + 1] - ends[i]) * rule.point(q)[0];
          const double dy   = (ends[i + 1] - ends[i]) * rule.weight(q) * area;
          const auto points = profile(y);
          for (std::size_t k = 0; k + 1 < points.size(); ++k)
            {
              const auto &[s0, u0] = points[k];
              const auto &[s1, u1] = points[k + 1];
              const double l = s1 - s0, force = l * (u0 + u1) / 2.;
              const double moment = l * (s0 * (u0 + u1) / 2. + l * (u0 / 6. + u1 / 3.));
              sums[0] += dy * force;
              sums[1] += dy * (begin_of(y) * force + moment);
              sums[2] += dy * y * force;
            }
        }
    return sums;
  }

  class WaterUnderABank : public testing::TestWithParam<Patch>
  {
  protected:
    WaterUnderABank()
      : mesh(
          split_joints(read_gmsh_mesh(std::string(FUGA_SOURCE_DIR) + "/meshes/" + GetParam().mesh),
                       {{"joint", "joint", "upper", "lower", "", "", false}}))
    {
      // The joint of this mesh rises by 0.3 in x and by 0.2 in y.
      for (auto &[x, y, z] : mesh.vertices)
        {
          z += rise * y - 0.3 * (x - 1.5) - 0.2 * (y - 1.);
          x = begin_of(y) + length_of(y) * x / 3.;
        }
      model.dimension         = 3;
      model.polynomial_degree = GetParam().degree;
      for (const char *body : {"lower", "upper"})
        add_material(model, body, 3000., 0., 0.);
      refine(GetParam(), mesh, model);
      hold(model, "bottom", "xyz");
      for (const char *side : {"top", "front", "back", "left", "right"})
        hold(model, side, "");
      LoadDefinition load;
      load.name           = "uplift";
      load.kind           = LoadKind::uplift;
      load.targets        = {"joint"};
      load.depth.gradient = gamma_w;
      load.depth.level    = "7";
      model.loads.push_back(load);
    }

    Uplift &
    uplift()
    {
      return model.loads[0].uplift;
    }

    /** What is left of exactness: on hexahedra the lines of flow run along the cells; through
     * triangles they run obliquely. */
    double
    tolerance(const double of_hexahedra) const
    {
      return std::string(GetParam().mesh) == "patch_hex.msh" ? of_hexahedra : 2e-4;
    }

    /** Return Σ u, Σ u x, Σ u y of forces in a mesh that is turned about the vertical by an angle
     * with this cosine and sine. */
    static Sums
    sums_of(const Vector &forces,
            const std::vector<ContactElement> &elements,
            const double c = 1.,
            const double s = 0.)
    {
      Sums sums{};
      for (const ContactElement &element : elements)
        {
          const double force = forces[element.normal_bar];
          sums[0] += force;
          sums[1] += force * (c * element.position[0] + s * element.position[1]);
          sums[2] += force * (c * element.position[1] - s * element.position[0]);
        }
      return sums;
    }

    /** Compare the forces with integrals. Elements up to @p open_up_to of the way are open to the
     * reservoir, those from @p open_from on to the tailwater. */
    void
    compare(const Sums &expected,
            const double tolerance,
            const double open_up_to = 0.,
            const double open_from  = 1.)
    {
      const CondensedSystem<3> system(mesh, model, {false}, Condensation::with_loads);
      std::vector<WaterAccess> access;
      for (const ContactElement &element : system.elements())
        if (open_up_to > 0.)
          access.push_back(share_of(element) < open_up_to  ? WaterAccess::upstream
                           : share_of(element) > open_from ? WaterAccess::downstream
                                                           : WaterAccess::seepage);
      const double tailwater = uplift().has_tailwater ? std::stod(uplift().tailwater.level) : 0.;
      const Vector forces    = system.uplift(0).forces(access, {{7., tailwater}}).front();
      const Sums sums        = sums_of(forces, system.elements());
      for (std::size_t i = 0; i < sums.size(); ++i)
        EXPECT_NEAR(sums[i], expected[i], tolerance * expected[i]) << i;
    }

    /** Return the share of its way at which an element lies. */
    static double
    share_of(const ContactElement &element)
    {
      return (element.position[0] - begin_of(element.position[1])) / length_of(element.position[1]);
    }

    std::string
    message() const
    {
      const CondensedSystem<3> system(mesh, model, {false}, Condensation::with_loads);
      try
        {
          system.assemble_load(0, 0.);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    }

    static double
    head(const double y)
    {
      return gamma_w * (7. - height_of(y));
    }

    JointedMesh mesh;
    ModelDefinition model;
  };
} // namespace

TEST_P(WaterUnderABank, FallsToNothing)
{
  compare(integral([&](const double y) {
            return std::vector<std::array<double, 2>>{{{0., head(y)}}, {{length_of(y), 0.}}};
          }),
          tolerance(1e-12));
}

// The tailwater stands at 2.5: it reaches the joint where y < 1.
TEST_P(WaterUnderABank, FallsToATailwaterThatReachesAPartOfTheEnd)
{
  uplift().has_tailwater   = true;
  uplift().tailwater.level = "2.5";
  compare(integral(
            [&](const double y) {
              return std::vector<std::array<double, 2>>{
                {{0., head(y)}}, {{length_of(y), gamma_w * std::max(2.5 - height_of(y), 0.)}}};
            },
            {1.}),
          tolerance(1e-12));
}

// The drain runs parallel to the upstream end, at 0.7 in the direction of flow, across the cells of
// the hexahedra: their shape functions are rational along it.
TEST_P(WaterUnderABank, Drain)
{
  uplift().drain_distance   = 0.7;
  uplift().drain_efficiency = 0.6;
  compare(integral([&](const double y) {
            const double inside = 0.4 * (1. - 0.7 / length_of(y)) * head(y);
            return std::vector<std::array<double, 2>>{
              {{0., head(y)}}, {{0.7, inside}}, {{length_of(y), 0.}}};
          }),
          tolerance(1e-6));
}

TEST_P(WaterUnderABank, ProfileAtSharesOfTheWay)
{
  uplift().profile = {{{0., 1.}}, {{0.3, 0.2}}, {{1., 0.1}}};
  compare(
    integral([&](const double y) {
      const double l = length_of(y), u = head(y);
      return std::vector<std::array<double, 2>>{{{0., u}}, {{0.3 * l, 0.2 * u}}, {{l, 0.1 * u}}};
    }),
    tolerance(1e-12));
}

// The water enters and leaves along the oblique ends, however far from each other they are in x.
TEST_P(WaterUnderABank, EntersAlongTheEnds)
{
  CondensedSystem<3> system(mesh, model, {false}, Condensation::with_loads);
  system.set_load_patterns({system.assemble_load(0, 0.)});
  ASSERT_NE(system.water_in_joints(), nullptr);
  const WaterNetwork &network = system.water_in_joints()->network();
  for (std::size_t k = 0; k < system.elements().size(); ++k)
    {
      const double share = share_of(system.elements()[k]);
      EXPECT_EQ(network.upstream[k], share < 1e-9) << share;
      EXPECT_EQ(network.downstream[k], share > 1. - 1e-9) << share;
    }
}

INSTANTIATE_TEST_SUITE_P(Meshes, WaterUnderABank, all_patches());

namespace
{
  class OpenJointUnderABank : public WaterUnderABank
  {
  };
} // namespace

// Every line of flow has its own tips, half-way to the next element, and its own heads: all of the
// reservoir up to the one, that of the tailwater from the other on.
TEST_P(OpenJointUnderABank, FallsFromTipToTip)
{
  uplift().has_tailwater   = true;
  uplift().tailwater.level = "3.2";
  const CondensedSystem<3> system(mesh, model, {false}, Condensation::with_loads);
  std::vector<double> shares;
  for (const ContactElement &element : system.elements())
    shares.push_back(share_of(element));
  std::sort(shares.begin(), shares.end());
  shares.erase(std::unique(shares.begin(),
                           shares.end(),
                           [](const double a, const double b) { return b - a < 1e-9; }),
               shares.end());
  ASSERT_GE(shares.size(), 4u);
  const std::size_t n = shares.size();
  const double first = (shares[1] + shares[2]) / 2., last = (shares[n - 2] + shares[n - 1]) / 2.;
  compare(integral([&](const double y) {
            const double l = length_of(y), down = gamma_w * (3.2 - height_of(y));
            return std::vector<std::array<double, 2>>{
              {{0., head(y)}}, {{first * l, head(y)}}, {{last * l, down}}, {{l, down}}};
          }),
          1e-12,
          first,
          last);
}

// Lines run along the borders of elements. Whatever rounding makes of them in a mesh that is turned
// about the vertical, the water is the same.
TEST_P(OpenJointUnderABank, MayBeTurned)
{
  const auto vertices = mesh.vertices;
  std::vector<Sums> all_sums;
  for (unsigned int i = 0; i < 12; ++i)
    {
      const double c = std::cos(0.5 * i), s = std::sin(0.5 * i);
      mesh.vertices = vertices;
      for (auto &[x, y, z] : mesh.vertices)
        std::tie(x, y) = std::pair(c * x - s * y, s * x + c * y);
      uplift().flow = {{c, s, 0.}};
      const CondensedSystem<3> system(mesh, model, {false}, Condensation::with_loads);
      std::vector<WaterAccess> access;
      for (const ContactElement &element : system.elements())
        {
          const double x = c * element.position[0] + s * element.position[1],
                       y = c * element.position[1] - s * element.position[0];
          // Of the neighbours across the flow some are open.
          access.push_back(x - begin_of(y) < 0.4 * length_of(y) && y > 0.5 ? WaterAccess::upstream
                                                                           : WaterAccess::seepage);
        }
      const Vector forces = system.uplift(0).forces(access, {{7., 0.}}).front();
      all_sums.push_back(sums_of(forces, system.elements(), c, s));
    }
  for (const Sums &sums : all_sums)
    for (std::size_t i = 0; i < sums.size(); ++i)
      EXPECT_NEAR(sums[i], all_sums.front()[i], 1e-12 * all_sums.front()[i]) << i;
}

TEST_P(OpenJointUnderABank, SaysWhatIsNoWay)
{
  const auto vertices = mesh.vertices;
  // A gorge with upright walls.
  for (auto &[x, y, z] : mesh.vertices)
    z += 2000. * std::abs(y - 1.);
  expect_message(message(),
                 {"'uplift'", "'joint' stands upright beside", "(1, 0, 0)", "of its own"});
  // A bend in plan, which lines in y leave and enter again.
  mesh.vertices = vertices;
  for (auto &[x, y, z] : mesh.vertices)
    x += 6. * std::abs(y - 1.);
  uplift().flow = {{0., 1., 0.}};
  expect_message(message(), {"'uplift'", "(0, 1, 0)", "'joint'", "enter them again"});
  uplift().flow = {{1., 0., 0.}};
  EXPECT_EQ(message(), "");
  // A drain beyond the longest line.
  mesh.vertices           = vertices;
  uplift().drain_distance = 4.6;
  expect_message(message(), {"'uplift'", "drain", "4.6", "'joint'", "4.5"});
}

INSTANTIATE_TEST_SUITE_P(Meshes, OpenJointUnderABank, testing::Values(Patch{"patch_hex.msh", 1}));
