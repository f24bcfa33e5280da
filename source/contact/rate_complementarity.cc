// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/layer_response.h>
#include <fuga/contact/lemke.h>
#include <fuga/contact/rate_problem.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** One unknown z ≥ 0 of the complementarity problem: a rate of dislocation in direction `sign`
     * of a bar. */
    struct Unknown
    {
      std::size_t element;
      std::size_t bar;
      double sign;
      ContactState state;
    };

    std::vector<Unknown>
    unknowns_of(const std::vector<BoundaryElement> &set,
                const std::vector<ContactElement> &elements)
    {
      std::vector<Unknown> unknowns;
      for (const BoundaryElement &candidate : set)
        {
          const std::size_t k           = candidate.element;
          const ContactElement &element = elements[k];
          for (const ContactState state : admissible_states(candidate))
            if (state == ContactState::open)
              unknowns.push_back({k, element.normal_bar, 1., state});
            else if (is_slipping(state))
              unknowns.push_back({k, element.tangential_bar, slip_sign(state), state});
        }
      return unknowns;
    }

    /** The inequality that belongs to an unknown: -Ṅ for an opening, -f Ṅ - σ Ṫ for a slip. */
    double
    reserve(const Unknown &unknown,
            const ContactElement &element,
            const double friction,
            const Vector &force_rates)
    {
      const double dN = force_rates[element.normal_bar];
      return unknown.state == ContactState::open
               ? -dN
               : -friction * dN - unknown.sign * force_rates[unknown.bar];
    }
  } // namespace

  // The rates that a unit rate of opening, or of slip with the rise of the lips that goes with it,
  // causes.
  bool
  RateProblem::respond(const JointState &state,
                       const std::size_t k,
                       const ContactState unknown,
                       JointRates &response)
  {
    response.forces.assign(system.n_bars(), 0.);
    response.dislocations.assign(system.n_bars(), 0.);
    const auto add = [&](const std::size_t bar, const double amount) {
      const std::optional<JointRates> unit = amount == 0. ? JointRates() : scheme.response(bar);
      if (!unit)
        return false;
      for (std::size_t i = 0; i < unit->forces.size(); ++i)
        {
          response.forces[i] += amount * unit->forces[i];
          response.dislocations[i] += amount * unit->dislocations[i];
        }
      return true;
    };
    const ContactElement &element = elements[k];
    if (unknown == ContactState::open)
      return add(element.normal_bar, 1.);
    return add(element.tangential_bar, slip_sign(unknown)) &&
           add(element.normal_bar, state.strengths[k].dilatancy);
  }

  // With every boundary element closed and stuck the others are condensed; each unknown then acts
  // by its response, which gives q and the columns of M.
  bool
  RateProblem::complementarity(const JointState &state,
                               const std::vector<BoundaryElement> &set,
                               const Drive &drive,
                               Continuation &result)
  {
    for (const BoundaryElement &candidate : set)
      scheme.set_state(candidate.element, ContactState::stick);
    const std::optional<JointRates> stuck = scheme.rates(drive);
    if (!stuck)
      {
        result.has_mechanism = true;
        result.mechanism     = scheme.mechanism();
        return false;
      }

    const std::vector<Unknown> unknowns = unknowns_of(set, elements);
    const std::size_t n                 = unknowns.size();
    DenseMatrix M(n, n);
    Vector q(n), scale(n);
    std::vector<JointRates> responses(n);
    for (std::size_t j = 0; j < n; ++j)
      {
        if (!respond(state, unknowns[j].element, unknowns[j].state, responses[j]))
          return false;
        scale[j] = 1. / std::sqrt(system.stiffness()(unknowns[j].bar, unknowns[j].bar));
      }
    // Scaled to unit diagonal of W, so that one pivot tolerance suits elements of every size.
    for (std::size_t i = 0; i < n; ++i)
      {
        const Unknown &unknown        = unknowns[i];
        const ContactElement &element = elements[unknown.element];
        const double f                = state.strengths[unknown.element].friction;
        q[i]                          = reserve(unknown, element, f, stuck->forces);
        if (unknown.state != ContactState::open)
          q[i] += cohesive_strength_rate(element, drive);
        q[i] *= scale[i];
        for (std::size_t j = 0; j < n; ++j)
          M(i, j) = scale[i] * scale[j] * reserve(unknown, element, f, responses[j].forces);
      }

    // Both directions of slip of an element may grow together without moving anything: a ray that
    // means nothing. It cannot occur if the artificial variable acts in the friction rows as f
    // times as in the opening row on top of its own share.
    Vector covering(n, 1.);
    for (std::size_t i = 0; i < n; ++i)
      if (unknowns[i].state != ContactState::open)
        covering[i] += state.strengths[unknowns[i].element].friction * scale[i] *
                       std::sqrt(system.stiffness()(elements[unknowns[i].element].normal_bar,
                                                    elements[unknowns[i].element].normal_bar));
    const LcpSolution lcp = solve_lcp(M, q, covering);
    if (lcp.solved)
      {
        const double smallest = 1e-12 * max_abs(lcp.z);
        for (std::size_t j = n; j-- > 0;)
          if (lcp.z[j] > smallest && scheme.state(unknowns[j].element) != ContactState::open)
            scheme.set_state(unknowns[j].element, unknowns[j].state);
        if (switch_states(state, set, drive, Stride::one_at_a_time, result))
          return true;
      }

    // The ray, or a solution that is unbounded but for rounding, is the motion that meets no
    // resistance if anything does; whether it really changes no force is for the caller to see.
    result.has_mechanism = true;
    result.mechanism.forces.assign(system.n_bars(), 0.);
    result.mechanism.dislocations.assign(system.n_bars(), 0.);
    for (std::size_t j = 0; j < n; ++j)
      if (lcp.z[j] != 0.)
        for (std::size_t i = 0; i < system.n_bars(); ++i)
          {
            const double amount = lcp.z[j] * scale[j];
            result.mechanism.forces[i] += amount * responses[j].forces[i];
            result.mechanism.dislocations[i] += amount * responses[j].dislocations[i];
          }
    return false;
  }
} // namespace fuga
