// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Random small problems: between two events every step of the path must be a solution of the
// implicit step problem that complete enumeration of all states, and lexicographic Lemke, find
// (tests/judges, independent of the solver).

#include "contact/toy_system.h"
#include "judges/from_contact.h"
#include "judges/judges.h"

#include <gtest/gtest.h>

#include <random>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  /** Keeps both ends of every smooth piece. */
  class PieceRecord : public Record
  {
  public:
    using Record::Record;

    std::vector<std::pair<JointState, JointState>> pieces;

    void
    advanced(const PathPoint &from, const PathPoint &to, const double length) override
    {
      Record::advanced(from, to, length);
      pieces.emplace_back(from.state, to.state);
    }
  };

  enum class Compliance
  {
    rigid,
    compliant,
    mixed
  };

  class RandomScene
  {
  public:
    RandomScene(const unsigned int seed, const Compliance compliance)
      : random(seed)
      , n(1 + static_cast<std::size_t>(random() % 4))
      , rigid_law(make_rigid_law())
      , soft_law(make_linear_law(std::pow(10., uniform(-3., 1.))))
      , elements(n)
    {
      for (std::size_t k = 0; k < n; ++k)
        {
          ContactElement &element = elements[k];
          element.normal_bar      = static_cast<unsigned int>(2 * k);
          element.tangential_bar  = static_cast<unsigned int>(2 * k + 1);
          element.area            = uniform(0.2, 2.);
          element.initial_gap     = uniform(0., 1.) < 0.3 ? uniform(0., 0.5) : 0.;
          const auto law          = [&]() {
            const bool rigid = compliance == Compliance::rigid ||
                               (compliance == Compliance::mixed && uniform(0., 1.) < 0.5);
            return rigid ? rigid_law.get() : soft_law.get();
          };
          element.normal_law = law();
          element.shear_law  = law();
          element.friction   = {uniform(0., 0.4), 0.};
        }
      make_system();
    }

    LoadHistory
    history()
    {
      std::vector<double> corners = {0.};
      std::vector<Vector> values  = {Vector(2, 0.)};
      for (int i = 1; i <= 4; ++i)
        {
          corners.push_back(i);
          values.push_back({uniform(0.3, 1.5), uniform(-1.5, 1.5)});
        }
      return {corners, values};
    }

    double
    uniform(const double low, const double high)
    {
      return std::uniform_real_distribution<double>(low, high)(random);
    }

  private:
    // Sᵢⱼ = Σ aᵢₖaⱼₖ + diagonal: definite, with couplings between normal and tangential directions.
    void
    make_system()
    {
      const std::size_t m = 2 * n;
      DenseMatrix A(m, m);
      for (std::size_t i = 0; i < m * m; ++i)
        A.data()[i] = uniform(-0.5, 0.5);
      system.S = multiply_transposed(A, A);
      system.F = DenseMatrix(m, 2);
      for (std::size_t i = 0; i < m; ++i)
        {
          system.S(i, i) += 0.5;
          system.F(i, 0) = i % 2 == 0 ? -uniform(0., 1.) : uniform(-0.3, 0.3);
          system.F(i, 1) = uniform(-1., 1.);
        }
    }

    std::mt19937 random;

  public:
    const std::size_t n;
    std::unique_ptr<ComplianceLaw> rigid_law, soft_law;
    std::vector<ContactElement> elements;
    ToySystem system;
  };

  void
  check(const Compliance compliance, const unsigned int first_seed)
  {
    const unsigned int n_scenes = 150;
    // Two solutions of the same system of at most 16 unknowns with condition numbers up to 1e4.
    const double tolerance = 1e-9;
    std::size_t n_events = 0, n_pieces = 0, n_rays = 0;
    for (unsigned int seed = first_seed; seed < first_seed + n_scenes; ++seed)
      {
        RandomScene scene(seed, compliance);
        const LoadHistory history = scene.history();
        const LayeredSystem layered(scene.system, scene.elements);
        EventPath path(scene.elements, layered, history, {});
        PieceRecord record(scene.system, scene.elements, history);
        const PathResult result = path.run({1., 2.5, 4.}, record);
        ASSERT_EQ(result.verdict, Verdict::done) << "seed " << seed;
        EXPECT_LE(record.worst.worst(), 1e-10) << "seed " << seed;
        n_events += record.events.size();

        const judges::JudgeProblem problem = judges::judge_problem(scene.system, scene.elements);
        for (const auto &[from, to] : record.pieces)
          {
            // A piece without length leaves nothing to solve.
            if (to.t - from.t < 1e-9)
              continue;
            ++n_pieces;
            const auto found =
              judges::enumerate_step(problem,
                                     judges::judge_slips(from),
                                     judges::judge_load(scene.system, history.factors(to.t)));
            double nearest = std::numeric_limits<double>::infinity();
            for (const auto &solution : found.solutions)
              {
                double distance = 0.;
                for (std::size_t b = 0; b < 2 * scene.n; ++b)
                  distance = std::max(
                    distance, std::abs(solution.forces[b] - to.forces[b]) / solution.force_scale);
                nearest = std::min(nearest, distance);
              }
            EXPECT_LE(nearest, tolerance) << "seed " << seed << " at t = " << to.t;

            // Lemke's method finds one solution; on these problems there is only one. On a ray it
            // says nothing, which must stay rare.
            const auto lemke =
              judges::lemke_step(problem,
                                 judges::judge_slips(from),
                                 judges::judge_load(scene.system, history.factors(to.t)),
                                 tolerance);
            if (!lemke.solved)
              {
                ++n_rays;
                continue;
              }
            for (std::size_t b = 0; b < 2 * scene.n; ++b)
              EXPECT_LE(std::abs(lemke.solution.forces[b] - to.forces[b]),
                        tolerance * lemke.solution.force_scale)
                << "seed " << seed << " at t = " << to.t;
          }
      }
    EXPECT_GT(n_events, 2 * n_scenes);
    EXPECT_GT(n_pieces, 4 * n_scenes);
    EXPECT_LE(n_rays, n_pieces / 100);
  }
} // namespace

TEST(RandomPath, CompliantEqualsEnumeration)
{
  check(Compliance::compliant, 1000);
}

TEST(RandomPath, RigidEqualsEnumeration)
{
  check(Compliance::rigid, 2000);
}

TEST(RandomPath, MixedEqualsEnumeration)
{
  check(Compliance::mixed, 3000);
}
