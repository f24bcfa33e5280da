// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/interruption.h>
#include <fuga/run/simulation/simulation.h>

#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** With Checkpoint = events: the run goes on so many times as long as the last one took. */
    constexpr double time_between = 100.;
  } // namespace

  template <int dim>
  bool
  Simulation<dim>::wants_cuts() const
  {
    return keeps_checkpoints() || safety_search.is_wanted();
  }

  template <int dim>
  bool
  Simulation<dim>::keeps_checkpoints() const
  {
    // When bodies have come to rest is found from all of the motion: a restart repeats it.
    return parameters.output.checkpoint != CheckpointOutput::never &&
           !model.construction.until_rest;
  }

  template <int dim>
  void
  Simulation<dim>::publish(const bool now)
  {
    history.publish(now);
    log.publish(now);
  }

  template <int dim>
  void
  Simulation<dim>::checkpoint_at_event()
  {
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - last_checkpoint;
    if (parameters.output.checkpoint == CheckpointOutput::every_event ||
        (parameters.output.checkpoint == CheckpointOutput::events &&
         since.count() > time_between * cost_of_checkpoint))
      write_checkpoint();
  }

  template <int dim>
  void
  Simulation<dim>::write_checkpoint()
  {
    Checkpoint checkpoint;
    checkpoint.cut = path->last_cut();
    write_checkpoint(std::move(checkpoint));
  }

  // A numerical failure is no end: whoever restarts sees it again.
  template <int dim>
  void
  Simulation<dim>::write_checkpoint(const Outcome &outcome)
  {
    if (outcome.code == ExitCode::numerical_failure)
      return;
    Checkpoint checkpoint;
    checkpoint.finished   = true;
    checkpoint.verdict    = outcome.verdict;
    checkpoint.exit_code  = static_cast<int>(outcome.code);
    checkpoint.cut        = path->last_cut();
    checkpoint.cut.result = outcome.path;
    write_checkpoint(std::move(checkpoint));
  }

  template <int dim>
  void
  Simulation<dim>::write_checkpoint(Checkpoint &&checkpoint)
  {
    if (!keeps_checkpoints() || searching)
      return;
    model.timer.finish("path");
    const auto begin = std::chrono::steady_clock::now();
    fill(checkpoint);
    if (motion)
      checkpoint.motion = phase.dynamic_path().last_motion_cut();
    if (monitored_motion)
      checkpoint.samples = monitored_motion->memory();
    fuga::write_checkpoint(parameters.output.directory, checkpoint);
    last_checkpoint    = std::chrono::steady_clock::now();
    cost_of_checkpoint = std::chrono::duration<double>(last_checkpoint - begin).count();
    model.timer.finish("checkpoints");
    if (checkpoint_action)
      checkpoint_action();
  }

  template <int dim>
  void
  Simulation<dim>::fill(Checkpoint &checkpoint) const
  {
    checkpoint.parameters   = description_of_problem(parameters);
    checkpoint.mesh         = mesh_identity;
    checkpoint.construction = model.construction;
    checkpoint.judge        = judge.memory();
    checkpoint.record       = *this;
    checkpoint.tables       = history.memory();
    checkpoint.fields       = fields.memory();
    checkpoint.log          = log.memory();
  }

  template <int dim>
  void
  Simulation<dim>::end_early()
  {
    Outcome outcome;
    outcome.verdict              = "interrupted";
    outcome.code                 = static_cast<ExitCode>(interruption::exit_code());
    outcome.path                 = path->last_cut().result;
    outcome.path.t               = last_state.t;
    const auto [stage, fraction] = stage_of(last_state.t, model.stage_names.size());
    outcome.message = fmt::format("Interrupted at {:.9g} of stage '{}' (t = {:.12g}, {} events{}).",
                                  fraction,
                                  model.stage_names[stage],
                                  last_state.t,
                                  n_events,
                                  searching ? ", in the search for a factor of safety" : "");
    publish(true);
    write_checkpoint();
    write_summary(outcome);
    throw Interrupted(outcome.message);
  }

  template <int dim>
  ExitCode
  Simulation<dim>::resume(const Checkpoint &checkpoint)
  {
    log_header();
    continue_output(checkpoint);
    const auto [stage, fraction] = stage_of(last_state.t, model.stage_names.size());
    log.line(fmt::format("Restarted at {:.9g} of stage '{}' (t = {:.12g})",
                         fraction,
                         model.stage_names[stage],
                         last_state.t));
    return follow([&]() {
      return motion ? resume_motion(checkpoint)
                    : path->resume(checkpoint.cut, model.loads.levels, *this);
    });
  }

  // At every moment the directory holds what the checkpoint refers to, which remains valid until
  // the next one takes its place.
  template <int dim>
  void
  Simulation<dim>::continue_output(const Checkpoint &checkpoint)
  {
    mesh_identity                   = checkpoint.mesh;
    static_cast<RunRecord &>(*this) = checkpoint.record;
    judge.restore(checkpoint.judge);
    history.restore(checkpoint.tables);
    log.restore(checkpoint.log);

    Outcome unfinished;
    unfinished.verdict = "unfinished";
    unfinished.path    = checkpoint.cut.result;
    write_summary(unfinished);
    fields.restore(checkpoint.fields);
    std::set<std::string> kept = {
      "summary.json", "boundaries.csv", "log.txt", checkpoint_file_name};
    for (const auto &[name, memory] : checkpoint.tables.files)
      kept.insert(name);
    for_each_field(checkpoint.fields, [&kept](const std::string &name, const auto &collection) {
      for (const auto &[t, file] : collection)
        kept.insert({name + ".pvd", file, paraview_script_name});
    });
    remove_earlier_results(parameters.output.directory, kept);
    publish(true);
    model.timer.finish("tables");
  }

  template class Simulation<2>;
  template class Simulation<3>;
} // namespace fuga
