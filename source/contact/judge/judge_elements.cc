// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/judge/judge.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    void
    raise(double &entry, const double value, const double scale)
    {
      entry = std::max(entry, share(std::max(value, 0.), scale));
    }
  } // namespace

  void
  Judge::check_element(const std::size_t k,
                       const JointState &state,
                       const Vector &delta,
                       Certificate &result) const
  {
    const ContactElement &element = elements[k];
    const Strength &left          = state.strengths[k];
    const std::size_t n           = element.normal_bar;
    const double N                = state.forces[n];
    const double gap              = element.initial_gap + delta[n] - state.dilations[k];
    const TangentVector T         = shear_part(element, state.forces);
    const TangentVector lost      = shear_part(element, state.unreleased);
    raise(result.tension, N - std::max(left.tension, state.unreleased[n]), largest_force);
    check_strength(k, left, result);
    if (state.states[k] == ContactState::open)
      {
        raise(result.penetration, -gap, largest_jump);
        raise(result.complementarity, std::abs(N - state.unreleased[n]), largest_force);
        raise(result.complementarity, length(sum(T, -1., lost)), largest_force);
        return;
      }
    const Layer elastic = layer(k, state);
    raise(result.layer_law, std::abs(gap - elastic.normal), largest_jump);
    if (!element.has_tangential_bar())
      return;
    // Lips press each other by the amount by which N is below the tension that a broken bond still
    // carries.
    const double still_pulling = std::max(state.unreleased[n], 0.);
    const double pressing      = left.tension > 0. ? -N : std::max(still_pulling - N, 0.);
    const double strength =
      left.friction * resisting_force(element.friction, element.area, pressing) + left.cohesion +
      length(lost);
    raise(result.cone, length(T) - strength, largest_force);
    const TangentVector jump_of_layer = sum(tangential(element, delta), -1., state.slips[k]);
    raise(result.layer_law, length(sum(jump_of_layer, -1., elastic.shear)), largest_jump);
    if (is_slipping(state.states[k]))
      raise(result.slip_direction, std::abs(along_slip(k, state, T) - strength), largest_force);
  }

  // The remaining strength is all or nothing of what the law gives, or of the share of it that a
  // strength reduction leaves.
  void
  Judge::check_strength(const std::size_t k, const Strength &left, Certificate &result) const
  {
    const FrictionLaw &law = elements[k].friction;
    const double A         = elements[k].area;
    const double s         = left.share;
    if ((left.friction != s * law.coefficient && left.friction != s * residual_friction(law)) ||
        (left.cohesion != 0. && left.cohesion != s * (law.cohesion * A)) ||
        (left.tension != 0. && left.tension != s * (law.tensile_strength * A)) ||
        (left.dilatancy != 0. && left.dilatancy != law.dilatancy))
      result.cone = std::numeric_limits<double>::infinity();
  }

  // A strength reduction leaves the same share to all elements that it concerns, and the full
  // strength to the others.
  void
  Judge::check_reduction(const JointState &state, Certificate &result) const
  {
    double share = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const double left = state.strengths[k].share;
        if (elements[k].friction.reduced && std::isnan(share))
          share = left;
        if (!(left > 0. && left <= 1. && left == (elements[k].friction.reduced ? share : 1.)))
          result.cone = std::numeric_limits<double>::infinity();
      }
  }
} // namespace fuga
