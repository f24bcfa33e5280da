// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/dependent_rows.h>
#include <gtest/gtest.h>

using namespace fuga;

namespace
{
  DenseMatrix
  matrix(const std::vector<Vector> &rows)
  {
    DenseMatrix result(rows.size(), rows.front().size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < rows[i].size(); ++j)
        result(i, j) = rows[i][j];
    return result;
  }
} // namespace

// Three bodies meet at a point, their offsets being the coordinates: the jump between the second
// and the third is the difference of the others, whatever further coordinates there are. A row in
// more directions than there are others has no share, one of zeros vanishes by itself.
TEST(DependentRows, KnownByHand)
{
  EXPECT_EQ(dependent_rows(matrix({{1., 0., 0.}, {0., 1., 0.}, {-1., 1., 0.}, {0., 1., 1.}})),
            (std::vector<bool>{true, true, true, false}));
  EXPECT_EQ(dependent_rows(matrix({{1., 0., 2.}, {0., 3., 0.}})),
            (std::vector<bool>{false, false}));
  EXPECT_EQ(dependent_rows(matrix({{1., 1.}, {0., 0.}, {2., 1.}})),
            (std::vector<bool>{false, true, false}));
  EXPECT_EQ(dependent_rows(matrix({{1.}, {-2.}})), (std::vector<bool>{true, true}));
}
