// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/cone_boundary.h>
#include <fuga/contact/layer_response.h>

#include <algorithm>
#include <limits>

namespace fuga
{
  namespace
  {
    /** The smallest τ > 0 at which c + 2bτ + aτ² goes from positive to negative, if c > 0. */
    double
    descending_root(const double a, const double b, const double c)
    {
      const double discriminant = b * b - a * c;
      if (discriminant < 0.)
        return no_boundary;
      const double s = std::sqrt(discriminant);
      if (b < 0.)
        return c / (s - b);
      return a < 0. ? (b + s) / -a : no_boundary;
    }
  } // namespace

  ConeBoundary::ConeBoundary(const std::vector<ContactElement> &contact_elements,
                             const LayeredSystem &layered_system)
    : elements(contact_elements), scales(elements, layered_system), system(layered_system)
  {
  }

  void
  ConeBoundary::set_scales(const JointState &state, const Vector &factors, const double widening)
  {
    constexpr double rounding = 1e-3; // of the relative tolerance: a few times that of numbers
    scales.set_scales(state, factors, widening);
    smallest_tolerance = 0.;
    for (std::size_t bar = 0; bar < system.n_bars(); ++bar)
      smallest_tolerance = std::max(smallest_tolerance, rounding * scales.force_tolerance(bar));
  }

  double
  ConeBoundary::strength_tolerance(const std::size_t k) const
  {
    const ContactElement &element = elements[k];
    return std::max(force_tolerance(element.tangential_bar),
                    element.has_second_tangential_bar()
                      ? force_tolerance(element.second_tangential_bar)
                      : 0.) +
           element.friction.coefficient * force_tolerance(element.normal_bar);
  }

  std::vector<BoundaryElement>
  ConeBoundary::elements_on_boundary(const JointState &state) const
  {
    std::vector<BoundaryElement> result;
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        const bool open               = state.states[k] == ContactState::open;
        const std::size_t n           = element.normal_bar;
        BoundaryElement candidate;
        candidate.element = k;
        candidate.sign    = 1.;
        candidate.grazing =
          open ? gap(element, state, k) <= gap_tolerance() : state.forces[n] >= -force_tolerance(n);
        if (has_friction(element) && (candidate.grazing || !open))
          {
            const double strength =
              open ? 0. : element.friction.coefficient * std::max(-state.forces[n], 0.);
            const double tolerance = strength_tolerance(k);
            if (candidate.grazing || strength <= tolerance)
              {
                candidate.grazing = true;
                candidate.shear   = ShearPosition::at_apex;
              }
            else if (is_slipping(state.states[k]) ||
                     length(tangential(element, state.forces)) >= strength - tolerance)
              candidate.shear = ShearPosition::at_strength;
          }
        if (candidate.grazing || candidate.shear != ShearPosition::inside)
          result.push_back(candidate);
      }
    return result;
  }

  double
  ConeBoundary::distance_of(const std::size_t k,
                            const JointState &state,
                            const JointRates &rates,
                            const ContactBoundary::RateNoise &noise) const
  {
    const ContactElement &element = elements[k];
    const std::size_t n           = element.normal_bar;
    if (state.states[k] == ContactState::open)
      return used_up_after({gap(element, state, k), rates.dislocations[n], gap_tolerance()},
                           noise.jump());
    const double nearest =
      used_up_after({-state.forces[n], -rates.forces[n], force_tolerance(n)}, noise.force(n));
    if (state.states[k] != ContactState::stick || !has_friction(element))
      return nearest;

    const double f = element.friction.coefficient;
    const double N = state.forces[n], N_rate = rates.forces[n];
    const TangentVector T      = tangential(element, state.forces);
    const TangentVector T_rate = tangential(element, rates.forces);
    const double reserve       = -f * N - length(T);
    const double size          = -f * N + length(T);
    const double a             = f * f * N_rate * N_rate - dot(T_rate, T_rate);
    const double b             = f * f * N * N_rate - dot(T, T_rate);
    if (reserve > strength_tolerance(k))
      return std::min(nearest, descending_root(a, b, reserve * size));
    // On the cone. The rate problem has seen to it that the element does not leave it at once.
    if (a < 0. && size > strength_tolerance(k) && b > 0.)
      return std::min(nearest, -2. * b / a);
    return nearest;
  }

  double
  ConeBoundary::distance(const JointState &state, const JointRates &rates, const Drive &drive) const
  {
    double nearest = no_boundary;
    const ContactBoundary::RateNoise noise(system, rates, drive);
    for (std::size_t k = 0; k < elements.size(); ++k)
      nearest = std::min(nearest, distance_of(k, state, rates, noise));
    return nearest;
  }

  std::vector<Reserve>
  ConeBoundary::reserves(const JointState &state, const JointRates &rates) const
  {
    std::vector<Reserve> result;
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        const std::size_t n           = element.normal_bar;
        if (state.states[k] == ContactState::open)
          {
            result.push_back({gap(element, state, k), rates.dislocations[n], gap_tolerance()});
            continue;
          }
        const double N = state.forces[n], N_rate = rates.forces[n];
        result.push_back({-N, -N_rate, force_tolerance(n)});
        if (state.states[k] != ContactState::stick || !has_friction(element))
          continue;
        const double f             = element.friction.coefficient;
        const TangentVector T      = tangential(element, state.forces);
        const TangentVector T_rate = tangential(element, rates.forces);
        const double size          = length(T);
        const double growth        = size > 0. ? dot(T, T_rate) / size : length(T_rate);
        result.push_back({-f * N - size, -f * N_rate - growth, strength_tolerance(k)});
      }
    return result;
  }
} // namespace fuga
