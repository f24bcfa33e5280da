// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// What only space can get wrong, the judge must find: directions of force, slip, elastic shear and
// released force, and how far lips slide that turn.

#include "contact/cone_toy.h"

#include <fuga/laws/cubic_root_law.h>


#include <cmath>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  /** Angle by which what is planted is turned [rad]. */
  constexpr double turn = 1e-5;

  TangentVector
  polar(const double size, const double angle)
  {
    return {{size * std::cos(angle), size * std::sin(angle)}};
  }

  TangentVector
  turned(const TangentVector &v, const double angle)
  {
    return sum({{std::cos(angle) * v[0], std::cos(angle) * v[1]}}, std::sin(angle), normal_to(v));
  }

  void
  set_shear(const TangentVector &value, Vector &of_bars)
  {
    of_bars[1] = value[0];
    of_bars[2] = value[1];
  }

  TangentVector
  shear_of(const Vector &of_bars)
  {
    return {{of_bars[1], of_bars[2]}};
  }

  /**
   * One element between a rigid base and a body without stiffness: its forces are the loads. N = -1
   * throughout, and along the second half of the loads the shear goes along a chord from the angle
   * -φ to φ with the size of the strength, f + c, at both ends. The slip goes along the force at
   * both ends and, by symmetry, in the middle.
   */
  class TurningSlip : public testing::Test
  {
  protected:
    static constexpr double f = 0.4, c = 0.2, tan_psi = 0.3, phi = 0.4, speed = 2., D = 0.25;

    TurningSlip()
    {
      ContactElement &element    = joint.elements.front();
      element.friction.cohesion  = c;
      element.friction.dilatancy = tan_psi;
      body.S                     = DenseMatrix(3, 3);
      body.F                     = DenseMatrix(3, 3);
      for (std::size_t i = 0; i < 3; ++i)
        body.F(i, i) = 1.;
      from.state           = state_at(1., -phi);
      to.state             = state_at(2., phi);
      to.state.slips[0][0] = slip;
      finish(from, -phi);
      to.state.dilations[0] = tan_psi * way();
      finish(to, phi);
    }

    /** At the strength, all slips zero. */
    JointState
    state_at(const double t, const double angle) const
    {
      JointState state;
      state.t      = t;
      state.states = {ContactState::slip_forward};
      state.forces = {-1., 0., 0.};
      set_shear(polar(f + c, angle), state.forces);
      state.slips      = {{{0., 0.}}};
      state.dilations  = {0.};
      state.strengths  = {virgin_strength(joint.elements[0].friction, 1.)};
      state.unreleased = Vector(3, 0.);
      return state;
    }

    /** Dislocations from slip and rise, and rates. The layer is linear: both bars have the same
     * compliance D as in the contact system. */
    void
    finish(PathPoint &point, const double angle) const
    {
      point.state.dislocations = {
        point.state.dilations[0], point.state.slips[0][0], point.state.slips[0][1]};
      point.rates.forces       = {0., 0., 2. * (f + c) * std::sin(phi)};
      point.rates.dislocations = {tan_psi * speed, 0., 0.};
      set_shear(polar(speed, angle), point.rates.dislocations);
    }

    /** ∫|s'| of the cubic with the slips and rates above, by 2000 chords. */
    static double
    way()
    {
      double result        = 0.;
      TangentVector before = {{0., 0.}};
      for (int i = 1; i <= 2000; ++i)
        {
          const double x = i / 2000., y = 1. - x;
          // Hermite's cubics: x²(3 - 2x) for the value at one; x y², -x² y for the slopes.
          const TangentVector now = {
            {slip * x * x * (3. - 2. * x) + speed * std::cos(phi) * x * y * (y - x),
             -speed * std::sin(phi) * x * y}};
          result += length(sum(now, -1., before));
          before = now;
        }
      return result;
    }

    using Plant = std::function<void(PathPoint &, PathPoint &)>;

    /** The judge at the end of the piece after @p plant has spoilt it, with its certificate. The
     * layer has its energy from the loads before. */
    std::pair<Judge, Certificate>
    judge(const Plant &plant) const
    {
      PathPoint a = from, b = to;
      plant(a, b);
      Judge result(body, joint.elements, history);
      JudgeMemory memory          = result.memory();
      memory.ledger.external_work = 0.5 * D * (1. + (f + c) * (f + c));
      result.restore(memory);
      EXPECT_LE(result.judge(from.state).worst(), 1e-15);
      result.follow(a, b, 1.);
      const Certificate found = result.judge(b.state);
      return {result, found};
    }

    /** The certificate of one state with these elements. */
    Certificate
    judge_state(const std::vector<ContactElement> &elements, const JointState &state) const
    {
      return Judge(body, elements, history).judge(state);
    }

    static constexpr double slip = 1.9;
    ConeJoint joint{1, 1., make_linear_law(D), make_linear_law(D), f};
    ToySystem body;
    const LoadHistory history{{0., 1., 2.},
                              {{0., 0., 0.},
                               {-1., (f + c) * std::cos(phi), -(f + c) * std::sin(phi)},
                               {-1., (f + c) * std::cos(phi), (f + c) * std::sin(phi)}}};
    PathPoint from, to;
  };
} // namespace

