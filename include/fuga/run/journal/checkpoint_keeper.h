// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_journal_checkpoint_keeper_h
#define fuga_run_journal_checkpoint_keeper_h

#include <fuga/run/journal/motion_journal.h>
#include <fuga/run/journal/run_outcome.h>

#include <chrono>
#include <functional>

namespace fuga
{
  /**
   * Keeps checkpoint.cbor of a run up to date, and restores a run from it. At every moment the
   * directory holds what the checkpoint refers to, which remains valid until the next one takes its
   * place.
   */
  template <int dim>
  class CheckpointKeeper
  {
  public:
    /** Journals must outlive this object. */
    CheckpointKeeper(RunJournal<dim> &journal, const MotionJournal<dim> &motion);

    /** Whether the run keeps checkpoints at all. */
    bool
    is_wanted() const;

    /** The output of a run begins: its mesh is what a restart compares. */
    void
    begin();

    /** Writes one of the last cut of the path, if it is time to. */
    void
    write_at_event();

    /** Writes one of the last cut of the path. @throws NumericalFailure */
    void
    write();

    /** Writes one of a run that has ended. A numerical failure is no end: whoever restarts sees it
     * again. */
    void
    write(const RunOutcome &outcome);

    /** Takes notes and output over from @p checkpoint, and removes results that it does not refer
     * to. */
    void
    restore(const Checkpoint &checkpoint);

    /** All that a checkpoint keeps but the cut. */
    void
    fill(Checkpoint &checkpoint) const;

    /** Nothing is written while this is true: a search for safety is under way, and checkpoints
     * are those of the path. */
    bool is_suspended = false;

    /** Is called behind every checkpoint. If it throws, the run ends there. */
    std::function<void()> action;

  private:
    void
    write(Checkpoint &&checkpoint);

    RunJournal<dim> &journal;
    const MotionJournal<dim> &motion_journal;
    FileIdentity mesh_identity;
    std::chrono::steady_clock::time_point last_time;
    /** Seconds that the last one took. */
    double cost = 0.;
  };
} // namespace fuga

#endif
