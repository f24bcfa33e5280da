// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_joint_state_h
#define fuga_contact_joint_state_h

#include <fuga/base/fields.h>
#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/contact/tangent_vector.h>
#include <fuga/contact/water_in_joints.h>
#include <fuga/laws/contact_state.h>
#include <fuga/laws/friction_law.h>

namespace fuga
{
  /** The complete state of the joints at one load time. */
  struct JointState
  {
    /** Load time. */
    double t = 0.;
    /** Part of the present time step that is done while bodies move, from 0 to 1. */
    double part_of_step = 0.;
    /** The working scheme: the state of each element. */
    std::vector<ContactState> states;
    /** Bar forces p [MN], tension positive. */
    Vector forces;
    /** Dislocations d of the bars [m], see LayeredSystem. */
    Vector dislocations;
    /** Irreversible slip s of each element along its tangents [m]; follows the jump while the
     * element is open. */
    std::vector<TangentVector> slips;
    /** Rise of the lips by dilatancy [m]: they touch when the gap equals it. */
    Vector dilations;
    /** Remaining strength of each element. */
    std::vector<Strength> strengths;
    /**
     * Forces that bars have lost but still carry [MN], with their sign: a bond that has just broken
     * is unloaded at constant load, not at once.
     */
    Vector unreleased;
    /** The origin of the water in each element. This and the next three members are empty without
     * water. */
    std::vector<WaterAccess> access;
    /** Forces ω [MN] with which water presses the two sides of each bar apart, in excess of the
     * water pressure in the closed joint; `forces` are those that the sides transmit. */
    Vector water;
    /** The forces by which the water still has to grow, at constant load, after a change of access
     * [MN]. */
    Vector missing_water;
    /** The forces that isolated elements have kept, in excess of what seepage would give them
     * [MN]. */
    Vector kept_water;

    /** Return whether the load has to stand still until all unreleased forces and missing water are
     * given up. */
    bool
    is_unsettled() const
    {
      return max_abs(unreleased) > 0. || max_abs(missing_water) > 0.;
    }
  };

  template <typename State, typename Visitor, only_for<State, JointState> = 0>
  void
  for_each_field(State &state, Visitor &&visit)
  {
    auto &[t,
           part_of_step,
           states,
           forces,
           dislocations,
           slips,
           dilations,
           strengths,
           unreleased,
           access,
           water,
           missing_water,
           kept_water] = state;
    visit("t", t);
    visit("part_of_step", part_of_step);
    visit("states", states);
    visit("forces", forces);
    visit("dislocations", dislocations);
    visit("slips", slips);
    visit("dilations", dilations);
    visit("strengths", strengths);
    visit("unreleased", unreleased);
    visit("access", access);
    visit("water", water);
    visit("missing_water", missing_water);
    visit("kept_water", kept_water);
  }

  /** Give @p state the water of @p from, or remove its water if @p from has none. */
  inline void
  take_water(const JointState &from, JointState &state)
  {
    state.access        = from.access;
    state.water         = from.water;
    state.missing_water = from.missing_water;
    state.kept_water    = from.kept_water;
  }

  /** The rates of a JointState per unit of the path parameter. */
  struct JointRates
  {
    Vector forces;
    Vector dislocations;
  };

  template <typename Rates, typename Visitor, only_for<Rates, JointRates> = 0>
  void
  for_each_field(Rates &rates, Visitor &&visit)
  {
    auto &[forces, dislocations] = rates;
    visit("forces", forces);
    visit("dislocations", dislocations);
  }

  /**
   * The quantities that drive the joints along one segment: the rate Ṙ of the reactions of the
   * stuck joint to loads and water; the rate of the unreleased forces of broken bonds, which only
   * fall in size; and that of the missing water. All of them are given per bar and unit of the path
   * parameter; the last two are empty while loads change.
   */
  struct Drive
  {
    Vector reactions;
    Vector release;
    Vector missing_water = {};
    /** Rates at which a strength reduction lowers the strength of each bar at its present
     * pressure, ≤ 0: that of f|N| + cA for tangential bars, that of σ_t A for normal ones. Empty
     * without reduction. */
    Vector strength = {};
  };
} // namespace fuga

#endif
