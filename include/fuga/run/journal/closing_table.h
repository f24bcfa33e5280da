// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_journal_closing_table_h
#define fuga_run_journal_closing_table_h

#include <fuga/run/journal/run_journal.h>
#include <fuga/run/journal/run_outcome.h>

namespace fuga
{
  /**
   * Log the warnings that follow only from the whole run: decisions between continuations, jumps,
   * paths not followed beyond a limit load, joints beyond the range of their model.
   */
  template <int dim>
  void
  log_closing_warnings(RunJournal<dim> &journal, const RunOutcome &outcome);

  /** Log the closing table: verdict with its proof, events, resultants, certificate. */
  template <int dim>
  void
  log_closing_table(RunJournal<dim> &journal, const RunOutcome &outcome);
} // namespace fuga

#endif
