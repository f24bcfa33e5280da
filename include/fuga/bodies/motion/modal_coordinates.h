// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_motion_modal_coordinates_h
#define fuga_bodies_motion_modal_coordinates_h

#include <fuga/bodies/dynamics/driving_forces.h>
#include <fuga/bodies/motion/modal_basis.h>
#include <fuga/bodies/motion/motion_coordinates.h>

#include <memory>

namespace fuga
{
  /**
   * The momenta ξ of the modes of a ModalBasis, followed by the interface coordinates along the
   * axes of R: a step of any length is a product with small dense matrices.
   *
   * The part of the displacement that is neither a mode nor caused by the interface follows the
   * loads as if it had no inertia. Thus the displacement of all nodes is that of the elastic bodies
   * under the loads, the jumps, and the inertia of the modes; it satisfies their equilibrium.
   */
  template <int dim>
  class ModalCoordinates : public MotionCoordinates
  {
  public:
    /**
     * @p basis is that of the @p model. Model and driving forces must live as long as this object.
     */
    ModalCoordinates(const CondensedSystem<dim> &model,
                     const DrivingForces<dim> &driving,
                     const RayleighDamping &damping,
                     std::shared_ptr<const ModalBasis> basis);

    const Vector &
    mass() const override
    {
      return its_mass;
    }

    Vector
    stiffness_times(const Vector &u) const override;

    Vector
    damping_times(const Vector &v) const override;
    Vector
    head_start(const Vector &velocity) const override
    {
      return velocity;
    }

    Vector
    resistance(const Vector &u, const Vector &v) const override;

    /** Not needed: rigid motions of bodies are not sums of other coordinates here. */
    Vector
    inertia_of_resultants(const Vector &) const override
    {
      return {};
    }

    Vector
    driving_forces(const double time) const override
    {
      return multiply(driving_columns, driving_factors(time));
    }

    Vector
    bar_forces(const Vector &p) const override;

    void
    collect(Vector &) const override
    {
    }

    Vector
    from_nodes(const Vector &velocity) const override;

    Vector
    jumps(const Vector &z) const override
    {
      return multiply(model.jump_operator(), interface_of(z));
    }

    DenseMatrix
    condensed_stiffness(const unsigned int rung, const double a0, const double a1) override;

    Vector
    condense(const unsigned int rung, const Vector &push) override;

    Vector
    expand(const unsigned int rung, const Vector &x) override;

    Vector
    displacement(const MotionState &state) const override;

    Vector
    at_nodes(const Vector &rate) const override;

    void
    watch(const std::vector<unsigned int> &dofs) override;

    Vector
    watched_displacement(const MotionState &state) const override;

    Vector
    watched(const Vector &rate) const override;

    /** Return zero: fields contain parts that follow without inertia. */
    const Vector &
    accelerated_mass() const override
    {
      return no_mass;
    }

    EquilibriumError
    equilibrium_error(const MotionState &state,
                      const Vector &p,
                      const Vector &acting) const override;

    std::string
    description() const override
    {
      return describe(*basis, dim);
    }

  private:
    /** The factors κ = 1 + a1 β and μ = a0 + a1 α by which a step multiplies K and M. */
    struct Factors
    {
      double stiffness = 1., mass = 0.;
    };

    std::size_t
    n_modes() const
    {
      return basis->squares.size();
    }

    /** Convert the coordinates of this object to x, and back. */
    Vector
    interface_of(const Vector &z) const
    {
      return multiply(basis->axes,
                      Vector(z.begin() + static_cast<std::ptrdiff_t>(n_modes()), z.end()));
    }
    Vector
    along_axes(const Vector &x) const
    {
      return multiply_transposed(basis->axes, x);
    }

    /** Return the amplitudes η = ξ - L x of the modes. */
    Vector
    amplitudes(const Vector &z) const;

    /**
     * Return the factors of the loads and of the ground, in the order of the columns of the
     * matrices below.
     */
    Vector
    driving_factors(const double time) const;
    Vector
    driving_field(const std::size_t column) const;

    /**
     * Return the forces on the bodies by nodes at the time of @p state, minus the inertia and
     * damping of the modes.
     */
    Vector
    forces_on_bodies(const MotionState &state) const;

    /** Return the part of the forces that inertia and damping balance. */
    static Vector
    dynamic_forces(const MotionState &state);

    const CondensedSystem<dim> &model;
    const DrivingForces<dim> &driving;
    const RayleighDamping damping;
    const std::shared_ptr<const ModalBasis> basis;
    /** The dual of the jump operator. */
    const SparseOperator dual;
    Vector its_mass, no_mass;
    /** S and L in terms of x along the axes. */
    DenseMatrix stiffness, coupling;
    /**
     * Columns to be multiplied by driving_factors(): forces on the coordinates, and the fields by
     * nodes that follow them without inertia.
     */
    DenseMatrix driving_columns, following_fields;
    std::vector<Factors> factors; // by rung
    Vector pushed;
    /** Watched degrees of freedom, and for each of them a row of Φ and of Ψ. */
    std::vector<unsigned int> watched_dofs;
    DenseMatrix watched_modes, watched_static;
  };
} // namespace fuga

#endif
