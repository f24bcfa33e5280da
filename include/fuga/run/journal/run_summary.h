// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_journal_run_summary_h
#define fuga_run_journal_run_summary_h

#include <fuga/run/journal/run_journal.h>
#include <fuga/run/journal/run_outcome.h>

namespace fuga
{
  /** Writes summary.json. */
  template <int dim>
  void
  write_summary(const RunJournal<dim> &journal, const RunOutcome &outcome);

  /** The same of a run that goes on, of which @p path is known. */
  template <int dim>
  void
  write_unfinished_summary(const RunJournal<dim> &journal, const PathResult &path = {});
} // namespace fuga

#endif
