// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/interruption.h>
#include <fuga/bodies/processes.h>
#include <fuga/contact/judge/limit_proof.h>
#include <fuga/contact/segments/scheme_equilibrium.h>
#include <fuga/run/journal/closing_table.h>
#include <fuga/run/journal/log_header.h>
#include <fuga/run/journal/run_summary.h>
#include <fuga/run/journal/verdict_text.h>
#include <fuga/run/model/phase_begin.h>
#include <fuga/run/simulation/data_doubts.h>
#include <fuga/run/simulation/simulation.h>

#include <fmt/format.h>

namespace fuga
{
  template <int dim>
  Simulation<dim>::Simulation(const Model<dim> &shared_model, AccuracyReport of_mesh)
    : model(shared_model)
    , parameters(model.parameters)
    , phase(model, parameters)
    , journal(phase, std::move(of_mesh))
    , motion_journal(journal)
    , checkpoints(journal, motion_journal)
    , continuation(journal, motion_journal)
  {
    model.timer.finish("layered system");
  }

  template <int dim>
  Simulation<dim>::~Simulation() = default;

  template <int dim>
  ExitCode
  Simulation<dim>::run()
  {
    journal.begin();
    checkpoints.begin();
    log_header(journal);
    from_the_beginning = true;
    return follow([this]() { return phase.path->run(model.loads.levels, *this); });
  }

  template <int dim>
  ExitCode
  Simulation<dim>::resume(const Checkpoint &checkpoint)
  {
    log_header(journal);
    checkpoints.restore(checkpoint);
    journal.log.line("Restarted at " + place_text(journal.record.last_state.t, model.stage_names));
    return follow([&]() {
      return phase.motion ? resume_motion(checkpoint)
                          : phase.path->resume(checkpoint.cut, model.loads.levels, *this);
    });
  }

  template <int dim>
  PhaseEnd
  Simulation<dim>::leave_phase()
  {
    PhaseEnd end = phase.leave(
      journal.record.last_state, *end_of_phase, journal.record.levels_written, goes_on_in_motion);
    checkpoints.fill(end.checkpoint);
    model.timer.finish("change of construction");
    end.timer = model.timer;
    return end;
  }

  template <int dim>
  ExitCode
  Simulation<dim>::enter_phase(const PhaseEnd &before)
  {
    const Checkpoint checkpoint = phase.enter(before);
    checkpoints.restore(checkpoint);
    if (model.construction.begins_stage())
      {
        journal.log.line(
          change_of_construction(parameters.model, model.bodies, model.construction.stage));
        for (const std::string &line : phase.joint.report)
          journal.log.line(line);
        log_model(journal);
      }
    else if (!phase.motion)
      journal.write_state(journal.record.last_state,
                          parameters.output.fields != FieldOutput::never);
    return follow([&]() { return phase.path->go_on(checkpoint.cut, model.loads.levels, *this); });
  }

  template <int dim>
  ExitCode
  Simulation<dim>::follow(const std::function<PathResult()> &path_to_follow)
  {
    RunOutcome outcome;
    try
      {
        if (!conclude(path_to_follow(), outcome))
          return ExitCode::done;
      }
    catch (const LawExhausted &failure)
      {
        conclude(failure, failure.state, outcome);
      }
    catch (const NumericalFailure &failure)
      {
        conclude(failure, journal.record.last_state, outcome);
      }
    catch (const Interrupted &)
      {
        end_early();
      }
    catch (const processes::Separated &)
      {
        if (interruption::signal_number() == 0)
          throw;
        end_early(); // the others noticed the signal before this process did
      }
    finish(outcome);
    return outcome.code;
  }

  template <int dim>
  bool
  Simulation<dim>::conclude(PathResult found, RunOutcome &outcome)
  {
    const bool was_in_motion = model.construction.until_rest;
    motion_journal.end();
    if (was_in_motion)
      outcome.proof.mechanism = continuation.end(found);
    else if (found.verdict != Verdict::done && found.beyond.end == BeyondLimit::End::none)
      journal.write_last_state();
    goes_on_in_motion = model.goes_on_in_motion(found) || continuation.still_move(found);
    if (goes_on_in_motion || (found.verdict == Verdict::done && !model.is_last_phase()))
      {
        if (goes_on_in_motion)
          continuation.begin(found);
        end_of_phase = found;
        return false;
      }
    if (!was_in_motion)
      outcome.proof = prove_limit(
        phase.judge, phase.joint.elements, phase.layered, journal.record.last_state, found);
    outcome.path    = found;
    outcome.verdict = verdict_name(found.verdict);
    outcome.code = found.verdict == Verdict::done ? ExitCode::done : ExitCode::loss_of_equilibrium;
    outcome.safety = find_safety(found);
    if (!(journal.record.worst.worst() <= parameters.solver.certificate_bound))
      {
        outcome.code    = ExitCode::certificate_violated;
        outcome.message = doubt();
      }
    return true;
  }

