// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/run/simulation/simulation.h>

namespace fuga
{
  template <int dim>
  PhaseEnd
  Simulation<dim>::leave_phase()
  {
    PhaseEnd end = phase.leave(last_state, *end_of_phase, levels_written, goes_on_in_motion);
    fill(end.checkpoint);
    model.timer.finish("change of construction");
    end.timer = model.timer;
    return end;
  }

  template <int dim>
  ExitCode
  Simulation<dim>::enter_phase(const PhaseEnd &before)
  {
    const Checkpoint checkpoint = phase.enter(before);
    continue_output(checkpoint);
    if (model.construction.begins_stage())
      {
        log.line(model.change_of_construction());
        for (const std::string &line : joint.report)
          log.line(line);
        log_model();
      }
    else if (!motion)
      write_state(last_state, parameters.output.fields != FieldOutput::never);
    return follow([&]() { return path->go_on(checkpoint.cut, model.loads.levels, *this); });
  }

  template class Simulation<2>;
  template class Simulation<3>;
} // namespace fuga
