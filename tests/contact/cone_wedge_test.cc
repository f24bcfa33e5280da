// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/cone_toy.h"

#include <cmath>

namespace fuga::tests
{
  namespace
  {
    using Point = std::array<double, 3>;

    Point
    combine(const double a, const Point &x, const double b, const Point &y)
    {
      return {{a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2]}};
    }

    Point
    cross(const Point &a, const Point &b)
    {
      return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
    }

    double
    inner(const Point &a, const Point &b)
    {
      return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    /**
     * A floating wedge on two planes that dip by 40 to 69 degrees to either side of their line of
     * intersection, which plunges by 23 to 52. Elements lie on the line, one of each plane at every
     * place, and at random places on the planes; Boussinesq's compliance 1/(r + a) joins them.
     * Load 0 is the weight.
     */
    ToySystem
    random_wedge(const std::size_t n, std::mt19937 &generator)
    {
      const auto pick = [&](const double a, const double b) {
        return std::uniform_real_distribution<double>(a, b)(generator);
      };
      const auto is_on_line = [n](const std::size_t k) { return k % (n / 2) < n / 8; };
      // As rigid joints that cross get it (joint_model.h).
      constexpr double crossing_compliance = 1e-4;
      const double plunge                  = pick(0.4, 0.9);
      const Point line                     = {{std::cos(plunge), 0., -std::sin(plunge)}};
      const Point up = {{std::sin(plunge), 0., std::cos(plunge)}}, side = {{0., 1., 0.}};
      std::vector<Point> points;
      DenseMatrix directions(3 * n, 3), G(3 * n, 6);
      for (int plane = 0; plane < 2; ++plane)
        {
          const double dip = pick(0.7, 1.2), sign = plane == 0 ? 1. : -1.;
          const Point outwards = combine(sign * std::cos(dip), side, std::sin(dip), up);
          const Point normal   = combine(-sign * std::sin(dip), side, std::cos(dip), up);
          const std::array<Point, 3> frame = {{normal, line, cross(normal, line)}};
          for (std::size_t k = plane * (n / 2); k < (plane == 0 ? n / 2 : n); ++k)
            {
              const double along =
                is_on_line(k) ? 0.3 * static_cast<double>(k % (n / 2)) : pick(0., 2.);
              points.push_back(combine(along, line, is_on_line(k) ? 0. : pick(0.1, 1.), outwards));
              for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = 0; j < 3; ++j)
                  {
                    Point axis               = {{0., 0., 0.}};
                    axis[j]                  = 1.;
                    directions(3 * k + i, j) = frame[i][j];
                    G(3 * k + i, j)          = frame[i][j];
                    G(3 * k + i, 3 + j)      = inner(frame[i], cross(axis, points[k]));
                  }
            }
        }
      const std::size_t m = 3 * n;
      DenseMatrix C(m, m), S(m, m);
      constexpr double radius = 0.1;
      for (std::size_t i = 0; i < m; ++i)
        {
          S(i, i) = 1.;
          for (std::size_t j = 0; j < m; ++j)
            {
              const Point apart = combine(1., points[i / 3], -1., points[j / 3]);
              double cosine     = 0.;
              for (std::size_t a = 0; a < 3; ++a)
                cosine += directions(i, a) * directions(j, a);
              C(i, j) = cosine / (std::sqrt(inner(apart, apart)) + radius);
            }
          if (is_on_line(i / 3))
            C(i, i) *= 1. + crossing_compliance;
        }
      EXPECT_TRUE(solve_positive_definite(C, S));

      // S - S G (Gᵀ S G)⁻¹ Gᵀ S resists no rigid motion; S G (Gᵀ S G)⁻¹ L carries the weight.
      const DenseMatrix S_G = multiply(S, G);
      DenseMatrix G_S_G     = multiply_transposed(G, S_G), shares(6, m + 1), L(6, 1);
      const Point middle    = {{pick(0.6, 1.), 0., 0.5}};
      L(2, 0)               = -1.;
      L(3, 0)               = -middle[1];
      L(4, 0)               = middle[0];
      for (std::size_t i = 0; i < 6; ++i)
        {
          shares(i, m) = L(i, 0);
          for (std::size_t j = 0; j < m; ++j)
            shares(i, j) = S_G(j, i);
        }
      EXPECT_TRUE(solve_positive_definite(G_S_G, shares));
      const DenseMatrix change = multiply(S_G, shares);
      ToySystem system;
      system.S = S;
      system.F = DenseMatrix(m, 1);
      for (std::size_t i = 0; i < m; ++i)
        {
          system.F(i, 0) = change(i, m);
          for (std::size_t j = 0; j < m; ++j)
            system.S(i, j) -= 0.5 * (change(i, j) + change(j, i));
        }
      system.motions      = G;
      system.motion_loads = L;
      return system;
    }
    /** A rigid wedge on two planes, its line of intersection plunging steeply; loads: the weight,
     * and water that presses on both planes. */
    struct RigidWedge
    {
      static constexpr std::size_t n_on_plane = 6;
      static constexpr double weight          = 10.;
      const double plunge;
      const std::array<double, 2> dips, thrusts;
      std::array<Point, 2> normals;
      ToySystem system;

