// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_condensed_condensed_system_h
#define fuga_bodies_condensed_condensed_system_h

#include <fuga/bodies/condensed/condensed_operator.h>
#include <fuga/bodies/condensed/linear_response.h>
#include <fuga/contact/contact_system.h>

namespace fuga
{
  template <int dim>
  class JointWaterModel;


  /** The time at which the bodies are factorised, which is the expensive part. */
  enum class Condensation
  {
    at_once,
    /**
     * By set_load_patterns(), so that an error in loads or joints is found before anything is
     * computed.
     */
    with_loads,
    /** Not at all: the input is checked and nothing is computed. */
    never
  };

  /**
   * The finite element model as the contact layer sees it: the condensed operator with the present
   * load patterns, and the fields that belong to its states. If supports are released it is not
   * condensed, since then the operator of the steps applies (BodiesInMotion), and the bodies need
   * no supports.
   */
  template <int dim>
  class CondensedSystem : public BodyModel<dim>, public ContactSystem, public TangentSolver
  {
  public:
    /**
     * Create the body model and, if requested, factorise it.
     * @throws InputError, NumericalFailure
     */
    CondensedSystem(const JointedMesh &mesh,
                    const ModelDefinition &model,
                    const std::vector<bool> &frictionless,
                    const Condensation condensation = Condensation::at_once,
                    const unsigned int stage        = 0);

    ~CondensedSystem() override;

    const DenseMatrix &
    stiffness() const override
    {
      return condensed.stiffness();
    }

    bool
    has_stiffness() const override
    {
      return condensed.has_stiffness();
    }

    Vector
    resistance(const Vector &x) const override
    {
      return condensed.resistance(x);
    }

    Vector
    stiffness_of_lips() const override
    {
      return condensed.stiffness_of_lips();
    }

    void
    refine(Solution &solution) const override
    {
      condensed.refine(solution);
    }

    Solution
    solve_with_bars(const std::vector<ElementStiffness> &of_elements,
                    const Vector &r,
                    const Solution &so_far,
                    const double tolerance) const override
    {
      return condensed.solve_with_bars(of_elements, r, so_far, tolerance);
    }

    unsigned int
    n_coordinates() const;

    const DenseMatrix &
    load_patterns() const override
    {
      return F;
    }

    const SparseOperator &
    jump_operator() const override;

    const DenseMatrix &
    imposed_jumps() const override
    {
      return E;
    }

    const DenseMatrix &
    rigid_motions() const override
    {
      return condensed.rigid_motions();
    }

    const DenseMatrix &
    rigid_coordinates() const override
    {
      return condensed.rigid_coordinates();
    }

    const DenseMatrix &
    rigid_motion_loads() const override
    {
      return motion_loads;
    }

    const WaterInJoints *
    water_in_joints() const override;

    /**
     * Return the forces of water in the closed joint: n_bars x n_patterns [MN]; empty without
     * water.
     */
    const DenseMatrix &
    closed_water() const
    {
      return water_of_closed;
    }

    /** Condense the patterns; they are kept for recover() and equilibrium_error(). */
    void
    set_load_patterns(std::vector<LoadPattern> patterns);

    /**
     * Declare that pattern @p number is the load left by an earlier phase of construction, and that
     * the bars feel @p jumps of it. To be called after set_load_patterns().
     */
    void
    set_carried_load(const std::size_t number, const Vector &jumps);

    const Vector &
    carried_load() const override
    {
      return carried;
    }

    /** Set the displacements at which bodies built later are free of stress. */
    void
    set_stress_free_shapes(std::vector<StressFreeShape> new_shapes)
    {
      shapes = std::move(new_shapes);
    }

    const std::vector<StressFreeShape> &
    stress_free_shapes() const
    {
      return shapes;
    }

    /**
     * Return the displacement that strains the bodies built in @p stage: a displacement of all
     * degrees of freedom minus the shape in which these bodies are free of stress.
     */
    template <typename VectorType>
    VectorType
    straining(VectorType displacement, const unsigned int stage) const
    {
      for (const StressFreeShape &shape : shapes)
        if (shape.stage == stage)
          for (std::size_t i = 0; i < shape.dofs.size(); ++i)
            displacement[static_cast<unsigned int>(shape.dofs[i])] -= shape.displacements[i];
      return displacement;
    }

    /**
     * Return the work of nodal forces (entry node * dim + component) on the shape of bodies built
     * in @p stage.
     */
    double
    stress_free_value(const Vector &force, const unsigned int stage) const;

    /**
     * Return the displacement of all degrees of freedom for load factors @p a and interface
     * coordinates @p x.
     */
    dealii::Vector<double>
    recover(const Vector &a, const Vector &x) const;

    /**
     * Return the nodal forces of the load patterns with the factors @p a; empty if there are none.
     */
    Vector
    applied_forces(const Vector &a) const
    {
      return combination(a, &LoadPattern::forces);
    }

    /**
     * Return the displacement under nodal forces (entry node * dim + component; empty: none) and
     * interface coordinates (empty: zero), without supports that move.
     */
    dealii::Vector<double>
    bonded_field(const Vector &forces, const Vector &x) const;

    /** Return this displacement by nodes. */
    Vector
    bonded_field_by_nodes(const Vector &forces, const Vector &x) const;

    /**
     * Replace columns of nodal forces by the displacements that they cause, with the jumps
     * unchanged and without refinement.
     */
    void
    solve_bonded(DenseMatrix &columns) const
    {
      condensed.solve_bonded(columns);
    }

    /**
     * Return the work of the nodal forces @p force (entry node * dim + component) on the
     * displacement, for any x and a: the result that recover() would give, without recovering
     * (doc/theory.md, section 1).
     */
    LinearResponse
    response(const Vector &force) const;

    /**
     * Interface coordinates, split into a rigid motion of the bodies that can move freely and the
     * rest.
     */
    struct RigidPart
    {
      /** Displacement of all degrees of freedom in the rigid motion closest to the coordinates. */
      dealii::Vector<double> motion;
      /** Coordinates without that motion. */
      Vector remainder;
    };

    /**
     * Split interface coordinates: a body held by soft joints moves by far more than it deforms,
     * and recover() of the remainder alone keeps the digits of the deformation.
     */
    RigidPart
    rigid_part(const Vector &x) const;

    /**
     * Return the errors of the full model for displacement u, bar forces p and load factors a.
     * @p motion is a rigid motion that was subtracted from u, up to whose last digits the jumps are
     * uncertain.
     */
    EquilibriumError
    equilibrium_error(const dealii::Vector<double> &u,
                      const Vector &p,
                      const Vector &a,
                      const dealii::Vector<double> &motion = {}) const;

    /**
     * Move the lips of @p u to the position where K u balances the bar forces @p p and the loads. S
     * and the stiffness of the full model differ by the rounding of the elimination, which may
     * leave the lips out of balance by more than the rounding of their displacements. Return the
     * largest jump by which they moved.
     */
    double
    balance_lips(const Vector &p, const Vector &a, dealii::Vector<double> &u) const;

    BodiesWork
    work() const;

  private:
    Vector
    combination(const Vector &a, const Vector LoadPattern::*part) const;

    CondensedOperator<dim> condensed;
    DenseMatrix F, E, motion_loads, water_of_closed;
    std::unique_ptr<JointWaterModel<dim>> water;
    std::vector<LoadPattern> patterns;
    Vector carried;
    std::vector<StressFreeShape> shapes;
    mutable std::size_t n_recovered_fields = 0;
  };
} // namespace fuga

#endif
