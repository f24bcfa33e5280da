// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_simulation_data_doubts_h
#define fuga_run_simulation_data_doubts_h

#include <fuga/output/tables/run_log.h>
#include <fuga/run/model/phase_run.h>

namespace fuga
{
  /**
   * Return evidence that the data are too ill-conditioned for the bound of the certificate, or for
   * the end that the path came to: a small change of the loads changes the answer by as much.
   * @p worst is the worst certificate of a path that began with the first load of the model. The
   * result is empty if there is no evidence, or if the check was skipped because it would cost more
   * than the run did. A note in @p log says that the check takes time.
   */
  template <int dim>
  std::string
  doubt_about_data(const PhaseRun<dim> &phase, const Certificate &worst, RunLog &log);

  /**
   * Describe the layer that has closed up to the limit of its law in @p state; empty if there is
   * none.
   */
  template <int dim>
  std::string
  limit_of_law(const PhaseRun<dim> &phase, const JointState &state);
} // namespace fuga

#endif
