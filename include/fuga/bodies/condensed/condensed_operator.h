// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_condensed_condensed_operator_h
#define fuga_bodies_condensed_condensed_operator_h

#include <fuga/base/numerics/sparse_operator.h>
#include <fuga/bodies/condensed/body_model.h>
#include <fuga/bodies/solvers/bodies_work.h>
#include <fuga/bodies/solvers/interior_solver.h>
#include <fuga/bodies/solvers/rigid_projection.h>
#include <fuga/contact/system/tangent_solver.h>

#include <optional>

namespace fuga
{
  class IterativeSolver;


  /**
   * The result of eliminating everything but the jumps of the joints from a body model by one
   * partial factorisation: the stiffness S of the jumps, the loads condensed to them, and the
   * recovery of the displacements. The processes of a run share the work (doc/parallel.md); each of
   * them has the whole result.
   */
  template <int dim>
  class CondensedOperator
  {
  public:
    /** Lines about sizes and solver are added to the report of @p model. */
    explicit CondensedOperator(BodyModel<dim> &model);

    ~CondensedOperator();

    /** Assemble and factorise. @throws NumericalFailure */
    void
    factorise();

    bool
    is_factorised() const
    {
      return solver != nullptr;
    }

    bool
    has_stiffness() const
    {
      return is_factorised() && used_solver != BodySolver::matrix_free;
    }

    const DenseMatrix &
    stiffness() const
    {
      return S;
    }

    /** Return the jumps of the bars in the rigid motions of the bodies that can move freely. */
    const DenseMatrix &
    rigid_motions() const
    {
      return motions;
    }

    /** Return the interface coordinates of these motions. */
    const DenseMatrix &
    rigid_coordinates() const
    {
      return motion_coordinates;
    }

    /** Return the amounts of the motions closest to given interface coordinates. */
    Vector
    motion_of(const Vector &x) const
    {
      return projection->motion_of(x);
    }

    /** Return S x. Like solve_with_bars(), this function is used if S is not known. */
    Vector
    resistance(const Vector &x) const;

    /**
     * Return S⁻¹ f, without motions of the bodies and work on them; empty if S is not known, or
     * singular apart from these motions.
     */
    Vector
    coordinates_under(Vector f) const;

    /** See TangentSolver::stiffness_of_lips(). */
    Vector
    stiffness_of_lips() const;

    /** See TangentSolver::refine(). */
    void
    refine(TangentSolver::Solution &solution) const;

    TangentSolver::Solution
    solve_with_bars(const std::vector<ElementStiffness> &bars,
                    const Vector &r,
                    const TangentSolver::Solution &so_far,
                    const double tolerance) const;

    /**
     * Return the condensed loads of the patterns, by columns; @p motion_loads is their work on the
     * motions.
     */
    DenseMatrix
    condense(const std::vector<LoadPattern> &patterns, const DenseMatrix &motion_loads) const;

    /** Return the condensed loads of coordinate loads, which are overwritten. */
    DenseMatrix
    condense(DenseMatrix &loads, const DenseMatrix &motion_loads) const;

    /**
     * Add the response to the residual forces under @p loads to u, with the jumps unchanged. Both
     * vectors are by nodes.
     */
    void
    add_bonded_response(const Vector &loads, Vector &u) const;

    /**
     * Replace columns of nodal forces by the displacements that they cause, with the jumps
     * unchanged and without refinement.
     */
    void
    solve_bonded(DenseMatrix &columns) const;

    /** Return the work done so far; none before factorise(). */
    BodiesWork
    work() const;

  private:
    void
    eliminate();

    void
    report_sizes(const SymmetricTriplets &matrix);

    void
    choose_solver(SymmetricTriplets &matrix);

    void
    check_stiffness();

    DenseMatrix
    stiffness_by_displacements() const;

    void
    remove_rounding();

    void
    find_rigid_motions();

    DenseMatrix
    loads_out_of_balance(const std::vector<LoadPattern> &patterns) const;

    /**
     * Return the eliminated coordinates in the rigid motion closest to these jumps; empty if the
     * bodies have no motions.
     */
    Vector
    interior_of_motion(const Vector &jumps) const;

    /** Return S x by columns, computed from the displacements that the jumps x cause. */
    DenseMatrix
    resistance_of_bodies(const DenseMatrix &x) const;

    /** Add the bonded response to the residual forces under its loads to every u. */
    void
    solve_bonded(const std::vector<Vector> &loads,
                 std::vector<Vector> &u,
                 const InteriorSolver::Digits digits) const;

    /** Do the same twice: the second solution refines the first one. */
    void
    solve_to_rounding(const std::vector<Vector> &loads, std::vector<Vector> &u) const;

    /** Number of columns solved in one pass over the factors. */
    static constexpr std::size_t at_once = 16;

    BodyModel<dim> &model;
    std::unique_ptr<InteriorSolver> solver;
    /** Points to `solver` if S is not known, otherwise null. */
    IterativeSolver *matrix_free_solver = nullptr;
    std::unique_ptr<RigidProjection> projection;
    BodySolver used_solver = BodySolver::direct;
    /** The estimate from which the solver was chosen; only if the program had to choose. */
    std::optional<SolverEstimate> estimate;
    /** Diagonal of K in the interface coordinates [MN/m]. */
    Vector lips;
    /** The dual of the jump operator. */
    SparseOperator dual;
    DenseMatrix S, motions, motion_coordinates;
  };
} // namespace fuga

#endif
