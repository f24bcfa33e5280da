// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/condensed_system.h>
#include <fuga/bodies/elastic_bodies.h>
#include <fuga/bodies/processes.h>
#include <fuga/bodies/rigid_pieces.h>

#include <deal.II/lac/vector.h>

#include <algorithm>

namespace fuga
{
  double
  LinearResponse::value(const Vector &x, const Vector &a) const
  {
    return dot(coordinates, x) + dot(patterns, a);
  }

  // With w the bonded response to the force q and g the prescribed displacements of a pattern,
  // Maxwell's theorem gives q·u = w·P + (q - K w)·g of the bonded structure; what the interface
  // coordinates add is the work of the condensed force on them.
  template <int dim>
  LinearResponse
  CondensedSystem<dim>::response(const Vector &force) const
  {
    timer.restart();
    Vector w(space->n_dofs(), 0.);
    add_bonded_response(force, w);
    add_bonded_response(force, w); // refines
    const Vector Kw = bodies->forces(w);

    LinearResponse result;
    for (const LoadPattern &pattern : patterns)
      {
        result.patterns.push_back(dot(w, pattern.forces));
        if (pattern.prescribed.empty())
          continue;
        const Vector g =
          coordinates->distribute(Vector(coordinates->size(), 0.).data(), pattern.prescribed);
        result.patterns.back() += dot(force, g) - dot(Kw, g);
      }
    if (coordinates->n_interface() > 0)
      {
        const Vector residual = out_of_balance(force, w);
        DenseMatrix column(residual.size(), 1), work(pieces->n_free_motions(), 1);
        std::copy(residual.begin(), residual.end(), column.data());
        for (std::size_t k = 0; k < work.n_rows(); ++k)
          work(k, 0) = dot(pieces->free_motion(k), force);
        DenseMatrix condensed = solver->condense(column);
        projection->project_loads(condensed, work);
        result.coordinates.assign(condensed.data(), condensed.data() + condensed.n_rows());
      }
    timer.finish("monitors");
    return result;
  }

  template <int dim>
  dealii::Vector<double>
  CondensedSystem<dim>::bonded_field(const Vector &forces, const Vector &x) const
  {
    Vector y(coordinates->size(), 0.), loads = forces;
    std::copy(x.begin(), x.end(), y.end() - static_cast<std::ptrdiff_t>(x.size()));
    loads.resize(space->n_dofs(), 0.);
    Vector u = coordinates->distribute(y.data(), {});
    add_bonded_response(loads, u);
    add_bonded_response(loads, u); // refines
    return by_degrees_of_freedom(u);
  }

  template <int dim>
  typename CondensedSystem<dim>::RigidPart
  CondensedSystem<dim>::rigid_part(const Vector &x) const
  {
    RigidPart result;
    result.remainder = x;
    if (motion_coordinates.empty())
      return result;
    const Vector amounts = projection->motion_of(x);
    Vector u(space->n_dofs(), 0.);
    for (std::size_t k = 0; k < amounts.size(); ++k)
      {
        const Vector motion = pieces->free_motion(k);
        for (std::size_t i = 0; i < u.size(); ++i)
          u[i] += amounts[k] * motion[i];
        for (std::size_t i = 0; i < x.size(); ++i)
          result.remainder[i] -= amounts[k] * motion_coordinates(i, k);
      }
    result.motion = by_degrees_of_freedom(u);
    return result;
  }

