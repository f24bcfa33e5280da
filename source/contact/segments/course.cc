// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/joint_strength.h>
#include <fuga/contact/element/joint_water.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/segments/course.h>

#include <algorithm>

namespace fuga
{
  // Stages begin at whole numbers, whatever rounding says.
  double
  Course::time_at(const double tau) const
  {
    return tau == length ? t_end : t + tau * (t_end - t) / length;
  }

  Vector
  Course::factors_at(const double tau) const
  {
    return along(factors, tau, factor_rates);
  }

  void
  reduce_strengths(const std::vector<ContactElement> &elements,
                   const Course &course,
                   const double tau,
                   std::vector<Strength> &strengths)
  {
    if (course.share_rate == 0.)
      return;
    for (std::size_t k = 0; k < elements.size(); ++k)
      if (const ContactElement &element = elements[k]; element.friction.reduced)
        reduce(
          strengths[k], element.friction, element.area, course.share + tau * course.share_rate);
  }

  // The remaining strength at the present pressure falls in proportion to its share s, i.e. at the
  // rate ṡ/s times itself.
  Drive
  drive_at(const std::vector<ContactElement> &elements,
           const Course &course,
           const JointState &state)
  {
    Drive drive = course.drive;
    if (course.share_rate == 0.)
      return drive;
    drive.strength.assign(state.forces.size(), 0.);
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        const Strength &strength      = state.strengths[k];
        if (!element.friction.reduced || state.states[k] == ContactState::open)
          continue;
        const double rate                      = course.share_rate / strength.share;
        drive.strength[element.normal_bar]     = rate * strength.tension;
        drive.strength[element.tangential_bar] = rate * shear_strength(element, state, k);
      }
    return drive;
  }

  bool
  is_bent_by_reduction(const std::vector<ContactElement> &elements,
                       const Course &course,
                       const JointState &state)
  {
    if (course.share_rate != 0.)
      for (std::size_t k = 0; k < elements.size(); ++k)
        if (elements[k].friction.reduced && is_slipping(state.states[k]))
          return true;
    return false;
  }

  ContactBoundary
  boundary_at(const PathContext &context,
              const Course &course,
              const double tau,
              const JointState &state)
  {
    ContactBoundary result(context.elements, context.system);
    result.set_scales(state, course.factors_at(tau), 1.);
    return result;
  }

  void
  release(const Drive &drive, const double tau, JointState &state)
  {
    state.unreleased    = along(state.unreleased, tau, drive.release);
    state.missing_water = along(state.missing_water, tau, drive.missing_water);
  }

  Vector
  set_loads(const PathContext &context, const Course &course, const double tau, JointState &state)
  {
    state.t        = course.time_at(tau);
    Vector factors = course.factors_at(tau);
    if (course.yielding)
      {
        const YieldingLoad &load = *course.yielding;
        double lag               = tau;
        for (std::size_t bar = 0; bar < load.weights.size(); ++bar)
          lag -= load.weights[bar] * (state.dislocations[bar] - load.dislocations[bar]);
        state.t += load.stiffness * lag;
        factors = along(factors, load.stiffness * lag, load.factor_rates);
      }
    set_water(context.system, factors, state);
    return factors;
  }

  void
  set_slips(const PathContext &context, const Course &course, const double tau, JointState &state)
  {
    reduce_strengths(context.elements, course, tau, state.strengths);
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      {
        const ContactElement &element = context.elements[k];
        if (!element.has_tangential_bar() ||
            (state.states[k] == ContactState::stick && carries_shear(element, state.strengths[k])))
          continue;
        const TangentVector slip = present_slip(element, state, k);
        state.dilations[k] +=
          state.strengths[k].dilatancy *
          dot(context.scheme.slip_direction_of(k), sum(slip, -1., state.slips[k]));
        state.slips[k] = slip;
      }
  }

  void
  complete_state(const PathContext &context,
                 const Course &course,
                 const double tau,
                 JointState &state,
                 const KnownForces *const known)
  {
    const Vector factors = set_loads(context, course, tau, state);
    state.forces         = context.system.forces(factors, state.dislocations, state.water, known);
    set_slips(context, course, tau, state);
  }

  KnownForces
  known_forces(const PathContext &context, const Course &course, const double tau, JointState state)
  {
    Vector factors = set_loads(context, course, tau, state);
    return {std::move(factors),
            std::move(state.dislocations),
            std::move(state.water),
            std::move(state.forces)};
  }
} // namespace fuga
