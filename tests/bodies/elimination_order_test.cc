// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/interruption.h>
#include <fuga/bodies/solvers/elimination_order.h>

#include <gtest/gtest.h>

#include <pthread.h>

#include <algorithm>
#include <chrono>
#include <csignal>
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

// METIS has a handler of its own for SIGTERM, and ends without an order when one comes: that of a
// batch system looked like a numerical failure. It takes some 0.3 s here.
TEST(EliminationOrder, KeepsSignalForTheRun)
{
  const Graph graph                  = grid(300);
  const std::vector<int> undisturbed = nested_dissection(graph);
  interruption::listen();
  std::thread batch_system([main = pthread_self()]() {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    pthread_kill(main, SIGTERM);
  });
  const std::vector<int> order = nested_dissection(graph);
  batch_system.join();
  EXPECT_EQ(interruption::signal_number(), SIGTERM);
  EXPECT_EQ(order, undisturbed);
  interruption::listen();
  for (const int number : {SIGINT, SIGTERM})
    std::signal(number, SIG_DFL);
}
