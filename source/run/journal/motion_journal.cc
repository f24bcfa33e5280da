// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/work_counter.h>
#include <fuga/run/journal/motion_journal.h>

#include <deal.II/lac/vector.h>

#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  template <int dim>
  MotionJournal<dim>::MotionJournal(RunJournal<dim> &of_run) : journal(of_run), phase(journal.phase)
  {
  }

  template <int dim>
  void
  MotionJournal<dim>::begin()
  {
    journal.record.n_intervals = 0.;
    if (const std::string line = phase.motion->description(); !line.empty())
      journal.log.line("Modes       " + line);
    if (!phase.parameters.output.spectra.wanted || phase.model.construction.until_rest)
      return;
    watch_monitors();
    note_accelerations();
  }

  template <int dim>
  void
  MotionJournal<dim>::resume(const MotionSamples &samples)
  {
    if (!phase.parameters.output.spectra.wanted)
      return;
    watch_monitors();
    monitored_motion->restore(samples);
  }

  template <int dim>
  void
  MotionJournal<dim>::end_step(const JointState &state)
  {
    const BodiesInMotion<dim> &motion = *phase.motion;
    RunRecord &record                 = journal.record;
    record.last_state                 = state;
    record.motion_energies            = phase.dynamic_path().energies();
    record.motion_steps               = phase.dynamic_path().n_steps();
    journal.history.add_motion(
      state.t,
      {motion.time(), motion.ground_acceleration(), record.motion_energies},
      phase.model.resultants(phase.results(state), phase.judge.dissipation()));
    journal.write_monitors(state, "step");
    if (monitored_motion && phase.dynamic_path().is_at_whole_step())
      note_accelerations();
    phase.ended_step(state);
    // Times are sums of steps.
    constexpr double rounding = 1e-9;
    if (const double interval = phase.parameters.output.field_interval; interval > 0.)
      if (const double n = std::floor((1. + rounding) * motion.time() / interval);
          n > record.n_intervals)
        {
          record.n_intervals = n;
          write_frame();
        }
    journal.publish(false);
  }

  template <int dim>
  void
  MotionJournal<dim>::end()
  {
    if (phase.motion && phase.parameters.output.field_interval > 0.)
      write_frame();
    if (!monitored_motion)
      return;
    journal.history.add_accelerations(phase.model.construction.stage,
                                      monitored_motion->accelerations());
    journal.publish(false);
  }

  template <int dim>
  void
  MotionJournal<dim>::note(const double t,
                           const std::array<std::string_view, 2> &names,
                           const Vector &change,
                           const double work)
  {
    const std::vector<ContactElement> &elements = phase.joint.elements;
    if (elements.empty())
      return;
    std::size_t farthest = 0;
    double largest       = 0.;
    for (std::size_t k = 0; k < elements.size(); ++k)
      for (std::size_t i = 0; i < elements[k].n_bars(); ++i)
        if (const double size = std::abs(change[elements[k].bar(i)]); size > largest)
          {
            largest  = size;
            farthest = k;
          }
    journal.history.add_event({t, farthest, names, work});
    ++journal.record.events_by_kind[fmt::format("{} -> {}", names[0], names[1])];
    ++journal.record.n_events;
  }

  template <int dim>
  void
  MotionJournal<dim>::note_jump(const JointState &to, const double work)
  {
    const JointState &last = journal.record.last_state;
    Vector change          = phase.layered.jumps(to.dislocations, to.forces);
    add_multiple(-1., phase.layered.jumps(last.dislocations, last.forces), change);
    note(to.t, {{"motion", "jump"}}, change, work);
  }

  template <int dim>
  MotionSamples
  MotionJournal<dim>::samples() const
  {
    return monitored_motion ? monitored_motion->memory() : MotionSamples();
  }

  template <int dim>
  void
  MotionJournal<dim>::watch_monitors()
  {
    monitored_motion.emplace(
      phase.model.monitors, phase.motion->time_grid().step, phase.motion->accelerated_mass());
  }

  template <int dim>
  void
  MotionJournal<dim>::note_accelerations()
  {
    const BodiesInMotion<dim> &motion = *phase.motion;
    monitored_motion->add(
      motion.watched_displacement(), motion.watched_acceleration(), motion.acceleration_of_frame());
  }

  template <int dim>
  void
  MotionJournal<dim>::write_frame()
  {
    const JointState &last = journal.record.last_state;
    if (journal.fields.has_written(last.t))
      return;
    const work::Scope scope(work::Phase::results);
    journal.write_fields(last,
                         phase.results(last),
                         phase.model.bodies.by_degrees_of_freedom(phase.displacement_in_motion()));
  }

  template class MotionJournal<2>;
  template class MotionJournal<3>;
} // namespace fuga
