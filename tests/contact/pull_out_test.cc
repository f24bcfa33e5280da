// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// V5: the bar as a chain of springs on nodes with one contact element each.

#include "contact/pull_out_bar.h"
#include "known_answer.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  constexpr const char *problem     = "V5 pull-out of a bar";
  constexpr const char *closed_form = "closed form";

  /** Keeps the losses at the requested loads as well. */
  class LossRecord : public Record
  {
  public:
    using Record::Record;
    std::vector<double> loss;

    void
    reached(const std::size_t index, const JointState &state) override
    {
      Record::reached(index, state);
      loss.push_back(judge.energies().dissipation);
    }
  };
} // namespace

// P(a) of a bar of finite length, node by node, by the closed form of the chain; full slip at P =
// qL is the limit load, by equilibrium. A hundred events, each from a few hundred numbers of order
// one: 1e-11.
TEST(PullOut, FrontOfFiniteBar)
{
  const std::size_t n = 100;
  const double length = 50.;
  const PullOutBar bar(n, length);
  const LayeredSystem layered(bar.system, bar.joint.elements);
  const double limit = PullOutBar::q * length;
  const LoadHistory history({0., 1., 2.}, {{0., 0.}, {1., 0.}, {1., 1.25 * limit}});
  EventPath path(bar.joint.elements, layered, history, {});
  Record record(bar.system, bar.joint.elements, history);
  const PathResult result = path.run({1., 2.}, record);

  EXPECT_LE(record.worst.worst(), 1e-12);
  EXPECT_EQ(result.verdict, Verdict::limit_load);
  EXPECT_EQ(result.mechanism, MechanismKind::sliding);
  expect_answer({problem, "full slip of a bar of length 50, P", limit, "equilibrium, qL"},
                1.25 * limit * (result.t - 1.),
                1e-11 * limit);
  ASSERT_EQ(record.events.size(), n + 1);
  for (std::size_t j = 0; j <= n; ++j)
    {
      const double pull = 1.25 * limit * (record.events[j].t - 1.);
      EXPECT_EQ(record.events[j].element, j);
      EXPECT_NEAR(pull, bar.pull_of_front(j), 1e-11 * limit) << j;
      // The continuous bar, P = q[a + tanh(λ(L-a))/λ]. In the chain 1/λ becomes sinh μ/(λ²h) =
      // √(1 + (λh)²/4)/λ: larger by λh²/8 = 2.0e-3 (the change of the tanh is below 1e-4).
      const double a = static_cast<double>(j) * bar.h, lambda = PullOutBar::lambda();
      const double continuous = PullOutBar::q * (a + std::tanh(lambda * (length - a)) / lambda);
      if (j > 0)
        {
          EXPECT_NEAR(pull, continuous, 2.1e-3 * PullOutBar::q) << j;
        }
      if (j == n / 2)
        expect_answer({problem, "P when half of that bar slips, n = 100", continuous, closed_form},
                      pull,
                      2.1e-3 * PullOutBar::q);
    }
}

