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
   * Keeps checkpoint.cbor of a run up to date and restores a run from it. At every moment the
   * directory holds the files to which the checkpoint refers; it remains valid until the next one
   * takes its place.
   */
  template <int dim>
  class CheckpointKeeper
  {
  public:
    /** The journals must outlive this object. */
    CheckpointKeeper(RunJournal<dim> &journal, const MotionJournal<dim> &motion);

    /** Return whether the run keeps checkpoints at all. */
    bool
    is_wanted() const;

    /** Begin the output of a run: identify its mesh, with which a restart compares its own. */
    void
    begin();

    /** Write a checkpoint of the last cut of the path if one is due. */
    void
    write_at_event();

    /** Write a checkpoint of the last cut of the path. @throws WriteFailure */
    void
    write();

    /**
     * Write a checkpoint of a run that has ended. A numerical failure is not an end: it occurs
     * again after a restart.
     */
    void
    write(const RunOutcome &outcome);

    /**
     * Restore records and output from @p checkpoint and remove results to which it does not refer.
     */
    void
    restore(const Checkpoint &checkpoint);

    /** Store everything that a checkpoint keeps, except for the cut. */
    void
    fill(Checkpoint &checkpoint) const;

    /**
     * Nothing is written while this is true: a search for safety is under way, but checkpoints are
     * those of the path.
     */
    bool is_suspended = false;

    /** Called after every checkpoint. If it throws, the run ends there. */
    std::function<void()> action;

  private:
    void
    write(Checkpoint &&checkpoint);

    RunJournal<dim> &journal;
    const MotionJournal<dim> &motion_journal;
    FileIdentity mesh_identity;
    std::chrono::steady_clock::time_point last_time;
    /** Time that the last checkpoint took [s]. */
    double cost = 0.;
  };
} // namespace fuga

#endif
