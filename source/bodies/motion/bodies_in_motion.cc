// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/numbers.h>

#include <fuga/bodies/dynamics/lumped_mass.h>
#include <fuga/bodies/dynamics/time_steps.h>
#include <fuga/bodies/model_names.h>
#include <fuga/bodies/motion/bodies_in_motion.h>
#include <fuga/bodies/motion/modal_coordinates.h>
#include <fuga/bodies/motion/nodal_coordinates.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    TimeGrid
    grid_of(const ModelDefinition &model, const ConstructionState &begin, const double end)
    {
      const DynamicsDefinition &dynamics = model.dynamics;
      StageDefinition span               = model.stages[begin.stage];
      if (begin.until_rest)
        {
          span.duration = dynamics.longest_continuation;
          span.levels   = 1;
        }
      const auto n_steps = static_cast<unsigned int>(number_of_time_steps(dynamics, span));
      return {begin.begin,
              end,
              n_steps,
              span.duration / n_steps,
              dynamics.halvings,
              dynamics.event_tolerance,
              begin.until_rest};
    }

    /** Return the dynamics in effect. Where an equilibrium was lost the ground stands still, and
     * supports hold. */
    DynamicsDefinition
    acting_in(DynamicsDefinition dynamics, const ConstructionState &begin)
    {
      if (begin.until_rest)
        {
          dynamics.ground         = {};
          dynamics.absorbing      = {};
          dynamics.compliant_base = {};
          dynamics.free_field     = {};
        }
      return dynamics;
    }

    /** Compute the damping from the ratio ζ = α/2ω + βω/2 at both frequencies. */
    RayleighDamping
    damping_of(const DynamicsDefinition &dynamics)
    {
      if (dynamics.damping_ratio == 0.)
        return {};
      const auto &f       = dynamics.damping_frequencies;
      const double factor = 2. * dynamics.damping_ratio / (f[0] + f[1]);
      return {factor * 2. * dealii::numbers::PI * f[0] * f[1], factor / (2. * dealii::numbers::PI)};
    }
  } // namespace


  template <int dim>
  BodiesInMotion<dim>::BodiesInMotion(const CondensedSystem<dim> &bodies,
                                      const DynamicsDefinition &definition,
                                      const LoadHistory &load_history,
                                      const ConstructionState &begin,
                                      const TemperatureField<dim> &temperature,
                                      const std::vector<bool> &massless_joints,
                                      std::shared_ptr<StepSolvers> same_steps)
    : model(bodies)
    , dynamics(acting_in(definition, begin))
    , construction(begin)
    , grid(grid_of(model.definition(), begin, load_history.end()))
    , damping(damping_of(dynamics))
    , steps(std::move(same_steps))
  {
    Vector mass = lumped_mass(model, massless_joints);
    if (!steps || dynamics.second_order != SecondOrder::none || steps->step != grid.step ||
        steps->mass != mass)
      {
        steps       = std::make_shared<StepSolvers>();
        steps->mass = std::move(mass);
        steps->step = grid.step;
        steps->solvers.resize(grid.halvings + 1);
        steps->stiffness.resize(grid.halvings + 1);
      }
    driving.emplace(model, dynamics, load_history, begin, steps->mass);
    if (!dynamics.free_field.names.empty())
      free_field.emplace(
        model, *driving, typename FreeColumn<dim>::Damping{damping.of_mass, damping.of_stiffness});
    coordinates = make_coordinates(temperature);
    integration = std::make_unique<TimeIntegration>(
      coordinates->mass(),
      [this](const Vector &v) { return coordinates->damping_times(v); },
      dynamics.spectral_radius);
  }


  template <int dim>
  std::unique_ptr<MotionCoordinates>
  BodiesInMotion<dim>::make_coordinates(const TemperatureField<dim> &temperature) const
  {
    if (dynamics.bodies == MotionBodies::finite_elements)
      return std::make_unique<NodalCoordinates<dim>>(
        model, dynamics, construction, temperature, *driving, damping, steps);
    const double highest =
      dynamics.highest_frequency > 0. ? dynamics.highest_frequency : 0.5 / grid.step;
    if (!steps->modes || steps->modes->highest_frequency != highest)
      steps->modes =
        std::make_shared<const ModalBasis>(make_modal_basis(model, steps->mass, highest));
    return std::make_unique<ModalCoordinates<dim>>(model, *driving, damping, steps->modes);
  }


  template <int dim>
  BodiesInMotion<dim>::~BodiesInMotion() = default;


  template <int dim>
  void
  BodiesInMotion<dim>::begin(const Vector &bar_forces, MotionLedger &ledger)
  {
    first_forces                = bar_forces;
    first_forces_on_coordinates = coordinates->bar_forces(bar_forces);
    present_time                = 0.;
    forces                      = coordinates->driving_forces(0.);
    if (free_field)
      free_field->begin();
    integration->begin(coordinates->from_nodes(initial_velocity()), net_forces(bar_forces, {}));
    ledger.kinetic = ledger.work = integration->kinetic_energy();
  }


  template <int dim>
  Vector
  BodiesInMotion<dim>::initial_velocity() const
  {
    const Discretization<dim> &space   = model.discretization();
    const ModelDefinition &definition  = model.definition();
    const std::vector<std::string> &of = model.jointed_mesh().body_names;
    if (!construction.velocity.empty())
      return space.by_nodes(construction.velocity);
    Vector result(space.n_dofs(), 0.);
    if (construction.stage != first_dynamic_stage(definition))
      return result;
    std::vector<std::array<double, 3>> velocities(of.size());
    for (const Material &material : definition.materials)
      velocities[index_of(of, material.body)] = material.initial_velocity;
    for (std::size_t cell = 0; cell < space.n_cells(); ++cell)
      for (std::size_t i = 0; i < space.reference_element().n_nodes(); ++i)
        for (unsigned int c = 0; c < dim; ++c)
          if (const std::size_t dof = space.cell_nodes(cell)[i] * dim + c; !model.fixed_dofs()[dof])
            result[dof] = velocities[space.cell_body(cell)][c];
    return result;
  }


  template <int dim>
  std::array<double, 3>
  BodiesInMotion<dim>::acceleration_of_frame() const
  {
    return dynamics.compliant_base.names.empty() ? ground_acceleration()
                                                 : std::array<double, 3>{{0., 0., 0.}};
  }


  template <int dim>
  double
  BodiesInMotion<dim>::largest_velocity() const
  {
    const Vector v = velocity();
    double largest = 0.;
    for (std::size_t node = 0; node < v.size() / dim; ++node)
      {
        double square = 0.;
        for (unsigned int c = 0; c < dim; ++c)
          square += v[node * dim + c] * v[node * dim + c];
        largest = std::max(largest, square);
      }
    return std::sqrt(largest);
  }


  template <int dim>
  DenseMatrix
  BodiesInMotion<dim>::condensed_stiffness(const unsigned int rung)
  {
    const double h = grid.length_of(rung);
    return coordinates->condensed_stiffness(
      rung, integration->mass_factor(h), integration->damping_factor(h));
  }


  // The unknown is measured from the head start û instead of Δū: a long way then has its own
  // digits, and does not take away those of the displacements that deform the bodies. The push
  // grows by (K + a1 C + a0 M) (Δū - û).
  template <int dim>
  MovingBodies::Step
  BodiesInMotion<dim>::begin_step(const unsigned int rung)
  {
    rung_of_step   = rung;
    const double h = grid.length_of(rung);
    forces_at_end  = coordinates->driving_forces(present_time + h);
    if (free_field)
      free_field->try_step(rung, h, present_time + h, forces_at_end);
    Vector growth = forces_at_end;
    add_multiple(-1., forces, growth);
    Vector start = coordinates->head_start(integration->steady_velocity());
    for (double &way : start)
      way *= h;
    TimeIntegration::Change predicted = integration->predicted(h);
    beyond_start                      = std::move(predicted.u);
    add_multiple(-1., start, beyond_start);
    add_multiple(-integration->damping_factor(h), beyond_start, predicted.v);
    add_multiple(-1., coordinates->resistance(start, predicted.v), growth);
    Vector push     = integration->push(growth);
    const double a0 = integration->mass_factor(h);
    for (std::size_t i = 0; i < push.size(); ++i)
      push[i] += a0 * integration->mass()[i] * beyond_start[i];
    return {coordinates->jumps(start), coordinates->condense(rung, push)};
  }


  template <int dim>
  void
  BodiesInMotion<dim>::finish_step(const Vector &x, const Vector &bar_forces, MotionLedger &ledger)
  {
    const double h = grid.length_of(rung_of_step);
    Vector mean    = first_forces_on_coordinates;
    add_multiple(0.5, forces, mean);
    add_multiple(0.5, forces_at_end, mean);
    Vector correction = coordinates->expand(rung_of_step, x);
    add_multiple(-1., beyond_start, correction);
    integration->advance(h, correction, mean, ledger);
    const Vector &u        = integration->displacement();
    const Vector restoring = coordinates->stiffness_times(u);
    ledger.bodies          = 0.5 * dot(u, restoring);
    forces                 = forces_at_end;
    if (free_field)
      free_field->finish_step();
    present_time += h;
    integration->correct(net_forces(bar_forces, restoring));
    integration->accelerate(coordinates->inertia_of_resultants(integration->memory().defect));
  }


  template <int dim>
  MotionMemory
  BodiesInMotion<dim>::memory() const
  {
    MotionMemory result = {present_time, first_forces, forces, {integration->memory()}};
    if (free_field)
      free_field->remember(result.integrations);
    return result;
  }


  template <int dim>
  void
  BodiesInMotion<dim>::restore(const MotionMemory &memory)
  {
    present_time                = memory.time;
    first_forces                = memory.first_forces;
    first_forces_on_coordinates = coordinates->bar_forces(first_forces);
    forces                      = memory.forces;
    integration->restore(memory.integrations.front());
    if (free_field)
      free_field->restore(memory.integrations, present_time);
  }


  template <int dim>
  Vector
  BodiesInMotion<dim>::net_forces(const Vector &bar_forces, const Vector &restoring) const
  {
    Vector changes = bar_forces;
    add_multiple(-1., first_forces, changes);
    Vector result = forces;
    add_multiple(-1., restoring, result);
    add_multiple(-1., coordinates->bar_forces(changes), result);
    coordinates->collect(result);
    return result;
  }


  // Where a body falls freely inertia leaves nothing of the forces, and where it rests they have
  // not changed: the forces of the joints have only the digits of what they carried before.
  template <int dim>
  EquilibriumError
  BodiesInMotion<dim>::equilibrium_error(const Vector &p) const
  {
    Vector changes = p;
    add_multiple(-1., first_forces, changes);
    Vector acting        = driving->at(present_time);
    const Vector carried = model.bar_forces(first_forces);
    for (std::size_t i = 0; i < acting.size(); ++i)
      acting[i] = std::max(std::abs(acting[i]), std::abs(carried[i]));
    return coordinates->equilibrium_error(now(), changes, acting);
  }


  template class BodiesInMotion<2>;
  template class BodiesInMotion<3>;
} // namespace fuga
