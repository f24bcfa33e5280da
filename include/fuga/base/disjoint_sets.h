// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_disjoint_sets_h
#define fuga_base_disjoint_sets_h

#include <algorithm>
#include <numeric>
#include <vector>

namespace fuga
{
  /** Union-find structure that keeps track of which items are connected. */
  class DisjointSets
  {
  public:
    explicit DisjointSets(const std::size_t size) : parent(size)
    {
      std::iota(parent.begin(), parent.end(), 0U);
    }

    unsigned int
    find(unsigned int i)
    {
      while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
      return i;
    }

    void
    unite(const unsigned int i, const unsigned int j)
    {
      const unsigned int a = find(i), b = find(j);
      parent[std::max(a, b)] = std::min(a, b);
    }

    /** Set @p numbers to consecutive numbers of the sets and return the number of sets. */
    unsigned int
    number(std::vector<unsigned int> &numbers)
    {
      unsigned int count = 0;
      numbers.resize(parent.size());
      for (unsigned int i = 0; i < parent.size(); ++i)
        numbers[i] =
          parent[i] == i ? count++ : numbers[find(i)]; // a root is the smallest of its set
      return count;
    }

  private:
    std::vector<unsigned int> parent;
  };
} // namespace fuga

#endif
