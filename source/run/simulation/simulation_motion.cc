// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/dynamics/time_steps.h>
#include <fuga/contact/dynamics/dynamic_path.h>
#include <fuga/run/simulation/simulation.h>

#include <fmt/format.h>

namespace fuga
{
  template <int dim>
  std::unique_ptr<BodiesInMotion<dim>>
  Simulation<dim>::make_motion() const
  {
    if (!model.is_dynamic())
      return nullptr;
    return std::make_unique<BodiesInMotion<dim>>(
      model.bodies, loading, model.construction.stage, model.massless_joints());
  }

  template <int dim>
  void
  Simulation<dim>::began_step(const ContactSystem &system, const LoadHistory &history_of_step)
  {
    if (!energies_at_rest)
      energies_at_rest = judge.energies();
    judge.begin_step(system, history_of_step);
  }

  template <int dim>
  void
  Simulation<dim>::ended_step(const JointState &state)
  {
    last_state          = state;
    const auto &dynamic = static_cast<const DynamicPath &>(*path);
    motion_energies     = dynamic.energies();
    motion_steps        = dynamic.n_steps();
    const Vector jumps  = layered.jumps(state.dislocations, state.forces);
    const Vector a      = model.loads.history.factors(state.t);
    const auto results  = element_results(joint.elements, state, jumps, closed_water(a));
    history.add_motion(state.t,
                       {motion->time(), motion->ground_acceleration(), motion_energies},
                       model.resultants(results, judge.dissipation()));
    if (!model.monitors.empty())
      write_monitors(state.t, "step", displacement_in_motion(), a);
    judge.end_step(state);
    publish(false);
  }

  template <int dim>
  Vector
  Simulation<dim>::displacement_in_motion() const
  {
    Vector u = motion->displacement();
    if (model.construction.displacement.empty())
      return u;
    const Vector before = model.bodies.discretization().by_nodes(model.construction.displacement);
    for (std::size_t i = 0; i < u.size(); ++i)
      u[i] += before[i];
    return u;
  }

  // What the judge calls the energy of moving bodies is the work on the stiffness of the steps. The
  // tables have no columns for what is kinetic, or was damped: they tell of the rest of the work.
  template <int dim>
  EnergyLedger
  Simulation<dim>::energies() const
  {
    EnergyLedger result = judge.energies();
    if (energies_at_rest)
      {
        result.external_work = energies_at_rest->external_work + motion_energies.work -
                               motion_energies.kinetic - motion_energies.damping;
        result.bodies = energies_at_rest->bodies + motion_energies.bodies;
      }
    return result;
  }

  template <int dim>
  void
  Simulation<dim>::log_motion()
  {
    if (motion_steps.empty())
      return;
    std::size_t n_halved = 0;
    for (std::size_t i = 1; i < motion_steps.size(); ++i)
      n_halved += motion_steps[i];
    const MotionLedger &e   = motion_energies;
    const std::string &unit = parameters.output.units.energy();
    log.line(
      fmt::format("Motion      {} steps and {} shorter ones; work {:.6g} {}: kinetic {:.6g}, "
                  "bodies {:.6g}, damping {:.6g}, joints {:.6g}; not accounted for {:.1e} of "
                  "the largest",
                  motion_steps[0],
                  n_halved,
                  e.work,
                  unit,
                  e.kinetic,
                  e.bodies,
                  e.damping,
                  e.joints,
                  e.largest > 0. ? std::abs(e.defect()) / e.largest : 0.));
  }

  template class Simulation<2>;
  template class Simulation<3>;
} // namespace fuga
