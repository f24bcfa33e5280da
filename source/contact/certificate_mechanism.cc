// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/blas.h>
#include <fuga/contact/certificate.h>
#include <fuga/contact/tangent_vector.h>

#include <algorithm>
#include <cmath>

// What the judge asks of a mechanism before it is called a limit load.
namespace fuga
{
  namespace
  {
    /** Forces below this share of the largest, and gaps below this share of the largest jump, are
     * zero in a state on the boundary of the contact conditions. */
    constexpr double on_boundary = 1e-8;

    double
    shear_jump_of(const ContactElement &element, const Vector &jumps)
    {
      return element.has_tangential_bar() ? length(tangential(element, jumps)) : 0.;
    }
  } // namespace

  double
  MechanismCertificate::error() const
  {
    return std::max({resistance, inadmissible, balance});
  }

  // A closed element must not open or slip before its force is at the strength, an open one must
  // not close where the gap is zero, and slip goes along its force.
  double
  Judge::inadmissible_jump(const std::size_t k,
                           const JointState &state,
                           const Vector &delta,
                           const Vector &w) const
  {
    const ContactElement &element = elements[k];
    const Strength &left          = state.strengths[k];
    const std::size_t n           = element.normal_bar;
    const double no_force         = on_boundary * largest_force;
    const double N                = state.forces[n];
    const double shear_jump       = shear_jump_of(element, w);
    const double gap              = element.initial_gap + delta[n] - state.dilations[k];
    if (state.states[k] == ContactState::open && gap > on_boundary * largest_jump)
      return 0.;
    if (left.tension <= no_force && N >= -no_force)
      return std::max(0., -w[n]); // at the apex of the cone
    if (left.tension > no_force && N >= left.tension - no_force)
      return std::max(0., -w[n]); // at the tensile strength
    const double T        = std::abs(shear_force(k, state));
    const double strength = left.friction * -N + left.cohesion;
    const bool slips      = element.has_tangential_bar() && T >= strength - no_force;
    const double rise     = slips ? left.dilatancy * shear_jump : 0.;
    const double normal   = std::abs(w[n] - rise);
    if (!slips)
      return std::max(normal, shear_jump);
    if (T <= no_force)
      return normal;
    const double along = dot(tangential(element, w), tangential(element, state.forces)) / T;
    return std::max(normal, shear_jump - along);
  }

  // Beyond the limit the power of the growing load exceeds what friction dissipates: forces do not
  // change, but by a strength reduction and what a broken bond lets go.
  MechanismCertificate
  Judge::judge_mechanism(const JointState &state, const Vector &motion) const
  {
    MechanismCertificate result;
    const double largest = max_abs(motion);
    if (largest == 0.)
      return result;
    const Vector x       = coordinates(motion);
    const Vector elastic = resistance(x);
    for (std::size_t i = 0; i < x.size(); ++i)
      result.resistance = std::max(
        result.resistance, share(std::abs(elastic[i]), stiffness_row_norms[i] * max_abs(x)));

    const Vector delta = jumps(state.dislocations, state.forces);
    for (std::size_t k = 0; k < elements.size(); ++k)
      result.inadmissible =
        std::max(result.inadmissible, inadmissible_jump(k, state, delta, motion) / largest);

    Vector load = loads(state.t);
    add_water(state, load);
    double power = 0., size = 0.;
    const auto add = [](const double term, double &sum, double &sum_of_sizes) {
      sum += term;
      sum_of_sizes += std::abs(term);
    };
    for (std::size_t i = 0; i < x.size(); ++i)
      add(load[i] * x[i], power, size);
    for (std::size_t bar = 0; bar < motion.size(); ++bar)
      add(-state.forces[bar] * motion[bar], power, size);
    result.balance = share(std::abs(power), size);

    const Vector load_rates = multiply(system.load_patterns(), history.rates(state.t));
    double growth = 0., size_of_growth = 0.;
    for (std::size_t i = 0; i < x.size(); ++i)
      add(load_rates[i] * x[i], growth, size_of_growth);
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        const double falls =
          elements[k].friction.reduced ? -history.strength_share_rate(state.t) : 0.;
        const double strength = std::abs(shear_force(k, state));
        add(falls * strength * shear_jump_of(element, motion), growth, size_of_growth);
        element.for_each_bar([&](const unsigned int bar, const ComplianceLaw &) {
          add(std::abs(state.unreleased[bar] * motion[bar]), growth, size_of_growth);
        });
      }
    result.drive = share(growth, size_of_growth);
    return result;
  }
} // namespace fuga
