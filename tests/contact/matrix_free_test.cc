// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Steps in which forces follow from jumps by return mapping: derivatives against differences, the
// conditions they are to meet, and ends of steps against those of working schemes.

#include "contact/cone_toy.h"
#include "contact/plane_scenes.h"
#include "contact/products_only.h"

#include <fuga/contact/element/joint_strength.h>
#include <fuga/contact/element/return_mapping.h>
#include <fuga/contact/path/matrix_free_path.h>
#include <fuga/contact/virgin_state.h>

namespace fuga::tests
{
  namespace
  {
    const std::vector<double> corners = {1., 2., 3., 4., 5.};

    /** All but the reduction of strengths. */
    std::vector<SceneCase>
    cases_without_reduction()
    {
      std::vector<SceneCase> result;
      for (const SceneCase &scene_case : scene_cases())
        if (!make_scene(scene_case, 1).elements[0].friction.reduced)
          result.push_back(scene_case);
      return result;
    }

    bool
    has_risen(const ContactElement &element, const StepResponse &response)
    {
      return response.dilation >= element.friction.dilation_limit;
    }

    class WithoutStiffness : public testing::TestWithParam<SceneCase>
    {
    };

    class CrossingWithoutStiffness : public WithoutStiffness
    {
    };

    /** Where two rigid layers are closed the third, which cannot move then, has no state of its
     * own. */
    std::vector<SceneCase>
    cases_with_compliance()
    {
      std::vector<SceneCase> result;
      for (const SceneCase &scene_case : cases_without_reduction())
        if (make_scene(scene_case, 1).normal->kind() != ComplianceKind::rigid)
          result.push_back(scene_case);
      return result;
    }

    /** Compares the ends of steps until one is another solution of the same step, if lips that rise
     * may be apart or touch; where joints cross, also higher or lower, or if of two bonds the one
     * that breaks first spares the other. Counts those compared. */
    void
    expect_same_steps(const PlaneScene &scene, std::size_t &n_same, std::size_t &n_other)
    {
      const LayeredSystem layered(scene.system, scene.elements);
      Record by_schemes(scene.system, scene.elements, scene.history);
      PathOptions options;
      options.follow = PathOptions::Follow::stage_ends;
      EventPath(scene.elements, layered, scene.history, options).run(corners, by_schemes);

      const ProductsOnly bodies(scene.system);
      Record by_jumps(scene.system, scene.elements, scene.history);
      MatrixFreePath(scene.elements, layered, bodies, bodies, scene.history).run(corners, by_jumps);

      EXPECT_LT(by_jumps.worst.worst(), 1e-9);
      ASSERT_EQ(by_jumps.levels.size(), by_schemes.levels.size());
      for (std::size_t i = 0; i < by_jumps.levels.size(); ++i)
        {
          const JointState &a = by_jumps.levels[i], &b = by_schemes.levels[i];
          const FrictionLaw &friction = scene.elements[0].friction;
          const bool crosses          = scene.system.B.size() > 0;
          if ((a.states != b.states ||
               (crosses && largest_difference(a.dilations, b.dilations) > 1e-9)) &&
              (friction.dilatancy > 0. ||
               (crosses && friction.bond_loss == FrictionLaw::BondLoss::slip)))
            {
              ++n_other;
              break;
            }
          ++n_same;
          EXPECT_LT(largest_difference(a.forces, b.forces), 1e-9 * max_abs(b.forces)) << i;
          EXPECT_LT(largest_difference(a.dilations, b.dilations), 1e-9) << i;
          EXPECT_EQ(a.states, b.states) << i;
          EXPECT_EQ(a.strengths, b.strengths) << i;
        }
    }
  } // namespace

