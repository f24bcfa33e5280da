// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_judges_judge_problem_h
#define fuga_tests_judges_judge_problem_h

#include "judges/envelope.h"

#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/laws/contact_state.h>

#include <vector>

/**
 * The independent judges: slow, plain solvers of the same mathematical problem, written from its
 * statement alone. They share no code with fuga_laws or fuga_contact; of the library they use the
 * two types Vector and DenseMatrix and the enumeration ContactState, nothing that computes.
 */
namespace fuga::judges
{
  /** The data of one contact element. */
  struct JudgeElement
  {
    static constexpr unsigned int no_bar = static_cast<unsigned int>(-1);

    unsigned int normal_bar = no_bar;
    /** no_bar for an element without tangential bar. */
    unsigned int tangential_bar = no_bar;
    /** A > 0. */
    double area = 1.;
    /** g0; the gap is g = g0 + δ_n. */
    double initial_gap = 0.;
    /** ρn ≥ 0, 0 = rigid. With law (9) its ρ0 > 0. */
    double normal_compliance = 0.;
    /** ρt ≥ 0, 0 = rigid. The shear layer is always linear here. */
    double shear_compliance = 0.;
    /** f. */
    double friction = 0.;
    Envelope envelope;
    /** c, a stress: |T| ≤ f|N| + cA while closed. */
    double cohesion = 0.;
    /** ζ0 > 0 makes the normal layer law (9) of the paper, 0 a linear (or rigid) one. */
    double layer_thickness = 0.;

    bool
    has_tangential_bar() const
    {
      return tangential_bar != no_bar;
    }

    bool
    has_nonlinear_layer() const
    {
      return layer_thickness > 0.;
    }

    /** The largest shear while closed under a pressing force P ≥ 0, with its bond or without. */
    double
    strength(const double P, const bool bonded = true) const
    {
      return friction * envelope.force(area, P) + (bonded ? cohesion * area : 0.);
    }
  };

  /**
   *     S x + Bᵀ p = f,   δ = B x,
   * p = (N, T) tension positive, δ opening positive. Every bar belongs to exactly one element.
   */
  struct JudgeProblem
  {
    /** Symmetric positive semidefinite, may be zero. */
    DenseMatrix S;
    /** Jump operator, n_bars x n_coordinates; empty = identity. */
    DenseMatrix B;
    std::vector<JudgeElement> elements;

    std::size_t
    n_coordinates() const
    {
      return S.rows();
    }

    std::size_t
    n_bars() const
    {
      return B.size() == 0 ? S.rows() : B.rows();
    }

    double
    jump_operator(const std::size_t bar, const std::size_t coordinate) const
    {
      return B.size() == 0 ? (bar == coordinate ? 1. : 0.) : B(bar, coordinate);
    }

    /** δ = B x. */
    Vector
    jumps(const Vector &x) const;
  };

  /** Throws std::invalid_argument on wrong sizes, a bar without element or with two, A ≤ 0 ... */
  void
  validate(const JudgeProblem &problem);

  /** The state at the end of one implicit load increment. */
  struct StepSolution
  {
    Vector x;
    /** δ and p, by bar. */
    Vector jumps;
    Vector forces;
    /** By element: the gap g = g0 + δ_n, and s (0 without tangential bar). */
    Vector gap;
    Vector slip;
    std::vector<ContactState> states;
    /** step_residual(). */
    double residual = 0.;
    /** What "relative" refers to: the largest force (load included) and the largest length. */
    double force_scale  = 0.;
    double length_scale = 0.;
    /** The scheme is singular; this is its solution of least norm, one of a family. */
    bool family = false;
  };

  /**
   * How far (x, p, s) is from solving the implicit step with the slip @p slip_before at its start
   * and the load @p load at its end. It looks at the three arguments only, not at states, and
   * returns the largest of
   *  - |S x + Bᵀ p - f| over the largest term of that equation (a normwise backward error);
   *  - min-type violations of every sign, law, cone, complementarity and slip direction, forces
   * over the largest force (load included), lengths over the largest length (jump, slip, gap).
   */
  double
  step_residual(const JudgeProblem &problem,
                const Vector &slip_before,
                const Vector &load,
                const Vector &x,
                const Vector &forces,
                const Vector &slip);

  /** Fills jumps, gap, scales and residual of @p solution from its x, forces and slip. */
  void
  complete(const JudgeProblem &problem,
           const Vector &slip_before,
           const Vector &load,
           StepSolution &solution);

  /** Slip s = 0 in every element: the virgin state. */
  Vector
  no_slip(const JudgeProblem &problem);

  /** The largest difference of forces and of jumps, relative to the scales of the solutions. */
  double
  distance(const StepSolution &a, const StepSolution &b);

  /** Law (9), σ = w/[ρ0(1-q)], q = (w/ζ0)^{1/3}: stress of a closure w in [0, ζ0). */
  double
  cubic_root_stress(const double rho0, const double zeta0, const double w);

  /** Law (9): dσ/dw. */
  double
  cubic_root_tangent(const double rho0, const double zeta0, const double w);

  /** Law (9): the closure of a stress ≥ 0, from the root in (0, 1) of q³ + κq - κ = 0, κ = ρ0σ/ζ0.
   */
  double
  cubic_root_closure(const double rho0, const double zeta0, const double sigma);
} // namespace fuga::judges

#endif
