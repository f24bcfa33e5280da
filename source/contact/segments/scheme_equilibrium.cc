// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/segments/scheme_equilibrium.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Share of the distance to the closure limit of a law that one iteration may go. */
    constexpr double fraction_to_limit = 0.9;
    constexpr int max_newton           = 40;
    /** Number of successive growing differences that count as divergence. */
    constexpr int patience = 8;
  } // namespace

  SchemeEquilibrium::SchemeEquilibrium(const PathContext &path_context,
                                       const Course &path_course,
                                       const PathOptions &path_options,
                                       IterationCount &iteration_count,
                                       const SchemeAnswer wanted)
    : context(path_context)
    , course(path_course)
    , options(path_options)
    , count(iteration_count)
    , answer(wanted)
  {
  }

  // Both iterations are described by one equation: K Δu = P - [forces of the layer at the present
  // u]. Newton's method includes the tangent stiffness of the layer in K at every iteration. The
  // paper keeps K = K_lin + A/ρ0 and moves (C(u) - A/ρ0) u to the right-hand side, equations (3),
  // (7), (8): with the residual written out, this is the same correction with the constant matrix.
  // Where a path begins without any load, only the forces of the present state tell what is
  // rounding.
  bool
  SchemeEquilibrium::solve(const double tau,
                           const double largest_jump,
                           JointState &state,
                           const KnownForces *const known)
  {
    const bool constant      = options.iteration == PathOptions::Iteration::constant_stiffness;
    const int max_iterations = constant ? static_cast<int>(options.max_iterations) : max_newton;
    double last_change       = std::numeric_limits<double>::infinity();
    double contraction       = 0.;
    int n_growing            = 0;
    // A correction that leaves something unresisted may be small as well.
    const bool leaves_nothing = answer == SchemeAnswer::of_no_mechanism;
    ++count.n_solutions;
    // Where forces are refined they may have moved beyond the limit.
    if (passes_limit_of_law(context.elements, state))
      return false;
    if (constant)
      context.scheme.linearise(state, LayerStiffness::initial);
    for (int i = 1; i <= max_iterations; ++i)
      {
        ++count.n_iterations;
        count.max_in_one = std::max(count.max_in_one, static_cast<std::size_t>(i));
        if (!constant)
          context.scheme.linearise(state);
        const Vector residual  = context.scheme.residual(state);
        const auto is_balanced = [&, size = max_abs(residual)]() {
          if (size <= max_abs(context.boundary.all_force_tolerances()))
            return true;
          const ContactBoundary here = boundary_at(context, course, tau, state);
          return size <=
                 std::max(max_abs(here.all_force_tolerances()), here.rounding_of_residual());
        };
        const std::optional<JointRates> change = context.scheme.correction(residual, answer);
        if (!change)
          return is_balanced();
        const Vector growth = context.system.jumps(change->dislocations, change->forces);
        const double share =
          constant ? 1.
                   : limit_safeguard(context.elements, state, growth, OpenLips::may_pass_limit);
        for (std::size_t b = 0; b < state.dislocations.size(); ++b)
          state.dislocations[b] += share * change->dislocations[b];
        complete_state(context, course, tau, state, known);

        // If a jump stays constant, the layer may take another part of it, and the slip the rest.
        const double size = std::max(max_abs(growth), max_abs(change->dislocations));
        const double total =
          std::max(largest_jump, max_abs(context.system.jumps(state.dislocations, state.forces)));
        if (passes_limit_of_law(context.elements, state))
          return false;
        if (size <= options.tolerance * total && (leaves_nothing || is_balanced()))
          return true;
        contraction = size / last_change;
        n_growing   = contraction >= 1. ? n_growing + 1 : 0;
        if (constant && n_growing >= patience)
          return false;
        // At the level of rounding the differences cannot decrease any further. A layer that is
        // nearly unloaded responds to a force that counts as zero with more than the rounding of a
        // jump.
        if (!constant && contraction > 0.3 &&
            (is_balanced() || (leaves_nothing && size <= 1e3 * options.tolerance * total)))
          return true;
        last_change = size;
      }
    return false;
  }

  namespace
  {
    /** Return whether the law is defined at @p w. A curve without a limit ends where numbers
     * overflow: sinh(w/w₀) at 710 w₀. */
    bool
    is_on_curve(const ComplianceLaw &law, const double w)
    {
      const double limit = law.deformation_limit();
      return std::isfinite(limit) ? w < limit : std::isfinite(law.tangent(std::max(w, 0.)));
    }
  } // namespace

  bool
  passes_limit_of_law(const std::vector<ContactElement> &elements, const JointState &state)
  {
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        if (state.states[k] == ContactState::open)
          continue;
        if (has_nonlinear_closure(element))
          if (const double closure = -gap(element, state, k);
              !(closure < closure_limit(element) && is_on_curve(*element.normal_law, closure)))
            return true;
        if (has_nonlinear_shear(element) &&
            !is_on_curve(*element.shear_law,
                         length(state.states[k] == ContactState::stick
                                  ? elastic_shear(element, state, k)
                                  : shear_deformation(element, state, k))))
          return true;
      }
    return false;
  }

  double
  limit_safeguard(const std::vector<ContactElement> &elements,
                  const JointState &state,
                  const Vector &growth_of,
                  const OpenLips open_lips)
  {
    double share = 1.;
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        const auto limit = [&](const double largest, const double now, const double growth) {
          const double room = largest - now;
          if (growth > fraction_to_limit * room)
            share = std::min(share, fraction_to_limit * room / growth);
        };
        const bool is_open = state.states[k] == ContactState::open;
        if (has_nonlinear_closure(element) &&
            (!is_open || open_lips == OpenLips::stay_short_of_limit))
          limit(closure_limit(element),
                is_open ? -lip_opening(element, state, k) : -gap(element, state, k),
                -growth_of[element.normal_bar]);
        if (state.states[k] == ContactState::stick && has_nonlinear_shear(element))
          {
            const TangentVector e = elastic_shear(element, state, k);
            const double size     = length(e);
            if (size > 0.)
              limit(element.shear_law->deformation_limit(),
                    size,
                    dot(e, tangential(element, growth_of)) / size);
          }
      }
    return share;
  }
} // namespace fuga
