// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/work_counter.h>
#include <fuga/output/warnings/motion_warnings.h>
#include <fuga/run/simulation/simulation.h>

#include <deal.II/lac/vector.h>

#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  template <int dim>
  void
  Simulation<dim>::began_motion()
  {
    n_intervals = 0.;
    if (!parameters.output.spectra.wanted || model.construction.until_rest)
      return;
    monitored_motion.emplace(model.monitors, motion->time_grid().step, motion->mass());
    note_accelerations();
  }

  // What a finished motion has to say of the monitors stands in the tables.
  template <int dim>
  PathResult
  Simulation<dim>::resume_motion(const Checkpoint &checkpoint)
  {
    if (parameters.output.spectra.wanted && !checkpoint.finished)
      {
        monitored_motion.emplace(model.monitors, motion->time_grid().step, motion->mass());
        monitored_motion->restore(checkpoint.samples);
      }
    return phase.dynamic_path().resume_motion(
      checkpoint.cut, checkpoint.motion, model.loads.levels, *this);
  }

  template <int dim>
  void
  Simulation<dim>::note_accelerations()
  {
    monitored_motion->add(
      motion->displacement(), motion->acceleration(), motion->acceleration_of_frame());
  }

  template <int dim>
  void
  Simulation<dim>::write_frame()
  {
    if (fields.has_written(last_state.t))
      return;
    const work::Scope scope(work::Phase::results);
    write_fields(last_state,
                 phase.results(last_state),
                 model.bodies.by_degrees_of_freedom(phase.displacement_in_motion()));
  }

  template <int dim>
  void
  Simulation<dim>::end_motion()
  {
    if (motion && parameters.output.field_interval > 0.)
      write_frame();
    if (!monitored_motion)
      return;
    history.add_accelerations(model.construction.stage, monitored_motion->accelerations());
    publish(false);
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
    last_state      = state;
    motion_energies = phase.dynamic_path().energies();
    motion_steps    = phase.dynamic_path().n_steps();
    history.add_motion(state.t,
                       {motion->time(), motion->ground_acceleration(), motion_energies},
                       model.resultants(phase.results(state), judge.dissipation()));
    if (!model.monitors.empty())
      write_monitors(state.t, "step", phase.monitored(state), model.loads.history.factors(state.t));
    if (monitored_motion && phase.dynamic_path().is_at_whole_step())
      note_accelerations();
    phase.ended_step(state);
    // Times are sums of steps.
    constexpr double rounding = 1e-9;
    if (const double interval = parameters.output.field_interval; interval > 0.)
      if (const double n = std::floor((1. + rounding) * motion->time() / interval); n > n_intervals)
        {
          n_intervals = n;
          write_frame();
        }
    publish(false);
    if (std::exchange(level_is_due, false))
      write_checkpoint();
    else
      checkpoint_at_event();
  }

  template <int dim>
  void
  Simulation<dim>::jumped_in_motion(const JointState &to, const double work)
  {
    Vector change = layered.jumps(to.dislocations, to.forces);
    add_multiple(-1., layered.jumps(last_state.dislocations, last_state.forces), change);
    note_motion(to.t, {{"motion", "jump"}}, change, work);
    jumped(to);
  }

  template <int dim>
  void
  Simulation<dim>::note_motion(const double t,
                               const std::array<std::string_view, 2> &names,
                               const Vector &change,
                               const double energy)
  {
    if (joint.elements.empty())
      return;
    std::size_t farthest = 0;
    double largest       = 0.;
    for (std::size_t k = 0; k < joint.elements.size(); ++k)
      for (std::size_t i = 0; i < joint.elements[k].n_bars(); ++i)
        if (const double size = std::abs(change[joint.elements[k].bar(i)]); size > largest)
          {
            largest  = size;
            farthest = k;
          }
    history.add_event({t, farthest, names, energy});
    ++events_by_kind[fmt::format("{} -> {}", names[0], names[1])];
    ++n_events;
  }

  template <int dim>
  void
  Simulation<dim>::log_motion()
  {
    if (motion_steps.empty())
      return;
    std::size_t n_halved = 0;
    for (std::size_t i = 1; i < motion_steps.size(); ++i)
      n_halved += motion_steps[i];
    const MotionLedger &e   = motion_energies;
    const std::string &unit = parameters.output.units.energy();
    log.line(
      fmt::format("Motion      {} steps and {} shorter ones; work {:.6g} {}: kinetic {:.6g}, "
                  "bodies {:.6g}, damping {:.6g}, joints {:.6g}, integration in time {:.3g} "
                  "({:.1e} of the largest){}; not accounted for {:.1e} of the largest",
                  motion_steps[0],
                  n_halved,
                  e.work,
                  unit,
                  e.kinetic,
                  e.bodies,
                  e.damping,
                  e.joints,
                  e.numerical,
                  e.share(e.numerical),
                  e.share(e.sudden) > 0. ? fmt::format(", sudden {:.3g}", e.sudden) : "",
                  e.share(e.defect())));
    for (const std::string &warning : motion_warnings(e, motion_steps))
      log.warning(warning);
  }

  template class Simulation<2>;
  template class Simulation<3>;
} // namespace fuga
