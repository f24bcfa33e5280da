// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/run/journal/checkpoint_keeper.h>
#include <fuga/run/journal/run_summary.h>

namespace fuga
{
  namespace
  {
    /** With Checkpoint = events, the run goes on for this many times the duration of the last
     * checkpoint. */
    constexpr double time_between = 100.;
  } // namespace

  template <int dim>
  CheckpointKeeper<dim>::CheckpointKeeper(RunJournal<dim> &of_run,
                                          const MotionJournal<dim> &of_motion)
    : journal(of_run), motion_journal(of_motion)
  {
  }

  template <int dim>
  bool
  CheckpointKeeper<dim>::is_wanted() const
  {
    // All of the motion is needed to find when bodies have come to rest, so a restart repeats it.
    const PhaseRun<dim> &phase = journal.phase;
    return phase.parameters.output.checkpoint != CheckpointOutput::never &&
           !phase.model.construction.until_rest;
  }

  template <int dim>
  void
  CheckpointKeeper<dim>::begin()
  {
    if (is_wanted())
      mesh_identity = identify_file(journal.phase.parameters.mesh_file);
  }

  template <int dim>
  void
  CheckpointKeeper<dim>::write_at_event()
  {
    const CheckpointOutput wanted             = journal.phase.parameters.output.checkpoint;
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - last_time;
    if (wanted == CheckpointOutput::every_event ||
        (wanted == CheckpointOutput::events && since.count() > time_between * cost))
      write();
  }

  template <int dim>
  void
  CheckpointKeeper<dim>::write()
  {
    Checkpoint checkpoint;
    checkpoint.cut = journal.phase.path->last_cut();
    write(std::move(checkpoint));
  }

  template <int dim>
  void
  CheckpointKeeper<dim>::write(const RunOutcome &outcome)
  {
    if (outcome.code == ExitCode::numerical_failure)
      return;
    Checkpoint checkpoint;
    checkpoint.finished   = true;
    checkpoint.verdict    = outcome.verdict;
    checkpoint.exit_code  = static_cast<int>(outcome.code);
    checkpoint.cut        = journal.phase.path->last_cut();
    checkpoint.cut.result = outcome.path;
    write(std::move(checkpoint));
  }

  template <int dim>
  void
  CheckpointKeeper<dim>::write(Checkpoint &&checkpoint)
  {
    if (!is_wanted() || is_suspended)
      return;
    const PhaseRun<dim> &phase = journal.phase;
    phase.model.timer.finish("path");
    const auto begin = std::chrono::steady_clock::now();
    fill(checkpoint);
    if (phase.motion)
      checkpoint.motion = phase.dynamic_path().last_motion_cut();
    checkpoint.samples = motion_journal.samples();
    write_checkpoint(phase.parameters.output.directory, checkpoint);
    last_time = std::chrono::steady_clock::now();
    cost      = std::chrono::duration<double>(last_time - begin).count();
    phase.model.timer.finish("checkpoints");
    if (action)
      action();
  }

  template <int dim>
  void
  CheckpointKeeper<dim>::fill(Checkpoint &checkpoint) const
  {
    const PhaseRun<dim> &phase = journal.phase;
    checkpoint.parameters      = description_of_problem(phase.parameters);
    checkpoint.mesh            = mesh_identity;
    checkpoint.construction    = phase.model.construction;
    checkpoint.judge           = phase.judge.memory();
    checkpoint.record          = journal.record;
    checkpoint.tables          = journal.history.memory();
    checkpoint.fields          = journal.fields.memory();
    checkpoint.log             = journal.log.memory();
  }

  template <int dim>
  void
  CheckpointKeeper<dim>::restore(const Checkpoint &checkpoint)
  {
    PhaseRun<dim> &phase = journal.phase;
    mesh_identity        = checkpoint.mesh;
    journal.record       = checkpoint.record;
    phase.judge.restore(checkpoint.judge);
    journal.history.restore(checkpoint.tables);
    journal.log.restore(checkpoint.log);
    write_unfinished_summary(journal, checkpoint.cut.result);
    journal.fields.restore(checkpoint.fields);

    std::set<std::string> kept = {
      "summary.json", "boundaries.csv", "log.txt", checkpoint_file_name};
    for (const auto &[name, memory] : checkpoint.tables.files)
      kept.insert(name);
    for_each_field(checkpoint.fields, [&kept](const std::string &name, const auto &collection) {
      for (const auto &[t, file] : collection)
        kept.insert({name + ".pvd", file, paraview_script_name});
    });
    remove_earlier_results(phase.parameters.output.directory, kept);
    journal.publish(true);
    phase.model.timer.finish("tables");
  }

  template class CheckpointKeeper<2>;
  template class CheckpointKeeper<3>;
} // namespace fuga