  template <int dim>
  void
  Simulation<dim>::conclude(const NumericalFailure &why, const JointState &at, RunOutcome &outcome)
  {
    outcome.verdict = "numerical failure";
    outcome.code    = ExitCode::numerical_failure;
    outcome.message = limit_of_law(phase, at);
    if (outcome.message.empty())
      {
        const std::string of_data = doubt();
        outcome.message           = of_data.empty() ? why.what() : of_data + ". " + why.what();
      }
    outcome.path.t = journal.record.last_state.t;
  }

  // Every search begins with the state at the end of the loads, even where another search came
  // before it.
  template <int dim>
  std::vector<SafetyFactor>
  Simulation<dim>::find_safety(const PathResult &loaded)
  {
    if (!phase.safety_search.is_wanted())
      return {};
    if (loaded.verdict != Verdict::done)
      return phase.safety_search.announced();
    JointState &last             = journal.record.last_state;
    const JointState end_of_load = last;
    checkpoints.is_suspended     = true;
    const auto factors           = phase.safety_search.run(
      phase.path->last_cut(),
      phase.judge,
      *this,
      [&last](const JointState &start) { last = start; },
      [this]() { journal.write_last_state(); });
    checkpoints.is_suspended = false;
    last                     = end_of_load;
    return factors;
  }

  template <int dim>
  std::string
  Simulation<dim>::doubt()
  {
    return from_the_beginning ? doubt_about_data(phase, journal.record.worst, journal.log)
                              : std::string();
  }

  // The results of a finished motion for the monitors are in the tables.
  template <int dim>
  PathResult
  Simulation<dim>::resume_motion(const Checkpoint &checkpoint)
  {
    if (!checkpoint.finished)
      motion_journal.resume(checkpoint.samples);
    return phase.dynamic_path().resume_motion(
      checkpoint.cut, checkpoint.motion, model.loads.levels, *this);
  }

  template <int dim>
  void
  Simulation<dim>::finish(const RunOutcome &outcome)
  {
    model.timer.finish("path");
    log_closing_warnings(journal, outcome);
    log_closing_table(journal, outcome);
    journal.log.close();
    journal.publish(true);
    write_summary(journal, outcome);
    checkpoints.write(outcome);
  }

  template <int dim>
  void
  Simulation<dim>::end_early()
  {
    RunOutcome outcome;
    outcome.verdict = "interrupted";
    outcome.code    = static_cast<ExitCode>(interruption::exit_code());
    outcome.path    = phase.path->last_cut().result;
    outcome.path.t  = journal.record.last_state.t;
    outcome.message =
      "Interrupted at " +
      place_text(
        outcome.path.t,
        model.stage_names,
        fmt::format(", {} events{}",
                    journal.record.n_events,
                    checkpoints.is_suspended ? ", in the search for a factor of safety" : "")) +
      ".";
    journal.publish(true);
    checkpoints.write();
    write_summary(journal, outcome);
    throw Interrupted(outcome.message);
  }

  template <int dim>
  bool
  Simulation<dim>::wants_cuts() const
  {
    return checkpoints.is_wanted() || phase.safety_search.is_wanted();
  }

  template <int dim>
  void
  Simulation<dim>::advanced(const PathPoint &from, const PathPoint &to, const double length)
  {
    phase.judge.follow(from, to, length);
    journal.advance_to(to.state);
    journal.log.progress(to.state.t, static_cast<double>(model.stage_names.size()));
  }

  template <int dim>
  void
  Simulation<dim>::jumped(const JointState &to)
  {
    phase.judge.lose_track();
    journal.advance_to(to);
  }

  template <int dim>
  void
  Simulation<dim>::jumped_in_motion(const JointState &to, const double work)
  {
    motion_journal.note_jump(to, work);
    jumped(to);
  }

  template <int dim>
  void
  Simulation<dim>::changed(const std::vector<ContactEvent> &events, const JointState &state)
  {
    journal.add_events(events, state);
    if (!phase.motion)
      checkpoints.write_at_event();
  }

  template <int dim>
  void
  Simulation<dim>::reached(const std::size_t index, const JointState &state)
  {
    const bool last    = model.is_last_phase() && state.t >= model.loads.end_of_loading;
    const bool written = parameters.output.fields == FieldOutput::levels ||
                         (parameters.output.fields == FieldOutput::end && last);
    journal.write_state(state, written);
    journal.record.levels_written = index + 1;
    if (phase.motion)
      level_is_due = true;
    else
      checkpoints.write();
  }

  template <int dim>
  void
  Simulation<dim>::went_beyond(const double length, const JointState &state)
  {
    if (length == 0.)
      {
        journal.record.last_state = state;
        journal.write_last_state();
        return;
      }
    journal.history.set_path_length(length);
    journal.write_state(state, parameters.output.fields == FieldOutput::levels);
  }

  template <int dim>
  void
  Simulation<dim>::began_motion()
  {
    motion_journal.begin();
  }

  template <int dim>
  void
  Simulation<dim>::began_step(const ContactSystem &system, const LoadHistory &history_of_step)
  {
    phase.began_step(system, history_of_step);
  }

  template <int dim>
  void
  Simulation<dim>::ended_step(const JointState &state)
  {
    motion_journal.end_step(state);
    if (std::exchange(level_is_due, false))
      checkpoints.write();
    else
      checkpoints.write_at_event();
  }

  template class Simulation<2>;
  template class Simulation<3>;
} // namespace fuga
