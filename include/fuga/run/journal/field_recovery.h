// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_journal_field_recovery_h
#define fuga_run_journal_field_recovery_h

#include <fuga/run/model/phase_run.h>

namespace fuga
{
  /**
   * Return the displacement of all degrees of freedom in @p state [m]: the only place where bodies
   * at rest are solved for. The residual of their equations is stored in @p certificate.
   */
  template <int dim>
  dealii::Vector<double>
  recover_displacement(const PhaseRun<dim> &phase,
                       const JointState &state,
                       Certificate &certificate);
} // namespace fuga

#endif
