// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/lac/vector.h>

#include <fuga/bodies/motion/modal_coordinates.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Return the last @p n entries; the next function returns those before them. */
    Vector
    last(const std::size_t n, const Vector &all)
    {
      return {all.end() - static_cast<std::ptrdiff_t>(n), all.end()};
    }

    Vector
    all_but(const std::size_t n, const Vector &all)
    {
      return {all.begin(), all.end() - static_cast<std::ptrdiff_t>(n)};
    }

    void
    append(const Vector &more, Vector &all)
    {
      all.insert(all.end(), more.begin(), more.end());
    }
  } // namespace


  template <int dim>
  ModalCoordinates<dim>::ModalCoordinates(const CondensedSystem<dim> &bodies,
                                          const DrivingForces<dim> &driving_forces,
                                          const RayleighDamping &rayleigh,
                                          std::shared_ptr<const ModalBasis> of_bodies)
    : model(bodies)
    , driving(driving_forces)
    , damping(rayleigh)
    , basis(std::move(of_bodies))
    , dual(dual_of(bodies.jump_operator()))
    , its_mass(n_modes(), 1.)
    , no_mass(bodies.discretization().n_dofs(), 0.)
    , stiffness(multiply_transposed(basis->axes, multiply(bodies.stiffness(), basis->axes)))
    , coupling(multiply(basis->coupling, basis->axes))
  {
    append(basis->masses_along_axes, its_mass);
    const std::size_t n_columns = driving_factors(0.).size();
    driving_columns             = DenseMatrix(its_mass.size(), n_columns);
    following_fields            = DenseMatrix(no_mass.size(), n_columns);
    for (std::size_t j = 0; j < n_columns; ++j)
      {
        const Vector force  = driving_field(j);
        Vector field        = model.bonded_field_by_nodes(force, {});
        const Vector on_x   = last(model.n_coordinates(), model.out_of_balance(force, field));
        Vector on_modes     = multiply_transposed(basis->shapes, force);
        Vector without_mode = on_x;
        add_multiple(-1., multiply_transposed(basis->coupling, on_modes), without_mode);
        Vector column = on_modes;
        append(along_axes(without_mode), column);
        driving_columns.col(j) = view(column);
        for (std::size_t k = 0; k < n_modes(); ++k)
          on_modes[k] /= basis->squares[k];
        add_multiple(-1., multiply(basis->shapes, on_modes), field);
        following_fields.col(j) = view(field);
      }
  }


  template <int dim>
  Vector
  ModalCoordinates<dim>::driving_factors(const double time) const
  {
    Vector result                            = driving.load_factors(time);
    const std::array<double, 3> acceleration = driving.ground_acceleration(time);
    for (unsigned int c = 0; c < dim; ++c)
      result.push_back(-acceleration[c]);
    return result;
  }


  template <int dim>
  Vector
  ModalCoordinates<dim>::driving_field(const std::size_t column) const
  {
    const std::size_t n_patterns = driving_factors(0.).size() - dim;
    Vector unit(n_patterns, 0.), result;
    if (column < n_patterns)
      {
        unit[column] = 1.;
        result       = model.applied_forces(unit);
      }
    result.resize(no_mass.size(), 0.);
    if (column >= n_patterns)
      for (std::size_t dof = column - n_patterns; dof < result.size(); dof += dim)
        result[dof] = basis->mass[dof];
    return result;
  }


  template <int dim>
  Vector
  ModalCoordinates<dim>::amplitudes(const Vector &z) const
  {
    Vector result = all_but(model.n_coordinates(), z);
    add_multiple(-1., multiply(coupling, last(model.n_coordinates(), z)), result);
    return result;
  }


  template <int dim>
  Vector
  ModalCoordinates<dim>::stiffness_times(const Vector &u) const
  {
    Vector result = amplitudes(u);
    for (std::size_t k = 0; k < result.size(); ++k)
      result[k] *= basis->squares[k];
    Vector on_interface = multiply(stiffness, last(model.n_coordinates(), u));
    add_multiple(-1., multiply_transposed(coupling, result), on_interface);
    append(on_interface, result);
    return result;
  }


  template <int dim>
  Vector
  ModalCoordinates<dim>::damping_times(const Vector &v) const
  {
    if (damping.of_mass == 0. && damping.of_stiffness == 0.)
      return {};
    Vector result = stiffness_times(v);
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = damping.of_stiffness * result[i] + damping.of_mass * its_mass[i] * v[i];
    return result;
  }


  template <int dim>
  Vector
  ModalCoordinates<dim>::resistance(const Vector &u, const Vector &v) const
  {
    Vector deforming = u;
    add_multiple(damping.of_stiffness, v, deforming);
    Vector result = stiffness_times(deforming);
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] += damping.of_mass * its_mass[i] * v[i];
    return result;
  }


  template <int dim>
  Vector
  ModalCoordinates<dim>::bar_forces(const Vector &p) const
  {
    Vector result(n_modes(), 0.);
    append(along_axes(multiply_transposed(model.jump_operator(), p)), result);
    return result;
  }


  // The jumps of a velocity are compatible: B x = jumps has a solution.
  template <int dim>
  Vector
  ModalCoordinates<dim>::from_nodes(const Vector &velocity) const
  {
    const Vector x = multiply_transposed(dual, model.jumps(model.by_degrees_of_freedom(velocity)));
    Vector momenta = velocity;
    for (std::size_t dof = 0; dof < momenta.size(); ++dof)
      momenta[dof] *= basis->mass[dof];
    Vector result = multiply_transposed(basis->shapes, momenta);
    append(along_axes(x), result);
    return result;
  }


  template <int dim>
  DenseMatrix
  ModalCoordinates<dim>::condensed_stiffness(const unsigned int rung,
                                             const double a0,
                                             const double a1)
  {
    factors.resize(std::max<std::size_t>(factors.size(), rung + 1));
    const double kappa = factors[rung].stiffness = 1. + a1 * damping.of_stiffness;
    const double mu = factors[rung].mass = a0 + a1 * damping.of_mass;
    DenseMatrix weighted                 = basis->coupling;
    for (std::size_t k = 0; k < n_modes(); ++k)
      {
        const double elastic = kappa * basis->squares[k];
        const double weight  = std::sqrt(elastic * (mu / (elastic + mu))); // eq. 41
        for (Eigen::Index c = 0; c < weighted.cols(); ++c)
          weighted(k, c) *= weight;
      }
    DenseMatrix result   = multiply_transposed(weighted, weighted);
    const DenseMatrix &S = model.stiffness(), &R = basis->residual_mass;
    result += kappa * S + mu * R;
    return result;
  }


  template <int dim>
  Vector
  ModalCoordinates<dim>::condense(const unsigned int rung, const Vector &push)
  {
    pushed                  = push;
    const auto &[kappa, mu] = factors[rung];
    Vector from_modes       = all_but(model.n_coordinates(), push);
    for (std::size_t k = 0; k < n_modes(); ++k)
      from_modes[k] *= kappa * basis->squares[k] / (kappa * basis->squares[k] + mu);
    Vector result = last(model.n_coordinates(), push);
    add_multiple(1., multiply_transposed(coupling, from_modes), result);
    return multiply(basis->axes, result);
  }


  template <int dim>
  Vector
  ModalCoordinates<dim>::expand(const unsigned int rung, const Vector &x)
  {
    const auto &[kappa, mu] = factors[rung];
    const Vector w = along_axes(x), moved = multiply(coupling, w);
    Vector result(n_modes());
    for (std::size_t k = 0; k < n_modes(); ++k)
      {
        const double elastic = kappa * basis->squares[k];
        result[k]            = (pushed[k] + elastic * moved[k]) / (elastic + mu);
      }
    append(w, result);
    return result;
  }


  template <int dim>
  Vector
  ModalCoordinates<dim>::dynamic_forces(const MotionState &state)
  {
    Vector result = state.integration.inertia();
    add_multiple(1., state.integration.damping_forces(), result);
    return result;
  }


  template <int dim>
  Vector
  ModalCoordinates<dim>::forces_on_bodies(const MotionState &state) const
  {
    Vector result       = driving.at(state.time);
    const Vector moving = all_but(model.n_coordinates(), dynamic_forces(state));
    const Vector shapes = multiply(basis->shapes, moving);
    for (std::size_t dof = 0; dof < result.size(); ++dof)
      result[dof] -= basis->mass[dof] * shapes[dof];
    return result;
  }


  template <int dim>
  Vector
  ModalCoordinates<dim>::displacement(const MotionState &state) const
  {
    return model.bonded_field_by_nodes(forces_on_bodies(state),
                                       interface_of(state.integration.displacement()));
  }


  template <int dim>
  Vector
  ModalCoordinates<dim>::at_nodes(const Vector &rate) const
  {
    Vector result = model.bonded_field_by_nodes({}, interface_of(rate));
    add_multiple(1., multiply(basis->shapes, amplitudes(rate)), result);
    return result;
  }


  // The jump at a lip moves a node by the imbalance that a unit force on the node causes there in
  // the bonded bodies (Maxwell and Betti).
  template <int dim>
  void
  ModalCoordinates<dim>::watch(const std::vector<unsigned int> &dofs)
  {
    watched_dofs   = dofs;
    watched_modes  = DenseMatrix(dofs.size(), n_modes());
    watched_static = DenseMatrix(dofs.size(), model.n_coordinates());
    for (std::size_t i = 0; i < dofs.size(); ++i)
      {
        for (std::size_t k = 0; k < n_modes(); ++k)
          watched_modes(i, k) = basis->shapes(dofs[i], k);
        Vector unit(no_mass.size(), 0.);
        unit[dofs[i]]        = 1.;
        const Vector at_lips = last(
          model.n_coordinates(), model.out_of_balance(unit, model.bonded_field_by_nodes(unit, {})));
        for (std::size_t c = 0; c < at_lips.size(); ++c)
          watched_static(i, c) = at_lips[c];
      }
  }


  template <int dim>
  Vector
  ModalCoordinates<dim>::watched(const Vector &rate) const
  {
    Vector values = multiply(watched_modes, amplitudes(rate)), result = no_mass;
    add_multiple(1., multiply(watched_static, interface_of(rate)), values);
    for (std::size_t i = 0; i < watched_dofs.size(); ++i)
      result[watched_dofs[i]] = values[i];
    return result;
  }


  template <int dim>
  Vector
  ModalCoordinates<dim>::watched_displacement(const MotionState &state) const
  {
    Vector result        = watched(state.integration.displacement());
    const Vector amounts = driving_factors(state.time);
    for (const unsigned int dof : watched_dofs)
      for (std::size_t j = 0; j < amounts.size(); ++j)
        result[dof] += following_fields(dof, j) * amounts[j];
    return result;
  }


  // Bar forces that are equivalent to those on the coordinates are found in the range of B.
  template <int dim>
  EquilibriumError
  ModalCoordinates<dim>::equilibrium_error(const MotionState &state,
                                           const Vector &p,
                                           const Vector &acting) const
  {
    Vector on_lips = multiply(dual, interface_of(dynamic_forces(state)));
    add_multiple(1., p, on_lips);
    const Vector u = displacement(state);
    return model.equilibrium_error_in_motion(forces_on_bodies(state), u, u, on_lips, acting);
  }


  template class ModalCoordinates<2>;
  template class ModalCoordinates<3>;
} // namespace fuga
