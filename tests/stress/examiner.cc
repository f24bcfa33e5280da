// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/examiner.h"

#include "judges/dislocation_form.h"
#include "judges/from_contact.h"
#include "judges/judges.h"

#include <fuga/laws/cubic_root_law.h>

#include <algorithm>
#include <cmath>

namespace fuga::stress
{
  using namespace judges;

  namespace
  {
    bool
    is_known(const ComplianceLaw &law, const bool normal)
    {
      return law.kind() != ComplianceKind::nonlinear ||
             (normal && dynamic_cast<const CubicRootLaw *>(&law) != nullptr);
    }

    bool
    is_known(const ContactElement &element)
    {
      return element.coupling == nullptr && is_known(*element.normal_law, true) &&
             (!element.has_tangential_bar() || is_known(*element.shear_law, false));
    }

    /** Where the judges do not know a law they get its linear part: good for the size of
     * numbers, not for steps. */
    JudgeProblem
    problem_of(const ContactSystem &system, std::vector<ContactElement> elements)
    {
      std::vector<std::unique_ptr<ComplianceLaw>> tangents;
      const auto replace = [&tangents](const ComplianceLaw *&law, const bool normal) {
        if (is_known(*law, normal))
          return;
        tangents.push_back(make_linear_law(law->reference_compliance()));
        law = tangents.back().get();
      };
      for (ContactElement &element : elements)
        {
          replace(element.normal_law, true);
          if (element.has_tangential_bar())
            replace(element.shear_law, false);
        }
      return judge_problem(system, elements);
    }

    double
    tangent_compliance(const ComplianceLaw &law, const double deformation)
    {
      return law.kind() == ComplianceKind::nonlinear ? 1. / law.tangent(deformation)
                                                     : law.initial_compliance();
    }
  } // namespace

  Examiner::Examiner(const Model<2> &fuga_model, const JointModel &joint)
    : model(fuga_model)
    , elements(joint.elements)
    , layered(model.bodies, elements)
    , judge(model.bodies, elements, model.loads.history)
    , problem(problem_of(model.bodies, elements))
  {
  }

  bool
  judges_know_layers(const std::vector<ContactElement> &elements)
  {
    return std::all_of(elements.begin(), elements.end(), [](const ContactElement &element) {
      return is_known(element);
    });
  }

  bool
  judges_know_strengths(const std::vector<ContactElement> &elements, const JointState &state)
  {
    for (const ContactElement &element : elements)
      if (element.coupling != nullptr)
        return false;
    return !state.is_unsettled() &&
           std::none_of(
             state.strengths.begin(), state.strengths.end(), [](const Strength &strength) {
               return strength.tension > 0. || strength.dilatancy > 0.;
             });
  }

  bool
  Examiner::can_solve(const JointState &state) const
  {
    return can_continue(state) && judges_know_layers(elements);
  }

  bool
  Examiner::can_continue(const JointState &state) const
  {
    return judges_know_strengths(elements, state);
  }

  Vector
  Examiner::load(const double t) const
  {
    return judge_load(model.bodies, model.loads.history.factors(t));
  }

  // Lips that have risen as they slid touch where the gap is their rise.
  JudgeProblem
  problem_in(const JudgeProblem &virgin, const JointState &state)
  {
    JudgeProblem result = virgin;
    for (std::size_t k = 0; k < result.elements.size(); ++k)
      {
        result.elements[k].initial_gap -= state.dilations[k];
        result.elements[k].friction = state.strengths[k].friction;
        result.elements[k].cohesion = state.strengths[k].cohesion / result.elements[k].area;
      }
    return result;
  }

  // Rates see the tangent of a curved envelope.
  JudgeProblem
  problem_of_rates(const JudgeProblem &virgin, const JointState &state)
  {
    JudgeProblem result = problem_in(virgin, state);
    for (JudgeElement &element : result.elements)
      {
        const double P      = std::max(0., -state.forces[element.normal_bar]);
        const double share  = element.envelope.slope(element.area, P);
        const double excess = element.envelope.force(element.area, P) - share * P;
        element.cohesion += element.friction * excess / element.area;
        element.friction *= share;
        element.envelope = {};
      }
    return result;
  }