// The judge's three points see the way to some 1e-6 at this turn; 2000 chords to 1e-8.
TEST_F(TurningSlip, NothingIsSeenWithout)
{
  const Certificate found = judge([](PathPoint &, PathPoint &) {}).second;
  EXPECT_LE(found.layer_law, 1e-6);
  EXPECT_LE(found.equilibrium, 1e-15);
  EXPECT_LE(found.cone, 1e-15);
  EXPECT_LE(found.slip_direction, 1e-15);
  EXPECT_LE(found.energy, 1e-6);
}

// The slip leaves the direction of the force by an angle at one end: the wrong work is |T| |s'|
// times it.
TEST_F(TurningSlip, SlipAcrossTheForce)
{
  const auto [the_judge, found] = judge([](PathPoint &a, PathPoint &) {
    set_shear(turned(shear_of(a.rates.dislocations), turn), a.rates.dislocations);
  });
  const double known            = (f + c) * speed * turn / the_judge.memory().largest_energy;
  EXPECT_NEAR(found.slip_direction, known, 1e-3 * known);
}

TEST_F(TurningSlip, SlipAgainstTheForce)
{
  const auto [the_judge, found] = judge([](PathPoint &a, PathPoint &b) {
    for (PathPoint *point : {&a, &b})
      {
        point->state.slips[0] = sum({{0., 0.}}, -1., point->state.slips[0]);
        for (Vector *of_bars : {&point->state.dislocations, &point->rates.dislocations})
          set_shear(sum({{0., 0.}}, -1., shear_of(*of_bars)), *of_bars);
      }
  });
  // At least |T| cos φ along the distance, against what the rise takes back of it.
  const double known = (f + c) * std::cos(phi) * slip / the_judge.memory().largest_energy;
  EXPECT_GT(found.slip_direction, 0.9 * known);
}

// The lips rise with the way along which they slid, not with the distance.
TEST_F(TurningSlip, RiseByTheDistance)
{
  const auto [the_judge, found] = judge([](PathPoint &, PathPoint &b) {
    b.state.dilations[0] = b.state.dislocations[0] = tan_psi * slip;
  });
  const double known            = tan_psi * (way() - slip) / the_judge.memory().largest_jump;
  EXPECT_GT(known, 1e-3);
  EXPECT_NEAR(found.layer_law, known, 1e-6);
}

// A stuck element slips, along a tangent that only space has.
TEST_F(TurningSlip, SlipOfAStuckElement)
{
  const auto [the_judge, found] = judge([](PathPoint &a, PathPoint &b) {
    for (PathPoint *point : {&a, &b})
      {
        point->state.states[0]    = ContactState::stick;
        point->state.dilations[0] = point->state.dislocations[0] = 0.;
        point->state.slips[0]                                    = {{0., 0.}};
        set_shear({{0., 0.}}, point->state.dislocations);
      }
    b.state.slips[0][1] = b.state.dislocations[2] = turn;
  });
  EXPECT_NEAR(found.layer_law, turn / the_judge.memory().largest_jump, 1e-15);
}

