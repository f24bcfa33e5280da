// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/cone_toy.h"

#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/segments/curved_segment.h>
#include <fuga/laws/cubic_root_law.h>

#include <boost/numeric/odeint.hpp>

#include <cmath>

namespace fuga::tests
{
  namespace
  {
    /** Of law (9). */
    constexpr double first_compliance = 0.3, thickness = 2., area = 0.7;

    double
    stress(const double w)
    {
      return w / (first_compliance * (1. - std::cbrt(w / thickness)));
    }

    double
    stress_slope(const double w)
    {
      const double q = std::cbrt(w / thickness);
      return (1. - 2. / 3. * q) / (first_compliance * (1. - q) * (1. - q));
    }

    /** What differs between the cases. */
    struct Case
    {
      bool shear_layer;
      double friction, cohesion, dilatancy;
      StrengthEnvelope envelope = {};
    };

    /**
     * One element whose body couples its three directions, S δ + p = F a, on a layer of law (9);
     * while it slides along e = T/|T|, |T| + f N = cA. Written from these equations, as an ordinary
     * differential equation for the slip and the rise of the lips, in which the jump is found by
     * Newton's method.
     */
    class SlidingElement
    {
    public:
      using State = Vector;

      SlidingElement(const ToySystem &toy, const Case &of_case, const LoadHistory &loads)
        : system(toy), law(of_case), history(loads)
      {
      }

      /** Jump δ at given slips s1, s2 and rise y[2]. */
      Vector
      jump(const State &y, const double t) const
      {
        Vector delta = {y[2] - 0.1, y[0], y[1]};
        for (int i = 0; i < 60; ++i)
          {
            Vector r       = bar_forces(delta, t);
            const double w = y[2] - delta[0];
            r[0] += area * stress(w);
            const std::array<double, 2> e = {{delta[1] - y[0], delta[2] - y[1]}};
            const double size             = std::hypot(e[0], e[1]);
            if (law.shear_layer)
              for (int a = 0; a < 2 && size > 0.; ++a)
                r[1 + a] -= area * stress(size) * e[a] / size;
            if (!law.shear_layer)
              {
                r[1] = -e[0];
                r[2] = -e[1];
              }
            LuFactors(jacobian(y, delta)).solve(r);
            double largest = 0.;
            for (std::size_t a = 0; a < 3; ++a)
              {
                delta[a] -= r[a];
                largest = std::max(largest, std::abs(r[a]));
              }
            if (largest < 1e-15)
              break;
          }
        return delta;
      }

      Vector
      bar_forces(const Vector &delta, const double t) const
      {
        Vector p = multiply(system.F, history.factors(t));
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j)
            p[i] -= system.S(i, j) * delta[j];
        return p;
      }

      void
      operator()(const State &y, State &rate, const double t) const
      {
        const Vector delta = jump(y, t), p = bar_forces(delta, t);
        const double T        = std::hypot(p[1], p[2]);
        const double e[2]     = {p[1] / T, p[2] / T};
        const DenseMatrix J   = jacobian(y, delta);
        const Vector by_loads = multiply(system.F, history.rates(t));
        // The residual's derivatives with respect to the loads and to an amount of slip along e.
        Vector from_load = by_loads, from_slip(3, 0.);
        from_slip[0]     = area * stress_slope(y[2] - delta[0]) * law.dilatancy;
        for (std::size_t a = 0; a < 2; ++a)
          if (law.shear_layer)
            from_slip[1 + a] = -(J(1 + a, 1) + system.S(1 + a, 1)) * e[0] -
                               (J(1 + a, 2) + system.S(1 + a, 2)) * e[1];
          else
            {
              from_load[1 + a] = 0.;
              from_slip[1 + a] = e[a];
            }
        const LuFactors factors{DenseMatrix(J)};
        factors.solve(from_load);
        factors.solve(from_slip);
        // δ' = -(from_load + γ from_slip), p' = F a' - S δ', e·T' + f G'(-N/A) N' = 0.
        const double slope = law.friction * std::pow(1. - p[0] / area / law.envelope.pressure,
                                                     law.envelope.exponent - 1.);
        const auto along   = [&](const Vector &x) {
          return e[0] * x[1] + e[1] * x[2] + slope * x[0];
        };
        const double gamma = -(along(by_loads) + along(multiply(system.S, from_load))) /
                             along(multiply(system.S, from_slip));
        rate = {gamma * e[0], gamma * e[1], gamma * law.dilatancy};
      }