  StepSolution
  Examiner::solution(const JudgeProblem &at,
                     const JointState &state,
                     const Vector &slip_before) const
  {
    StepSolution result;
    result.x      = judge.coordinates(layered.jumps(state.dislocations, state.forces), state.t);
    result.forces = state.forces;
    result.slip   = judge_slips(state);
    result.states = state.states;
    complete(at, slip_before, load(state.t), result);
    return result;
  }

  std::optional<StepSolution>
  solve_anew(const JudgeProblem &at,
             const Vector &slip_before,
             const Vector &load_before,
             const Vector &new_load)
  {
    const std::size_t few_elements = 30, many_elements = 60;
    NewtonOptions options;
    options.load_before    = load_before;
    options.tolerance      = 1e-10;
    options.max_iterations = 60;
    options.strategies     = {"undamped", "damped", "load homotopy", "friction homotopy"};
    if (at.elements.size() > many_elements)
      options.strategies = {"undamped", "damped"};
    NewtonStep newton = semismooth_newton_step(at, slip_before, new_load, options);
    if (newton.converged)
      return std::move(newton.solution);
    const bool linear = std::none_of(at.elements.begin(), at.elements.end(), [](const auto &e) {
      return e.has_nonlinear_layer() || e.envelope.exponent != 1.;
    });
    if (!linear || at.elements.size() > few_elements)
      return {};
    LemkeStep step = lemke_step(at, slip_before, new_load, 1e-10);
    if (!step.solved)
      return {};
    return std::move(step.solution);
  }

  StepReport
  Examiner::examine_step(const JointState &from, const JointState &to) const
  {
    const JudgeProblem at   = problem_in(problem, from);
    const StepSolution ours = solution(at, to, judge_slips(from));
    StepReport report;
    report.residual = ours.residual;
    // Where the load vanishes rounding is what is left: it is measured by what was there before.
    const auto size = [&](const JointState &state) {
      return std::max(max_abs(state.forces), max_abs(load(state.t)));
    };
    if (size(to) < size(from))
      report.residual *= size(to) / size(from);
    if (const auto other = solve_anew(at, judge_slips(from), load(from.t), load(to.t)))
      report.distance = distance(*other, ours);
    return report;
  }

  // On a boundary is what is closer to it than the rounding of the terms p = R a - W d of its
  // force, and whatever the state says to slip.
  std::vector<RateElement>
  Examiner::positions(const JudgeProblem &at, const JointState &state, const double tolerance) const
  {
    const DislocationForm form = dislocation_form(at, {load(state.t)});
    const Vector jumps         = layered.jumps(state.dislocations, state.forces);
    Vector terms(at.n_bars(), 0.);
    double length = 0.;
    for (std::size_t i = 0; i < terms.size(); ++i)
      {
        terms[i] = std::abs(form.R[0][i]);
        for (std::size_t j = 0; j < terms.size(); ++j)
          terms[i] += std::abs(form.W(i, j) * state.dislocations[j]);
        length = std::max({length, std::abs(jumps[i]), std::abs(state.dislocations[i])});
      }
    std::vector<RateElement> result;
    for (std::size_t k = 0; k < at.elements.size(); ++k)
      {
        const JudgeElement &element = at.elements[k];
        const double gap            = element.initial_gap + jumps[element.normal_bar];
        const Strength &left        = state.strengths[k];
        const double pressing       = -state.forces[element.normal_bar];
        RateElement place;
        place.closure = std::max(0., -gap);
        if (state.states[k] == ContactState::open)
          place.status = gap > tolerance * std::max(length, element.initial_gap)
                           ? RateStatus::open
                           : RateStatus::grazing;
        else if (pressing + left.tension <= tolerance * terms[element.normal_bar])
          place.status = RateStatus::grazing;
        else if (element.has_tangential_bar() && element.friction == 0. && element.cohesion == 0.)
          place.status = RateStatus::frictionless;
        else if (element.has_tangential_bar())
          {
            const double T     = state.forces[element.tangential_bar];
            const double limit = element.friction * pressing + element.cohesion * element.area;
            const double noise = tolerance * (terms[element.tangential_bar] +
                                              element.friction * terms[element.normal_bar]);
            if (is_slipping(state.states[k]) || std::abs(T) >= limit - noise)
              {
                place.status = RateStatus::slip_limit;
                place.sign   = T >= 0. ? 1. : -1.;
              }
          }
        result.push_back(place);
      }
    return result;
  }

