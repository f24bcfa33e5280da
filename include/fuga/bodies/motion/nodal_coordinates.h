// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_motion_nodal_coordinates_h
#define fuga_bodies_motion_nodal_coordinates_h

#include <fuga/bodies/dynamics/driving_forces.h>
#include <fuga/bodies/elasticity/free_motions.h>
#include <fuga/bodies/loads/temperature_field.h>
#include <fuga/bodies/motion/motion_coordinates.h>
#include <fuga/bodies/motion/step_solvers.h>

namespace fuga
{
  /**
   * The degrees of freedom of the finite elements (entry node * dim + component): each step length
   * has its own factorisation, computed when first needed; a step is one solution with it.
   */
  template <int dim>
  class NodalCoordinates : public MotionCoordinates
  {
  public:
    /**
     * @p steps contains the masses; its solvers are used if they exist, and created otherwise. The
     * other arguments must live as long as this object.
     */
    NodalCoordinates(const CondensedSystem<dim> &model,
                     const DynamicsDefinition &dynamics,
                     const ConstructionState &begin,
                     const TemperatureField<dim> &temperature,
                     const DrivingForces<dim> &driving,
                     const RayleighDamping &damping,
                     const std::shared_ptr<StepSolvers> &steps);

    const Vector &
    mass() const override
    {
      return steps->mass;
    }

    /** Return K u + K_g u. */
    Vector
    stiffness_times(const Vector &u) const override;

    Vector
    damping_times(const Vector &v) const override;
    Vector
    head_start(const Vector &velocity) const override;
    Vector
    resistance(const Vector &u, const Vector &v) const override;

    Vector
    inertia_of_resultants(const Vector &forces) const override
    {
      return free_motions.inertia_of_resultants(forces);
    }

    Vector
    driving_forces(const double time) const override
    {
      return driving.at(time);
    }

    Vector
    bar_forces(const Vector &p) const override
    {
      return model.bar_forces(p);
    }

    void
    collect(Vector &forces) const override
    {
      model.discretization().hanging_nodes().move_to_masters(forces);
    }

    Vector
    from_nodes(const Vector &velocity) const override
    {
      return velocity;
    }

    Vector
    jumps(const Vector &u) const override
    {
      return model.contact_bars().jumps(u);
    }

    DenseMatrix
    condensed_stiffness(const unsigned int rung, const double a0, const double a1) override;

    Vector
    condense(const unsigned int rung, const Vector &push) override;

    Vector
    expand(const unsigned int rung, const Vector &x) override;

    Vector
    displacement(const MotionState &state) const override
    {
      return state.integration.displacement();
    }

    Vector
    at_nodes(const Vector &rate) const override
    {
      return rate;
    }

    /** Does nothing: watching is not needed. */
    void
    watch(const std::vector<unsigned int> &) override
    {
    }

    Vector
    watched_displacement(const MotionState &state) const override
    {
      return state.integration.displacement();
    }

    Vector
    watched(const Vector &rate) const override
    {
      return rate;
    }

    const Vector &
    accelerated_mass() const override
    {
      return steps->mass;
    }

    EquilibriumError
    equilibrium_error(const MotionState &state,
                      const Vector &p,
                      const Vector &acting) const override;

    std::string
    description() const override
    {
      return {};
    }

  private:
    bool
    is_damped() const;
    /** Add all of C v except for the part proportional to the stiffness. */
    void
    add_other_damping(const Vector &v, Vector &forces) const;

    const CondensedSystem<dim> &model;
    const DrivingForces<dim> &driving;
    const RayleighDamping damping;
    /** Dashpots of the absorbing boundaries. */
    const Dashpots<dim> dashpots;
    const FreeMotions free_motions;
    dealii::SparsityPattern pattern;
    /** K, and K_g if it is requested; by nodes, for the own cells. */
    dealii::SparseMatrix<double> stiffness, geometric;
    std::shared_ptr<StepSolvers> steps;
  };
} // namespace fuga

#endif
