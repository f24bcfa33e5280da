// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_journal_run_summary_h
#define fuga_run_journal_run_summary_h

#include <fuga/run/journal/run_journal.h>
#include <fuga/run/journal/run_outcome.h>

namespace fuga
{
  /** Write summary.json. */
  template <int dim>
  void
  write_summary(const RunJournal<dim> &journal, const RunOutcome &outcome);

  /** Write summary.json of a run that is still going on and whose path is known up to @p path. */
  template <int dim>
  void
  write_unfinished_summary(const RunJournal<dim> &journal, const PathResult &path = {});
} // namespace fuga

#endif
