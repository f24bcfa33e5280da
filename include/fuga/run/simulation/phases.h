// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_simulation_phases_h
#define fuga_run_simulation_phases_h

#include <fuga/run/simulation/simulation.h>

namespace fuga
{
  /**
   * Do a run, or the rest of it after @p checkpoint (null: none), phase of construction by phase of
   * construction; mostly there is one. @p on_checkpoint is called after every checkpoint.
   * @throws InputError, NumericalFailure
   */
  template <int dim>
  ExitCode
  run_all_phases(std::unique_ptr<const Model<dim>> model,
                 const Checkpoint *checkpoint               = nullptr,
                 const std::function<void()> &on_checkpoint = {});
} // namespace fuga

#endif
