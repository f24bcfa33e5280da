// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/cone_examiner.h"

#include <algorithm>
#include <cmath>

namespace fuga::stress
{
  std::vector<judges::ConeElement>
  cones_of(const std::vector<ContactElement> &elements)
  {
    std::vector<judges::ConeElement> result;
    for (const ContactElement &element : elements)
      {
        judges::ConeElement copy;
        copy.normal_bar        = element.normal_bar;
        copy.area              = element.area;
        copy.initial_gap       = element.initial_gap;
        copy.normal_compliance = element.normal_law->initial_compliance();
        if (element.has_tangential_bar())
          {
            copy.tangential_bars.push_back(element.tangential_bar);
            copy.shear_compliance = element.shear_law->initial_compliance();
          }
        if (element.has_second_tangential_bar())
          copy.tangential_bars.push_back(element.second_tangential_bar);
        copy.friction = element.friction.coefficient;
        result.push_back(copy);
      }
    return result;
  }

  // Openings count from the closed joint.
  judges::ConeState
  cone_state(const std::vector<ContactElement> &elements, const JointState &state)
  {
    judges::ConeState result{state.forces, state.dislocations};
    for (const ContactElement &element : elements)
      result.dislocations[element.normal_bar] += element.initial_gap;
    return result;
  }

  StepReport
  examine_cone_step(const judges::ConeNewton &newton,
                    const judges::ConeState &from,
                    const Vector &factors_before,
                    const judges::ConeState &to,
                    const Vector &factors)
  {
    StepReport report;
    report.residual              = newton.residual(from.dislocations, factors, to);
    const judges::ConeStep other = newton.step(from.dislocations, factors_before, factors);
    if (other.converged)
      report.distance = newton.distance(to, other.state, factors);
    return report;
  }

  ConeExaminer::ConeExaminer(const Model<3> &fuga_model, const JointModel &joint)
    : model(fuga_model)
    , elements(joint.elements)
    , judge(model.bodies, elements, model.loads.history)
    , newton(model.bodies.stiffness(),
             model.bodies.jump_operator(),
             model.bodies.load_patterns(),
             cones_of(elements))
  {
  }

  StepReport
  ConeExaminer::examine_step(const JointState &from, const JointState &to) const
  {
    return examine_cone_step(newton,
                             cone_state(elements, from),
                             model.loads.history.factors(from.t),
                             cone_state(elements, to),
                             model.loads.history.factors(to.t));
  }

  bool
  ConeExaminer::respects(const ContactElement &element,
                         const JointState &state,
                         const Vector &jumps) const
  {
    constexpr double none      = 1e-5;
    constexpr double no_force  = 1e-9;
    const double largest_force = max_abs(state.forces);
    const double pressing      = -state.forces[element.normal_bar];
    if (element.initial_gap + state.dislocations[element.normal_bar] >
        1e-9 * max_abs(state.dislocations))
      return true; // open
    const double normal = jumps[element.normal_bar];
    if (pressing <= no_force * largest_force)
      return normal >= -none;
    if (std::abs(normal) > none)
      return false;
    double force = 0., along = 0., shear = 0.;
    for (const unsigned int bar : {element.tangential_bar, element.second_tangential_bar})
      if (bar != ContactElement::no_bar)
        {
          force = std::hypot(force, state.forces[bar]);
          shear = std::hypot(shear, jumps[bar]);
          along += state.forces[bar] * jumps[bar];
        }
    if (shear <= none || element.friction.coefficient == 0.)
      return true;
    return force >= element.friction.coefficient * pressing - no_force * largest_force &&
           along >= (1. - none) * force * shear;
  }

  bool
  ConeExaminer::is_mechanism(const JointState &state, const Vector &jumps) const
  {
    constexpr double free   = 1e-6;
    const Vector x          = judge.coordinates(jumps);
    const DenseMatrix &S    = model.bodies.stiffness();
    const Vector resistance = multiply(S, x);
    if (max_abs(resistance) > free * largest_diagonal(S) * max_abs(x))
      return false;
    const Vector load = multiply(model.bodies.load_patterns(), model.loads.history.rates(state.t));
    return dot(load, x) > 0. &&
           std::all_of(elements.begin(), elements.end(), [&](const ContactElement &element) {
             return respects(element, state, jumps);
           });
  }

  bool
  ConeExaminer::finds_step_beyond(const JointState &state, const double part) const
  {
    const judges::ConeState now = cone_state(elements, state);
    const Vector factors        = model.loads.history.factors(state.t);
    const Vector rates          = model.loads.history.rates(state.t);
    Vector beyond               = factors;
    for (std::size_t l = 0; l < beyond.size(); ++l)
      beyond[l] += part * rates[l];
    const judges::ConeStep step = newton.step(now.dislocations, factors, beyond);
    const double nearby         = 1e3 * part;
    // What the solution leaves must be small beside what so short a step changes.
    const double solved = 1e-6 * part;
    return step.converged && newton.distance(now, step.state, beyond) <= nearby &&
           newton.residual(now.dislocations, beyond, step.state) <= solved;
  }
} // namespace fuga::stress
