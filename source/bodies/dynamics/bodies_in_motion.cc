// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/numbers.h>
#include <deal.II/lac/vector.h>

#include <fuga/bodies/dynamics/bodies_in_motion.h>
#include <fuga/bodies/dynamics/lumped_mass.h>
#include <fuga/bodies/dynamics/time_steps.h>
#include <fuga/bodies/elasticity/elastic_bodies.h>
#include <fuga/bodies/joints/contact_bars.h>
#include <fuga/bodies/model_names.h>
#include <fuga/bodies/processes.h>
#include <fuga/bodies/solvers/elimination_order.h>

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

    /** Where an equilibrium was lost the ground stands still, and supports hold. */
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

    /** With a matrix by nodes, of the own cells. */
    Vector
    product(const dealii::SparseMatrix<double> &matrix, const Vector &u)
    {
      const dealii::Vector<double> x(u.begin(), u.end());
      dealii::Vector<double> result(x.size());
      matrix.vmult(result, x);
      Vector sum(result.begin(), result.end());
      processes::sum(sum);
      return sum;
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
    , dashpots(make_dashpots(model, dynamics.absorbing.names))
    , free_motions(model.rigid_pieces())
    , steps(std::move(same_steps))
  {
    // The ratio ζ = α/2ω + βω/2 at both frequencies.
    if (const auto &f = dynamics.damping_frequencies; dynamics.damping_ratio > 0.)
      {
        const double factor = 2. * dynamics.damping_ratio / (f[0] + f[1]);
        mass_damping        = factor * 2. * dealii::numbers::PI * f[0] * f[1];
        stiffness_damping   = factor / (2. * dealii::numbers::PI);
      }
    model.elastic_bodies().assemble_by_nodes(pattern, stiffness);
    if (dynamics.second_order == SecondOrder::weight)
      {
        geometric.reinit(pattern);
        add_geometric_stiffness(model, begin.displacement, temperature, geometric);
      }
    integration = std::make_unique<TimeIntegration>(
      lumped_mass(model, massless_joints),
      [this](const Vector &v) { return damping_times(v); },
      dynamics.spectral_radius);
    if (!steps || !geometric.empty() || steps->step != grid.step ||
        steps->mass != integration->mass())
      {
        steps       = std::make_shared<StepSolvers>();
        steps->mass = integration->mass();
        steps->step = grid.step;
        steps->solvers.resize(grid.halvings + 1);
        steps->stiffness.resize(grid.halvings + 1);
      }
    driving.emplace(model, dynamics, load_history, begin, integration->mass());
    if (!dynamics.free_field.names.empty())
      free_field.emplace(
        model, *driving, typename FreeColumn<dim>::Damping{mass_damping, stiffness_damping});
  }


  template <int dim>
  BodiesInMotion<dim>::~BodiesInMotion() = default;


  template <int dim>
  void
  BodiesInMotion<dim>::begin(const Vector &bar_forces, MotionLedger &ledger)
  {
    first_forces          = bar_forces;
    first_forces_at_nodes = model.bar_forces(bar_forces);
    present_time          = 0.;
    forces                = driving->at(0.);
    if (free_field)
      free_field->begin();
    integration->begin(initial_velocity(), net_forces(bar_forces, {}));
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
    const Vector &v = integration->velocity();
    double largest  = 0.;
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
    if (steps->solvers[rung])
      return steps->stiffness[rung];
    const auto &coordinates  = model.interface_coordinates();
    const double h           = grid.length_of(rung);
    SymmetricTriplets matrix = model.elastic_bodies().assemble(coordinates);
    const double damped      = 1. + integration->damping_factor(h) * stiffness_damping;
    for (double &value : matrix.values)
      value *= damped;
    if (!geometric.empty())
      add_by_nodes(geometric, coordinates, matrix);
    if (processes::is_first())
      {
        const double damping = integration->damping_factor(h);
        add_diagonal(integration->mass_factor(h) + damping * mass_damping,
                     integration->mass(),
                     coordinates,
                     matrix);
        add_dashpots(damping, dashpots, coordinates, matrix);
      }
    if (steps->order.empty() && processes::is_first())
      steps->order = elimination_order(model.discretization(), coordinates);
    steps->solvers[rung]   = std::make_unique<SchurSolver>(steps->order);
    steps->stiffness[rung] = steps->solvers[rung]->eliminate(matrix, coordinates.n_interface());
    return steps->stiffness[rung];
  }


  template <int dim>
  Vector
  BodiesInMotion<dim>::begin_step(const unsigned int rung)
  {
    rung_of_step   = rung;
    const double h = grid.length_of(rung);
    forces_at_end  = driving->at(present_time + h);
    if (free_field)
      free_field->try_step(rung, h, present_time + h, forces_at_end);
    Vector growth = forces_at_end;
    add_multiple(-1., forces, growth);
    const Vector push = model.interface_coordinates().gather(integration->push(h, growth));
    DenseMatrix loads(push.size(), 1);
    std::copy(push.begin(), push.end(), loads.data());
    const DenseMatrix condensed = steps->solvers[rung]->condense(loads);
    return {condensed.data(), condensed.data() + condensed.n_rows()};
  }


  template <int dim>
  void
  BodiesInMotion<dim>::finish_step(const Vector &x, const Vector &bar_forces, MotionLedger &ledger)
  {
    const double h  = grid.length_of(rung_of_step);
    const Vector y  = steps->solvers[rung_of_step]->expand(x);
    const Vector du = model.interface_coordinates().distribute(y.data(), {});
    Vector mean     = first_forces_at_nodes;
    add_multiple(0.5, forces, mean);
    add_multiple(0.5, forces_at_end, mean);
    integration->advance(h, du, mean, ledger);
    const Vector &u        = integration->displacement();
    const Vector restoring = restoring_forces(u);
    ledger.bodies          = 0.5 * dot(u, restoring);
    forces                 = forces_at_end;
    if (free_field)
      free_field->finish_step();
    present_time += h;
    integration->correct(net_forces(bar_forces, restoring));
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
    present_time          = memory.time;
    first_forces          = memory.first_forces;
    first_forces_at_nodes = model.bar_forces(first_forces);
    forces                = memory.forces;
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
    add_multiple(-1., model.bar_forces(changes), result);
    model.discretization().hanging_nodes().move_to_masters(result);
    return result;
  }


  template <int dim>
  Vector
  BodiesInMotion<dim>::restoring_forces(const Vector &u) const
  {
    Vector result = product(stiffness, free_motions.deformation(u));
    if (!geometric.empty())
      add_multiple(1., product(geometric, u), result);
    return result;
  }


  template <int dim>
  Vector
  BodiesInMotion<dim>::damping_times(const Vector &v) const
  {
    if (mass_damping == 0. && stiffness_damping == 0. && dashpots.empty())
      return {};
    Vector result = stiffness_damping > 0. ? product(stiffness, free_motions.deformation(v))
                                           : Vector(v.size(), 0.);
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = stiffness_damping * result[i] + mass_damping * integration->mass()[i] * v[i];
    add_dashpot_forces(1., dashpots, v, result);
    model.discretization().hanging_nodes().move_to_masters(result);
    return result;
  }


  template <int dim>
  EquilibriumError
  BodiesInMotion<dim>::equilibrium_error(const Vector &p) const
  {
    Vector loads = forces;
    add_multiple(-1., integration->inertia(), loads);
    add_multiple(-1., integration->damping_forces(), loads);
    if (!geometric.empty())
      add_multiple(-1., product(geometric, integration->displacement()), loads);
    Vector changes = p;
    add_multiple(-1., first_forces, changes);
    // Where a body falls freely inertia leaves nothing of the forces, and where it rests they have
    // not changed: those of the joints have the digits of what they carried before.
    const double largest = std::max(max_abs(forces), max_abs(first_forces_at_nodes));
    return model.equilibrium_error_under(
      loads, model.by_degrees_of_freedom(integration->displacement()), changes, {}, largest);
  }


  template class BodiesInMotion<2>;
  template class BodiesInMotion<3>;
} // namespace fuga
