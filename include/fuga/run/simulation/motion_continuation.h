// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_simulation_motion_continuation_h
#define fuga_run_simulation_motion_continuation_h

#include <fuga/run/journal/motion_journal.h>

namespace fuga
{
  /**
   * How a slow path that has lost its equilibrium, or has none to begin with, goes on as a motion
   * of the bodies until they rest: Solver/Beyond limit load = dynamic.
   */
  template <int dim>
  class MotionContinuation
  {
  public:
    /** Journals must outlive this object. */
    MotionContinuation(RunJournal<dim> &journal, MotionJournal<dim> &motion);

    /** Whether the bodies still move behind a dynamic stage that ended with @p result, and are to
     * come to rest before the slow one behind it. */
    bool
    still_move(const PathResult &result) const;

    /** The slow path has lost its equilibrium, @p loss, which is proven if it can be, or the bodies
     * still move. */
    void
    begin(PathResult &loss);

    /** The motion has ended: either at rest, or @p result becomes the verdict of the slow path that
     * it followed, whose proof is returned. */
    MechanismCertificate
    end(PathResult &result);

  private:
    RunJournal<dim> &journal;
    MotionJournal<dim> &motion_journal;
    PhaseRun<dim> &phase;
  };
} // namespace fuga

#endif
