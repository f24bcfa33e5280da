// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/water_in_joints.h>

namespace fuga
{
  std::vector<bool>
  connected(const WaterNetwork &network,
            const std::vector<bool> &open,
            const std::vector<bool> &ends)
  {
    std::vector<bool> reached(open.size(), false);
    std::vector<std::size_t> front;
    const auto reach = [&](const std::size_t k) {
      if (!open[k] || reached[k])
        return;
      reached[k] = true;
      front.push_back(k);
    };
    for (std::size_t k = 0; k < open.size(); ++k)
      if (ends[k])
        reach(k);
    while (!front.empty())
      {
        const std::size_t k = front.back();
        front.pop_back();
        for (const std::size_t neighbour : network.neighbours[k])
          reach(neighbour);
      }
    return reached;
  }
} // namespace fuga