  // Random jumps: forces on or within the strength, slip along the shear, lips that rise with it;
  // and central differences, which lack the cube of a step of 1e-6 and rounding over it.
  TEST_P(WithoutStiffness, ReturnsToTheStrength)
  {
    constexpr double step = 1e-6;
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> closure(0.02, 0.2), shear(-0.4, 0.4);
    std::size_t n_slips = 0;
    for (unsigned int trial = 0; trial < 20; ++trial)
      {
        const PlaneScene scene = oblique_scene(GetParam(), trial + 1);
        JointState from        = virgin_state(scene.elements, 9, false);
        Vector jumps;
        for (const ContactElement &element : scene.elements)
          {
            jumps.push_back(-element.initial_gap - closure(generator));
            jumps.push_back(shear(generator));
            jumps.push_back(shear(generator));
          }
        const AugmentedLayers layers(scene.elements, Vector(9, 10.), {});
        ReturnMapping mapping(layers.elements(), from, jumps);
        for (std::size_t k = 0; k < scene.elements.size(); ++k)
          {
            SCOPED_TRACE(testing::Message() << "trial " << trial << ", element " << k);
            const ContactElement &element = scene.elements[k];
            const StepResponse response   = mapping.respond(k);
            ASSERT_NE(response.state, ContactState::open);
            const TangentVector T = {{response.forces[1], response.forces[2]}};
            const double strength = shear_strength(element, from, k, response.forces[0]);
            EXPECT_LE(length(T), strength * (1. + 1e-12));
            const double way = length(response.slip);
            if (is_slipping(response.state))
              {
                ++n_slips;
                EXPECT_NEAR(length(T), strength, 1e-12 * strength);
                EXPECT_NEAR(dot(response.slip, T), way * length(T), 1e-12 * way * length(T));
              }
            else
              EXPECT_EQ(way, 0.);
            const double rise =
              from.states[k] == ContactState::open
                ? 0.
                : std::min(from.strengths[k].dilatancy * way, element.friction.dilation_limit);
            EXPECT_NEAR(response.dilation, rise, 1e-12);
            for (std::size_t j = 0; j < 3; ++j)
              {
                std::array<StepResponse, 2> beside;
                for (const std::size_t side : {0u, 1u})
                  {
                    Vector moved = jumps;
                    moved[3 * k + j] += side == 0 ? -step : step;
                    beside[side] = ReturnMapping(layers.elements(), from, moved).respond(k);
                  }
                if (beside[0].state != beside[1].state ||
                    has_risen(element, beside[0]) != has_risen(element, beside[1]))
                  continue;
                for (std::size_t i = 0; i < 3; ++i)
                  EXPECT_NEAR((beside[1].forces[i] - beside[0].forces[i]) / (2. * step),
                              response.tangent[i][j],
                              1e-6 * (1. + std::abs(response.tangent[i][i])))
                    << "force " << i << " by jump " << j;
              }
          }
      }
    EXPECT_GT(n_slips, 10u);
  }

  // In the plane, and on cones in space under loads from all sides.
  TEST_P(WithoutStiffness, EndsStepsWhereSchemesDo)
  {
    std::size_t n_same = 0, n_other = 0;
    for (unsigned int seed = 1; seed <= 6; ++seed)
      {
        SCOPED_TRACE(seed);
        expect_same_steps(make_scene(GetParam(), seed), n_same, n_other);
        expect_same_steps(oblique_scene(GetParam(), seed), n_same, n_other);
      }
    EXPECT_GT(n_same, 50u);
    EXPECT_LE(n_other, 2u);
  }

  // Where joints cross there are more bars than coordinates: here a further element feels the sum
  // of the jumps of two others.
  TEST_P(CrossingWithoutStiffness, EndsStepsWhereSchemesDo)
  {
    std::size_t n_same = 0, n_other = 0;
    for (unsigned int seed = 1; seed <= 6; ++seed)
      {
        SCOPED_TRACE(seed);
        PlaneScene scene    = make_scene(GetParam(), seed);
        const std::size_t n = scene.elements.size(), m = 2 * n;
        scene.system.B = DenseMatrix(m + 2, m);
        for (std::size_t i = 0; i < m; ++i)
          scene.system.B(i, i) = 1.;
        for (std::size_t i = 0; i < 2; ++i)
          scene.system.B(m + i, i) = scene.system.B(m + i, 2 + i) = 1.;
        scene.elements.push_back(scene.elements.front());
        scene.elements.back().normal_bar     = static_cast<unsigned int>(m);
        scene.elements.back().tangential_bar = static_cast<unsigned int>(m + 1);
        expect_same_steps(scene, n_same, n_other);
      }
    EXPECT_GT(n_same, 20u);
    EXPECT_LE(n_other, 3u);
  }

  // Lips that rose by their whole way in the step in which they meet would be pressed together at
  // once: forces would jump with the gap, and steps of some of these scenes end nowhere.
  TEST(MatrixFreePath, LipsThatRiseLeaveNoStepWithoutEnd)
  {
    std::size_t n_steps = 0;
    for (const SceneCase &scene_case : cases_without_reduction())
      for (unsigned int seed = 1; seed <= 60; ++seed)
        for (const PlaneScene &scene :
             {make_scene(scene_case, seed), oblique_scene(scene_case, seed)})
          {
            if (scene.elements[0].friction.dilatancy == 0.)
              continue;
            SCOPED_TRACE(testing::Message() << scene_case.name << ", " << seed);
            const LayeredSystem layered(scene.system, scene.elements);
            const ProductsOnly bodies(scene.system);
            Record record(scene.system, scene.elements, scene.history);
            EXPECT_NO_THROW(MatrixFreePath(scene.elements, layered, bodies, bodies, scene.history)
                              .run(corners, record));
            EXPECT_LT(record.worst.worst(), 1e-9);
            n_steps += record.levels.size();
          }
    EXPECT_GE(n_steps, 6u * 2u * 60u * corners.size());
  }

  INSTANTIATE_TEST_SUITE_P(Laws,
                           CrossingWithoutStiffness,
                           testing::ValuesIn(cases_with_compliance()),
                           name_of_case);

  INSTANTIATE_TEST_SUITE_P(Laws,
                           WithoutStiffness,
                           testing::ValuesIn(cases_without_reduction()),
                           name_of_case);
} // namespace fuga::tests
