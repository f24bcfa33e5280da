// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Sequences of states of single elements, each pressed and sheared through springs of stiffness
// one; everything follows by hand. With a linear layer, C_n = 1, C_t = 2, and the gap g0:
//     open: u_n = -F_n, u_t = F_t;      closed: -N = (F_n - g0)/2;
//     stick: T = (F_t - s)/3;            slip: u_t = F_t - T, s = F_t - 3T.

#include "contact/beyond_record.h"
#include "known_answer.h"

#include <fuga/laws/cubic_root_law.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  /** A few divisions of numbers of order one. */
  constexpr double tolerance = 1e-13;

  /** n elements that know nothing of each other; loads 2k (pressing) and 2k + 1 (shearing). */
  ToySystem
  separate_elements(const std::size_t n)
  {
    ToySystem system;
    system.S = DenseMatrix(2 * n, 2 * n);
    system.F = DenseMatrix(2 * n, 2 * n);
    for (std::size_t i = 0; i < 2 * n; ++i)
      {
        system.S(i, i) = 1.;
        system.F(i, i) = i % 2 == 0 ? -1. : 1.;
      }
    return system;
  }

  void
  expect_event(const ContactEvent &event,
               const double t,
               const ContactState from,
               const ContactState to)
  {
    EXPECT_NEAR(event.t, t, tolerance);
    EXPECT_EQ(event.from, from);
    EXPECT_EQ(event.to, to);
  }
} // namespace

// Open → stick → slip → open → stick → slip back, reported at one level only. g0 = f = 1/2.
//   F_n 0 → 1: closes at F_n = g0, t = 1/2.
//   F_n = 1 - 2σ, F_t = 2σ: slips where 2σ/3 = f(1/4 - σ), σ = 3/28; opens at σ = 1/4.
//   F_n -1 → 1, F_t = 2: closes at F_n = 1/2, σ = 3/4, with the shear jump 2: no shear comes back.
//   F_t 2 → 1: slips back where (F_t - 2)/3 = -f/4, σ = 3/8; ends at u_t = 1 + 1/8, s = 1 + 3/8.
// Losses: forward, ds = 3.5 dσ: ∫ f(1/4 - σ) 3.5 dσ = 1/56; back: 1/8 · 5/8.
TEST(StateChanges, OpenStickSlipOpenWithinOneLevel)
{
  ToyJoint joint(1, 1., make_linear_law(1.), make_linear_law(2.), {0.5, 0.});
  joint.elements[0].initial_gap = 0.5;
  const ToySystem system        = separate_elements(1);
  const LayeredSystem layered(system, joint.elements);
  const LoadHistory history({0., 1., 2., 3., 4.},
                            {{0., 0.}, {1., 0.}, {-1., 2.}, {1., 2.}, {1., 1.}});
  EventPath path(joint.elements, layered, history, {});
  Record record(system, joint.elements, history);
  EXPECT_EQ(path.run({4.}, record).verdict, Verdict::done);
  EXPECT_LE(record.worst.worst(), tolerance);

  ASSERT_EQ(record.events.size(), 5u);
  expect_event(record.events[0], 0.5, ContactState::open, ContactState::stick);
  expect_event(record.events[1], 1. + 3. / 28., ContactState::stick, ContactState::slip_forward);
  expect_event(record.events[2], 1.25, ContactState::slip_forward, ContactState::open);
  expect_event(record.events[3], 2.75, ContactState::open, ContactState::stick);
  expect_event(record.events[4], 3.375, ContactState::stick, ContactState::slip_backward);

  const JointState &end = record.levels.at(0);
  const Vector jumps    = layered.jumps(end.dislocations, end.forces);
  EXPECT_NEAR(end.forces[0], -0.25, tolerance);
  EXPECT_NEAR(end.forces[1], -0.125, tolerance);
  EXPECT_NEAR(jumps[0], -0.75, tolerance);
  EXPECT_NEAR(jumps[1], 1.125, tolerance);
  EXPECT_NEAR(end.slips[0][0], 1.375, tolerance);

  // The ledger. External work: normal 5/16 (the path there and back is elastic); tangential, piece
  // by piece ∫F_t du_t = 3/196 + 5/2 (1/16 - 9/784) + 15/8 + (1.625² - 4)/3 + (1 - 1.625²)/2.
  const EnergyLedger &energies = record.judge.energies();
  const double loss            = 1. / 56. + 5. / 64.;
  const double work            = 5. / 16. + 3. / 196. + 2.5 * (1. / 16. - 9. / 784.) + 1.875 +
                      (1.625 * 1.625 - 4.) / 3. + (1. - 1.625 * 1.625) / 2.;
  EXPECT_NEAR(energies.dissipation, loss, tolerance);
  EXPECT_NEAR(energies.bodies, (0.75 * 0.75 + 1.125 * 1.125) / 2., tolerance);
  EXPECT_NEAR(energies.layer, (0.0625 + 0.015625 / 0.5) / 2., tolerance);
  EXPECT_NEAR(energies.external_work, work, tolerance);
}

