// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/mechanism.h>
#include <fuga/contact/judge/judge.h>
#include <fuga/contact/tangent_vector.h>

#include <algorithm>
#include <cmath>

// The conditions that the judge imposes on a mechanism before it is called a limit load.
namespace fuga
{
  namespace
  {
    /** Share of the largest force of a state below which forces are zero. */
    constexpr double no_force_share = 1e-8;
    /** Share of the largest force of the run below which forces are left by rounding, where
     * everything has been unloaded. */
    constexpr double left_by_rounding = 1e-11;

    double
    nothing_beside(const double share, const double now, const double largest_of_run)
    {
      return std::max(share * now, left_by_rounding * largest_of_run);
    }

    /** Largest error of a motion that proves a limit load. Where the load approaches its limit
     * asymptotically the path ends while the motion still meets a small resistance. */
    constexpr double largest_error = 0.02;

    /** Return whether the share of its power with which the load drives a motion is more than the
     * errors of the motion can make of zero. */
    bool
    is_driven(const MechanismCertificate &proof)
    {
      constexpr double rounding = 1e-14, always_enough = 1e-9;
      return proof.drive > std::clamp(proof.error(), rounding, always_enough);
    }
  } // namespace

  double
  MechanismCertificate::error() const
  {
    return std::max({resistance, inadmissible, balance});
  }

  bool
  MechanismCertificate::proves() const
  {
    return error() <= largest_error && is_driven(*this);
  }

  bool
  MechanismCertificate::is_neutral() const
  {
    constexpr double none = 1e-7; // like a force that does not resist
    return std::max(error(), std::abs(drive)) <= none;
  }

  double
  Judge::slope_of_strength(const std::size_t k, const JointState &state) const
  {
    const ContactElement &element = elements[k];
    const std::size_t n           = element.normal_bar;
    const double pressing         = std::max(state.unreleased[n], 0.) - state.forces[n];
    return state.strengths[k].friction * element.friction.envelope.slope(pressing / element.area);
  }

  Freedom
  Judge::freedom(const std::size_t k, const JointState &state, const Vector &delta) const
  {
    using Kind                    = Freedom::Kind;
    const ContactElement &element = elements[k];
    const Strength &left          = state.strengths[k];
    const std::size_t n           = element.normal_bar;
    const double no_force = nothing_beside(no_force_share, max_abs(state.forces), largest_force);
    const double N        = state.forces[n];
    const double gap      = element.initial_gap + delta[n] - state.dilations[k];
    const double slope    = slope_of_strength(k, state);
    if (state.states[k] == ContactState::open &&
        gap > nothing_beside(closed_to_motions, max_abs(delta), largest_jump))
      return {Kind::open, 0., {}, 0., false};
    const bool at_apex    = left.tension <= no_force && N >= -no_force;
    const bool at_tension = left.tension > no_force && N >= left.tension - no_force;
    if (at_apex || at_tension)
      return {Kind::parting, 0., {}, slope, at_tension || left.cohesion > no_force};
    const TangentVector force = shear_part(element, state.forces);
    const double T            = length(force);
    if (!element.has_tangential_bar() ||
        T < left.friction * resisting_force(element.friction, element.area, -N) + left.cohesion -
              no_force)
      return {Kind::none, 0., {}, 0., true};
    if (T <= no_force)
      return {Kind::sliding, left.dilatancy, {}, slope, false};
    return {Kind::sliding, left.dilatancy, direction(force), slope, false};
  }

  double
  Judge::inadmissible_jump(const std::size_t k, const Freedom &freedom, const Vector &w) const
  {
    const double normal = w[elements[k].normal_bar], shear = length(shear_part(elements[k], w));
    switch (freedom.kind)
      {
        case Freedom::Kind::open:
          return 0.;
        case Freedom::Kind::parting:
          return std::max(0., -normal);
        case Freedom::Kind::none:
          return std::max(std::abs(normal), shear);
        case Freedom::Kind::sliding:
          break;
      }
    const double across = std::abs(normal - freedom.dilatancy * shear);
    if (length(freedom.along) == 0.)
      return across;
    return std::max(across, shear - dot(tangential(elements[k], w), freedom.along));
  }

