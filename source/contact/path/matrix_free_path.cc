// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/element/change_of_state.h>
#include <fuga/contact/element/joint_water.h>
#include <fuga/contact/element/return_mapping.h>
#include <fuga/contact/path/matrix_free_path.h>
#include <fuga/contact/segments/scheme_equilibrium.h>
#include <fuga/contact/system/layered_system.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** Tolerance of the residual, in the 2-norm, relative to the largest force: bodies as a whole
     * are in equilibrium to the root of the number of bars times this, and the certificate is to be
     * below 1e-9. */
    constexpr double tolerance = 1e-11;
    /** Tolerances of a linear solution: while schemes change, and, when they do not any more, at
     * most. */
    constexpr double rough = 1e-3, fine = 1e-9;
    /** Share of the tolerance that a residual should have after a linear solution that is to bring
     * it within the tolerance. */
    constexpr double margin = 0.3;
    constexpr int max_steps = 80;
    /** Schemes lead further if the residual may grow at first, but not for ever, since they would
     * then cycle. */
    constexpr int free_steps         = 10;
    constexpr double harmless_growth = 1.5;

    /** Return the force that counts as zero in a state at the end of a step [MN]. */
    double
    no_force_in(const JointState &state)
    {
      return 10. * tolerance * max_abs(state.forces);
    }

    /** Shortest part of a step by which it goes on to guess its end. */
    constexpr double shortest_part = 1. / 16.;
  } // namespace

  MatrixFreePath::MatrixFreePath(const std::vector<ContactElement> &contact_elements,
                                 const LayeredSystem &layered_system,
                                 const ContactSystem &contact_system,
                                 const TangentSolver &tangent_solver,
                                 const LoadHistory &load_history)
    : ContactPath(contact_elements, layered_system, load_history)
    , bodies(contact_system)
    , solver(tangent_solver)
    , n_bars(layered_system.n_bars())
    , dual(dual_of(contact_system.jump_operator()))
    , layers(contact_elements, tangent_solver.stiffness_of_lips(), contact_system.jump_operator())
  {
  }

  PathResult
  MatrixFreePath::follow(const std::vector<double> &levels, ReportCounter &observer)
  {
    JointState state  = cut.state;
    PathResult result = cut.result;
    while (state.t < history.end() && observer.wants_more())
      {
        make_cut(state, result, observer);
        double t = history.next_corner(state.t);
        if (next_level < levels.size() && levels[next_level] > state.t)
          t = std::min(t, levels[next_level]);
        state = let_water_in(step_to(state, t), observer, result);
        observer.jumped(state);
        result.t = state.t;
        ++result.n_jumps;
        reach_levels(levels, state, observer);
      }
    make_cut(state, result, observer);
    return result;
  }

  Vector
  MatrixFreePath::imposed_jumps(const double t) const
  {
    const DenseMatrix &E = bodies.imposed_jumps();
    return E.size() == 0 ? Vector(n_bars, 0.) : multiply(E, history.factors(t));
  }

  Vector
  MatrixFreePath::jumps(const double t, const Trial &trial) const
  {
    Vector result = imposed_jumps(t);
    add_multiple(1., multiply(bodies.jump_operator(), trial.bodies.x), result);
    layers.enlarge(result);
    return result;
  }

  // All results that follow from x and S x are computed.
  void
  MatrixFreePath::evaluate(const JointState &from, const double t, Trial &trial) const
  {
    trial.states.resize(elements.size());
    trial.tangents.resize(elements.size());
    trial.dilations.resize(elements.size());
    trial.forces.assign(n_bars, 0.);
    ReturnMapping mapping(layers.elements(), from, jumps(t, trial));
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const StepResponse response = mapping.respond(k);
        trial.states[k]             = response.state;
        trial.tangents[k]           = response.tangent;
        trial.dilations[k]          = response.dilation;
        for (std::size_t i = 0; i < elements[k].n_bars(); ++i)
          trial.forces[elements[k].bar(i)] = response.forces[i];
      }
    Vector pressed = trial.forces;
    add_multiple(-1., from.water, pressed);
    trial.residual = multiply(bodies.load_patterns(), history.factors(t));
    add_multiple(-1., trial.bodies.resistance, trial.residual);
    add_multiple(-1., multiply_transposed(bodies.jump_operator(), pressed), trial.residual);
  }

  // The full step is taken unless the error would grow; S x is known along the step, so that trying
  // costs nothing. There is no step where all forces are infinite.
  MatrixFreePath::Trial
  MatrixFreePath::line_search(const JointState &from,
                              const double t,
                              const Trial &at,
                              const TangentSolver::Solution &step,
                              const double largest_growth) const
  {
    constexpr double shortest = 0.01;
    const double error        = std::sqrt(dot(at.residual, at.residual));
    Trial best;
    double least    = std::numeric_limits<double>::infinity();
    JointState here = from;
    here.states     = at.states;
    here.forces.assign(n_bars, 0.); // then the dislocations are the jumps
    here.dislocations    = jumps(t, at);
    const double longest = limit_safeguard(layers.elements(),
                                           here,
                                           multiply(bodies.jump_operator(), step.x),
                                           OpenLips::stay_short_of_limit);
    for (double length = longest; length >= shortest * longest; length *= 0.5)
      {
        Trial trial;
        trial.bodies = at.bodies;
        trial.bodies.add(length, step);
        evaluate(from, t, trial);
        const double rest = std::sqrt(dot(trial.residual, trial.residual));
        if (rest < least)
          {
            least = rest;
            best  = std::move(trial);
          }
        if (least < largest_growth * error)
          break;
      }
    return best;
  }

  // Where no equilibrium is found, a smaller load on the way gives a better guess; each is the end
  // of a step from the beginning.
  JointState
  MatrixFreePath::step_to(const JointState &from, const double t)
  {
    Trial reached;
    Vector of_bodies = system.jumps(from.dislocations, from.forces);
    add_multiple(-1., imposed_jumps(from.t), of_bodies);
    reached.bodies.x = multiply_transposed(dual, of_bodies);
    solver.refine(reached.bodies);
    reached.forces = from.forces;
    double done = 0., piece = 1.;
    while (piece >= shortest_part)
      {
        const double share = done + piece < 1. - 0.5 * shortest_part ? done + piece : 1.;
        Trial trial        = reached;
        layers.update(trial.forces);
        const std::optional<JointState> end =
          end_of_step(from, share < 1. ? from.t + share * (t - from.t) : t, trial);
        if (end && share == 1.)
          return *end;
        if (end)
          {
            reached = std::move(trial);
            done    = share;
            piece *= 2.;
          }
        else
          piece *= 0.25;
      }
    throw NumericalFailure(fmt::format(
      "No state of equilibrium was found at t = {:.9g}, nor on the way beyond {:.9g}: the loads "
      "may be "
      "beyond their limit. Solver/Bodies = iterative or direct with Follow = events finds it.",
      t,
      from.t + done * (t - from.t)));
  }

  // What is lost in the step is lost: equilibrium is then looked for again.
  std::optional<JointState>
  MatrixFreePath::end_of_step(JointState from, const double t, Trial &trial)
  {
    set_water(system, history.factors(t), from);
    while (find_equilibrium(from, t, trial))
      {
        JointState state       = state_of(from, t, trial);
        const double no_force  = no_force_in(state);
        const auto along_shear = [&](const std::size_t k) {
          return direction_of(tangential(elements[k], state.forces));
        };
        if (!lose_strength_in_step(elements, state, along_shear, no_force, from))
          return state;
      }
    return {};
  }

  // The missing part of the water comes at once, and may open more elements.
  JointState
  MatrixFreePath::let_water_in(JointState state, PathObserver &observer, PathResult &result)
  {
    while (let_water_follow(Vector(n_bars, no_force_in(state)), state, observer, result))
      {
        std::fill(state.missing_water.begin(), state.missing_water.end(), 0.);
        state = step_to(state, state.t);
      }
    standstill.forget();
    return state;
  }

  bool
  MatrixFreePath::find_equilibrium(const JointState &from, const double t, Trial &trial)
  {
    bool is_exact        = true;
    const double loading = max_abs(multiply(bodies.load_patterns(), history.factors(t)));
    bool is_near         = false;
    ++iteration_count.n_solutions;
    evaluate(from, t, trial);
    for (int count = 0;; ++count)
      {
        const double scale =
          std::max({loading, max_abs(trial.forces), max_abs(trial.bodies.resistance)});
        const double rest = std::sqrt(dot(trial.residual, trial.residual));
        if (rest <= tolerance * scale)
          {
            if (layers.defect(trial.forces) > tolerance * scale)
              layers.update(trial.forces);
            else if (is_exact)
              return true;
            else
              {
                solver.refine(trial.bodies);
                is_exact = true;
              }
            evaluate(from, t, trial);
            continue;
          }
        if (count == max_steps)
          return false;
        const auto states                  = trial.states;
        const TangentSolver::Solution step = solver.solve_with_bars(
          trial.tangents,
          trial.residual,
          trial.bodies,
          is_near ? std::clamp(margin * tolerance * scale / rest, fine, rough) : rough);
        trial = line_search(from, t, trial, step, count < free_steps ? harmless_growth : 1.);
        if (trial.states.empty())
          return false;
        is_near  = trial.states == states;
        is_exact = false;
        ++iteration_count.n_iterations;
        iteration_count.max_in_one =
          std::max<std::size_t>(iteration_count.max_in_one, static_cast<std::size_t>(count) + 1);
      }
  }

  JointState
  MatrixFreePath::state_of(const JointState &from, const double t, const Trial &trial) const
  {
    JointState state  = from;
    state.t           = t;
    state.states      = trial.states;
    state.forces      = trial.forces;
    state.dilations   = trial.dilations;
    const Vector felt = jumps(t, trial);
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = layers.elements()[k];
        element.for_each_bar([&](const unsigned int bar, const ComplianceLaw &law) {
          state.dislocations[bar] =
            felt[bar] - bar_compliance(law, element.area) * state.forces[bar];
        });
        if (is_slipping(state.states[k]) && state.dilations[k] >= element.friction.dilation_limit)
          state.strengths[k].dilatancy = 0.;
        const bool is_open = state.states[k] == ContactState::open;
        if (!is_open && !has_nonlinear_closure(element))
          state.dislocations[element.normal_bar] = state.dilations[k] - element.initial_gap;
        if (!element.has_tangential_bar())
          continue;
        if (state.states[k] != ContactState::stick || !carries_shear(element, state.strengths[k]))
          state.slips[k] = present_slip(element, state, k);
        else if (!has_nonlinear_shear(element))
          for (std::size_t i = 1; i < element.n_bars(); ++i)
            state.dislocations[element.bar(i)] = from.slips[k][i - 1];
      }
    return state;
  }
} // namespace fuga
