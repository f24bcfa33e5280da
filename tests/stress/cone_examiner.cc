// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/cone_examiner.h"

#include "judges/from_contact.h"
#include "sparse.h"
#include "stress/confirm.h"
#include "stress/examiner.h"

#include <algorithm>
#include <cmath>

namespace fuga::stress
{
  bool
  cones_know_layers(const std::vector<ContactElement> &elements)
  {
    return std::all_of(elements.begin(), elements.end(), [](const ContactElement &element) {
      return element.coupling == nullptr &&
             (!element.has_tangential_bar() ||
              element.shear_law->kind() != ComplianceKind::nonlinear);
    });
  }

  std::vector<judges::ConeElement>
  cones_of(const std::vector<ContactElement> &elements, const JointState &state)
  {
    std::vector<judges::ConeElement> result;
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        judges::ConeElement copy;
        copy.normal_bar        = element.normal_bar;
        copy.area              = element.area;
        copy.initial_gap       = element.initial_gap - state.dilations[k];
        copy.normal_compliance = element.normal_law->initial_compliance();
        if (element.normal_law->kind() == ComplianceKind::nonlinear)
          {
            const ComplianceLaw *const law = element.normal_law;
            copy.stress                    = [law](const double w) { return law->stress(w); };
            copy.tangent                   = [law](const double w) { return law->tangent(w); };
            copy.closure_limit             = law->deformation_limit();
          }
        if (element.has_tangential_bar())
          {
            copy.tangential_bars.push_back(element.tangential_bar);
            copy.shear_compliance = element.shear_law->initial_compliance();
          }
        if (element.has_second_tangential_bar())
          copy.tangential_bars.push_back(element.second_tangential_bar);
        copy.friction = state.strengths[k].friction;
        copy.envelope = judges::envelope_of(element.friction);
        copy.cohesion = state.strengths[k].cohesion;
        result.push_back(copy);
      }
    return result;
  }

  // Openings count from where the lips touch; a layer that closes along a curve deforms by more or
  // less than its linear part says, which is what its dislocation has left.
  judges::ConeState
  cone_state(const std::vector<ContactElement> &elements, const JointState &state)
  {
    judges::ConeState result{state.forces, state.dislocations};
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        const unsigned int n          = element.normal_bar;
        result.dislocations[n] += element.initial_gap - state.dilations[k];
        if (element.normal_law->kind() == ComplianceKind::nonlinear)
          result.dislocations[n] +=
            element.normal_law->reference_compliance() * state.forces[n] / element.area;
      }
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
             tests::dense(model.bodies.jump_operator()),
             model.bodies.load_patterns(),
             cones_of(elements, virgin_state(joint)))
  {
  }

  bool
  ConeExaminer::can_solve(const JointState &state) const
  {
    return cones_know_layers(elements) && judges_know_strengths(elements, state);
  }

  StepReport
  ConeExaminer::examine_step(const JointState &from, const JointState &to) const
  {
    return examine_cone_step(newton.with(cones_of(elements, from)),
                             cone_state(elements, from),
                             model.loads.history.factors(from.t),
                             cone_state(elements, to),
                             model.loads.history.factors(to.t));
  }

  bool
  ConeExaminer::respects(const judges::ConeElement &element,
                         const judges::ConeState &state,
                         const Vector &jumps) const
  {
    constexpr double none      = 1e-5;
    constexpr double no_force  = 1e-9;
    const double largest_force = max_abs(state.forces);
    const double pressing      = -state.forces[element.normal_bar];
    if (state.dislocations[element.normal_bar] > 1e-9 * max_abs(state.dislocations))
      return true; // open
    const double normal = jumps[element.normal_bar];
    if (pressing <= no_force * largest_force && (element.cohesion == 0. || normal > none))
      return normal >= -none;
    if (std::abs(normal) > none)
      return false;
    double force = 0., along = 0., shear = 0.;
    for (const unsigned int bar : element.tangential_bars)
      {
        force = std::hypot(force, state.forces[bar]);
        shear = std::hypot(shear, jumps[bar]);
        along += state.forces[bar] * jumps[bar];
      }
    const double strength = element.strength(std::max(0., pressing));
    if (shear <= none || strength == 0.)
      return true;
    return force >= strength - no_force * largest_force && along >= (1. - none) * force * shear;
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
    const judges::ConeState now = cone_state(elements, state);
    const auto cones            = cones_of(elements, state);
    return dot(load, x) > 0. &&
           std::all_of(cones.begin(), cones.end(), [&](const judges::ConeElement &element) {
             return respects(element, now, jumps);
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
    const judges::ConeNewton in_state = newton.with(cones_of(elements, state));
    const judges::ConeStep step       = in_state.step(now.dislocations, factors, beyond);
    const double nearby               = 1e3 * part;
    // What the solution leaves must be small beside what so short a step changes.
    const double solved = 1e-6 * part;
    return step.converged && in_state.distance(now, step.state, beyond) <= nearby &&
           in_state.residual(now.dislocations, beyond, step.state) <= solved;
  }
} // namespace fuga::stress
