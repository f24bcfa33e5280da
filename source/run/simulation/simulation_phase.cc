// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/space/discretization.h>
#include <fuga/contact/element/joint_water.h>
#include <fuga/run/simulation/simulation.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/vector.h>

namespace fuga
{
  template <int dim>
  PhaseEnd
  Simulation<dim>::leave_phase()
  {
    for (const std::string &text :
         tables.warnings<dim>(model.joint_names, parameters.output.units.stress()))
      log.warning(text);

    PhaseEnd end;
    end.stage      = model.next_stage();
    end.mesh       = model.shared_mesh;
    end.elements   = joint.elements;
    end.identities = model.bodies.identities();
    end.shapes     = model.construction.shapes;

    const Vector jumps = layered.jumps(last_state.dislocations, last_state.forces);
    const dealii::Vector<double> u =
      motion ? model.bodies.by_degrees_of_freedom(displacement_in_motion())
             : model.bodies.recover(model.loads.history.factors(last_state.t),
                                    judge.coordinates(jumps, last_state.t));
    if (motion)
      judge.end_motion(energies().bodies);
    end.displacement.assign(u.begin(), u.end());
    end.was_there.assign(u.size(), false);
    const Discretization<dim> &space = model.bodies.discretization();
    for (std::size_t node = 0; node < space.n_nodes(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        end.was_there[space.dof(node, c)] = true;

    fill(end.checkpoint);
    end.checkpoint.cut.result     = *end_of_phase;
    end.checkpoint.cut.iterations = path->iterations();
    end.checkpoint.cut.next_level = levels_written;
    model.timer.finish("change of construction");
    end.timer = model.timer;
    return end;
  }

  template <int dim>
  ExitCode
  Simulation<dim>::enter_phase(const PhaseEnd &before)
  {
    const PhaseTransfer transfer(before, joint.elements, model.bodies.identities());
    Checkpoint checkpoint        = before.checkpoint;
    checkpoint.record.last_state = model.first_state;
    checkpoint.cut.state         = model.first_state;
    checkpoint.judge.element_dissipation =
      transfer.of_elements(before.checkpoint.judge.element_dissipation);
    // Water in what is grouted is squeezed out.
    const Vector factors = model.loads.history.factors(model.first_state.t);
    const Vector no_force(layered.n_bars(), 0.);
    renew_water(
      joint.elements, layered, factors, no_force, WaterRelief::allowed, checkpoint.cut.state);
    checkpoint.record.last_state = checkpoint.cut.state;
    CriticalFriction &critical   = checkpoint.cut.result.critical;
    critical.elements            = transfer.numbers(critical.elements);
    continue_output(checkpoint);
    judge.begin_phase(checkpoint.judge, model.first_state);
    log.line(model.change_of_construction());
    for (const std::string &line : joint.report)
      log.line(line);
    log_model();
    return follow([&]() { return path->go_on(checkpoint.cut, model.loads.levels, *this); });
  }

  template class Simulation<2>;
  template class Simulation<3>;
} // namespace fuga
