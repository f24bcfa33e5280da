// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Stages in one step: in space, and with every law.

#include "contact/cone_toy.h"
#include "contact/lifted_problem.h"
#include "contact/plane_scenes.h"

#include <fuga/contact/virgin_state.h>

#include <cmath>

namespace fuga::tests
{
  namespace
  {
    /** A path by steps, with beginning and end of every step. */
    class Steps : public Record
    {
    public:
      std::vector<std::pair<JointState, JointState>> steps;
      PathResult result;

      Steps(const ContactSystem &system,
            const std::vector<ContactElement> &elements,
            const LoadHistory &history,
            const std::vector<double> &load_times)
        : Record(system, elements, history)
      {
        const LayeredSystem layered(system, elements);
        PathOptions options;
        options.follow = PathOptions::Follow::stage_ends;
        here           = virgin_state(elements, layered.n_bars(), false);
        EventPath path(elements, layered, history, options);
        result = path.run(load_times, *this);
      }

      void
      advanced(const PathPoint &from, const PathPoint &to, const double length) override
      {
        Record::advanced(from, to, length);
        here = to.state;
      }

      void
      jumped(const JointState &to) override
      {
        Record::jumped(to);
        steps.push_back({here, to});
        here = to;
      }

      void
      changed(const std::vector<ContactEvent> &new_events, const JointState &state) override
      {
        Record::changed(new_events, state);
        here = state;
      }

    private:
      JointState here;
    };

    const std::vector<double> corners = {1., 2., 3., 4., 5.};

    /** What a backward Euler step demands of the slip of an element, beyond what a state shows: it
     * has the direction of the shear force, sticking elements do not slip, lips that touched rise
     * by tan ψ. The largest violation, in the units of jumps. */
    double
    wrong_slip(const ContactElement &element,
               const std::size_t k,
               const JointState &from,
               const JointState &to)
    {
      const TangentVector slip = sum(to.slips[k], -1., from.slips[k]);
      const double way         = length(slip);
      double rise              = 0.;
      double wrong             = 0.;
      if (to.states[k] == ContactState::stick)
        wrong = way;
      else if (is_slipping(to.states[k]))
        {
          wrong = length(sum(slip, -way, direction_of(tangential(element, to.forces))));
          if (from.strengths[k].dilatancy > 0. && from.states[k] != ContactState::open)
            rise = std::min(from.dilations[k] + element.friction.dilatancy * way,
                            element.friction.dilation_limit) -
                   from.dilations[k];
        }
      return std::max(wrong, std::abs(to.dilations[k] - from.dilations[k] - rise));
    }

    class StepsWithLaws : public testing::TestWithParam<SceneCase>
    {
    };
  } // namespace

  // Against Gauss-Seidel sweeps from element to element, which project one after the other.
  TEST(ImplicitStep, IsTheReturnMapping)
  {
    for (unsigned int seed = 1; seed <= 40; ++seed)
      {
        SCOPED_TRACE(seed);
        std::mt19937 generator(seed);
        const std::size_t n    = 8;
        const double friction  = seed % 2 == 0 ? 0.3 : 0.6;
        const ToySystem system = random_bodies(n, generator);
        ConeJoint joint(n, 1., make_linear_law(0.1), make_linear_law(0.2), friction);
        Vector gaps(n, 0.);
        for (std::size_t k = 0; k < n; k += 3)
          gaps[k] = joint.elements[k].initial_gap = 0.05 * static_cast<double>(k);
        const LoadHistory history = roundabout();
        const Steps run(system, joint.elements, history, corners);
        EXPECT_EQ(run.steps.size(), corners.size());
        EXPECT_LT(run.worst.worst(), 1e-9);
        const LayeredSystem layered(system, joint.elements);
        Vector d(3 * n, 0.);
        for (std::size_t c = 0; c < corners.size(); ++c)
          {
            d = return_mapping(layered.stiffness(),
                               multiply(layered.reactions(), history.factors(corners[c])),
                               gaps,
                               friction,
                               d,
                               1e-14);
            EXPECT_LT(largest_difference(run.levels[c].dislocations, d), 1e-10) << "corner " << c;
          }
      }
  }

  // Virgin joints without gaps under one load: the path is straight, and its end that of the step.
  TEST(ImplicitStep, EndsProportionalLoadsWhereEventsEnd)
  {
    for (unsigned int seed = 1; seed <= 40; ++seed)
      {
        SCOPED_TRACE(seed);
        std::mt19937 generator(seed);
        const std::size_t n    = 12;
        const ToySystem system = random_bodies(n, generator);
        ConeJoint joint(n, 1., make_linear_law(0.05), make_linear_law(0.05), 0.4);
        const LoadHistory history({0., 1.}, {{0., 0., 0.}, {1., 1., -1.}});
        const ConeRun followed(system, joint.elements, history, {1.});
        const Steps stepped(system, joint.elements, history, {1.});
        ASSERT_EQ(stepped.steps.size(), 1u);
        EXPECT_LT(largest_difference(followed.record.last.forces, stepped.last.forces), 1e-10);
        EXPECT_LT(largest_difference(followed.record.last.dislocations, stepped.last.dislocations),
                  1e-10);
      }
  }

