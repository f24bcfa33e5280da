// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Forces of joints that are softer than the bodies in one direction.

#include "contact/toy_system.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::tests;

// A block on three elements, soft across the joint and stiff along it, whose nodes lie e, -2e and e
// off the line: as it tilts, their lips move by as much along the joint. That a tilt is resisted
// across the joint only is right but for this, and that is worth s e D ΔN = 3e-9 of the forces. The
// body has the stiffness s against all that is orthogonal to the orthonormal motions m, so that
// its equations are s (x - Σ m m·x) + p = F with x = D p.
TEST(SoftBars, JointThatIsNotQuiteStraight)
{
  constexpr double e = 1e-10, s = 65., D_n = 0.27, D_t = 1e-11;
  const double third = std::sqrt(1. / 3.), half = std::sqrt(0.5);
  const Vector motions[] = {{third, 0., third, 0., third, 0.},
                            {0., third, 0., third, 0., third},
                            {-half, half * e, 0., -2. * half * e, half, half * e}};
  const Vector load      = {-1., 0.3, 0.5, 0.2, 1., 0.};
  const ToyJoint joint(3, 1., make_linear_law(D_n), make_linear_law(D_t), {0.5, 0.});
  ToySystem system;
  system.S            = DenseMatrix(6, 6);
  system.F            = DenseMatrix(6, 1);
  system.motions      = DenseMatrix(6, 3);
  system.motion_loads = DenseMatrix(3, 1);
  for (std::size_t i = 0; i < 6; ++i)
    {
      system.F(i, 0) = load[i];
      system.S(i, i) = s;
      for (std::size_t k = 0; k < 3; ++k)
        {
          system.motions(i, k) = motions[k][i];
          system.motion_loads(k, 0) += motions[k][i] * load[i];
          for (std::size_t j = 0; j < 6; ++j)
            system.S(i, j) -= s * motions[k][i] * motions[k][j];
        }
    }
  const LayeredSystem layered(system, joint.elements);
  const Vector p = layered.forces({1.}, Vector(6, 0.), {});

  Vector x(6), deformation(6);
  for (std::size_t i = 0; i < 6; ++i)
    x[i] = deformation[i] = (i % 2 == 0 ? D_n : D_t) * p[i];
  for (const Vector &motion : motions)
    {
      double share = 0.;
      for (std::size_t i = 0; i < 6; ++i)
        share += motion[i] * x[i];
      for (std::size_t i = 0; i < 6; ++i)
        deformation[i] -= share * motion[i];
    }
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(p[i], load[i] - s * deformation[i], 1e-13) << i;
}

namespace
{
  /** A bar of the stiffness k = 1e9 between two coordinates, the last digits of which elimination
   * has left wrong, on springs of stiffness one: two at its first end, one at the other. */
  class BarOnThreeSprings : public ToySystem
  {
  public:
    static constexpr double k = 1e9;

    BarOnThreeSprings()
    {
      S       = DenseMatrix(2, 2);
      S(0, 0) = k;
      S(0, 1) = S(1, 0) = -k;
      S(1, 1)           = k * (1. + 1e-15);
      F                 = DenseMatrix(2, 1);
      F(1, 0)           = 1.;
      B                 = DenseMatrix(3, 2);
      B(0, 0) = B(1, 1) = B(2, 0) = 1.;
      motions                     = DenseMatrix(3, 1);
      motions(0, 0) = motions(1, 0) = motions(2, 0) = 1.;
      motion_loads                                  = DenseMatrix(1, 1);
      motion_loads(0, 0)                            = 1.;
      coordinates                                   = DenseMatrix(2, 1);
      coordinates(0, 0) = coordinates(1, 0) = 1.;
    }

    const DenseMatrix &
    rigid_coordinates() const override
    {
      return coordinates;
    }

  private:
    DenseMatrix coordinates;
  };
} // namespace

// Dislocations that let the body move as it is press nothing: W d = 0, although S answers such a
// motion with 1e-6. Of a dislocation at the first end alone, or a load at the other, the springs
// take, by hand, from k (x1 - x2) + 2 p1 = 0, p1 = x1 - d1, p2 = x2 and p2 = L - 2 p1.
TEST(SoftBars, RigidMotionOfABodyOnMoreBarsThanCoordinates)
{
  const BarOnThreeSprings system;
  const std::unique_ptr<ComplianceLaw> spring = make_linear_law(1.);
  std::vector<ContactElement> elements(3);
  for (unsigned int i = 0; i < 3; ++i)
    {
      elements[i].normal_bar = i;
      elements[i].number     = i;
      elements[i].area       = 1.;
      elements[i].normal_law = spring.get();
    }
  const LayeredSystem layered(system, elements);
  const auto response = [&](const Vector &d) {
    Vector p(3, 0.);
    layered.subtract_response(d, p);
    return p;
  };
  constexpr double rounding = 1e-14, k = BarOnThreeSprings::k;
  for (const double p : response({1., 1., 1.}))
    EXPECT_NEAR(p, 0., rounding);
  const double x2 = 2. / (3. + 2. / k);
  const Vector p  = response({1., 0., 1.});
  EXPECT_NEAR(p[0], -0.5 * x2, rounding);
  EXPECT_NEAR(p[1], x2, rounding);
  EXPECT_NEAR(p[2], -0.5 * x2, rounding);
  const double x1 = 1. / (3. + 2. / k);
  for (const std::size_t bar : {0, 2})
    EXPECT_NEAR(layered.reactions()(bar, 0), x1, rounding);
  EXPECT_NEAR(layered.reactions()(1, 0), x1 * (1. + 2. / k), rounding);
}
