// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// A path followed again from any of its cuts is the same path: the oracle is the unbroken one, and
// the tolerance is no bit.

#include "contact/toy_system.h"

#include <fuga/base/errors.h>
#include <fuga/laws/cubic_root_law.h>

#include <gtest/gtest.h>

#include <cstring>
#include <random>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  /** The bytes of numbers, one after the other. */
  class Bytes
  {
  public:
    std::string text;

    template <typename Value>
    void
    operator()(const char *, const Value &value)
    {
      if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value> ||
                    std::is_same_v<Value, Strength>)
        text.append(reinterpret_cast<const char *>(&value), sizeof(Value));
      else if constexpr (std::is_same_v<Value, std::vector<bool>>)
        for (const bool item : value)
          (*this)("", item);
      else if constexpr (std::is_same_v<Value, JointState>)
        for_each_field(value, *this);
      else
        for (const auto &item : value)
          (*this)("", item);
    }
  };

  /** Every report as its bytes, and the cut at each of them. */
  class CutRecord : public PathObserver
  {
  public:
    explicit CutRecord(const EventPath &observed_path) : path(observed_path)
    {
    }

    std::vector<std::string> reports;
    std::vector<PathCut> cuts;

    bool
    wants_cuts() const override
    {
      return true;
    }

    void
    advanced(const PathPoint &from, const PathPoint &to, const double length) override
    {
      Bytes bytes;
      for (const PathPoint *point : {&from, &to})
        {
          bytes("", point->state);
          bytes("", point->rates.forces);
          bytes("", point->rates.dislocations);
        }
      bytes("", length);
      keep(bytes);
    }

    void
    jumped(const JointState &to) override
    {
      Bytes bytes;
      bytes("", to);
      keep(bytes);
    }

    void
    changed(const std::vector<ContactEvent> &events, const JointState &state) override
    {
      Bytes bytes;
      bytes("", state);
      for (const ContactEvent &event : events)
        {
          bytes("", event.t);
          bytes("", event.element);
          bytes("", event.to);
        }
      keep(bytes);
    }

    void
    reached(const std::size_t index, const JointState &state) override
    {
      Bytes bytes;
      bytes("", index);
      bytes("", state);
      keep(bytes);
    }

  private:
    void
    keep(const Bytes &bytes)
    {
      reports.push_back(bytes.text);
      cuts.push_back(path.last_cut());
    }

    const EventPath &path;
  };

  enum class Layer
  {
    rigid,
    linear,
    nonlinear
  };

  /** Twelve elements that are coupled at random, pressed, and pushed to and fro. */
  class Scene
  {
  public:
    Scene(const Layer layer, const FrictionLaw &friction)
      : joint(n, 1., law(layer), law(layer), friction)
    {
      const std::size_t m = 2 * n;
      DenseMatrix A(m, m);
      for (std::size_t i = 0; i < m * m; ++i)
        A.data()[i] = uniform(-0.3, 0.3);
      system.S = multiply_transposed(A, A);
      system.F = DenseMatrix(m, 2);
      for (std::size_t i = 0; i < m; ++i)
        {
          system.S(i, i) += 0.5;
          system.F(i, 0) = i % 2 == 0 ? -uniform(0.2, 1.) : uniform(-0.2, 0.2);
          system.F(i, 1) = uniform(-1., 1.);
        }
    }

    static LoadHistory
    history(const std::size_t n_cycles)
    {
      std::vector<double> corners = {0., 1.};
      std::vector<Vector> values  = {{0., 0.}, {0.1, 0.}};
      for (std::size_t i = 0; i < 2 * n_cycles; ++i)
        {
          corners.push_back(corners.back() + 1.);
          values.push_back({0.1, i % 2 == 0 ? 0.09 : -0.07});
        }
      return {corners, values};
    }

    static constexpr std::size_t n = 12;
    ToyJoint joint;
    ToySystem system;

  private:
    static std::unique_ptr<ComplianceLaw>
    law(const Layer layer)
    {
      return layer == Layer::rigid    ? make_rigid_law()
             : layer == Layer::linear ? make_linear_law(0.7)
                                      : std::make_unique<CubicRootLaw>(0.7, 1.3);
    }

    double
    uniform(const double low, const double high)
    {
      return std::uniform_real_distribution<double>(low, high)(random);
    }

    std::mt19937 random{5};
  };

  std::vector<double>
  levels(const double end)
  {
    std::vector<double> result;
    for (double t = 0.3; t < end; t += 0.3)
      result.push_back(t);
    result.push_back(end);
    return result;
  }

  /** Number of cuts from which the path was followed again. */
  std::size_t
  check(const Scene &scene, const PathOptions &options, const std::size_t n_cycles)
  {
    const LoadHistory history = Scene::history(n_cycles);
    const LayeredSystem layered(scene.system, scene.joint.elements);
    EventPath whole(scene.joint.elements, layered, history, options);
    CutRecord record(whole);
    const PathResult expected   = whole.run(levels(history.end()), record);
    const IterationCount counts = whole.iterations();
    EXPECT_EQ(expected.verdict, Verdict::done);
    const std::size_t stride = 1 + record.cuts.size() / 60;
    for (std::size_t i = 0; i < record.cuts.size(); i += stride)
      {
        EventPath path(scene.joint.elements, layered, history, options);
        CutRecord rest(path);
        const PathResult result = path.resume(record.cuts[i], levels(history.end()), rest);
        EXPECT_EQ(rest.reports.size(), record.reports.size() - i - 1);
        EXPECT_TRUE(std::equal(rest.reports.rbegin(), rest.reports.rend(), record.reports.rbegin()))
          << "report " << i;
        EXPECT_EQ(result.n_schemes, expected.n_schemes);
        EXPECT_EQ(result.n_events, expected.n_events);
        EXPECT_EQ(result.n_steps, expected.n_steps);
        EXPECT_EQ(result.n_zero_steps, expected.n_zero_steps);
        EXPECT_EQ(result.n_decided_by, expected.n_decided_by);
        EXPECT_EQ(path.iterations().n_iterations, counts.n_iterations);
      }
    return record.cuts.size();
  }
} // namespace