// On closing the element sticks if |Ṫ| ≤ f|Ṅ| with the rates of stick: Ḟ_t/3 ≤ f Ḟ_n/2, here Ḟ_t ≤
// 3/4 Ḟ_n; beyond, it slips from its first contact on.
TEST(StateChanges, ClosingDecidesBetweenStickAndSlip)
{
  for (const auto &[ratio, state] : {std::pair(0.74, ContactState::stick),
                                     {0.76, ContactState::slip_forward},
                                     {-0.76, ContactState::slip_backward}})
    {
      ToyJoint joint(1, 1., make_linear_law(1.), make_linear_law(2.), {0.5, 0.});
      joint.elements[0].initial_gap = 0.5;
      const ToySystem system        = separate_elements(1);
      const LayeredSystem layered(system, joint.elements);
      const LoadHistory history({0., 1.}, {{0., 0.}, {1., ratio}});
      EventPath path(joint.elements, layered, history, {});
      Record record(system, joint.elements, history);
      EXPECT_EQ(path.run({1.}, record).verdict, Verdict::done);
      EXPECT_LE(record.worst.worst(), tolerance);
      ASSERT_EQ(record.events.size(), 1u);
      expect_event(record.events[0], 0.5, ContactState::open, state);
      // The jump at closing is kept as slip: T from there on.
      const double T = state == ContactState::stick ? 0.5 * ratio / 3. : 0.125 * slip_sign(state);
      EXPECT_NEAR(record.levels[0].forces[1], T, tolerance);
    }
}

// A layer that is a million times as soft beside a common one, both sliding. It carries 1e-12, of
// which friction holds less than the last digits of the other shear, but it is closed by 1e-6. So
// it opens where the load that presses it vanishes, σ = 1/2, not where that begins to fall.
TEST(StateChanges, SoftLayerStaysClosedWhereItsShearIsOnlyRounding)
{
  constexpr double C = 1e6, N = 1e-12, F = N * (1. + C);
  ToyJoint joint(2, 1., make_linear_law(1.), make_linear_law(2.), {0.5, 0.});
  const std::unique_ptr<ComplianceLaw> soft = make_linear_law(C);
  joint.elements[0].normal_law              = soft.get();
  const ToySystem system                    = separate_elements(2);
  const LoadHistory history({0., 1., 2.},
                            {{0., 0., 0., 0.}, {F, 1e-3, 2., 3.}, {-F, 1e-3, 2., 3.}});
  const auto [result, record] =
    follow_beyond_in_plane_and_space(system, joint.elements, history, 1., {1., 2.});
  EXPECT_EQ(result.verdict, Verdict::done);
  EXPECT_LE(record.worst.worst(), 1e-12); // of 1e-6 beside jumps of 2
  ASSERT_EQ(record.events.size(), 3u);
  expect_event(record.events[0], 0., ContactState::stick, ContactState::slip_forward);
  expect_event(record.events[1], 0., ContactState::stick, ContactState::slip_forward);
  expect_event(record.events[2], 1.5, ContactState::slip_forward, ContactState::open);
  EXPECT_NEAR(record.levels[0].forces[0], -N, 1e-19);
  EXPECT_NEAR(record.levels[1].dislocations[0], F, 1e-18);
}

