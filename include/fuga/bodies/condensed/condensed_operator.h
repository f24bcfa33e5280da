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
   * Everything but the jumps of the joints eliminated from a body model by one partial
   * factorisation: the stiffness S of the jumps, the loads condensed to them, and the way back to
   * the displacements. The processes of a run share the work (doc/parallel.md); every one has the
   * whole result.
   */
  template <int dim>
  class CondensedOperator
  {
  public:
    /** Lines about sizes and solver are added to the report of @p model. */
    explicit CondensedOperator(BodyModel<dim> &model);

    ~CondensedOperator();

    /** Assembles and factorises. @throws NumericalFailure */
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

    /** Jumps of the bars in the rigid motions of the bodies that can move freely. */
    const DenseMatrix &
    rigid_motions() const
    {
      return motions;
    }

    /** The interface coordinates of these motions. */
    const DenseMatrix &
    rigid_coordinates() const
    {
      return motion_coordinates;
    }

    /** Amounts of the motions nearest to given interface coordinates. */
    Vector
    motion_of(const Vector &x) const
    {
      return projection->motion_of(x);
    }

    /** S x and solutions with bars where S is not known. */
    Vector
    resistance(const Vector &x) const;

    /** S⁻¹ f, without motions of the bodies and work on them; empty if S is not known or singular
     * besides. */
    Vector
    coordinates_under(Vector f) const;

    /** TangentSolver::stiffness_of_lips(). */
    Vector
    stiffness_of_lips() const;

    /** TangentSolver::refine(). */
    void
    refine(TangentSolver::Solution &solution) const;

    TangentSolver::Solution
    solve_with_bars(const std::vector<ElementStiffness> &bars,
                    const Vector &r,
                    const TangentSolver::Solution &so_far,
                    const double tolerance) const;

    /** Condensed loads of the patterns, by columns; @p motion_loads: their work on the motions. */
    DenseMatrix
    condense(const std::vector<LoadPattern> &patterns, const DenseMatrix &motion_loads) const;

    /** The same of coordinate loads, which are overwritten. */
    DenseMatrix
    condense(DenseMatrix &loads, const DenseMatrix &motion_loads) const;

    /** Adds to u the response to what is out of balance under @p loads, with the jumps as they are.
     * Both by nodes. */
    void
    add_bonded_response(const Vector &loads, Vector &u) const;

    /** Columns of nodal forces become those of the displacements under them, with the jumps as they
     * are and without refinement. */
    void
    solve_bonded(DenseMatrix &columns) const;

    /** None before factorise(). */
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

    /** What a motion of the bodies with these jumps does inside; empty if they have no motions. */
    Vector
    interior_of_motion(const Vector &jumps) const;

    /** S x by columns, from the displacements that the jumps x cause. */
    DenseMatrix
    resistance_of_bodies(const DenseMatrix &x) const;

    /** Adds to every u the bonded response to what is out of balance under its loads. */
    void
    solve_bonded(const std::vector<Vector> &loads,
                 std::vector<Vector> &u,
                 const InteriorSolver::Digits digits) const;

    /** Columns for which one pass over the factors serves. */
    static constexpr std::size_t at_once = 16;

    BodyModel<dim> &model;
    std::unique_ptr<InteriorSolver> solver;
    /** The same solver if S is not known. */
    IterativeSolver *matrix_free_solver = nullptr;
    std::unique_ptr<RigidProjection> projection;
    BodySolver used_solver = BodySolver::direct;
    /** If the program had to choose. */
    std::optional<SolverEstimate> estimate;
    /** Diagonal of K in the interface coordinates [MN/m]. */
    Vector lips;
    /** Of the jump operator. */
    SparseOperator dual;
    DenseMatrix S, motions, motion_coordinates;
  };
} // namespace fuga

#endif
