// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/process_info.h>
#include <fuga/run/journal/run_summary.h>

namespace fuga
{
  template <int dim>
  void
  write_summary(const RunJournal<dim> &journal, const RunOutcome &outcome)
  {
    const PhaseRun<dim> &phase   = journal.phase;
    const Model<dim> &model      = phase.model;
    const Parameters &parameters = phase.parameters;
    const RunRecord &record      = journal.record;
    Summary summary;
    summary.verdict              = outcome.verdict;
    summary.exit_code            = static_cast<int>(outcome.code);
    summary.message              = outcome.message;
    summary.t                    = outcome.path.t;
    const auto [stage, fraction] = stage_of(summary.t, model.stage_names.size());
    summary.stage                = model.stage_names[stage];
    summary.stage_fraction       = fraction;
    summary.drive                = journal.context.driving.at(summary.t, stage);
    summary.motion               = model.motion(phase.joint.elements, outcome.path);
    summary.proof                = outcome.proof;
    summary.path                 = outcome.path;
    for (const std::size_t k : outcome.path.critical.elements)
      {
        const ContactElement &element = phase.joint.elements[k];
        summary.critical_elements.push_back(
          {model.joint_names[element.joint],
           element.number,
           {element.position.begin(), element.position.begin() + dim}});
      }
    summary.safety       = outcome.safety;
    summary.accuracy     = journal.accuracy;
    summary.load_factors = model.loads.factors_by_name(parameters.model, summary.t);
    summary.sizes        = model.sizes();
    summary.work         = {model.bodies.work(), 1, phase.path->work()};
    if (phase.motion)
      summary.work.bodies.add(phase.motion->step_solvers()->work());
    summary.motion_energies   = record.motion_energies;
    summary.motion_steps      = record.motion_steps;
    summary.continuations     = record.continuations;
    summary.events_by_kind    = record.events_by_kind;
    summary.n_events          = record.n_events;
    summary.iterations        = phase.path->iterations();
    summary.certificate       = record.worst;
    summary.certificate_bound = parameters.solver.certificate_bound;
    summary.phases            = model.timer.seconds();
    summary.peaks             = model.timer.peak_megabytes();
    summary.memory_MB         = peak_memory_in_megabytes();
    summary.split_report      = model.mesh.report;
    summary.warnings          = journal.log.all_warnings();
    write_complete_file(parameters.output.directory + "/summary.json",
                        summary_json(summary, parameters));
  }

  template <int dim>
  void
  write_unfinished_summary(const RunJournal<dim> &journal, const PathResult &path)
  {
    RunOutcome outcome;
    outcome.verdict = "unfinished";
    outcome.path    = path;
    write_summary(journal, outcome);
  }

  template void
  write_summary(const RunJournal<2> &, const RunOutcome &);
  template void
  write_summary(const RunJournal<3> &, const RunOutcome &);
  template void
  write_unfinished_summary(const RunJournal<2> &, const PathResult &);
  template void
  write_unfinished_summary(const RunJournal<3> &, const PathResult &);
} // namespace fuga
