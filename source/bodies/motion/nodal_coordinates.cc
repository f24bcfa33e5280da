// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/lac/vector.h>

#include <fuga/bodies/dynamics/geometric_stiffness.h>
#include <fuga/bodies/elasticity/elastic_bodies.h>
#include <fuga/bodies/motion/nodal_coordinates.h>
#include <fuga/bodies/processes.h>
#include <fuga/bodies/solvers/elimination_order.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    /** Return the product of u with a matrix by nodes, of the cells of this process. */
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
  NodalCoordinates<dim>::NodalCoordinates(const CondensedSystem<dim> &bodies,
                                          const DynamicsDefinition &dynamics,
                                          const ConstructionState &begin,
                                          const TemperatureField<dim> &temperature,
                                          const DrivingForces<dim> &driving_forces,
                                          const RayleighDamping &rayleigh,
                                          const std::shared_ptr<StepSolvers> &of_steps)
    : model(bodies)
    , driving(driving_forces)
    , damping(rayleigh)
    , dashpots(make_dashpots(model, dynamics.absorbing.names))
    , free_motions(model.rigid_pieces(), of_steps->mass)
    , steps(of_steps)
  {
    model.elastic_bodies().assemble_by_nodes(pattern, stiffness);
    if (dynamics.second_order == SecondOrder::weight)
      {
        geometric.reinit(pattern);
        add_geometric_stiffness(model, begin.displacement, temperature, geometric);
      }
  }


  template <int dim>
  Vector
  NodalCoordinates<dim>::stiffness_times(const Vector &u) const
  {
    Vector result = product(stiffness, free_motions.deformation_of_far(u));
    if (!geometric.empty())
      add_multiple(1., product(geometric, u), result);
    return result;
  }


  template <int dim>
  Vector
  NodalCoordinates<dim>::damping_times(const Vector &v) const
  {
    if (!is_damped())
      return {};
    Vector result = damping.of_stiffness > 0. ? product(stiffness, free_motions.deformation(v))
                                              : Vector(v.size(), 0.);
    for (double &force : result)
      force *= damping.of_stiffness;
    add_other_damping(v, result);
    collect(result);
    return result;
  }


  template <int dim>
  bool
  NodalCoordinates<dim>::is_damped() const
  {
    return damping.of_mass > 0. || damping.of_stiffness > 0. || !dashpots.empty();
  }


  template <int dim>
  void
  NodalCoordinates<dim>::add_other_damping(const Vector &v, Vector &forces) const
  {
    for (std::size_t i = 0; i < forces.size(); ++i)
      forces[i] += damping.of_mass * mass()[i] * v[i];
    add_dashpot_forces(1., dashpots, v, forces);
  }


  template <int dim>
  Vector
  NodalCoordinates<dim>::head_start(const Vector &velocity) const
  {
    return free_motions.rigid_part(velocity);
  }


  // Only the geometric part of K feels rigid motions. This saves a product, the most expensive part
  // of a step.
  template <int dim>
  Vector
  NodalCoordinates<dim>::resistance(const Vector &u, const Vector &v) const
  {
    Vector result = is_damped() ? damping_times(v) : Vector(u.size(), 0.);
    if (!geometric.empty())
      add_multiple(1., product(geometric, u), result);
    return result;
  }


  template <int dim>
  DenseMatrix
  NodalCoordinates<dim>::condensed_stiffness(const unsigned int rung,
                                             const double a0,
                                             const double a1)
  {
    if (steps->solvers[rung])
      return steps->stiffness[rung];
    const auto &coordinates  = model.interface_coordinates();
    SymmetricTriplets matrix = model.elastic_bodies().assemble(coordinates);
    const double damped      = 1. + a1 * damping.of_stiffness;
    for (double &value : matrix.values)
      value *= damped;
    if (!geometric.empty())
      add_by_nodes(geometric, coordinates, matrix);
    if (processes::is_first())
      {
        add_diagonal(a0 + a1 * damping.of_mass, mass(), coordinates, matrix);
        add_dashpots(a1, dashpots, coordinates, matrix);
      }
    if (steps->order.empty() && processes::is_first())
      steps->order = elimination_order(model.discretization(), coordinates);
    steps->solvers[rung]   = std::make_unique<SchurSolver>(steps->order);
    steps->stiffness[rung] = steps->solvers[rung]->eliminate(matrix, coordinates.n_interface());
    return steps->stiffness[rung];
  }


  template <int dim>
  Vector
  NodalCoordinates<dim>::condense(const unsigned int rung, const Vector &push)
  {
    const Vector gathered = model.interface_coordinates().gather(push);
    DenseMatrix loads(gathered.size(), 1);
    std::copy(gathered.begin(), gathered.end(), loads.data());
    const DenseMatrix condensed = steps->solvers[rung]->condense(loads);
    return {condensed.data(), condensed.data() + condensed.rows()};
  }


  template <int dim>
  Vector
  NodalCoordinates<dim>::expand(const unsigned int rung, const Vector &x)
  {
    const Vector y = steps->solvers[rung]->expand(x);
    return model.interface_coordinates().distribute(y.data(), {});
  }


  template <int dim>
  EquilibriumError
  NodalCoordinates<dim>::equilibrium_error(const MotionState &state,
                                           const Vector &p,
                                           const Vector &acting) const
  {
    const TimeIntegration &integration = state.integration;
    Vector loads                       = state.forces;
    add_multiple(-1., integration.inertia(), loads);
    add_multiple(-1., integration.damping_forces(), loads);
    if (!geometric.empty())
      add_multiple(-1., product(geometric, integration.displacement()), loads);
    const Vector &u = integration.displacement();
    return model.equilibrium_error_in_motion(
      loads, u, free_motions.deformation_of_far(u), p, acting);
  }


  template class NodalCoordinates<2>;
  template class NodalCoordinates<3>;
} // namespace fuga
