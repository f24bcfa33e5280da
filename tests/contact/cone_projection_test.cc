// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/cone_projection.h>
#include <gtest/gtest.h>

using namespace fuga;

// In the plane: the cone x + y = 0 is a line; the quadrant leaves of (1, -2) the first component,
// of (-1, -2) nothing; between the faces y >= 0 and x >= y the point next to (-1, 3) is that on the
// second, (1, 1).
TEST(ConeProjection, KnownByHand)
{
  DenseMatrix none(0, 2), sum(1, 2), quadrant(2, 2), wedge(2, 2);
  sum(0, 0) = sum(0, 1) = 1.;
  quadrant(0, 0) = quadrant(1, 1) = 1.;
  wedge(0, 1) = wedge(1, 0) = 1.;
  wedge(1, 1)               = -1.;
  const auto expect         = [](const Vector &found, const Vector &known) {
    for (std::size_t i = 0; i < known.size(); ++i)
      EXPECT_NEAR(found.at(i), known[i], 1e-14);
  };
  expect(nearest_in_cone(none, none, {3., 4.}), {3., 4.});
  expect(nearest_in_cone(sum, none, {3., 1.}), {1., -1.});
  expect(nearest_in_cone(none, quadrant, {1., -2.}), {1., 0.});
  expect(nearest_in_cone(none, quadrant, {-1., -2.}), {0., 0.});
  expect(nearest_in_cone(none, wedge, {-1., 3.}), {1., 1.});
  expect(nearest_in_cone(sum, quadrant, {3., 1.}), {0., 0.});
}
