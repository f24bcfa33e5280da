// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/dynamics/driving_forces.h>
#include <fuga/bodies/dynamics/ground_motion.h>

#include <algorithm>

namespace fuga
{
  template <int dim>
  DrivingForces<dim>::DrivingForces(const CondensedSystem<dim> &bodies,
                                    const DynamicsDefinition &definition,
                                    const LoadHistory &load_history,
                                    const ConstructionState &construction,
                                    const Vector &mass_of_dofs)
    : model(bodies)
    , dynamics(definition)
    , history(load_history)
    , begin(construction.begin)
    , is_first(construction.is_first())
    , duration(bodies.definition().stages[construction.stage].duration)
    , shakes(dynamics.earthquake_stage == construction.stage)
    , mass(mass_of_dofs)
    , base_dashpots(make_dashpots(model, dynamics.compliant_base.names))
  {
    for (unsigned int c = 0; c < dim && shakes && !base_dashpots.empty(); ++c)
      ground_velocities[c] = integrated(dynamics.ground[c]).velocities;
  }


  template <int dim>
  Vector
  DrivingForces<dim>::load_factors(const double time) const
  {
    const double part = duration > 0. ? std::min(time / duration, 1.) : 1.;
    Vector factors    = history.factors(begin + part * (history.end() - begin));
    if (!is_first)
      {
        add_multiple(-1., history.factors(begin), factors);
        // The imbalance at the beginning of the phase (CarriedLoads::released) moves at once.
        factors.back() = -1.;
      }
    return factors;
  }


  template <int dim>
  Vector
  DrivingForces<dim>::at(const double time) const
  {
    Vector result = model.applied_forces(load_factors(time));
    result.resize(model.discretization().n_dofs(), 0.);
    if (base_dashpots.empty())
      {
        const std::array<double, 3> acceleration = ground_acceleration(time);
        for (std::size_t dof = 0; dof < result.size(); ++dof)
          result[dof] -= mass[dof] * acceleration[dof % dim];
      }
    else
      {
        const std::array<double, dim> wave = upward_wave(time);
        Vector velocity(result.size(), 0.);
        for (const auto &[node, dashpot] : base_dashpots)
          std::copy(wave.begin(), wave.end(), velocity.begin() + node * dim);
        add_dashpot_forces(2., base_dashpots, velocity, result);
      }
    return result;
  }


  template <int dim>
  std::array<double, 3>
  DrivingForces<dim>::ground_acceleration(const double time) const
  {
    std::array<double, 3> result = {{0., 0., 0.}};
    for (unsigned int c = 0; c < dim && shakes; ++c)
      result[c] = acceleration_at(dynamics.ground[c], time);
    return result;
  }


  template <int dim>
  std::array<double, dim>
  DrivingForces<dim>::upward_wave(const double time) const
  {
    std::array<double, dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      result[c] =
        dynamics.upward_share * velocity_at(dynamics.ground[c], ground_velocities[c], time);
    return result;
  }


  template class DrivingForces<2>;
  template class DrivingForces<3>;
} // namespace fuga
