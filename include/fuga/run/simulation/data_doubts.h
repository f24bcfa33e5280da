// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_simulation_data_doubts_h
#define fuga_run_simulation_data_doubts_h

#include <fuga/output/tables/run_log.h>
#include <fuga/run/model/phase_run.h>

namespace fuga
{
  /**
   * What shows that the data are too ill-conditioned for the bound of the certificate, or for the
   * end that the path came to: a small change of the loads moves the answer as far. @p worst: of a
   * path that began with the first load of the model. Empty if nothing shows it, or if it was not
   * asked because it would cost more than the run did. That the question takes its time stands in
   * @p log.
   */
  template <int dim>
  std::string
  doubt_about_data(const PhaseRun<dim> &phase, const Certificate &worst, RunLog &log);

  /** Which layer has closed as far as its law reaches in @p state; empty if none has. */
  template <int dim>
  std::string
  limit_of_law(const PhaseRun<dim> &phase, const JointState &state);
} // namespace fuga

#endif
