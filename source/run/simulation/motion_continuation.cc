// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/element/mechanism.h>
#include <fuga/contact/judge/limit_proof.h>
#include <fuga/contact/virgin_state.h>
#include <fuga/run/journal/verdict_text.h>
#include <fuga/run/simulation/motion_continuation.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  template <int dim>
  MotionContinuation<dim>::MotionContinuation(RunJournal<dim> &of_run,
                                              MotionJournal<dim> &of_motion)
    : journal(of_run), motion_journal(of_motion), phase(journal.phase)
  {
  }

  // The stage after this is that of a slow path without changes of structure, in which supports
  // hold.
  template <int dim>
  bool
  MotionContinuation<dim>::still_move(const PathResult &result) const
  {
    const Model<dim> &model           = phase.model;
    const ModelDefinition &definition = phase.parameters.model;
    const MotionLedger &energies      = journal.record.motion_energies;
    return phase.parameters.solver.beyond_limit == LimitLoadChoice::dynamic && phase.motion &&
           !model.construction.until_rest && result.verdict == Verdict::done &&
           !model.is_last_phase() && !definition.stages[model.next_stage()].is_dynamic() &&
           keeps_structure(definition, model.next_stage()) &&
           energies.kinetic > TimeGrid::at_rest * energies.largest;
  }

  template <int dim>
  void
  MotionContinuation<dim>::begin(PathResult &loss)
  {
    JointState &last = journal.record.last_state;
    MotionBeyondLimit continuation;
    try
      {
        continuation.proof =
          prove_limit(phase.judge, phase.joint.elements, phase.layered, last, loss).mechanism;
      }
    catch (const NumericalFailure &)
      {
        // No proof is needed: either the bodies come to rest, or they do not.
      }
    continuation.loss     = loss;
    continuation.t        = phase.parameters.model.dynamics.end_of_continuation(loss.t);
    continuation.friction = -phase.judge.energies().dissipation;
    if (last.states.empty())
      last = virgin_state(
        phase.joint.elements, phase.layered.n_bars(), phase.layered.water_in_joints() != nullptr);
    journal.log.line(
      fmt::format("t = {:.12g}: {}. The bodies move under the loads of t = {:.12g}.",
                  loss.t,
                  phase.motion ? "the dynamic stage ends in motion" : verdict_name(loss.verdict),
                  continuation.t));
    motion_journal.note(loss.t,
                        {{phase.motion ? "motion" : "equilibrium", "motion until rest"}},
                        loss.mechanism_jumps.empty()
                          ? phase.layered.jumps(last.dislocations, last.forces)
                          : loss.mechanism_jumps,
                        0.);
    journal.record.continuations.push_back(std::move(continuation));
  }

  template <int dim>
  MechanismCertificate
  MotionContinuation<dim>::end(PathResult &result)
  {
    RunRecord &record               = journal.record;
    MotionBeyondLimit &continuation = record.continuations.back();
    continuation.rests              = result.verdict == Verdict::done;
    continuation.duration           = phase.motion->time();
    continuation.velocity           = phase.motion->largest_velocity();
    continuation.energies           = record.motion_energies;
    continuation.friction += phase.judge.energies().dissipation;
    JointState &last        = record.last_state;
    const JointState &first = phase.model.first_state;
    Vector change           = phase.layered.jumps(last.dislocations, last.forces);
    add_multiple(-1., phase.layered.jumps(first.dislocations, first.forces), change);
    const std::vector<ContactElement> &elements = phase.joint.elements;
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const TangentVector slip = sum(last.slips[k], -1., first.slips[k]);
        continuation.slip        = std::max(continuation.slip, length(slip));
        continuation.opening =
          std::max(continuation.opening, std::abs(change[elements[k].normal_bar]));
      }
    motion_journal.note(last.t,
                        {{"motion until rest", continuation.rests ? "equilibrium" : "motion"}},
                        change,
                        record.motion_energies.joints);
    if (continuation.rests)
      {
        last.t                            = continuation.t;
        const std::vector<double> &levels = phase.model.loads.levels;
        while (record.levels_written < levels.size() && levels[record.levels_written] <= last.t)
          ++record.levels_written;
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
        result.mechanism = classify_mechanism(result.mechanism_jumps, elements);
      }
    journal.log.line(continuation_text(continuation, phase.parameters.output.units));
    return continuation.proof;
  }

  template class MotionContinuation<2>;
  template class MotionContinuation<3>;
} // namespace fuga
