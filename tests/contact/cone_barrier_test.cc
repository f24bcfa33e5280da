// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Virtual motions that show that a rate problem in space has no solution.

#include "contact/cone_toy.h"

#include <fuga/contact/cones/cone_barrier.h>
#include <fuga/contact/judge/limit_proof.h>

#include <cmath>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  using Place = ConeAnswer::Place;

  Vector
  diagonal_of(const DenseMatrix &W)
  {
    Vector result;
    for (Eigen::Index i = 0; i < W.rows(); ++i)
      result.push_back(W(i, i));
    return result;
  }

  /** Rows n, t1, t2 of an element whose slip along t1 by one presses it by 0.8: with f = 1.5 it
   * gains 1.2 of strength and loses 1 of shear. */
  DenseMatrix
  stiffness_beyond_critical()
  {
    DenseMatrix W(3, 3);
    for (std::size_t i = 0; i < 3; ++i)
      W(i, i) = 1.;
    W(0, 1) = W(1, 0) = -0.8;
    return W;
  }

  ConeAnswer
  on_cone(const double friction)
  {
    ConeAnswer answer;
    answer.friction = friction;
    return answer;
  }
} // namespace

// 0 ≤ γ ⟂ -(e + f n)·r + (1 - 0.8 f) γ ≥ 0 has no solution if both terms are negative, and else
// one.
TEST(ConeBarrier, OneSlidingElementBeyondCriticalFriction)
{
  const DenseMatrix W = stiffness_beyond_critical();
  const Vector ones   = {1., 1., 1.};
  const Vector loaded = {0., 1., 0.3}, unloaded = {0., -1., 0.3};
  const std::optional<Vector> y = find_barrier(W, loaded, ones, {on_cone(1.5)});
  ASSERT_TRUE(y);
  EXPECT_GT((*y)[1], 0.);
  EXPECT_NEAR((*y)[0], 1.5 * (*y)[1], 1e-12 * (*y)[1]);
  EXPECT_EQ((*y)[2], 0.);
  EXPECT_FALSE(find_barrier(W, unloaded, ones, {on_cone(1.5)}));
  EXPECT_FALSE(find_barrier(W, loaded, ones, {on_cone(1.2)}));
  // A rate of the strength of more than the load.
  ConeAnswer stronger    = on_cone(1.5);
  stronger.strength_rate = 1.1;
  EXPECT_FALSE(find_barrier(W, loaded, ones, {stronger}));
  stronger.strength_rate = 0.9;
  EXPECT_TRUE(find_barrier(W, loaded, ones, {stronger}));
}

namespace
{
  /** A state of an element with one tangent: what its rates are, v = γ column, and how the force
   * answers. */
  enum class State
  {
    stick,
    open,
    forward,
    backward
  };

  /** A rate problem with elements of one tangent each: all states can be tried. */
  class RandomProblem
  {
  public:
    DenseMatrix W;
    Vector r;
    std::vector<ConeAnswer> answers;

    RandomProblem(const std::size_t n, std::mt19937 &generator)
      : W(random_stiffness(2 * n, generator))
    {
      std::uniform_real_distribution<double> uniform(-1., 1.);
      for (std::size_t k = 0; k < n; ++k)
        {
          ConeAnswer answer;
          answer.place      = generator() % 3 == 0 ? Place::at_apex : Place::on_cone;
          answer.row        = 2 * k;
          answer.n_tangents = 1;
          answer.friction   = 1.5 + 1.2 * uniform(generator);
          answer.rise       = answer.place == Place::on_cone && generator() % 4 == 0 ? 0.2 : 0.;
          answer.direction  = {{generator() % 2 == 0 ? 1. : -1., 0.}};
          answers.push_back(answer);
          r.push_back(uniform(generator));
          r.push_back(uniform(generator));
        }
    }

    bool
    has_solution() const
    {
      std::size_t n_combinations = 1;
      for (std::size_t k = 0; k < answers.size(); ++k)
        n_combinations *= 4;
      for (std::size_t combination = 0; combination < n_combinations; ++combination)
        {
          std::vector<State> states;
          bool exist = true;
          for (std::size_t k = 0, rest = combination; k < answers.size(); ++k, rest /= 4)
            {
              states.push_back(static_cast<State>(rest % 4));
              exist = exist && (answers[k].place == Place::at_apex ||
                                (states[k] != State::open && states[k] != State::backward));
            }
          if (exist && is_solution(states))
            return true;
        }
      return false;
    }

    /** The least margin by which y fails to be a barrier; positive: it is none. */
    double
    violation(const Vector &y) const
    {
      const Vector p  = multiply(W, y);
      const auto size = max_abs(y);
      double worst    = 1e-6 - dot(y, r) / size;
      for (const ConeAnswer &answer : answers)
        {
          const std::size_t n = answer.row, t = n + 1;
          const double sign = answer.direction[0], f = answer.friction;
          if (answer.place == Place::on_cone)
            worst = std::max({worst,
                              -y[n] / size,
                              std::abs(y[n] - f * sign * y[t]) / size,
                              (sign * p[t] + answer.rise * p[n]) / size});
          else
            worst = std::max(
              {worst, p[n] / size, std::abs(p[t]) / size, (f * std::abs(y[t]) - y[n]) / size});
        }
      return worst;
    }

