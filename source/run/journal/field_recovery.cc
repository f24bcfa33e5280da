// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/not_a_number.h>
#include <fuga/run/journal/field_recovery.h>

#include <deal.II/lac/vector.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    void
    absorb(const EquilibriumError &error, Certificate &certificate)
    {
      certificate.equilibrium      = larger_error(certificate.equilibrium, error.residual);
      certificate.body_equilibrium = larger_error(certificate.body_equilibrium, error.resultant);
    }

    // The stiffness of the bodies that the path uses differs from theirs by rounding. Either the
    // forces are wrong by this, or the jumps; the certificate tells for both by which share. The
    // lips of u move to where the bodies are in balance with the forces on them, if the residual is
    // worth it and both errors are then smaller. The return value tells whether they did.
    template <int dim>
    bool
    balance_lips(const PhaseRun<dim> &phase,
                 const Vector &on_lips,
                 const Vector &factors,
                 const dealii::Vector<double> &motion_of_bodies,
                 const double residual,
                 dealii::Vector<double> &u,
                 Certificate &certificate)
    {
      constexpr double worth_balancing = 1e-10;
      if (residual <= worth_balancing)
        return false;
      const CondensedSystem<dim> &bodies = phase.model.bodies;
      dealii::Vector<double> balanced    = u;
      const double moved =
        share(bodies.balance_lips(on_lips, factors, balanced), phase.judge.memory().largest_jump);
      const EquilibriumError error =
        bodies.equilibrium_error(balanced, on_lips, factors, motion_of_bodies);
      if (std::max(error.residual, moved) >= residual)
        return false;
      u = balanced;
      absorb(error, certificate);
      certificate.penetration = std::max(certificate.penetration, moved);
      return true;
    }

    template <int dim>
    dealii::Vector<double>
    displacement_at_rest(const PhaseRun<dim> &phase,
                         const JointState &state,
                         Certificate &certificate)
    {
      const CondensedSystem<dim> &bodies = phase.model.bodies;
      const Vector jumps                 = phase.layered.jumps(state.dislocations, state.forces);
      const Vector factors               = phase.model.loads.history.factors(state.t);
      const auto rigid         = bodies.rigid_part(phase.judge.coordinates(jumps, state.t));
      dealii::Vector<double> u = bodies.recover(factors, rigid.remainder);
      Vector on_lips           = state.forces;
      for (std::size_t i = 0; i < state.water.size(); ++i)
        on_lips[i] -= state.water[i];
      const EquilibriumError error = bodies.equilibrium_error(u, on_lips, factors, rigid.motion);
      if (!balance_lips(phase, on_lips, factors, rigid.motion, error.residual, u, certificate))
        absorb(error, certificate);
      if (rigid.motion.size() > 0)
        u += rigid.motion;
      return u;
    }
  } // namespace

  template <int dim>
  dealii::Vector<double>
  recover_displacement(const PhaseRun<dim> &phase,
                       const JointState &state,
                       Certificate &certificate)
  {
    dealii::Vector<double> u;
    if (phase.motion)
      {
        absorb(phase.motion->equilibrium_error(state.forces), certificate);
        u = phase.model.bodies.by_degrees_of_freedom(phase.displacement_in_motion());
      }
    else
      u = displacement_at_rest(phase, state, certificate);
    phase.model.timer.finish("recovery of displacements");
    return u;
  }

  template dealii::Vector<double>
  recover_displacement(const PhaseRun<2> &, const JointState &, Certificate &);
  template dealii::Vector<double>
  recover_displacement(const PhaseRun<3> &, const JointState &, Certificate &);
} // namespace fuga
