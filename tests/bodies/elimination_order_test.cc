// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/solvers/elimination_order.h>

#include <gtest/gtest.h>

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <future>
#include <thread>

using namespace fuga;

namespace
{
  /** Of n × n squares. */
  Graph
  grid(const int n)
  {
    Graph graph;
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x)
        {
          for (int v = std::max(0, y - 1); v <= std::min(n, y + 1); ++v)
            for (int u = std::max(0, x - 1); u <= std::min(n, x + 1); ++u)
              if (u != x || v != y)
                graph.neighbours.push_back(v * (n + 1) + u);
          graph.start.push_back(static_cast<int>(graph.neighbours.size()));
        }
    return graph;
  }
} // namespace

// METIS_NodeND() has a handler of its own for SIGTERM and leaves by longjmp() when one comes, the
// worse the more unlucky the moment: a batch system's SIGTERM was a numerical failure, or freed
// memory twice. Signals come all along; an order takes some 0.3 s here.
TEST(EliminationOrder, LeavesSignalsToTheRun)
{
  const Graph graph                  = grid(300);
  const std::vector<int> undisturbed = nested_dissection(graph);
  static std::atomic<int> n_heard;
  n_heard = 0;
  std::signal(SIGTERM, [](int) { ++n_heard; });
  std::vector<int> order;
  {
    std::atomic<bool> is_ordered = false;
    const auto batch_system =
      std::async(std::launch::async, [&is_ordered, main = pthread_self()]() {
        while (!is_ordered)
          {
            pthread_kill(main, SIGTERM);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
          }
      });
    EXPECT_NO_THROW(order = nested_dissection(graph));
    is_ordered = true;
  }
  std::signal(SIGTERM, SIG_DFL);
  EXPECT_GT(n_heard, 10);
  EXPECT_EQ(order, undisturbed);
}
