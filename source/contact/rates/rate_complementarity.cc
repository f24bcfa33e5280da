// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/blas.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/rates/boundary_lcp.h>
#include <fuga/contact/rates/lemke.h>
#include <fuga/contact/rates/rate_problem.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    using Unknown = BoundaryLcp::Unknown;

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

    /** Return the inequality that belongs to an unknown: -Ṅ for an opening, -f Ṅ - σ Ṫ for a
     * slip. */
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

  // The result contains the rates caused by a unit rate of opening, or of slip together with the
  // rise of the lips.
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

  JointRates
  BoundaryLcp::motion(const Vector &z) const
  {
    JointRates result;
    result.forces.assign(responses.empty() ? 0 : responses.front().forces.size(), 0.);
    result.dislocations.assign(result.forces.size(), 0.);
    for (std::size_t j = 0; j < size(); ++j)
      if (z[j] != 0.)
        {
          const double amount = z[j] * scale[j];
          const std::size_t n = result.forces.size();
          blas::axpy(n, amount, responses[j].forces.data(), result.forces.data());
          blas::axpy(n, amount, responses[j].dislocations.data(), result.dislocations.data());
        }
    return result;
  }

  // With every boundary element closed and stuck the others are condensed; each unknown then acts
  // by its response, which gives q and the columns of M.
  std::optional<BoundaryLcp>
  RateProblem::boundary_lcp(const JointState &state,
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
        return {};
      }

    BoundaryLcp lcp;
    lcp.stuck                            = *stuck;
    lcp.unknowns                         = unknowns_of(set, elements);
    const std::vector<Unknown> &unknowns = lcp.unknowns;
    const std::size_t n                  = unknowns.size();
    lcp.M                                = DenseMatrix(n, n);
    lcp.q.resize(n);
    lcp.responses.resize(n);
    const auto unit = [&](const std::size_t bar) { return 1. / system.scale(bar); };
    for (std::size_t j = 0; j < n; ++j)
      {
        if (!respond(state, unknowns[j].element, unknowns[j].state, lcp.responses[j]))
          return {};
        lcp.scale.push_back(unit(unknowns[j].bar));
      }
    // The rows are scaled to a unit diagonal of W, so that one pivot tolerance suits elements of
    // every size.
    for (std::size_t i = 0; i < n; ++i)
      {
        const Unknown &unknown        = unknowns[i];
        const ContactElement &element = elements[unknown.element];
        const double f                = state.strengths[unknown.element].friction;
        const double s                = lcp.scale[i];
        lcp.q[i]                      = s * reserve(unknown, element, f, stuck->forces);
        lcp.q[i] +=
          s * (unknown.state == ContactState::open ? tensile_strength_rate(element, drive)
                                                   : shear_strength_rate(element, f, drive));
        for (std::size_t j = 0; j < n; ++j)
          lcp.M(i, j) = s * lcp.scale[j] * reserve(unknown, element, f, lcp.responses[j].forces);
        // Both directions of slip of an element may grow together without moving anything: a
        // meaningless ray. It cannot occur if the artificial variable acts in the friction rows by
        // more than f times what it does in the opening row.
        lcp.friction_share.push_back(
          unknown.state == ContactState::open ? 0. : 2. * f * s / unit(element.normal_bar));
        lcp.covering.push_back(1. + lcp.friction_share.back());
      }
    return lcp;
  }

  void
  RateProblem::take_states(const BoundaryLcp &lcp,
                           const std::vector<BoundaryElement> &set,
                           const Vector &z)
  {
    for (const BoundaryElement &candidate : set)
      scheme.set_state(candidate.element, ContactState::stick);
    const double smallest = 1e-12 * max_abs(z);
    for (std::size_t j = z.size(); j-- > 0;)
      if (z[j] > smallest && scheme.state(lcp.unknowns[j].element) != ContactState::open)
        scheme.set_state(lcp.unknowns[j].element, lcp.unknowns[j].state);
  }

  bool
  RateProblem::complementarity(const JointState &state,
                               const std::vector<BoundaryElement> &set,
                               const Drive &drive,
                               Continuation &result)
  {
    const std::optional<BoundaryLcp> lcp = boundary_lcp(state, set, drive, result);
    if (!lcp)
      return false;
    const LcpSolution solution = solve_lcp(lcp->M, lcp->q, lcp->covering);
    take_states(*lcp, set, solution.solved() ? solution.z : solution.vertex);
    if (switch_states(state, set, drive, Stride::one_at_a_time, result))
      return true;
    // The ray, or a solution that is unbounded up to rounding, is the motion that meets no
    // resistance if any motion does; the caller has to check whether it really changes no force.
    result.has_mechanism = true;
    result.mechanism     = lcp->motion(solution.z);
    return false;
  }
} // namespace fuga
