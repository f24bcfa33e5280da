// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_journal_motion_journal_h
#define fuga_run_journal_motion_journal_h

#include <fuga/output/results/monitored_motion.h>
#include <fuga/run/journal/run_journal.h>

#include <optional>

namespace fuga
{
  /** What a run writes of a dynamic stage, step of time by step of time. */
  template <int dim>
  class MotionJournal
  {
  public:
    /** @p journal must outlive this object. */
    explicit MotionJournal(RunJournal<dim> &journal);

    /** The bodies begin to move. */
    void
    begin();

    /** They go on to move behind a checkpoint, which knows @p samples of the monitors. */
    void
    resume(const MotionSamples &samples);

    /** A step of time has ended in @p state: energies, monitors, and fields where they are due. */
    void
    end_step(const JointState &state);

    /** The motion has ended. */
    void
    end();

    /** A row of events.csv: @p change of the jumps of all bars [m], with @p work on the joints. */
    void
    note(const double t,
         const std::array<std::string_view, 2> &names,
         const Vector &change,
         const double work);

    /** The same of a jump from the last state @p to another one. */
    void
    note_jump(const JointState &to, const double work);

    /** What the monitors have felt; empty if nobody asked. */
    MotionSamples
    samples() const;

  private:
    void
    watch_monitors();
    void
    note_accelerations();
    /** The fields of bodies in motion, unless they are there. */
    void
    write_frame();

    RunJournal<dim> &journal;
    PhaseRun<dim> &phase;
    /** Only if response spectra of a dynamic stage are asked for. */
    std::optional<MonitoredMotion> monitored_motion;
  };
} // namespace fuga

#endif