  private:
    bool
    is_solution(const std::vector<State> &states) const
    {
      // Unknowns: both rates of open elements, the slip of sliding ones.
      std::vector<Vector> columns, rows;
      const auto unit = [this](const std::size_t row, const double along, const double across) {
        Vector result(r.size(), 0.);
        result[row]     = across;
        result[row + 1] = along;
        return result;
      };
      for (std::size_t k = 0; k < states.size(); ++k)
        {
          const ConeAnswer &answer = answers[k];
          if (states[k] == State::open)
            for (const double along : {0., 1.})
              {
                columns.push_back(unit(answer.row, along, 1. - along));
                rows.push_back(columns.back());
              }
          else if (states[k] != State::stick)
            {
              const double sign = slip_sign(k, states[k]);
              columns.push_back(unit(answer.row, sign, answer.rise));
              rows.push_back(unit(answer.row, sign, answer.friction));
            }
        }
      const std::size_t m = columns.size();
      DenseMatrix M(m, m);
      Vector x(m), v(r.size(), 0.);
      for (std::size_t i = 0; i < m; ++i)
        {
          x[i] = dot(rows[i], r);
          for (std::size_t j = 0; j < m; ++j)
            M(i, j) = dot(rows[i], multiply(W, columns[j]));
        }
      if (m > 0)
        LuFactors(std::move(M)).solve(x);
      for (std::size_t j = 0; j < m; ++j)
        add_multiple(x[j], columns[j], v);
      Vector q = r;
      add_multiple(-1., multiply(W, v), q);
      for (std::size_t k = 0; k < states.size(); ++k)
        if (!is_admissible(k, states[k], v, q))
          return false;
      return true;
    }

    double
    slip_sign(const std::size_t k, const State state) const
    {
      if (answers[k].place == Place::on_cone)
        return answers[k].direction[0];
      return state == State::forward ? 1. : -1.;
    }

    bool
    is_admissible(const std::size_t k, const State state, const Vector &v, const Vector &q) const
    {
      constexpr double none = 1e-9;
      const std::size_t n = answers[k].row, t = n + 1;
      const double f = answers[k].friction;
      if (state == State::open)
        return v[n] >= -none;
      if (answers[k].place == Place::at_apex && q[n] > none)
        return false;
      if (state == State::stick)
        return answers[k].place == Place::on_cone
                 ? answers[k].direction[0] * q[t] + f * q[n] <= none
                 : std::abs(q[t]) + f * q[n] <= none;
      return slip_sign(k, state) * v[t] >= -none;
    }
  };
} // namespace

// Of random problems without solution most have a barrier, and it is one by the conditions on it
// written out; none has where trying all states finds a solution. (1e-6 as above: rounding is 1e-9
// here.)
TEST(ConeBarrier, RandomProblemsHaveOneOnlyWithoutSolution)
{
  std::mt19937 generator(7);
  std::size_t n_without_solution = 0, n_barriers = 0;
  for (int i = 0; i < 8000; ++i)
    {
      const RandomProblem problem(1 + generator() % 4, generator);
      const bool is_solvable = problem.has_solution();
      const std::optional<Vector> y =
        find_barrier(problem.W, problem.r, diagonal_of(problem.W), problem.answers);
      EXPECT_FALSE(is_solvable && y && problem.violation(*y) <= 1e-8) << "problem " << i;
      n_without_solution += is_solvable ? 0 : 1;
      if (is_solvable || !y)
        continue;
      EXPECT_LE(problem.violation(*y), 1e-8) << "problem " << i;
      ++n_barriers;
    }
  EXPECT_GT(n_without_solution, 50u);
  EXPECT_GT(2 * n_barriers, n_without_solution);
  RecordProperty("without_solution", static_cast<int>(n_without_solution));
  RecordProperty("barriers", static_cast<int>(n_barriers));
}

namespace
{
  /** Keeps the last state of a path without events as well. */
  class End : public Record
  {
  public:
    using Record::Record;

    void
    advanced(const PathPoint &from, const PathPoint &to, const double length) override
    {
      Record::advanced(from, to, length);
      last = to.state;
    }
  };

  /** Thirteen nodes on stiffness_beyond_critical() with rigid joints, f = 1.5, pressed by one and
   * then sheared: on their strength, at t = 1 + 1.5/3, none can go on, and 2^13 combinations of
   * states are not tried. */
  class ThirteenNodes : public testing::Test
  {
  protected:
    static constexpr std::size_t n = 13;

    static ToySystem
    thirteen_nodes()
    {
      const DenseMatrix of_node = stiffness_beyond_critical();
      ToySystem result;
      result.S = DenseMatrix(3 * n, 3 * n);
      result.F = DenseMatrix(3 * n, 2);
      for (std::size_t k = 0; k < n; ++k)
        {
          for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
              result.S(3 * k + i, 3 * k + j) = of_node(i, j);
          for (std::size_t a = 0; a < 2; ++a)
            result.F(3 * k + a, a) = 1.;
        }
      return result;
    }