// Several elements change at the very same load, t = 1, each in its own way: 0 closes and sticks, 1
// closes slipping forwards, 2 closes slipping backwards, 3 comes to rest by the reversal of its
// load, 4 opens, 5 starts to slip. f = 1/2, gaps 1/2 of elements 0, 1, 2.
TEST(StateChanges, ManyEventsAtOneLoad)
{
  const std::size_t n = 6;
  ToyJoint joint(n, 1., make_linear_law(1.), make_linear_law(2.), {0.5, 0.});
  for (const std::size_t k : {0u, 1u, 2u})
    joint.elements[k].initial_gap = 0.5;
  const ToySystem system = separate_elements(n);
  const LayeredSystem layered(system, joint.elements);
  const Vector zero(2 * n, 0.);
  // Element 3: F_n = 1, T up to 1/4: slips from F_t = 3/4 on, reached at t = 0.875. Element 4: F_n
  // 1 at t = 0.5, 0 at t = 1. Element 5: its strength 1/4 at F_t = 3/4.
  const Vector half = {0.25, 0., 0.25, 0., 0.25, 0., 1., 0.6, 1., 0., 1., 0.5};
  const Vector one  = {0.5, 0., 0.5, 0., 0.5, 0., 1., 0.8, 0., 0., 1., 0.75};
  const Vector end  = {1., 0.2, 1., 1., 1., -1., 1., 0.7, -1., 0., 1., 1.};
  const LoadHistory history({0., 0.5, 1., 2.}, {zero, half, one, end});
  EventPath path(joint.elements, layered, history, {});
  Record record(system, joint.elements, history);
  EXPECT_EQ(path.run({1., 2.}, record).verdict, Verdict::done);
  EXPECT_LE(record.worst.worst(), tolerance);

  std::vector<const ContactEvent *> found(n, nullptr);
  for (const ContactEvent &event : record.events)
    if (std::abs(event.t - 1.) < 1e-14)
      {
        EXPECT_EQ(found[event.element], nullptr) << event.element;
        found[event.element] = &event;
      }
  const std::pair<ContactState, ContactState> expected[] = {
    {ContactState::open, ContactState::stick},
    {ContactState::open, ContactState::slip_forward},
    {ContactState::open, ContactState::slip_backward},
    {ContactState::slip_forward, ContactState::stick},
    {ContactState::stick, ContactState::open},
    {ContactState::stick, ContactState::slip_forward}};
  for (std::size_t k = 0; k < n; ++k)
    {
      ASSERT_NE(found[k], nullptr) << k;
      expect_event(*found[k], 1., expected[k].first, expected[k].second);
    }
  // T at the end: 0.2/3, ±f(1 - 1/2)/2, (0.7 - s)/3 with s = 0.8 - 3/4, 0, f/2.
  const double T[] = {0.2 / 3., 0.125, -0.125, 0.65 / 3., 0., 0.25};
  for (std::size_t k = 0; k < n; ++k)
    EXPECT_NEAR(record.levels[1].forces[2 * k + 1], T[k], tolerance) << k;
}

// A load that shears elements without pressing them, but for rounding errors, as a block under
// uniaxial stress does to the plane on which it stands: they give way at once, T = 0, and the load
// goes on. Here slip changes N by 1e-17 of what opening does, less than the spacing of numbers.
TEST(StateChanges, NormalForcesOfRoundingOnly)
{
  const ToyJoint joint(3, 1., make_rigid_law(), make_rigid_law(), {1., 0.});
  ToySystem system      = separate_elements(3);
  system.F              = DenseMatrix(6, 1);
  const double noises[] = {1e-17, 0., -1e-17};
  for (std::size_t k = 0; k < 3; ++k)
    {
      system.S(2 * k, 2 * k + 1) = system.S(2 * k + 1, 2 * k) = noises[k];
      system.F(2 * k + 1, 0)                                  = 1.;
    }
  const LayeredSystem layered(system, joint.elements);
  const LoadHistory history({0., 1., 2.}, {{0.}, {1.}, {0.}});
  EventPath path(joint.elements, layered, history, {});
  Record record(system, joint.elements, history);
  EXPECT_EQ(path.run({1., 2.}, record).verdict, Verdict::done);
  EXPECT_LE(record.worst.worst(), tolerance);
  for (std::size_t k = 0; k < 3; ++k)
    for (const std::size_t level : {0u, 1u})
      {
        const JointState &state = record.levels[level];
        EXPECT_NEAR(state.forces[2 * k + 1], 0., tolerance);
        EXPECT_NEAR(layered.jumps(state.dislocations, state.forces)[2 * k + 1],
                    level == 0 ? 1. : 0.,
                    tolerance);
      }
}

