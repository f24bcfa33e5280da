// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/run/simulation/phases.h>

namespace fuga
{
  template <int dim>
  ExitCode
  run_all_phases(std::unique_ptr<const Model<dim>> model,
                 const Checkpoint *checkpoint,
                 const std::function<void()> &on_checkpoint)
  {
    auto simulation = std::make_unique<Simulation<dim>>(*model);
    simulation->on_checkpoint(on_checkpoint);
    ExitCode code = checkpoint ? simulation->resume(*checkpoint) : simulation->run();
    while (simulation->is_between_phases())
      {
        const PhaseEnd end = simulation->leave_phase();
        simulation.reset();
        const std::shared_ptr<const Parameters> parameters = model->shared_parameters;
        std::shared_ptr<CondensedSystem<dim>> bodies;
        if (!end.next.begins_stage() || keeps_structure(parameters->model, end.next.stage))
          bodies = model->shared_bodies;
        model.reset(); // two factorisations at once would take twice the memory
        model      = std::make_unique<const Model<dim>>(*parameters, end, std::move(bodies));
        simulation = std::make_unique<Simulation<dim>>(*model);
        simulation->on_checkpoint(on_checkpoint);
        code = simulation->enter_phase(end);
      }
    return code;
  }

  template ExitCode
  run_all_phases(std::unique_ptr<const Model<2>>,
                 const Checkpoint *,
                 const std::function<void()> &);
  template ExitCode
  run_all_phases(std::unique_ptr<const Model<3>>,
                 const Checkpoint *,
                 const std::function<void()> &);
} // namespace fuga