  MechanismCertificate
  Judge::judge_mechanism(const JointState &state, const Vector &motion) const
  {
    MechanismCertificate result;
    const double largest = largest_of_elements(motion);
    if (largest == 0.)
      return result;
    const Vector x       = coordinates(motion);
    const Vector elastic = resistance(x);
    // Rows in which the stiffness of a body that nothing holds is only rounding are measured by the
    // others.
    constexpr double rounding = 1e-12;
    const double no_stiffness = rounding * max_abs(stiffness_row_norms);
    for (std::size_t i = 0; i < x.size(); ++i)
      result.resistance = std::max(
        result.resistance,
        share(std::abs(elastic[i]), std::max(no_stiffness, stiffness_row_norms[i]) * max_abs(x)));

    const Vector delta = jumps(state.dislocations, state.forces);
    for (std::size_t k = 0; k < elements.size(); ++k)
      result.inadmissible = std::max(
        result.inadmissible, inadmissible_jump(k, freedom(k, state, delta), motion) / largest);

    Vector load = loads(state.t);
    add_water(state, load);
    double power = 0., size = 0.;
    for (std::size_t i = 0; i < x.size(); ++i)
      {
        power += load[i] * x[i];
        size += std::abs(load[i] * x[i]);
      }
    for (std::size_t bar = 0; bar < motion.size(); ++bar)
      {
        power -= state.forces[bar] * motion[bar];
        size += std::abs(state.forces[bar] * motion[bar]);
      }
    // For a motion about a point through which all forces pass no term is more than rounding.
    result.balance = share(std::abs(power), std::max(size, largest_force * largest));

    result.drive = drive(state, motion);
    if (result.error() <= largest_error && !is_driven(result))
      if (const std::optional<Vector> other = driven_motion(state, Motions::resisted_by_none))
        result.drive = drive(state, *other);
    return result;
  }

  TangentVector
  Judge::lost_shear(const std::size_t k, const JointState &state) const
  {
    const TangentVector lost = shear_part(elements[k], state.unreleased);
    if (state.states[k] == ContactState::open)
      return lost;
    const double pulling = std::max(state.unreleased[elements[k].normal_bar], 0.);
    return sum({{0., 0.}},
               length(lost) + slope_of_strength(k, state) * pulling,
               direction(shear_part(elements[k], state.forces)));
  }

  // The load waits while lost strength is given up, or water comes in.
  Vector
  Judge::growth_of_factors(const JointState &state) const
  {
    return state.is_unsettled() ? Vector(system->load_patterns().cols(), 0.)
                                : history->rates(state.t);
  }

  // Beyond the limit the power of the growing load exceeds what friction dissipates: forces do not
  // change, except by a strength reduction and by what a broken bond releases.
  double
  Judge::drive(const JointState &state, const Vector &motion) const
  {
    const Vector x          = coordinates(motion);
    const Vector load_rates = multiply(system->load_patterns(), growth_of_factors(state));
    double growth = 0., size = 0.;
    const auto add = [&](const double term) {
      growth += term;
      size += std::abs(term);
    };
    for (std::size_t i = 0; i < x.size(); ++i)
      add(load_rates[i] * x[i]);
    for (std::size_t bar = 0; bar < state.missing_water.size(); ++bar)
      add(state.missing_water[bar] * motion[bar]);
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        const double falls = element.friction.reduced ? -history->strength_share_rate(state.t) : 0.;
        const TangentVector slide = shear_part(element, motion);
        add(falls * length(shear_part(element, state.forces)) * length(slide));
        add(std::abs(state.unreleased[element.normal_bar] * motion[element.normal_bar]));
        add(std::abs(dot(lost_shear(k, state), slide)));
      }
    return share(growth, size);
  }
} // namespace fuga
