// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/path/implicit_step.h>
#include <fuga/contact/path/slow_motion.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fuga
{
  namespace
  {
    /** Initial and largest resistance, in units of the largest stiffness of the bodies, or, if
     * these are rigid, of the joints, and the factors by which it falls and rises. */
    constexpr double first_resistance = 10., largest_resistance = 1e6;
    constexpr double fall = 0.5, rise = 4.;
    constexpr int max_motions = 300;
    /** Share of the largest force below which the resistance is zero and the motion rests. */
    constexpr double at_rest = 1e-10;
    /** Size of a motion without bound, in units of the largest deformation, or distance of lips,
     * before it. */
    constexpr double far = 1e3;
    /** Share of the force within which a motion has met the same force, and the number of steps for
     * which it may do so: then something slides, and there is no equilibrium near by either. */
    constexpr double same_force = 1e-5;
    constexpr int max_steady    = 20;
    /** Number of such steps after which lips that come closer are brought together at once, and the
     * part of the way that this leads along. */
    constexpr int least_steady   = 3;
    constexpr double just_before = 1. - 1e-6;

    /** The bodies with a viscous resistance between their faces against all jumps, beginning at δ0:
     * (S + κ BᵀB) x + Bᵀp = F a + κ Bᵀδ0. */
    class DampedBodies : public ContactSystem
    {
    public:
      DampedBodies(const ContactSystem &bodies,
                   const Vector &factors,
                   const double resistance,
                   const Vector &jumps_before)
        : S(bodies.stiffness()), F(S.rows(), 1), B(bodies.jump_operator())
      {
        const Vector loads = multiply(bodies.load_patterns(), factors);
        const Vector x0    = multiply_transposed(B, jumps_before);
        for (Eigen::Index j = 0; j < S.rows(); ++j)
          F(j, 0) = loads[j] + resistance * x0[j];
        add_congruent(B, Vector(jumps_before.size(), resistance), S);
        if (bodies.imposed_jumps().size() == 0)
          return;
        const Vector imposed = multiply(bodies.imposed_jumps(), factors);
        E                    = DenseMatrix(imposed.size(), 1);
        E.col(0)             = view(imposed);
      }

      const DenseMatrix &
      stiffness() const override
      {
        return S;
      }

      const DenseMatrix &
      load_patterns() const override
      {
        return F;
      }

      const SparseOperator &
      jump_operator() const override
      {
        return B;
      }

      const DenseMatrix &
      imposed_jumps() const override
      {
        return E;
      }

      const DenseMatrix &
      rigid_motions() const override
      {
        return none;
      }

      const DenseMatrix &
      rigid_motion_loads() const override
      {
        return none;
      }

    private:
      DenseMatrix S, F, E;
      const SparseOperator &B;
      const DenseMatrix none;
    };

    /** Take one implicit step under constant loads, while the forces that broken bonds still carry
     * are given up. */
    std::optional<JointState>
    step(const std::vector<ContactElement> &elements,
         const LayeredSystem &system,
         const Vector &factors,
         const JointState &from)
    {
      Course course;
      course.t = course.t_end = from.t;
      course.factors          = factors;
      course.factor_rates     = Vector(factors.size(), 0.);
      course.drive.release    = from.unreleased;
      for (double &force : course.drive.release)
        force = -force;
      course.length = 1.;
      const ContactBoundary boundary(elements, system);
      WorkingScheme scheme(elements, system);
      return ImplicitStep({elements, system, boundary, scheme}, course).solve(from);
    }

    /** Return the work of friction in a step, computed from the forces at its end. */
    double
    friction_work(const std::vector<ContactElement> &elements,
                  const JointState &from,
                  const JointState &to)
    {
      double work = 0.;
      for (std::size_t k = 0; k < elements.size(); ++k)
        if (is_slipping(to.states[k]))
          work += dot(tangential(elements[k], to.forces), sum(to.slips[k], -1., from.slips[k])) +
                  to.forces[elements[k].normal_bar] * (to.dilations[k] - from.dilations[k]);
      return work;
    }

    /** Return the energy of the nonlinear layers beyond ½ D p², which the linear part of the system
     * contains. */
    double
    energy_beyond_linear(const std::vector<ContactElement> &elements,
                         const LayeredSystem &system,
                         const JointState &state)
    {
      double energy = 0.;
      for (std::size_t k = 0; k < elements.size(); ++k)
        {
          energy += nonlinear_energy(elements[k], state, k);
          for (std::size_t i = 0; i < elements[k].n_bars(); ++i)
            if (const std::size_t bar = elements[k].bar(i); system.is_curved(bar))
              energy -= 0.5 * system.compliance(bar) * state.forces[bar] * state.forces[bar];
        }
      return energy;
    }

    /** Return the energy that bodies, layers and loads release from one equilibrium to another, at
     * the load of the latter: along dislocations the potential changes by -p·dd, and p is linear in
     * d. */
    double
    released_energy(const std::vector<ContactElement> &elements,
                    const LayeredSystem &system,
                    const Vector &factors,
                    const JointState &from,
                    const JointState &to)
    {
      double released =
        energy_beyond_linear(elements, system, from) - energy_beyond_linear(elements, system, to);
      const Vector before = system.forces(factors, from.dislocations, from.water);
      for (std::size_t i = 0; i < before.size(); ++i)
        released += 0.5 * (before[i] + to.forces[i]) * (to.dislocations[i] - from.dislocations[i]);
      return released;
    }

    /** Return how many steps such as that from @p before to @p after, the largest jump of which is
     * @p moved, bring open lips together; zero if none come closer, or if lips rise, which has its
     * own end. */
    double
    steps_to_contact(const std::vector<ContactElement> &elements,
                     const JointState &before,
                     const JointState &after,
                     const double moved)
    {
      constexpr double part = 1e-3; // of the motion, which is no rounding
      double n_steps        = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < elements.size(); ++k)
        {
          if (after.dilations[k] != before.dilations[k])
            return 0.;
          if (after.states[k] != ContactState::open || before.states[k] != ContactState::open)
            continue;
          const double gap      = lip_opening(elements[k], after, k);
          const double approach = lip_opening(elements[k], before, k) - gap;
          if (approach > part * moved)
            n_steps = std::min(n_steps, gap / approach);
        }
      return std::isfinite(n_steps) ? n_steps : 0.;
    }

    /** Repeat the step from @p before to @p after @p n_steps times, as a motion does that nothing
     * but the constant resistance stops. */
    void
    repeat_step(const JointState &before, const double n_steps, JointState &after)
    {
      for (std::size_t i = 0; i < after.dislocations.size(); ++i)
        after.dislocations[i] += n_steps * (after.dislocations[i] - before.dislocations[i]);
      for (std::size_t k = 0; k < after.slips.size(); ++k)
        after.slips[k] = sum(after.slips[k], n_steps, sum(after.slips[k], -1., before.slips[k]));
    }

    /** Return the widest distance of open lips [m]. */
    double
    widest_opening(const std::vector<ContactElement> &elements, const JointState &state)
    {
      double widest = 0.;
      for (std::size_t k = 0; k < elements.size(); ++k)
        if (state.states[k] == ContactState::open)
          widest = std::max(widest, lip_opening(elements[k], state, k));
      return widest;
    }

    double
    largest_difference(const Vector &a, const Vector &b)
    {
      double result = 0.;
      for (std::size_t i = 0; i < a.size(); ++i)
        result = std::max(result, std::abs(a[i] - b[i]));
      return result;
    }

    /** Return B x, the jumps without those imposed. */
    Vector
    jumps_of_bodies(const LayeredSystem &system, const Vector &factors, const JointState &state)
    {
      Vector jumps = system.jumps(state.dislocations, state.forces);
      if (const DenseMatrix &E = system.contact_system().imposed_jumps(); E.size() > 0)
        {
          const Vector imposed = multiply(E, factors);
          for (std::size_t i = 0; i < jumps.size(); ++i)
            jumps[i] -= imposed[i];
        }
      return jumps;
    }
  } // namespace

  std::optional<JumpEnd>
  find_equilibrium_nearby(const std::vector<ContactElement> &elements,
                          const LayeredSystem &system,
                          const Course &course,
                          const JointState &from)
  {
    const ContactSystem &bodies = system.contact_system();
    if (bodies.water_in_joints() != nullptr)
      return {};
    JumpEnd end{from, {}};
    JointState &state = end.state;
    state.t           = course.t_end;
    reduce_strengths(elements, course, course.length, state.strengths);
    const Vector factors = course.factors_at(course.length);

    const double of_bodies    = largest_diagonal(bodies.stiffness());
    const double stiffness    = of_bodies > 0. ? of_bodies : system.largest_stiffness();
    const Vector jumps_before = jumps_of_bodies(system, course.factors, from);
    // The displacements of bodies before a time step are contained in its imposed jumps.
    const double reach  = far * std::max({max_abs(system.jumps(from.dislocations, from.forces)),
                                          max_abs(from.forces) / stiffness,
                                          widest_opening(elements, from)});
    double resistance   = first_resistance * stiffness;
    Vector jumps        = jumps_before;
    double force_before = 0.;
    int n_steady        = 0;
    for (int i = 0;
         i < max_motions && n_steady < max_steady && resistance <= largest_resistance * stiffness;
         ++i)
      {
        const DampedBodies damped(bodies, factors, resistance, jumps);
        const LayeredSystem layered(damped, elements);
        std::optional<JointState> next = step(elements, layered, {1.}, state);
        if (!next)
          {
            resistance *= rise;
            continue;
          }
        const JointState before  = std::exchange(state, std::move(*next));
        const Vector jumps_after = jumps_of_bodies(system, factors, state);
        const double moved       = largest_difference(jumps_after, jumps);
        const double friction    = friction_work(elements, before, state);
        const double force       = resistance * moved;
        end.jump.dissipated += friction;
        n_steady     = std::abs(force - force_before) <= same_force * force ? n_steady + 1 : 0;
        force_before = force;
        jumps        = jumps_after;
        if (n_steady >= least_steady)
          if (const double n_steps = just_before * steps_to_contact(elements, before, state, moved);
              n_steps > 1.)
            {
              repeat_step(before, n_steps, state);
              end.jump.dissipated += n_steps * friction;
              jumps    = jumps_of_bodies(system, factors, state);
              n_steady = 0;
            }
        if (largest_difference(jumps, jumps_before) > reach)
          return {};
        if (force <= at_rest * max_abs(state.forces))
          if (std::optional<JointState> equilibrium = step(elements, system, factors, state))
            {
              end.jump.dissipated += friction_work(elements, state, *equilibrium);
              state           = std::move(*equilibrium);
              end.jump.found  = true;
              end.jump.t      = from.t;
              end.jump.length = course.t_end - from.t;
              end.jump.size =
                largest_difference(jumps_of_bodies(system, factors, state), jumps_before);
              end.jump.released = released_energy(elements, system, factors, from, state);
              return end;
            }
        resistance *= fall;
      }
    return {};
  }
} // namespace fuga
