// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Cells divided among processes: parts of equal size, also of more processes than cells; a strip is
// cut across.

#include "block_mesh.h"

#include <fuga/bodies/cell_owners.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::test;

TEST(CellOwners, EqualParts)
{
  BlockMesh strip;
  strip.add_block("strip",
                  12,
                  2,
                  [](double s, double r) {
                    return std::array<double, 2>{{6. * s, r}};
                  },
                  {{"", "", "", ""}});
  const Discretization<2> space(strip.mesh, ModelDefinition());
  ASSERT_EQ(space.n_cells(), 24u);
  for (const unsigned int n : {1u, 2u, 3u, 5u, 7u, 24u, 31u})
    {
      const std::vector<unsigned int> owners = cell_owners(space, n);
      ASSERT_EQ(owners.size(), 24u);
      std::vector<unsigned int> count(n, 0);
      for (const unsigned int owner : owners)
        ++count.at(owner);
      // Every cut in two rounds once.
      const double cuts = std::ceil(std::log2(n));
      for (const unsigned int of_one : count)
        EXPECT_LT(std::abs(of_one - 24. / n), 1. + cuts / 2.) << n;
    }
  const std::vector<unsigned int> halves = cell_owners(space, 2);
  for (std::size_t cell = 0; cell < space.n_cells(); ++cell)
    EXPECT_EQ(halves[cell], space.position(space.cell_nodes(cell)[0])[0] < 3. - 1e-9 ? 0u : 1u);
}
