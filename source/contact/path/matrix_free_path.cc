// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/path/matrix_free_path.h>
#include <fuga/contact/system/layered_system.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** Of the residual, by its 2-norm, to the largest force: bodies are in equilibrium as a whole
     * to the root of the number of bars times this, and the certificate is to be below 1e-9. */
    constexpr double tolerance = 1e-11;
    /** Of a linear solution: while schemes change, and when they do not any more. */
    constexpr double rough = 1e-3, fine = 1e-9;
    constexpr int max_steps = 80;

    std::array<unsigned int, 3>
    bars_of(const ContactElement &element)
    {
      return {element.normal_bar, element.tangential_bar, element.second_tangential_bar};
    }
  } // namespace

  std::string
  unavailable_without_stiffness(const ContactElement &element)
  {
    const auto is_linear = [](const ComplianceLaw &law) {
      return law.kind() == ComplianceKind::linear;
    };
    if (!is_linear(*element.normal_law) ||
        (element.has_tangential_bar() && !is_linear(*element.shear_law)) ||
        element.coupling != nullptr)
      return "layers other than linear ones";
    if (!element.friction.is_plain())
      return "cohesion, tensile strength, residual friction and dilatancy";
    return {};
  }

  MatrixFreePath::MatrixFreePath(const std::vector<ContactElement> &contact_elements,
                                 const LayeredSystem &layered_system,
                                 const ContactSystem &contact_system,
                                 const TangentSolver &tangent_solver,
                                 const LoadHistory &load_history)
    : ContactPath(contact_elements, layered_system, load_history)
    , bodies(contact_system)
    , solver(tangent_solver)
    , n_bars(layered_system.n_bars())
  {
    for (const ContactElement &element : elements)
      if (const std::string what = unavailable_without_stiffness(element); !what.empty())
        throw InputError(
          fmt::format("Not available without the stiffness of the interface: {}.", what));
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
        state = step_to(state, t);
        observer.jumped(state);
        result.t = state.t;
        ++result.n_jumps;
        reach_levels(levels, state, observer);
      }
    make_cut(state, result, observer);
    return result;
  }

  // A closed layer gives N by the closure; the shear that it would carry without further slip is
  // put back onto the cone, in its own direction.
  MatrixFreePath::Response
  MatrixFreePath::respond(const std::size_t k, const Vector &jumps, const Vector &slips) const
  {
    const ContactElement &element = elements[k];
    Response result;
    const double gap = element.initial_gap + jumps[element.normal_bar];
    if (gap > 0.)
      return result;
    const double C_n     = 1. / bar_compliance(*element.normal_law, element.area);
    result.state         = ContactState::stick;
    result.forces[0]     = C_n * gap;
    result.tangent[0][0] = C_n;
    if (!element.has_tangential_bar())
      return result;

    const double C_t      = 1. / bar_compliance(*element.shear_law, element.area);
    const double strength = -element.friction.coefficient * result.forces[0];
    const auto bars       = bars_of(element);
    const std::size_t n   = element.n_bars();
    double size           = 0.;
    for (std::size_t i = 1; i < n; ++i)
      {
        result.forces[i] = C_t * (jumps[bars[i]] - slips[bars[i]]);
        size             = std::hypot(size, result.forces[i]);
      }
    if (size <= strength)
      {
        for (std::size_t i = 1; i < n; ++i)
          result.tangent[i][i] = C_t;
        return result;
      }
    std::array<double, 3> direction{};
    for (std::size_t i = 1; i < n; ++i)
      {
        direction[i]         = result.forces[i] / size;
        result.forces[i]     = strength * direction[i];
        result.tangent[i][0] = -element.friction.coefficient * C_n * direction[i];
      }
    if (n == 3)
      for (std::size_t i = 1; i < n; ++i)
        for (std::size_t j = 1; j < n; ++j)
          result.tangent[i][j] =
            strength / size * C_t * ((i == j ? 1. : 0.) - direction[i] * direction[j]);
    // With two tangents the direction is that of T, and the sign says nothing.
    result.state =
      n == 2 && direction[1] < 0. ? ContactState::slip_backward : ContactState::slip_forward;
    return result;
  }

  Vector
  MatrixFreePath::imposed_jumps(const double t) const
  {
    const DenseMatrix &E = bodies.imposed_jumps();
    return E.empty() ? Vector(n_bars, 0.) : multiply(E, history.factors(t));
  }

  // Fills in all that follows from x and S x.
  void
  MatrixFreePath::evaluate(const JointState &from, const double t, Trial &trial) const
  {
    Vector jumps = imposed_jumps(t);
    for (std::size_t i = 0; i < n_bars; ++i)
      jumps[i] += trial.x[i];
    trial.states.resize(elements.size());
    trial.tangents.resize(elements.size());
    trial.forces.assign(n_bars, 0.);
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const Response response = respond(k, jumps, from.dislocations);
        trial.states[k]         = response.state;
        trial.tangents[k]       = response.tangent;
        for (std::size_t i = 0; i < elements[k].n_bars(); ++i)
          trial.forces[bars_of(elements[k])[i]] = response.forces[i];
      }
    trial.residual = multiply(bodies.load_patterns(), history.factors(t));
    for (std::size_t i = 0; i < n_bars; ++i)
      trial.residual[i] -= trial.Sx[i] + trial.forces[i];
  }

  // The full step unless the error would grow; S x is known along the step, so trying costs
  // nothing.
  MatrixFreePath::Trial
  MatrixFreePath::line_search(const JointState &from,
                              const double t,
                              const Trial &at,
                              const TangentSolver::Solution &step) const
  {
    constexpr double harmless_growth = 1.5, shortest = 0.05;
    const double error = std::sqrt(dot(at.residual, at.residual));
    Trial best;
    double least = std::numeric_limits<double>::infinity();
    for (double length = 1.; length >= shortest; length *= 0.5)
      {
        Trial trial{at.x, at.Sx, {}, {}, {}, {}};
        for (std::size_t i = 0; i < n_bars; ++i)
          {
            trial.x[i] += length * step.jumps[i];
            trial.Sx[i] += length * step.resistance[i];
          }
        evaluate(from, t, trial);
        const double rest = std::sqrt(dot(trial.residual, trial.residual));
        if (rest < least)
          {
            least = rest;
            best  = std::move(trial);
          }
        if (least <= harmless_growth * error)
          break;
      }
    return best;
  }

  JointState
  MatrixFreePath::step_to(const JointState &from, const double t)
  {
    Trial trial;
    trial.x.resize(n_bars);
    const Vector imposed = imposed_jumps(from.t);
    for (const ContactElement &element : elements)
      for (std::size_t i = 0; i < element.n_bars(); ++i)
        {
          const unsigned int bar   = bars_of(element)[i];
          const ComplianceLaw &law = i == 0 ? *element.normal_law : *element.shear_law;
          trial.x[bar]             = from.dislocations[bar] +
                         bar_compliance(law, element.area) * from.forces[bar] - imposed[bar];
        }
    bool is_exact        = true;
    trial.Sx             = bodies.resistance(trial.x);
    const double loading = max_abs(multiply(bodies.load_patterns(), history.factors(t)));
    double accuracy      = rough;
    ++iteration_count.n_solutions;
    for (int count = 0;; ++count)
      {
        evaluate(from, t, trial);
        const double scale = std::max({loading, max_abs(trial.forces), max_abs(trial.Sx)});
        if (std::sqrt(dot(trial.residual, trial.residual)) <= tolerance * scale)
          {
            if (is_exact)
              break;
            trial.Sx = bodies.resistance(trial.x);
            is_exact = true;
            continue;
          }
        if (count == max_steps)
          throw NumericalFailure(fmt::format(
            "No state of equilibrium was found at t = {:.9g} in {} schemes: the loads may be "
            "beyond "
            "their limit. Solver/Bodies = iterative or direct with Follow = events finds it.",
            t,
            max_steps));
        const auto states = trial.states;
        trial             = line_search(
          from, t, trial, solver.solve_with_bars(trial.tangents, trial.residual, accuracy));
        accuracy = trial.states == states ? fine : rough;
        is_exact = false;
        ++iteration_count.n_iterations;
        iteration_count.max_in_one =
          std::max<std::size_t>(iteration_count.max_in_one, static_cast<std::size_t>(count) + 1);
      }
    return state_of(from, t, trial);
  }

  JointState
  MatrixFreePath::state_of(const JointState &from, const double t, const Trial &trial) const
  {
    JointState state     = from;
    state.t              = t;
    state.states         = trial.states;
    state.forces         = trial.forces;
    const Vector imposed = imposed_jumps(t);
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        for (std::size_t i = 0; i < element.n_bars(); ++i)
          {
            const unsigned int bar   = bars_of(element)[i];
            const ComplianceLaw &law = i == 0 ? *element.normal_law : *element.shear_law;
            state.dislocations[bar] =
              trial.x[bar] + imposed[bar] - bar_compliance(law, element.area) * state.forces[bar];
          }
        if (state.states[k] != ContactState::open)
          state.dislocations[element.normal_bar] = -element.initial_gap;
        if (!element.has_tangential_bar())
          continue;
        if (state.states[k] == ContactState::stick)
          for (std::size_t i = 1; i < element.n_bars(); ++i)
            state.dislocations[bars_of(element)[i]] = from.dislocations[bars_of(element)[i]];
        state.slips[k] = tangential(element, state.dislocations);
      }
    return state;
  }
} // namespace fuga
