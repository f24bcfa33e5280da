// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_path_matrix_free_path_h
#define fuga_contact_path_matrix_free_path_h

#include <fuga/contact/element/augmented_layers.h>
#include <fuga/contact/path/contact_path.h>
#include <fuga/contact/system/tangent_solver.h>

namespace fuga
{
  /**
   * The path computed in implicit steps, from one corner of the loads or requested level to the
   * next, for bodies whose stiffness S is not known as a matrix. Forces are functions of the jumps
   * (ReturnMapping; those of rigid layers by AugmentedLayers), so
   *
   *     S x + p(x) = F a(t)
   *
   * is solved by a semismooth Newton method, in which each step is one solution of the bodies with
   * the bars in their present scheme (doc/theory.md, section 18); p = Bᵀ(p(B x) - ω) where joints
   * cross and water presses them apart. Water follows the elements that are open at the end of a
   * step. Energies and events are not known.
   */
  class MatrixFreePath : public ContactPath
  {
  public:
    /** Constructor. Only the bars of @p system are used. */
    MatrixFreePath(const std::vector<ContactElement> &elements,
                   const LayeredSystem &system,
                   const ContactSystem &bodies,
                   const TangentSolver &solver,
                   const LoadHistory &history);

    SchemeWork
    work() const override
    {
      return scheme_work;
    }

  private:
    PathResult
    follow(const std::vector<double> &levels, ReportCounter &observer) override;

    /** The solution of the bodies, and the response of the elements to their jumps. */
    struct Trial
    {
      TangentSolver::Solution bodies;
      Vector forces, residual;
      std::vector<ContactState> states;
      std::vector<ElementStiffness> tangents;
      Vector dilations;
    };

    /** Return the jumps that the joints feel, with those of rigid layers enlarged. */
    Vector
    jumps(const double t, const Trial &trial) const;
    void
    evaluate(const JointState &from, const double t, Trial &trial) const;
    Trial
    line_search(const JointState &from,
                const double t,
                const Trial &at,
                const TangentSolver::Solution &step,
                const double largest_growth) const;
    /** @throws NumericalFailure */
    JointState
    step_to(const JointState &from, const double t);
    /** Return the end of a step from @p from, with @p trial as the initial guess; nothing if it is
     * not found. */
    std::optional<JointState>
    end_of_step(JointState from, const double t, Trial &trial);
    /** Return the joints with the effects of the water at the end of a step that has led to
     * @p state. */
    JointState
    let_water_in(JointState state, PathObserver &observer, PathResult &result);
    /** Bring @p trial into equilibrium with the strengths of @p from. Return false if no
     * equilibrium is found. */
    bool
    find_equilibrium(const JointState &from, const double t, Trial &trial);
    JointState
    state_of(const JointState &from, const double t, const Trial &trial) const;
    Vector
    imposed_jumps(const double t) const;

    const ContactSystem &bodies;
    const TangentSolver &solver;
    const std::size_t n_bars;
    /** The dual of the jump operator. */
    const SparseOperator dual;
    AugmentedLayers layers;
    SchemeWork scheme_work;
  };
} // namespace fuga

#endif