    /** The path to its end. */
    PathResult
    follow()
    {
      const LayeredSystem layered(system, joint.elements);
      EventPath path(joint.elements, layered, history, PathOptions());
      return path.run({}, end);
    }

    const ToySystem system = thirteen_nodes();
    const ConeJoint joint{n, 1., make_rigid_law(), make_rigid_law(), 1.5};
    const LoadHistory history{{0., 1., 2.}, {{0., 0.}, {-1., 0.}, {-1., 3.}}};
    End end{system, joint.elements, history};
  };
} // namespace

// No continuation is a verdict although not all was tried. The virtual motion is that of the single
// element, in any combination of the nodes: w_n = 1.5 w_t, with forces -W w = (-0.7, 0.2) w_t; the
// load does nothing else than work on it.
TEST_F(ThirteenNodes, ABarrierProvesThatThereIsNoContinuation)
{
  PathResult result = follow();
  EXPECT_EQ(result.verdict, Verdict::no_continuation);
  EXPECT_NEAR(result.t, 1.5, 1e-12);
  EXPECT_FALSE(result.tried.empty());
  const JointRates barrier = result.barrier;
  ASSERT_EQ(barrier.forces.size(), 3 * n);
  for (std::size_t k = 0; k < n; ++k)
    {
      const double slip = barrier.dislocations[3 * k + 1];
      EXPECT_GT(slip, 0.);
      EXPECT_NEAR(barrier.dislocations[3 * k], 1.5 * slip, 1e-9 * slip);
      EXPECT_NEAR(barrier.forces[3 * k], -0.7 * slip, 1e-9 * slip);
      EXPECT_NEAR(barrier.forces[3 * k + 1], 0.2 * slip, 1e-9 * slip);
    }
  const LayeredSystem layered(system, joint.elements);
  const LimitProof proof = prove_limit(end.judge, joint.elements, layered, end.last, result);
  EXPECT_TRUE(proof.barrier.proves());
  EXPECT_LE(proof.barrier.error(), 1e-12);
  EXPECT_NEAR(proof.barrier.drive, 1., 1e-12);
  EXPECT_EQ(result.verdict, Verdict::no_continuation);
  EXPECT_TRUE(result.tried.empty());
}

// What is planted into jumps and forces the judge must find, and a load that falls drives nothing.
TEST_F(ThirteenNodes, TheJudgeFindsPlantedErrors)
{
  const JointRates barrier = follow().barrier;
  const JointState &last   = end.last;
  ASSERT_TRUE(end.judge.judge_barrier(last, barrier).proves());
  constexpr double error = 1e-3;
  double largest         = 0.; // the lips open most
  for (std::size_t k = 0; k < n; ++k)
    largest = std::max(largest, barrier.dislocations[3 * k]);

  // Forces that no body has: beside the row (-0.8, 1, 0) of S.
  JointRates planted = barrier;
  planted.forces[1] += error * largest;
  EXPECT_NEAR(
    end.judge.judge_barrier(last, planted).equilibrium, error / std::sqrt(1.64), 1e-6 * error);
  // Slip across the force, with the forces that go with it.
  planted = barrier;
  planted.dislocations[2] += error * largest;
  planted.forces[2] -= error * largest;
  EXPECT_NEAR(end.judge.judge_barrier(last, planted).inadmissible, error, 1e-6 * error);
  // Lips that part by more than friction asks.
  planted = barrier;
  planted.dislocations[0] += error * largest;
  planted.forces[0] -= error * largest;
  planted.forces[1] += 0.8 * error * largest;
  EXPECT_GT(end.judge.judge_barrier(last, planted).inadmissible, 0.9 * error);
  EXPECT_FALSE(end.judge.judge_barrier(last, planted).proves());

  planted = barrier;
  for (Vector *values : {&planted.dislocations, &planted.forces})
    for (double &value : *values)
      value = -value;
  EXPECT_NEAR(end.judge.judge_barrier(last, planted).drive, -1., 1e-12);
  EXPECT_GT(end.judge.judge_barrier(last, planted).inadmissible, 0.5);

  // Below its strength an element answers with any force, and open lips in any way.
  JointState other = last;
  other.forces[1] *= 0.9;
  EXPECT_GT(end.judge.judge_barrier(other, barrier).inadmissible, 0.1);
  other                 = last;
  other.states[0]       = ContactState::open;
  other.forces[0]       = 0.;
  other.forces[1]       = 0.;
  other.dislocations[0] = 1.;
  EXPECT_GT(end.judge.judge_barrier(other, barrier).inadmissible, 0.1);
  const LoadHistory falling{{0., 1., 2.}, {{0., 0.}, {-1., 3.}, {-1., 0.}}};
  const Judge judge(system, joint.elements, falling);
  EXPECT_NEAR(judge.judge_barrier(last, barrier).drive, -1., 1e-12);
}
