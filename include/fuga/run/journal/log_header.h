// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_journal_log_header_h
#define fuga_run_journal_log_header_h

#include <fuga/run/journal/run_journal.h>

namespace fuga
{
  /** Says what is computed: version, sizes, joints with their layers, bodies and loads. */
  template <int dim>
  void
  log_header(RunJournal<dim> &journal);

  /** Says what the bodies and the loads of this phase add up to, and what seems to be wrong in
   * them. */
  template <int dim>
  void
  log_model(RunJournal<dim> &journal);
} // namespace fuga

#endif