// Re-stick inside a curved segment. Law (9) with ρ0 = ζ0 = 1 on a spring of stiffness one: w + σ(w)
// = F_n. With F_n = F_t = t, f = 1/2, C_t = 1/2 the element slips from the start, s = t - 3 f σ,
// and
//     ṡ = 1 - 3/2 σ'/(1 + σ')
// vanishes where the layer has hardened to σ' = 2: 1 - 2q/3 = 2(1 - q)², q = (5 - √7)/6. From there
// on it sticks. ṡ falls linearly there, so the load of the event is as exact as ṡ, which is as
// exact as the iteration (1e-13) over the slope dṡ/dt, of order one: 1e-11.
TEST(StateChanges, RestickInsideCurvedSegment)
{
  const ToyJoint joint(
    1, 1., std::make_unique<CubicRootLaw>(1., 1.), make_linear_law(2.), {0.5, 0.});
  const ToySystem system = separate_elements(1);
  const LayeredSystem layered(system, joint.elements);
  const LoadHistory history({0., 1.}, {{0., 0.}, {1., 1.}});
  EventPath path(joint.elements, layered, history, {});
  Record record(system, joint.elements, history);
  EXPECT_EQ(path.run({1.}, record).verdict, Verdict::done);
  EXPECT_LE(record.worst.worst(), 1e-9);

  const double q = (5. - std::sqrt(7.)) / 6., w = q * q * q, sigma = w / (1. - q);
  ASSERT_NEAR((1. - 2. * q / 3.) / ((1. - q) * (1. - q)), 2., 1e-14);
  const double t = w + sigma, slip = t - 1.5 * sigma;
  ASSERT_EQ(record.events.size(), 2u);
  EXPECT_EQ(record.events[0].to, ContactState::slip_forward);
  EXPECT_EQ(record.events[0].t, 0.);
  EXPECT_EQ(record.events[1].from, ContactState::slip_forward);
  EXPECT_EQ(record.events[1].to, ContactState::stick);
  expect_answer({"V11 law (9)", "load of re-stick on one element", t, "closed form"},
                record.events[1].t,
                1e-11);
  expect_answer({"V11 law (9)", "slip kept at re-stick", slip, "closed form"},
                record.levels[0].slips[0][0],
                1e-11);
  EXPECT_NEAR(record.levels[0].forces[1], (1. - slip) / 3., 1e-11);

  // Ledger: loss ∫T ds = ½∫σ (dt - 3/2 dσ), dt = dw + dσ, with ∫σ dw the energy of law (9),
  // 3[-ln(1-q) - q - q²/2 - q³/3 - q⁴/4 - q⁵/5]. The pieces lose 1e-9 of the energies at most
  // (theory, section 6).
  const double bracket =
    -std::log1p(-q) - q * (1. + q * (1. / 2. + q * (1. / 3. + q * (1. / 4. + q / 5.))));
  const double loss = 0.5 * (3. * bracket - 0.25 * sigma * sigma);
  expect_answer({"V11 law (9)", "loss until re-stick", loss, "closed form"},
                record.judge.energies().dissipation,
                1e-9 * record.judge.energies().external_work);
}

// A broken bond still carries T = 1 along a spring of stiffness one, and gives it up in proportion
// while the load on the spring falls from 1 to -2: the lips move by -2 against the force, whose
// work -1 is no error of slip. Loads do ∫(1 - 3τ) d(-2τ) = 1, the spring stores 2.
TEST(Judge, OpenLipsMoveAgainstAFadingForce)
{
  const ToySystem system = spring_beside_joint(1.);
  const ToyJoint joint(1, 1., make_rigid_law(), make_rigid_law(), {0.5});
  const LoadHistory history({0., 1.}, {{0., 1.}, {0., -2.}});
  PathPoint from, to;
  from.state.states       = {ContactState::open};
  from.state.forces       = {0., 1.};
  from.state.unreleased   = {0., 1.};
  from.state.dislocations = {0., 0.};
  from.state.slips        = {{{0., 0.}}};
  from.state.dilations    = {0.};
  from.state.strengths    = {virgin_strength(joint.elements[0].friction, 1.)};
  from.rates              = {{0., -1.}, {0., -2.}};
  to                      = from;
  to.state.t              = 1.;
  to.state.forces = to.state.unreleased = {0., 0.};
  to.state.dislocations                 = {0., -2.};
  to.state.slips                        = {{{-2., 0.}}};

  Judge judge(system, joint.elements, history);
  EXPECT_LE(judge.judge(from.state).worst(), tolerance);
  judge.follow(from, to, 1.);
  EXPECT_LE(judge.judge(to.state).worst(), tolerance);
  EXPECT_NEAR(judge.energies().external_work, 1., tolerance);
  EXPECT_NEAR(judge.energies().bodies, 2., tolerance);
  EXPECT_NEAR(judge.energies().dissipation, -1., tolerance);
}