    private:
      // Of the residual with respect to the jump.
      DenseMatrix
      jacobian(const State &y, const Vector &delta) const
      {
        DenseMatrix J(3, 3);
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j)
            J(i, j) = i == 0 || law.shear_layer ? -system.S(i, j) : (i == j ? -1. : 0.);
        J(0, 0) -= area * stress_slope(y[2] - delta[0]);
        const std::array<double, 2> e = {{delta[1] - y[0], delta[2] - y[1]}};
        const double size             = std::hypot(e[0], e[1]);
        if (law.shear_layer)
          for (std::size_t i = 0; i < 2; ++i)
            for (std::size_t j = 0; j < 2; ++j)
              {
                const double secant = size > 0. ? stress(size) / size : 1. / first_compliance;
                const double unit   = size > 0. ? e[i] * e[j] / (size * size) : 0.;
                J(1 + i, 1 + j) -=
                  area * ((i == j ? secant : 0.) + (stress_slope(size) - secant) * unit);
              }
        return J;
      }

      const ToySystem &system;
      const Case law;
      const LoadHistory &history;
    };

    /** Bodies that couple the pressure with both shears. */
    ToySystem
    coupled_element()
    {
      ToySystem system;
      system.S             = DenseMatrix(3, 3);
      system.F             = DenseMatrix(3, 3);
      const double S[3][3] = {{1.5, 0.3, -0.2}, {0.3, 4., 0.5}, {-0.2, 0.5, 3.}};
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          system.S(i, j) = S[i][j];
      system.F(0, 0) = -2.;
      system.F(1, 1) = system.F(2, 2) = 4.;
      return system;
    }

    /** Pressed, dragged along the second tangent, then, between 2 and 3, along the first. */
    LoadHistory
    dragged_around_a_corner()
    {
      return LoadHistory({0., 1., 2., 3.},
                         {{0., 0., 0.}, {1., 0., 0.}, {1., 0., 0.8}, {0.9, 1., 1.2}});
    }

    std::unique_ptr<ComplianceLaw>
    law_nine()
    {
      return std::make_unique<CubicRootLaw>(first_compliance, thickness);
    }

    ConeJoint
    layered_joint(const Case &of_case)
    {
      ConeJoint joint(
        1, area, law_nine(), of_case.shear_layer ? law_nine() : make_rigid_law(), of_case.friction);
      FrictionLaw &friction = joint.elements[0].friction;
      friction.envelope     = of_case.envelope;
      friction.cohesion     = of_case.cohesion;
      friction.dilatancy    = of_case.dilatancy;
      return joint;
    }

    const std::vector<Case> cases = {{false, 0.4, 0., 0.},
                                     {true, 0.4, 0., 0.},
                                     {false, 0.5, 0.2, 0.},
                                     {true, 0.4, 0.1, 0.2},
                                     {false, 0.6, 0., 0., {0.6, 1.}},
                                     {true, 0.6, 0.1, 0.1, {0.7, 2.}}};

    SlidingElement::State
    slips_of(const JointState &state)
    {
      return {state.slips[0][0], state.slips[0][1], state.dilations[0]};
    }

    SlidingElement::State
    reference(const SlidingElement &element, SlidingElement::State y, const double to)
    {
      namespace odeint = boost::numeric::odeint;
      odeint::integrate_adaptive(
        odeint::make_controlled<odeint::runge_kutta_fehlberg78<SlidingElement::State>>(1e-14,
                                                                                       1e-14),
        std::cref(element),
        y,
        2.,
        to,
        1e-3);
      return y;
    }
  } // namespace

  // The path of the program against an integrator of somebody else.
  TEST(CurvedSegment, TractrixOnNonlinearLayers)
  {
    for (std::size_t i = 0; i < cases.size(); ++i)
      {
        SCOPED_TRACE(i);
        const ToySystem system    = coupled_element();
        const ConeJoint joint     = layered_joint(cases[i]);
        const LoadHistory history = dragged_around_a_corner();
        const ConeRun run(system, joint.elements, history, {2., 2.1, 2.5, 3.});
        ASSERT_EQ(run.result.verdict, Verdict::done);
        const SlidingElement element(system, cases[i], history);
        const std::vector<JointState> &levels = run.record.levels;
        ASSERT_TRUE(is_slipping(levels.front().states[0]));
        ASSERT_EQ(run.result.n_events, 1u); // stick to slip
        for (const JointState &state : levels)
          {
            const SlidingElement::State y = reference(element, slips_of(levels.front()), state.t);
            const Vector p                = element.bar_forces(element.jump(y, state.t), state.t);
            for (std::size_t a = 0; a < 3; ++a)
              {
                EXPECT_NEAR(slips_of(state)[a], y[a], 1e-9) << state.t;
                EXPECT_NEAR(state.forces[a], p[a], 1e-9) << state.t;
              }
          }
        EXPECT_GT(std::abs(std::atan2(levels.back().forces[2], levels.back().forces[1]) -
                           std::atan2(levels.front().forces[2], levels.front().forces[1])),
                  0.3);
        EXPECT_LT(run.record.worst.worst(), 1e-8);
      }
  }

  // Without any load law (9) has no curvature to go by, and trial steps are too long. The load that
  // closes the layer by a given w is S w + A σ(w); what friction leaves of the shear slides, and
  // stays where it is while the load does.
  TEST(CurvedSegment, SlidesFromTheApexOnLawNine)
  {
    constexpr double stiffness = 2., friction = 0.4, closure = 0.02;
    const double pressing = area * stress(closure), slip = (5. - friction * pressing) / stiffness;
    ToySystem system;
    system.S = DenseMatrix(3, 3);
    system.F = DenseMatrix(3, 1);
    for (std::size_t i = 0; i < 3; ++i)
      system.S(i, i) = stiffness;
    system.F(0, 0)        = -(stiffness * closure + pressing);
    system.F(1, 0)        = 3.;
    system.F(2, 0)        = 4.;
    const ConeJoint joint = layered_joint({false, friction, 0., 0.});
    const ConeRun run(system, joint.elements, LoadHistory({0., 1., 2.}, {{0.}, {1.}, {1.}}), {2.});
    ASSERT_EQ(run.result.verdict, Verdict::done);
    const JointState &end = run.record.levels.back();
    EXPECT_NEAR(end.forces[0], -pressing, 1e-10);
    for (std::size_t a = 0; a < 2; ++a)
      {
        const double e = a == 0 ? 0.6 : 0.8;
        EXPECT_NEAR(end.forces[1 + a], friction * pressing * e, 1e-10);
        EXPECT_NEAR(end.slips[0][a], slip * e, 1e-10);
      }
  }

  // Equal steps, each from where the one before ended, as a level inside a long step is found.
  TEST(CurvedSegment, KeepsItsOrderOnNonlinearLayers)
  {
    for (std::size_t i = 0; i < cases.size(); ++i)
      {
        SCOPED_TRACE(i);
        const ToySystem system    = coupled_element();
        const ConeJoint joint     = layered_joint(cases[i]);
        const LoadHistory history = dragged_around_a_corner();
        const LayeredSystem layered(system, joint.elements);
        const ConeRun run(system, joint.elements, history, {2.});
        const JointState begin = run.record.levels.front();
        const double t_end     = 2.4;
        const SlidingElement element(system, cases[i], history);
        const SlidingElement::State exact = reference(element, slips_of(begin), t_end);

        const auto error_with = [&](const int n_steps) {
          PathPoint point = {begin, {}};
          for (int n = 0; n < n_steps; ++n)
            {
              const TangentVector T = tangential(joint.elements[0], point.state.forces);
              const TangentVector e = {{T[0] / length(T), T[1] / length(T)}};
              Course course;
              course.t               = point.state.t;
              course.t_end           = 3.;
              course.length          = course.t_end - course.t;
              course.factors         = history.factors(course.t);
              course.factor_rates    = history.rates(course.t);
              course.drive.reactions = multiply(layered.reactions(), course.factor_rates);
              WorkingScheme scheme(joint.elements, layered);
              scheme.set_state(0, ContactState::slip_forward, e);
              scheme.set_strength(0, point.state.strengths[0]);
              scheme.linearise(point.state);
              point.rates = *scheme.rates(course.drive);
              ContactBoundary boundary(joint.elements, layered);
              boundary.set_scales(point.state, course.factors, 1.);
              WorkingScheme background(joint.elements, layered);
              IterationCount count;
              CurvedSegment segment({joint.elements, layered, boundary, background},
                                    course,
                                    point,
                                    {e},
                                    PathOptions(),
                                    count);
              point = segment.at((t_end - 2.) / n_steps);
            }
          double error = 0.;
          for (std::size_t a = 0; a < 3; ++a)
            error = std::max(error, std::abs(slips_of(point.state)[a] - exact[a]));
          return error;
        };
        const double coarse = error_with(2), middle = error_with(4), fine = error_with(8);
        EXPECT_LT(coarse, 1e-3);
        EXPECT_GT(fine, 1e-12); // rounding tells nothing
        EXPECT_GT(coarse, 16. * middle) << coarse << ' ' << middle << ' ' << fine;
        EXPECT_GT(middle, 16. * fine) << coarse << ' ' << middle << ' ' << fine;
      }
  }
} // namespace fuga::tests
