// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_journal_log_header_h
#define fuga_run_journal_log_header_h

#include <fuga/run/journal/run_journal.h>

namespace fuga
{
  /** Log what is computed: version, sizes, joints with their layers, bodies and loads. */
  template <int dim>
  void
  log_header(RunJournal<dim> &journal);

  /** Log the totals of the bodies and the loads of this phase, and warnings about doubtful ones. */
  template <int dim>
  void
  log_model(RunJournal<dim> &journal);
} // namespace fuga

#endif
