// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/element/mechanism.h>
#include <fuga/contact/judge/limit_proof.h>
#include <fuga/contact/virgin_state.h>
#include <fuga/output/tables/summary.h>
#include <fuga/run/simulation/simulation.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  // The stage behind is that of a slow path without changes of structure, in which supports hold.
  template <int dim>
  bool
  Simulation<dim>::still_move(const PathResult &result) const
  {
    const ModelDefinition &definition = parameters.model;
    return parameters.solver.beyond_limit == LimitLoadChoice::dynamic && motion &&
           !model.construction.until_rest && result.verdict == Verdict::done &&
           !model.is_last_phase() && !definition.stages[model.next_stage()].is_dynamic() &&
           keeps_structure(definition, model.next_stage()) &&
           motion_energies.kinetic > TimeGrid::at_rest * motion_energies.largest;
  }

  template <int dim>
  void
  Simulation<dim>::begin_continuation(PathResult &loss)
  {
    MotionBeyondLimit continuation;
    try
      {
        continuation.proof = prove_limit(judge, joint.elements, layered, last_state, loss).mechanism;
      }
    catch (const NumericalFailure &)
      {
        // No proof is needed: either the bodies come to rest, or they do not.
      }
    continuation.loss     = loss;
    continuation.t        = parameters.model.dynamics.end_of_continuation(loss.t);
    continuation.friction = -judge.energies().dissipation;
    if (last_state.states.empty())
      last_state =
        virgin_state(joint.elements, layered.n_bars(), layered.water_in_joints() != nullptr);
    log.line(fmt::format("t = {:.12g}: {}. The bodies move under the loads of t = {:.12g}.",
                         loss.t,
                         motion ? "the dynamic stage ends in motion" : verdict_name(loss.verdict),
                         continuation.t));
    note_motion(loss.t,
                {{motion ? "motion" : "equilibrium", "motion until rest"}},
                loss.mechanism_jumps.empty()
                  ? layered.jumps(last_state.dislocations, last_state.forces)
                  : loss.mechanism_jumps,
                0.);
    continuations.push_back(std::move(continuation));
  }

  template <int dim>
  MechanismCertificate
  Simulation<dim>::end_continuation(PathResult &result)
  {
    MotionBeyondLimit &continuation = continuations.back();
    continuation.rests              = result.verdict == Verdict::done;
    continuation.duration           = motion->time();
    continuation.velocity           = motion->largest_velocity();
    continuation.energies           = motion_energies;
    continuation.friction += judge.energies().dissipation;
    const JointState &first = model.first_state;
    Vector change           = layered.jumps(last_state.dislocations, last_state.forces);
    add_multiple(-1., layered.jumps(first.dislocations, first.forces), change);
    for (std::size_t k = 0; k < joint.elements.size(); ++k)
      {
        const TangentVector slip = sum(last_state.slips[k], -1., first.slips[k]);
        continuation.slip        = std::max(continuation.slip, length(slip));
        continuation.opening =
          std::max(continuation.opening, std::abs(change[joint.elements[k].normal_bar]));
      }
    note_motion(last_state.t,
                {{"motion until rest", continuation.rests ? "equilibrium" : "motion"}},
                change,
                motion_energies.joints);
    if (continuation.rests)
      {
        last_state.t = continuation.t;
        while (levels_written < model.loads.levels.size() &&
               model.loads.levels[levels_written] <= last_state.t)
          ++levels_written;
      }
    else
      {
        const PathResult &loss = continuation.loss;
        result.verdict         = Verdict::limit_load;
        result.t               = loss.t;
        result.mechanism_jumps = loss.mechanism_jumps;
        if (const double largest = max_abs(change); loss.mechanism_jumps.empty() && largest > 0.)
          {
            for (double &jump : change)
              jump /= largest;
            result.mechanism_jumps = change;
          }
        result.mechanism = classify_mechanism(result.mechanism_jumps, joint.elements);
      }
    log.line(describe(continuation));
    return continuation.proof;
  }

  template <int dim>
  std::string
  Simulation<dim>::describe(const MotionBeyondLimit &continuation) const
  {
    const Units &units  = parameters.output.units;
    const bool was_lost = continuation.loss.verdict != Verdict::done;
    const std::string state =
      continuation.rests
        ? fmt::format("rest at t = {:.12g}", continuation.t)
        : fmt::format("still move with {:.4g} {}/s", continuation.velocity, units.length);
    return fmt::format(
      "bodies that {} at t = {:.12g} {} after {:.4g} s; largest slip "
      "{:.6g} {}, work of the loads {:.4g} {}, of friction {:.4g}, of damping {:.4g}",
      was_lost ? "lost equilibrium" : "moved",
      continuation.loss.t,
      state,
      continuation.duration,
      continuation.slip,
      units.length,
      continuation.energies.work,
      units.energy(),
      continuation.friction,
      continuation.energies.damping);
  }

  template class Simulation<2>;
  template class Simulation<3>;
} // namespace fuga