// The same share beyond the strength in every direction, however small its components are.
TEST_F(TurningSlip, ShearBeyondTheStrength)
{
  for (const double angle : {0.1, 0.8, 2., 4.})
    {
      JointState state = state_at(1., angle);
      set_shear(polar((f + c) * (1. + turn), angle), state.forces);
      state.dislocations      = Vector(3, 0.);
      const Certificate found = judge_state(joint.elements, state);
      EXPECT_NEAR(found.cone, (f + c) * turn, 1e-12);
      EXPECT_NEAR(found.slip_direction, (f + c) * turn, 1e-12);
      EXPECT_LE(found.layer_law, 1e-15);
    }
}

// What a broken bond still carries adds to the strength by its size, whatever its direction.
TEST_F(TurningSlip, StrengthNotYetReleased)
{
  JointState state            = state_at(1., 0.8);
  state.dislocations          = Vector(3, 0.);
  state.strengths[0].cohesion = 0.;
  set_shear(polar(c, 2.), state.unreleased);
  EXPECT_LE(judge_state(joint.elements, state).cone, 1e-15);
  EXPECT_LE(judge_state(joint.elements, state).slip_direction, 1e-15);
  set_shear(polar(c - turn, 2.), state.unreleased);
  EXPECT_NEAR(judge_state(joint.elements, state).cone, turn, 1e-12);
}

// Lips that are apart carry what is not yet released, in its direction.
TEST_F(TurningSlip, ReleaseInAnotherDirection)
{
  JointState state   = state_at(1., 0.8);
  state.states[0]    = ContactState::open;
  state.strengths[0] = {f, 0., 0., tan_psi, 1.};
  state.forces[0]    = 0.;
  state.dislocations = {1., 0., 0.};
  state.unreleased   = state.forces;
  EXPECT_LE(judge_state(joint.elements, state).complementarity, 0.);
  set_shear(polar(f + c, 0.8 + turn), state.unreleased);
  EXPECT_NEAR(judge_state(joint.elements, state).complementarity, (f + c) * turn, 1e-12);
}

// A layer deforms along its force: closures and shears of the law itself, the shear turned.
TEST_F(TurningSlip, ElasticShearAcrossTheForce)
{
  const CubicRootLaw law_nine(D, 1.);
  const ShearCoupling coupling(ShearCoupling::Kind::closure, law_nine, D, 2., 1.);
  for (const ShearCoupling *of_both : {static_cast<const ShearCoupling *>(nullptr), &coupling})
    for (const double angle : {0., turn})
      {
        std::vector<ContactElement> elements = joint.elements;
        elements[0].normal_law = elements[0].shear_law = &law_nine;
        elements[0].coupling                           = of_both;
        JointState state                               = state_at(1., 0.8);
        state.states[0]                                = ContactState::stick;
        set_shear(polar(0.5, 0.8), state.forces);
        // The coupled layer: σ_n(w) + ½ k_t' e² = 1, k_t e = 1/2 with k_t = 1/[D (1 - w/2)].
        double w = law_nine.deformation(1.), e = law_nine.deformation(0.5);
        if (of_both != nullptr)
          for (int i = 0; i < 100; ++i)
            {
              e = 0.5 * D * (1. - 0.5 * w);
              w = law_nine.deformation(1. - 0.25 * e * e / (D * (1. - 0.5 * w) * (1. - 0.5 * w)));
            }
        state.dislocations = {D - w, 0., 0.};
        set_shear(sum(polar(e, 0.8 + angle), -D, polar(0.5, 0.8)), state.dislocations);
        const Certificate found = judge_state(elements, state);
        EXPECT_NEAR(found.layer_law, e * angle / std::max(w, e), 1e-12);
        EXPECT_LE(found.cone, 0.);
      }
}
