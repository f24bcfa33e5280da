// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/disjoint_sets.h>
#include <fuga/bodies/condensed/blocks_of_bars.h>

#include <optional>

namespace fuga
{
  std::vector<BlockOfCoordinates>
  blocks_of_bars(const std::vector<ContactElement> &elements,
                 const std::vector<ElementStiffness> &stiffness,
                 const SparseOperator &B,
                 const std::size_t n_coordinates)
  {
    DisjointSets sets(n_coordinates);
    for (const ContactElement &element : elements)
      {
        std::optional<std::size_t> first;
        for (std::size_t i = 0; i < element.n_bars(); ++i)
          B.for_each_in_row(element.bar(i), [&](const std::size_t c, double) {
            first = first.value_or(c);
            sets.unite(static_cast<unsigned int>(*first), static_cast<unsigned int>(c));
          });
      }
    std::vector<unsigned int> number;
    std::vector<BlockOfCoordinates> blocks(sets.number(number));
    std::vector<std::size_t> place;
    for (std::size_t c = 0; c < n_coordinates; ++c)
      {
        std::vector<int> &coordinates = blocks[number[c]].coordinates;
        place.push_back(coordinates.size());
        coordinates.push_back(static_cast<int>(c));
      }
    for (BlockOfCoordinates &block : blocks)
      block.stiffness = DenseMatrix(block.coordinates.size(), block.coordinates.size());
    for (std::size_t k = 0; k < elements.size(); ++k)
      for (std::size_t i = 0; i < elements[k].n_bars(); ++i)
        for (std::size_t j = 0; j < elements[k].n_bars(); ++j)
          B.for_each_in_row(elements[k].bar(i), [&](const std::size_t c, const double left) {
            B.for_each_in_row(elements[k].bar(j), [&](const std::size_t d, const double right) {
              blocks[number[c]].stiffness(place[c], place[d]) += left * stiffness[k][i][j] * right;
            });
          });
    return blocks;
  }
} // namespace fuga