      RigidWedge(const double line_plunges,
                 const std::array<double, 2> &planes_dip,
                 const std::array<double, 2> &water)
        : plunge(line_plunges), dips(planes_dip), thrusts(water)
      {
        const Point line   = {{std::cos(plunge), 0., -std::sin(plunge)}};
        const Point side   = {{0., 1., 0.}};
        system.S           = DenseMatrix(6, 6);
        system.B           = DenseMatrix(6 * n_on_plane, 6);
        system.F           = DenseMatrix(6, 2);
        const Point middle = combine(1., line, 0.7, up());
        system.F(2, 0)     = -weight;
        system.F(3, 0)     = -weight * middle[1];
        system.F(4, 0)     = weight * middle[0];
        for (std::size_t plane = 0; plane < 2; ++plane)
          {
            const double dip = dips[plane], sign = plane == 0 ? 1. : -1.;
            normals[plane]       = combine(-sign * std::sin(dip), side, std::cos(dip), up());
            const Point outwards = combine(sign * std::cos(dip), side, std::sin(dip), up());
            const std::array<Point, 3> frame = {
              {normals[plane], line, cross(normals[plane], line)}};
            for (std::size_t k = 0; k < n_on_plane; ++k)
              {
                const Point x = combine(
                  0.5 + 0.5 * static_cast<double>(k % 3), line, k < 3 ? 0.2 : 1.2, outwards);
                const auto row  = 3 * (plane * n_on_plane + k);
                const Point arm = cross(x, normals[plane]);
                for (std::size_t j = 0; j < 3; ++j)
                  {
                    Point axis = {{0., 0., 0.}};
                    axis[j]    = 1.;
                    for (std::size_t i = 0; i < 3; ++i)
                      {
                        system.B(row + i, j)     = frame[i][j];
                        system.B(row + i, 3 + j) = inner(frame[i], cross(axis, x));
                      }
                    const double share = thrusts[plane] / n_on_plane;
                    system.F(j, 1) += share * normals[plane][j];
                    system.F(3 + j, 1) += share * arm[j];
                  }
              }
          }
        system.motions      = system.B;
        system.motion_loads = system.F;
      }

      Point
      up() const
      {
        return {{std::sin(plunge), 0., std::cos(plunge)}};
      }

      /** E. Hoek, J. W. Bray, Rock Slope Engineering: slip along the line of intersection, no shear
       * across it. @p cohesion: force on both planes together. */
      double
      factor_of_safety(const double friction, const double cohesion) const
      {
        const double sine   = std::sin(dips[0] + dips[1]);
        const double normal = weight * std::cos(plunge);
        const double N_a    = normal * std::sin(dips[1]) / sine - thrusts[0];
        const double N_b    = normal * std::sin(dips[0]) / sine - thrusts[1];
        return (friction * (N_a + N_b) + cohesion) / (weight * std::sin(plunge));
      }
    };
  } // namespace

  // Friction, cohesion and water; the strength is reduced until the wedge slides. Across the line
  // of intersection the joint shears by what the wedge is pressed into the groove, k_t/k_n of the
  // pressure. That turns into the direction of slip as slips grow without bounds; at the limit none
  // is left, whatever the stiffness, and the path ends 1e-8 of the load before.
  TEST(ConeWedge, FactorOfSafetyIsThatOfHoekAndBray)
  {
    for (const double shear_compliance : {1e-3, 100.})
      for (const double cohesion : {0., 3.})
        for (const double water : {0., 1.})
          {
            SCOPED_TRACE(testing::Message()
                         << shear_compliance << ", cohesion " << cohesion << ", water " << water);
            const RigidWedge wedge(0.7, {{0.8, 1.}}, {{water, 0.5 * water}});
            constexpr double friction = 1.1;
            constexpr std::size_t n   = 2 * RigidWedge::n_on_plane;
            ConeJoint joint(
              n, 0.5, make_linear_law(1e-3), make_linear_law(shear_compliance), friction);
            for (ContactElement &element : joint.elements)
              {
                element.friction.cohesion = cohesion / (n * element.area);
                element.friction.reduced  = true;
              }
            const LoadHistory history(
              {0., 1., 2., 3.}, {{0., 0.}, {1., 0.}, {1., 1.}, {1., 1.}}, {1., 1., 1., 0.2});
            const ConeRun run(wedge.system, joint.elements, history, {1., 2.});
            EXPECT_EQ(run.result.verdict, Verdict::limit_load);
            EXPECT_EQ(run.result.mechanism, MechanismKind::sliding);
            const double factor = 1. / history.strength_share(run.result.t);
            const double below  = 1. - factor / wedge.factor_of_safety(friction, cohesion);
            EXPECT_GT(below, 0.);
            EXPECT_LT(below, 1e-8);
            EXPECT_LT(run.record.worst.worst(), 1e-9);
          }
  }

  // The virgin state of rigid joints with a friction of 0.9 is one rate problem at the apex of all
  // cones. Newton's method alone, from soft layers and with sweeps, leaves eight of these forty
  // unsolved. The judge knows nothing of the rate problem: its equilibrium is the proof.
  TEST(ConeWedge, StandsOnRigidJoints)
  {
    for (unsigned int seed = 1; seed <= 40; ++seed)
      {
        SCOPED_TRACE(seed);
        std::mt19937 generator(seed);
        const std::size_t n    = 30;
        const ToySystem system = random_wedge(n, generator);
        const ConeJoint joint(n, 1., make_rigid_law(), make_rigid_law(), 0.9);
        const ConeRun run(system, joint.elements, LoadHistory({0., 1.}, {{0.}, {1.}}), {1.});
        EXPECT_EQ(run.result.verdict, Verdict::done);
        // The default bound of a run.
        EXPECT_LT(run.record.worst.worst(), 1e-9);
      }
  }
} // namespace fuga::tests
