// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/parts_of_bodies.h"

namespace fuga::stress
{
  Edge
  edge(const std::vector<std::size_t> &corners, const std::size_t i)
  {
    const std::size_t a = corners[i], b = corners[(i + 1) % corners.size()];
    return {{std::min(a, b), std::max(a, b)}};
  }

  std::vector<std::size_t>
  number_bodies_of_parts(const std::vector<std::size_t> &body,
                         const std::vector<std::vector<std::size_t>> &neighbors)
  {
    const std::size_t unseen = body.size();
    std::vector<std::size_t> number(body.size(), unseen);
    std::size_t n = 0;
    for (std::size_t p = 0; p < body.size(); ++p)
      {
        if (number[p] != unseen)
          continue;
        std::vector<std::size_t> waiting = {p};
        number[p]                        = n;
        while (!waiting.empty())
          {
            const std::size_t at = waiting.back();
            waiting.pop_back();
            for (const std::size_t q : neighbors[at])
              if (number[q] == unseen && body[q] == body[at])
                {
                  number[q] = n;
                  waiting.push_back(q);
                }
          }
        ++n;
      }
    return number;
  }
} // namespace fuga::stress