  template <int dim>
  EquilibriumError
  CondensedSystem<dim>::equilibrium_error(const dealii::Vector<double> &u,
                                          const Vector &p,
                                          const Vector &a,
                                          const dealii::Vector<double> &motion) const
  {
    timer.restart();
    Vector terms;
    Vector elastic = bodies->forces(space->by_nodes(u), terms);
    // The rounding of a jump moves both lips against each other. It is that of a sum over all bars,
    // of the size of the motion.
    if (motion.size() > 0)
      {
        const double sum_length = 0.25 * static_cast<double>(bars->bars().size());
        Vector far_terms;
        bodies->forces(space->by_nodes(motion), far_terms);
        for (const auto &bar : bars->bars())
          for (const unsigned int node : {bar.plus_node, bar.minus_node})
            for (unsigned int c = 0; c < dim && node != Discretization<dim>::no_node; ++c)
              terms[node * dim + c] =
                std::max(terms[node * dim + c], sum_length * far_terms[node * dim + c]);
      }
    for (const auto &bar : bars->bars())
      if (bar.minus_node != Discretization<dim>::no_node)
        for (unsigned int c = 0; c < dim; ++c)
          {
            double &plus = terms[bar.plus_node * dim + c], &minus = terms[bar.minus_node * dim + c];
            plus = minus = std::max(plus, minus);
          }
    // Rounding knows no axes: what it does along one it does across, by the balance of moments.
    for (std::size_t node = 0; node < space->n_nodes(); ++node)
      {
        double *const of_node = terms.data() + node * dim;
        std::fill(of_node, of_node + dim, *std::max_element(of_node, of_node + dim));
      }
    Vector loads = combination(a, &LoadPattern::forces);
    loads.resize(space->n_dofs(), 0.);
    Vector contact(space->n_dofs(), 0.);
    bars->add_forces(1., p, contact);
    for (Vector *forces : {&elastic, &terms, &loads})
      space->hanging_nodes().move_to_masters(*forces);

    const EquilibriumError error =
      fuga::equilibrium_error(elastic, terms, contact, loads, fixed, *pieces);
    timer.finish("equilibrium check");
    return error;
  }

  template <int dim>
  BodiesWork
  CondensedSystem<dim>::work() const
  {
    if (!solver)
      return {};
    const SolverWork &work = solver->work();
    return {work.n_factorisations,
            work.n_condensed_loads,
            work.n_solutions,
            n_recovered_fields,
            processes::number(),
            work.n_iterations,
            used_solver,
            estimate};
  }

  template <int dim>
  dealii::Vector<double>
  CondensedSystem<dim>::nodal_forces(const dealii::Vector<double> &u) const
  {
    Vector forces = bodies->forces(space->by_nodes(u));
    space->hanging_nodes().move_to_masters(forces);
    return by_degrees_of_freedom(forces);
  }

  template <int dim>
  Vector
  CondensedSystem<dim>::jumps(const dealii::Vector<double> &u) const
  {
    return bars->jumps(space->by_nodes(u));
  }

  template <int dim>
  double
  CondensedSystem<dim>::bulk_energy(const dealii::Vector<double> &u) const
  {
    return bodies->energy(space->by_nodes(u));
  }

  template <int dim>
  Vector
  CondensedSystem<dim>::cell_energies(const Vector &u) const
  {
    return bodies->cell_energies(u);
  }

  template LinearResponse
  CondensedSystem<2>::response(const Vector &) const;
  template dealii::Vector<double>
  CondensedSystem<2>::bonded_field(const Vector &, const Vector &) const;
  template CondensedSystem<2>::RigidPart
  CondensedSystem<2>::rigid_part(const Vector &) const;
  template EquilibriumError
  CondensedSystem<2>::equilibrium_error(const dealii::Vector<double> &,
                                        const Vector &,
                                        const Vector &,
                                        const dealii::Vector<double> &) const;
  template BodiesWork
  CondensedSystem<2>::work() const;
  template dealii::Vector<double>
  CondensedSystem<2>::nodal_forces(const dealii::Vector<double> &) const;
  template Vector
  CondensedSystem<2>::jumps(const dealii::Vector<double> &) const;
  template double
  CondensedSystem<2>::bulk_energy(const dealii::Vector<double> &) const;
  template Vector
  CondensedSystem<2>::cell_energies(const Vector &) const;
  template LinearResponse
  CondensedSystem<3>::response(const Vector &) const;
  template CondensedSystem<3>::RigidPart
  CondensedSystem<3>::rigid_part(const Vector &) const;
  template EquilibriumError
  CondensedSystem<3>::equilibrium_error(const dealii::Vector<double> &,
                                        const Vector &,
                                        const Vector &,
                                        const dealii::Vector<double> &) const;
  template BodiesWork
  CondensedSystem<3>::work() const;
  template dealii::Vector<double>
  CondensedSystem<3>::nodal_forces(const dealii::Vector<double> &) const;
  template Vector
  CondensedSystem<3>::jumps(const dealii::Vector<double> &) const;
  template double
  CondensedSystem<3>::bulk_energy(const dealii::Vector<double> &) const;
  template Vector
  CondensedSystem<3>::cell_energies(const Vector &) const;
  template dealii::Vector<double>
  CondensedSystem<3>::bonded_field(const Vector &, const Vector &) const;
} // namespace fuga