  RateSearch
  Examiner::search(const JointState &state) const
  {
    JudgeProblem at                       = problem_of_rates(problem, state);
    const std::vector<RateElement> places = positions(at, state, 1e-10);
    for (std::size_t k = 0; k < at.elements.size(); ++k)
      {
        JudgeElement &element        = at.elements[k];
        const ContactElement &origin = elements[k];
        element.normal_compliance    = tangent_compliance(*origin.normal_law, places[k].closure);
        element.layer_thickness      = 0.;
        if (element.has_tangential_bar())
          element.shear_compliance =
            tangent_compliance(*origin.shear_law,
                               origin.shear_law->kind() == ComplianceKind::nonlinear
                                 ? origin.shear_law->deformation(
                                     std::abs(state.forces[element.tangential_bar]) / element.area)
                                 : 0.);
      }
    return search_continuation(
      at, places, judge_load(model.bodies, model.loads.history.rates(state.t)), stiffness_error());
  }

  // Rigid motions meet no resistance. What S answers is what its elimination has left: slender
  // bodies leave more than the last digit of its largest entry.
  double
  Examiner::stiffness_error() const
  {
    const DenseMatrix &motions = model.bodies.rigid_coordinates();
    double error               = 0.;
    for (Eigen::Index k = 0; k < motions.cols(); ++k)
      {
        const Vector motion(motions.col(k).data(), motions.col(k).data() + motions.rows());
        if (const double size = max_abs(motion); size > 0.)
          error = std::max(error, max_abs(multiply(problem.S, motion)) / size);
      }
    return error;
  }

  // The lips of closed elements neither part nor close, unless N = 0; those inside the cone do not
  // slide, those on it slide forward only.
  bool
  Examiner::is_mechanism(const JointState &state, const Vector &jumps) const
  {
    constexpr double none     = 1e-5;
    constexpr double free     = 1e-6;
    const JudgeProblem at     = problem_of_rates(problem, state);
    const auto places         = positions(at, state, 1e-9);
    const Vector x            = judge.coordinates(jumps);
    const Vector resistance   = multiply(at.S, x);
    double largest_resistance = 0., largest_stiffness = 0., largest_x = 0.;
    for (std::size_t i = 0; i < x.size(); ++i)
      {
        largest_resistance = std::max(largest_resistance, std::abs(resistance[i]));
        largest_stiffness  = std::max(largest_stiffness, at.S(i, i));
        largest_x          = std::max(largest_x, std::abs(x[i]));
      }
    if (largest_resistance > free * largest_stiffness * largest_x)
      return false;
    for (std::size_t k = 0; k < places.size(); ++k)
      {
        const JudgeElement &element = at.elements[k];
        const RateStatus status     = places[k].status;
        const double normal         = jumps[element.normal_bar];
        const double shear = element.has_tangential_bar() ? jumps[element.tangential_bar] : 0.;
        const double rise  = state.strengths[k].dilatancy * std::abs(shear);
        if (status == RateStatus::open)
          continue;
        if (status == RateStatus::grazing ? normal < -none : std::abs(normal - rise) > none)
          return false;
        if ((status == RateStatus::slip_limit && places[k].sign * shear < -none) ||
            (status == RateStatus::stick && std::abs(shear) > none))
          return false;
      }
    return true;
  }

  bool
  Examiner::finds_step_beyond(const JointState &state, const double part) const
  {
    const JudgeProblem at = problem_in(problem, state);
    const Vector now      = load(state.t),
                 rate     = judge_load(model.bodies, model.loads.history.rates(state.t));
    Vector beyond         = now;
    for (std::size_t i = 0; i < now.size(); ++i)
      beyond[i] += part * rate[i];
    const double nearby = 1e3 * part;
    const auto other    = solve_anew(at, judge_slips(state), now, beyond);
    return other && distance(*other, solution(at, state, judge_slips(state))) <= nearby;
  }

  bool
  Examiner::is_turning_point(const JointState &state) const
  {
    if (!has_curved_envelope(elements) || !can_solve(state))
      return false;
    for (const double part : {1e-6, 1e-5, 1e-4})
      if (finds_step_beyond(state, part))
        return false;
    return true;
  }
} // namespace fuga::stress
