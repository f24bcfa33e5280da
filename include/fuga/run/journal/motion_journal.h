// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_journal_motion_journal_h
#define fuga_run_journal_motion_journal_h

#include <fuga/output/results/monitored_motion.h>
#include <fuga/run/journal/run_journal.h>

#include <optional>

namespace fuga
{
  /** Writes the output of a dynamic stage, time step by time step. */
  template <int dim>
  class MotionJournal
  {
  public:
    /** @p journal must outlive this object. */
    explicit MotionJournal(RunJournal<dim> &journal);

    /** Begin the output when the bodies begin to move. */
    void
    begin();

    /**
     * Continue the output of a motion after a restart from a checkpoint that contains @p samples of
     * the monitors.
     */
    void
    resume(const MotionSamples &samples);

    /**
     * Write energies, monitors, and fields if they are due, after a time step that ended in
     * @p state.
     */
    void
    end_step(const JointState &state);

    /** End the output when the motion has ended. */
    void
    end();

    /**
     * Write a row of events.csv: @p change of the jumps of all bars [m], with @p work on the
     * joints.
     */
    void
    note(const double t,
         const std::array<std::string_view, 2> &names,
         const Vector &change,
         const double work);

    /** Write such a row for a jump from the last state @p to another one. */
    void
    note_jump(const JointState &to, const double work);

    /** Return the samples of the monitors; empty if no response spectra are requested. */
    MotionSamples
    samples() const;

  private:
    void
    watch_monitors();
    void
    note_accelerations();
    /** Write the fields of the bodies in motion unless they have been written. */
    void
    write_frame();

    RunJournal<dim> &journal;
    PhaseRun<dim> &phase;
    /** Present only if response spectra of a dynamic stage are requested. */
    std::optional<MonitoredMotion> monitored_motion;
  };
} // namespace fuga

#endif