  // In the plane and in space, with tangents turned by any angle, with every law.
  TEST_P(StepsWithLaws, AreInSpaceThoseOfThePlane)
  {
    std::size_t n_steps = 0;
    for (unsigned int seed = 1; seed <= 6; ++seed)
      {
        SCOPED_TRACE(seed);
        const PlaneScene scene = make_scene(GetParam(), seed);
        const Steps plane(scene.system, scene.elements, scene.history, corners);
        const LiftedProblem lifted(scene.system, scene.elements);
        const Steps space(lifted.system, lifted.elements, scene.history, corners);
        n_steps += plane.steps.size();
        EXPECT_LT(plane.worst.worst(), 1e-9);
        EXPECT_LT(space.worst.worst(), 1e-9);
        ASSERT_EQ(space.steps.size(), plane.steps.size());
        for (std::size_t i = 0; i < plane.steps.size(); ++i)
          {
            const JointState &from = plane.steps[i].first, &to = plane.steps[i].second;
            for (std::size_t k = 0; k < scene.elements.size(); ++k)
              EXPECT_LT(wrong_slip(scene.elements[k], k, from, to), 1e-11)
                << "step " << i << ", element " << k;
            EXPECT_LT(
              largest_difference(space.steps[i].second.forces, LiftedProblem::lift(to).forces),
              1e-9)
              << "step " << i;
          }
      }
    EXPECT_GT(n_steps, 20u);
  }

  // Loads that come from all sides: slips of a step have the direction of the force at its end.
  TEST_P(StepsWithLaws, HaveRightSlipsInSpace)
  {
    std::size_t n_steps = 0, n_slips = 0;
    for (unsigned int seed = 1; seed <= 6; ++seed)
      {
        SCOPED_TRACE(seed);
        const PlaneScene scene = oblique_scene(GetParam(), seed);
        const Steps space(scene.system, scene.elements, scene.history, corners);
        EXPECT_EQ(space.result.verdict, Verdict::done);
        EXPECT_LT(space.worst.worst(), 1e-9);
        n_steps += space.steps.size();
        for (const auto &[from, to] : space.steps)
          for (std::size_t k = 0; k < scene.elements.size(); ++k)
            {
              n_slips += is_slipping(to.states[k]) ? 1 : 0;
              EXPECT_LT(wrong_slip(scene.elements[k], k, from, to), 1e-11) << to.t << ", " << k;
            }
      }
    EXPECT_GT(n_steps, 20u);
    EXPECT_GT(n_slips, 5u);
  }

  // Between bodies that hardly deform an element has lips that move as they are told. Without shear
  // it does not slip, with all of it, it sticks or does: between these there is a slip for every
  // strength. Where less shear loosens the layer faster than the strength falls it is a long one.
  TEST(ImplicitStep, LetsLipsOfCoupledLayersGo)
  {
    std::size_t n_slips = 0;
    for (unsigned int seed = 1; seed <= 400; ++seed)
      {
        SCOPED_TRACE(seed);
        std::mt19937 generator(seed);
        const auto between = [&](const double low, const double high) {
          return std::uniform_real_distribution<>(low, high)(generator);
        };
        const auto kind =
          seed % 2 == 0 ? ShearCoupling::Kind::closure : ShearCoupling::Kind::pressure;
        ToyJoint joint(
          1, 1., make_linear_law(0.5), make_linear_law(0.5), FrictionLaw{between(0.3, 1.5)});
        const ShearCoupling coupling(kind,
                                     *joint.normal,
                                     std::pow(10., between(-1.5, 0.5)),
                                     std::pow(10., between(-1.5, 0.5)),
                                     between(0.3, 1.));
        joint.elements[0].coupling = &coupling;
        constexpr double stiff     = 1e4;
        ToySystem system;
        system.S = system.F = DenseMatrix(2, 2);
        for (std::size_t i = 0; i < 2; ++i)
          {
            system.S(i, i) = stiff;
            system.F(i, i) = stiff;
          }
        const double first = between(0.02, 1.), second = between(0.02, 1.);
        const double closed = kind == ShearCoupling::Kind::closure ? coupling.closure_limit() : 1.;
        const LoadHistory history({0., 1., 2.},
                                  {{0., 0.},
                                   {-first * std::min(closed, 1.), between(-1., 1.)},
                                   {-second * std::min(closed, 1.), between(-1., 1.)}});
        const Steps run(system, joint.elements, history, {1., 2.});
        EXPECT_EQ(run.steps.size(), 2u);
        EXPECT_LT(run.worst.worst(), 1e-9);
        for (const auto &[from, to] : run.steps)
          {
            n_slips += is_slipping(to.states[0]) ? 1 : 0;
            EXPECT_LT(wrong_slip(joint.elements[0], 0, from, to), 1e-9);
          }
      }
    EXPECT_GT(n_slips, 200u);
  }

  INSTANTIATE_TEST_SUITE_P(Laws, StepsWithLaws, testing::ValuesIn(scene_cases()), name_of_case);
} // namespace fuga::tests