namespace
{
  // First loading to P0 = 3 P_e, then one cycle ±P0, L = 200 (nearly infinite: the far end moves by
  // e^{-10}). Closed forms: u0 = P²/(2 EA q) + q/(2k), a = P/q - 1/λ, W; first loading loses W/4.
  // The chain differs from the continuous bar by the errors of W that an independent code finds for
  // the chain (tests/scenes/reference; 7.6e-4, 3.3e-4, 5.8e-5, 2.2e-5: half a unit of the last
  // digit); u0 by terms of order (λh)²/8 of q/2k and the position of the front within its element,
  // again quadratic: (λh)²; a by the distance of the nodes.
  void
  expect_losses(const std::size_t n, const double printed_error)
  {
    const double P0 = 3. * PullOutBar::first_slip(), W = PullOutBar::loss_per_cycle(P0);
    EXPECT_NEAR(W, 210.8185, 0.5e-4);
    const double q = PullOutBar::q, lambda = PullOutBar::lambda();
    const double a  = P0 / q - 1. / lambda;
    const double u0 = P0 * P0 / (2. * PullOutBar::EA * q) + q / (2. * PullOutBar::k);
    EXPECT_NEAR(a, 31.6228, 0.5e-4);
    EXPECT_NEAR(u0, 2.5, 1e-14);
    const PullOutBar bar(n, 200.);
    const LayeredSystem layered(bar.system, bar.joint.elements);
    const LoadHistory history({0., 1., 2., 3., 4.},
                              {{0., 0.}, {1., 0.}, {1., P0}, {1., -P0}, {1., P0}});
    EventPath path(bar.joint.elements, layered, history, {});
    LossRecord record(bar.system, bar.joint.elements, history);
    EXPECT_EQ(path.run({1., 2., 3., 4.}, record).verdict, Verdict::done);
    EXPECT_LE(record.worst.worst(), 1e-12);

    const double loss      = record.loss[3] - record.loss[1];
    const double digit     = std::pow(10., std::floor(std::log10(printed_error)) - 1.);
    const double tolerance = printed_error + 0.5 * digit;
    EXPECT_NEAR(loss / W - 1., printed_error, 0.5 * digit);
    expect_answer(
      {problem, fmt::format("W per cycle, n = {}", n), W, closed_form}, loss, tolerance * W);
    expect_answer(
      {problem, fmt::format("loss of the first loading, n = {}", n), W / 4., closed_form},
      record.loss[1],
      tolerance * W / 4.);
    // Masing: both halves of the cycle lose the same, and the first loading a quarter, in the
    // chain as well; roundings of a few hundred terms.
    EXPECT_NEAR(record.loss[2] - record.loss[1], 0.5 * loss, 1e-12 * W);
    EXPECT_NEAR(record.loss[1], 0.25 * loss, 1e-12 * W);
    const Vector jumps = layered.jumps(record.levels[1].dislocations, record.levels[1].forces);
    expect_answer({problem, fmt::format("u0 at 3 P_e, n = {}", n), u0, closed_form},
                  jumps[1],
                  u0 * lambda * lambda * bar.h * bar.h);
    std::size_t n_slipping = 0;
    for (const ContactState state : record.levels[1].states)
      n_slipping += is_slipping(state) ? 1 : 0;
    expect_answer({problem, fmt::format("slip length a at 3 P_e, n = {}", n), a, closed_form},
                  (static_cast<double>(n_slipping) - 0.5) * bar.h,
                  0.5 * bar.h);
  }
} // namespace

TEST(PullOut, LossPerCycleConverges)
{
  expect_losses(100, 7.6e-4);
  expect_losses(200, 3.3e-4);
}

TEST(LargePullOut, LossPerCycleConverges)
{
  expect_losses(400, 5.8e-5);
  expect_losses(800, 2.2e-5);
}

// Every reversal re-sticks all bars at once, at its very load, and nothing slips back before the
// pull has fallen by 2 P_e (Masing): exact for the chain with its own P_e, pull_of_front(0).
TEST(PullOut, ReversalSticksAllAtOnce)
{
  const PullOutBar bar(200, 200.);
  const double P0 = 3. * PullOutBar::first_slip();
  const LayeredSystem layered(bar.system, bar.joint.elements);
  const LoadHistory history({0., 1., 2., 3., 4.},
                            {{0., 0.}, {1., 0.}, {1., P0}, {1., -P0}, {1., P0}});
  EventPath path(bar.joint.elements, layered, history, {});
  Record record(bar.system, bar.joint.elements, history);
  path.run({2., 3.}, record);
  for (const std::size_t level : {0u, 1u})
    {
      std::size_t n_slipping = 0, n_restuck = 0;
      for (const ContactState state : record.levels[level].states)
        n_slipping += is_slipping(state) ? 1 : 0;
      const double corner = 2. + static_cast<double>(level);
      double next         = corner + 1.;
      for (const ContactEvent &event : record.events)
        if (event.t == corner)
          {
            EXPECT_TRUE(is_slipping(event.from));
            EXPECT_EQ(event.to, ContactState::stick);
            ++n_restuck;
          }
        else if (event.t > corner)
          next = std::min(next, event.t);
      EXPECT_EQ(n_slipping, 32u); // at 0 … 31: a = 31.6
      EXPECT_EQ(n_restuck, n_slipping);
      EXPECT_NEAR(next, corner + bar.pull_of_front(0) / P0, 1e-12);
    }
}
