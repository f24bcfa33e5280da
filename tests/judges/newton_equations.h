// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_judges_newton_equations_h
#define fuga_tests_judges_newton_equations_h

#include "judges/dislocation_form.h"

namespace fuga::judges
{
  /**
   * The semismooth equations F(y) = 0 of semismooth_newton_step(); y by bar: a or, with law (9), g
   * in the normal bars, s in the tangential ones. All entries of F are forces.
   */
  class NewtonEquations
  {
  public:
    NewtonEquations(const JudgeProblem &problem,
                    const Vector &slip_before,
                    const Vector &load_before,
                    const Vector &load);

    /** Nothing loaded: the initial gaps and the slips before. */
    Vector
    start() const;

    /** d(y) and its derivative, which is diagonal. */
    void
    dislocations(const Vector &y, Vector &d, Vector &slope) const;

    /** p(d) at the load part load_part. */
    Vector
    forces(const Vector &d) const;

    /** F(y), and its Jacobian (zero on entry) if the pointer is not null. */
    Vector
    evaluate(const Vector &y, DenseMatrix *const jacobian) const;

    /** Largest part of the step @p dy that leaves every law 0.1 of its remaining distance. */
    double
    permitted_part(const Vector &y, const Vector &dy) const;

    /** (x, p, s) and names of states from y, at the full load. */
    StepSolution
    solution(const Vector &y, const Vector &load) const;

    const JudgeProblem &problem;
    const Vector slip_before;
    const DislocationForm form;
    /** Diagonal of W. */
    const Vector stiffness;
    /** Homotopy parameters: way from the load before to the load; factor of f and c. */
    double load_part     = 1.;
    double friction_part = 1.;
    /** Factor of c_n and c_t. */
    double scale = 1.;
  };
} // namespace fuga::judges

#endif
