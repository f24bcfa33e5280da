// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_simulation_motion_continuation_h
#define fuga_run_simulation_motion_continuation_h

#include <fuga/run/journal/motion_journal.h>

namespace fuga
{
  /**
   * Continues a slow path that has lost its equilibrium, or has none to begin with, as a motion of
   * the bodies until they rest: Solver/Beyond limit load = dynamic.
   */
  template <int dim>
  class MotionContinuation
  {
  public:
    /** The journals must outlive this object. */
    MotionContinuation(RunJournal<dim> &journal, MotionJournal<dim> &motion);

    /**
     * Return whether the bodies still move after a dynamic stage that ended with @p result and have
     * to come to rest before the slow stage that follows it.
     */
    bool
    still_move(const PathResult &result) const;

    /**
     * Begin the motion: either the slow path has lost its equilibrium with the result @p loss,
     * which is proven if possible, or the bodies still move.
     */
    void
    begin(PathResult &loss);

    /**
     * End the motion: either the bodies are at rest, or @p result becomes the verdict of the
     * preceding slow path, whose proof is returned.
     */
    MechanismCertificate
    end(PathResult &result);

  private:
    RunJournal<dim> &journal;
    MotionJournal<dim> &motion_journal;
    PhaseRun<dim> &phase;
  };
} // namespace fuga

#endif
