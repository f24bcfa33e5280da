// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/cycle_record.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <malloc.h>

namespace fuga::tests
{
  LoadHistory
  cyclic_history(const std::size_t n,
                 const Vector &first,
                 const Vector &second,
                 const Vector &begin)
  {
    std::vector<double> corners = {0., 1.};
    std::vector<Vector> values  = {Vector(begin.size(), 0.), begin};
    for (std::size_t i = 0; i < n; ++i)
      for (const Vector &value : {first, second})
        {
          corners.push_back(corners.back() + 1.);
          values.push_back(value);
        }
    return {corners, values};
  }

  std::vector<double>
  whole_numbers(const std::size_t n)
  {
    std::vector<double> result;
    for (std::size_t i = 1; i <= n; ++i)
      result.push_back(static_cast<double>(i));
    return result;
  }

  CycleRecord::CycleRecord(const ContactSystem &system,
                           const std::vector<ContactElement> &elements,
                           const LoadHistory &history)
    : judge(system, elements, history)
  {
  }

  void
  CycleRecord::advanced(const PathPoint &from, const PathPoint &to, const double length)
  {
    judge.follow(from, to, length);
  }

  void
  CycleRecord::jumped(const JointState &)
  {
    judge.lose_track();
  }

  void
  CycleRecord::changed(const std::vector<ContactEvent> &events, const JointState &state)
  {
    n_events_in_cycle += events.size();
    worst.absorb(judge.judge(state));
  }

  void
  CycleRecord::reached(const std::size_t index, const JointState &state)
  {
    worst.absorb(judge.judge(state));
    if (index % 2 != 0)
      return;
    const double total = judge.energies().dissipation;
    if (index > 0)
      {
        loss.push_back(total - loss_before);
        n_events.push_back(n_events_in_cycle);
        memory.push_back(mallinfo2().uordblks);
      }
    loss_before       = total;
    n_events_in_cycle = 0;
    if (index == 4)
      end_of_second = state;
    last = state;
  }

  void
  expect_steady_cycles(const CycleRecord &record,
                       const std::vector<ContactElement> &elements,
                       const double loss_scale,
                       const double advance)
  {
    const std::size_t n = record.loss.size();
    ASSERT_GE(n, 100u);
    EXPECT_LE(record.worst.worst(), 1e-9);
    EXPECT_NEAR(record.loss[n - 1], record.loss[1], 1e-9 * loss_scale);
    for (std::size_t i = 1; i < n; ++i)
      {
        ASSERT_NEAR(record.loss[i], record.loss[1], 1e-9 * loss_scale) << "cycle " << i + 1;
        ASSERT_EQ(record.n_events[i], record.n_events[1]) << "cycle " << i + 1;
      }

    // The load times of events near t = 2n + 1 are rounded to eps (2n + 1) of a stage: 2e-12.
    const JointState &early = record.end_of_second, &late = record.last;
    EXPECT_EQ(early.states, late.states);
    const double total = advance * static_cast<double>(n - 2);
    const double force = max_abs(early.forces), length = max_abs(late.dislocations);
    for (const ContactElement &element : elements)
      {
        EXPECT_NEAR(
          early.forces[element.normal_bar], late.forces[element.normal_bar], 1e-10 * force);
        EXPECT_NEAR(
          early.forces[element.tangential_bar], late.forces[element.tangential_bar], 1e-10 * force);
        EXPECT_NEAR(early.dislocations[element.tangential_bar] + total,
                    late.dislocations[element.tangential_bar],
                    1e-10 * length);
      }

    // Nothing grows: the bytes are those of this record, 32 per cycle, twice as much when its
    // vectors have just grown.
    EXPECT_LE(static_cast<double>(record.memory[n - 1]),
              static_cast<double>(record.memory[1]) + 100. * static_cast<double>(n) + 1e4);
  }
} // namespace fuga::tests
