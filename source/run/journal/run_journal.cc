// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/work_counter.h>
#include <fuga/output/tables/boundary_table.h>
#include <fuga/run/journal/field_recovery.h>
#include <fuga/run/journal/run_journal.h>
#include <fuga/run/journal/run_summary.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    template <int dim>
    HistoryContext
    context_of(const PhaseRun<dim> &phase)
    {
      const Model<dim> &model = phase.model;
      return {phase.joint.elements,
              model.joint_names,
              model.joints_there,
              model.stage_names,
              model.monitors,
              phase.parameters.output.units,
              model.bodies.closed_water().size() > 0,
              dim == 3,
              may_move(phase.parameters),
              phase.parameters.output.spectra,
              DrivingQuantities(phase.parameters.model, model.loads.load_factors)};
    }
  } // namespace

  template <int dim>
  RunJournal<dim>::RunJournal(PhaseRun<dim> &of_run, AccuracyReport of_mesh)
    : phase(of_run)
    , accuracy(std::move(of_mesh))
    , context(context_of(phase))
    , log(phase.parameters.output.log, context, phase.parameters.output.directory + "/log.txt")
    , history(phase.parameters.output.directory, context)
    , fields(phase.parameters.output.directory,
             phase.model.bodies,
             phase.parameters.model,
             phase.model.mesh.body_names)
    , model_range(phase.joint.elements, phase.model.joint_names.size(), record.excesses)
  {
  }

  template <int dim>
  void
  RunJournal<dim>::begin()
  {
    const OutputSettings &output = phase.parameters.output;
    begin_results(output.directory, [this]() { write_unfinished_summary(*this); });
    write_boundary_table(output.directory, phase.model.mesh, output.units);
    if (!accuracy.rounds.empty())
      write_refinement_table(output.directory, accuracy);
    publish(true);
    phase.model.timer.finish("tables");
  }

  template <int dim>
  void
  RunJournal<dim>::advance_to(const JointState &state)
  {
    model_range.watch(state);
    record.last_state = state;
  }

  template <int dim>
  void
  RunJournal<dim>::add_events(const std::vector<ContactEvent> &events, const JointState &state)
  {
    record.last_state             = state;
    const Certificate certificate = phase.judge.judge(state);
    record.worst.absorb(certificate);
    for (const ContactEvent &event : events)
      ++record.events_by_kind[fmt::format("{} -> {}", event.names()[0], event.names()[1])];
    record.n_events += events.size();
    history.add_events(events, certificate.worst());
    if (phase.parameters.output.monitors == MonitorOutput::events && !phase.motion)
      write_monitors(state, "event");
    log.events(events, certificate.worst());
    publish(false);
  }

  template <int dim>
  void
  RunJournal<dim>::write_state(const JointState &state, const bool with_fields)
  {
    const work::Scope scope(work::Phase::results);
    phase.model.timer.finish("path");
    Certificate certificate = phase.judge.judge(state);
    const auto results      = phase.results(state);
    if (with_fields)
      write_fields(state, results, recover_displacement(phase, state, certificate));
    record.worst.absorb(certificate);
    history.add_level(state.t,
                      results,
                      phase.model.resultants(results, phase.judge.dissipation()),
                      phase.energies(),
                      certificate.worst());
    write_monitors(state, "level");
    log.level(state.t, results, certificate.worst());
    publish(false);
    phase.model.timer.finish("tables");
  }

  template <int dim>
  void
  RunJournal<dim>::write_last_state()
  {
    const JointState &last = record.last_state;
    if (last.states.empty())
      return;
    constexpr double rounding         = 1e-14;
    const std::vector<double> &levels = phase.model.loads.levels;
    const bool is_level =
      record.levels_written > 0 &&
      std::abs(levels[record.levels_written - 1] - last.t) <= rounding * std::max(1., last.t);
    if (!is_level)
      write_state(last, phase.parameters.output.fields != FieldOutput::never);
  }

  template <int dim>
  void
  RunJournal<dim>::write_fields(const JointState &state,
                                const std::vector<ElementResult> &results,
                                const dealii::Vector<double> &displacement)
  {
    const Model<dim> &model = phase.model;
    // Beyond a limit load the load time does not grow, but the times of an animation must.
    const double time = state.t + history.path_length();
    dealii::Vector<double> velocity;
    if (phase.motion && phase.parameters.output.field_interval > 0.)
      velocity = model.bodies.by_degrees_of_freedom(phase.motion->steady_velocity());
    fields.write_bodies(time,
                        displacement,
                        velocity,
                        model.loads.template temperature<dim>(
                          phase.parameters.model, model.mesh.body_names, state.t));
    fields.write_joints(time, phase.joint.elements, results, phase.judge.dissipation());
    model.timer.finish("fields");
  }

  template <int dim>
  void
  RunJournal<dim>::write_monitors(const JointState &state, const std::string &occasion)
  {
    const Model<dim> &model              = phase.model;
    const std::vector<Monitor> &monitors = model.monitors;
    if (monitors.empty())
      return;
    Vector thermal_strains(monitors.size(), 0.);
    if (std::any_of(monitors.begin(), monitors.end(), [](const Monitor &monitor) {
          return monitor.has_stress();
        }))
      {
        const TemperatureField<dim> temperature = model.loads.template temperature<dim>(
          phase.parameters.model, model.mesh.body_names, state.t);
        for (std::size_t i = 0; i < monitors.size(); ++i)
          thermal_strains[i] =
            temperature.strain(model.monitor_points[i].position(), monitors[i].body());
      }
    history.add_monitors(state.t,
                         occasion,
                         phase.monitored(state),
                         model.loads.history.factors(state.t),
                         thermal_strains);
  }

  template <int dim>
  void
  RunJournal<dim>::publish(const bool now)
  {
    history.publish(now);
    log.publish(now);
  }

  template class RunJournal<2>;
  template class RunJournal<3>;
} // namespace fuga