TEST(Restart, LinearLayer)
{
  EXPECT_GT(check(Scene(Layer::linear, {0.3, 0.}), {}, 3), 100u);
}

// So many cycles that the inverse is factorised anew on the way.
TEST(Restart, RigidLayerManyCycles)
{
  EXPECT_GT(check(Scene(Layer::rigid, {0.3, 0.}), {}, 15), 300u);
}

TEST(Restart, NonlinearLayer)
{
  EXPECT_GT(check(Scene(Layer::nonlinear, {0.3, 0.}), {}, 2), 100u);
}

TEST(Restart, Cohesion)
{
  EXPECT_GT(check(Scene(Layer::linear, {0.3, 0.02}), {}, 3), 50u);
  EXPECT_GT(check(Scene(Layer::nonlinear, {0.3, 0.02}), {}, 1), 20u);
}

// Strength that sliding uses up, and lips that rise.
TEST(Restart, StrengthWithMemory)
{
  FrictionLaw law{0.3, 0.02};
  law.tensile_strength = 0.01;
  law.bond_loss        = FrictionLaw::BondLoss::slip;
  law.friction_loss    = 0.1;
  law.dilatancy        = 0.1;
  law.dilation_limit   = 0.003;
  EXPECT_GT(check(Scene(Layer::linear, law), {}, 3), 50u);
}

TEST(Restart, ImplicitSteps)
{
  PathOptions options;
  options.follow = PathOptions::Follow::stage_ends;
  EXPECT_GT(check(Scene(Layer::linear, {0.3, 0.}), options, 3), 10u);
}

// A history that goes on after the end of another one: from the cut at that end the rest is the
// same as in one piece.
TEST(Restart, StagesAddedLater)
{
  for (const Layer layer : {Layer::linear, Layer::nonlinear})
    {
      const Scene scene(layer, {0.3, 0.});
      const LayeredSystem layered(scene.system, scene.joint.elements);
      const LoadHistory first = Scene::history(1), all = Scene::history(2);
      EventPath begin(scene.joint.elements, layered, first, {});
      CutRecord at_begin(begin);
      begin.run({1., 2., 3.}, at_begin);
      const PathCut cut = begin.last_cut();
      EXPECT_EQ(cut.state.t, first.end());
      EXPECT_EQ(cut.n_reports, 0u);

      EventPath whole(scene.joint.elements, layered, all, {}),
        rest(scene.joint.elements, layered, all, {});
      CutRecord at_whole(whole), at_rest(rest);
      whole.run({1., 2., 3., 3.5, 5.}, at_whole);
      rest.resume(cut, {1., 2., 3., 3.5, 5.}, at_rest);
      std::vector<std::string> in_two = at_begin.reports;
      in_two.insert(in_two.end(), at_rest.reports.begin(), at_rest.reports.end());
      EXPECT_EQ(in_two.size(), at_whole.reports.size());
      EXPECT_TRUE(in_two == at_whole.reports);
      EXPECT_GT(at_rest.reports.size(), 5u);
    }
}

// What cannot be repeated is not taken for the same path.
TEST(Restart, AnotherPathIsNoticed)
{
  const Scene scene(Layer::linear, {0.3, 0.});
  const LoadHistory history = Scene::history(1);
  const LayeredSystem layered(scene.system, scene.joint.elements);
  EventPath path(scene.joint.elements, layered, history, {});
  CutRecord record(path);
  path.run(levels(history.end()), record);
  PathCut cut = record.cuts[record.cuts.size() / 2];
  cut.n_reports += 5;
  EventPath again(scene.joint.elements, layered, history, {});
  EXPECT_THROW(again.resume(cut, levels(history.end()), record), NumericalFailure);
}
