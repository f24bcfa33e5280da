// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_parts_of_bodies_h
#define fuga_tests_stress_parts_of_bodies_h

#include <cstddef>
#include <vector>

namespace fuga::stress
{
  /** Bodies by part, numbered anew from 0 such that parts of one body hang together: @p body is
   * that of each part before, @p neighbors are the parts beside it. */
  std::vector<std::size_t>
  number_bodies_of_parts(const std::vector<std::size_t> &body,
                         const std::vector<std::vector<std::size_t>> &neighbors);
} // namespace fuga::stress

#endif
