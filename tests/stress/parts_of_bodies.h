// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_parts_of_bodies_h
#define fuga_tests_stress_parts_of_bodies_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace fuga::stress
{
  /** Two vertices, lower number first. */
  using Edge = std::array<std::size_t, 2>;

  /** From corner number @p i to the next one of corners that go round. */
  Edge
  edge(const std::vector<std::size_t> &corners, const std::size_t i);

  /** Bodies by part, numbered anew from 0 such that parts of one body hang together: @p body is
   * that of each part before, @p neighbors are the parts beside it. */
  std::vector<std::size_t>
  number_bodies_of_parts(const std::vector<std::size_t> &body,
                         const std::vector<std::vector<std::size_t>> &neighbors);

  /** The same of parts that know their body. A body that a cut leaves in several pieces becomes
   * several bodies. */
  template <typename Part>
  void
  number_bodies(std::vector<Part> &parts, const std::vector<std::vector<std::size_t>> &neighbors)
  {
    std::vector<std::size_t> body;
    for (const Part &part : parts)
      body.push_back(part.body);
    const std::vector<std::size_t> number = number_bodies_of_parts(body, neighbors);
    for (std::size_t p = 0; p < parts.size(); ++p)
      parts[p].body = number[p];
  }

  template <typename Part>
  std::size_t
  number_of_bodies(const std::vector<Part> &parts)
  {
    std::size_t result = 0;
    for (const Part &part : parts)
      result = std::max(result, part.body + 1);
    return result;
  }
} // namespace fuga::stress

#endif
