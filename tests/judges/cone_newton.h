// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_judges_cone_newton_h
#define fuga_tests_judges_cone_newton_h

#include "judges/dislocation_form.h"

namespace fuga::judges
{
  /** A contact element in space: linear or rigid layer, Coulomb's circular cone. */
  struct ConeElement
  {
    unsigned int normal_bar = 0;
    /** None without friction; one where supports leave one tangent. */
    std::vector<unsigned int> tangential_bars;
    double area              = 1.;
    double initial_gap       = 0.;
    double normal_compliance = 0.;
    double shear_compliance  = 0.;
    double friction          = 0.;
  };

  /** The state at the end of one implicit load increment, by bar: forces p, openings a and slips s.
   */
  struct ConeState
  {
    Vector forces, dislocations;
  };

  struct ConeStep
  {
    bool converged = false;
    ConeState state;
  };

  /**
   * Contact with circular cones by a semismooth Newton method after Alart and Curnier, in the
   * dislocation form p = R - W d (see DislocationForm; d_n = a - g0, d_t = s):
   *
   *     N - min(0, N + c_n a) = 0,     T - proj_r(T + c_t (s - s_before)) = 0,     r = f P,
   *
   * with the projection onto the disc of radius r, P = -min(0, N + c_n a) the pressing force, and
   * c from the diagonal of W.
   */
  class ConeNewton
  {
  public:
    /** @p S, @p B, @p load_patterns as in ContactSystem. */
    ConeNewton(const DenseMatrix &S,
               const DenseMatrix &B,
               const DenseMatrix &load_patterns,
               std::vector<ConeElement> elements);

    /** Whether the bodies are held when all joints are closed, and no bars repeat each other. */
    bool
    is_regular() const
    {
      return form.regular;
    }

    /** One implicit step from the slips @p before to the loads with @p factors; @p factors_before
     * are those of a homotopy's beginning. */
    ConeStep
    step(const Vector &before, const Vector &factors_before, const Vector &factors) const;

    /**
     * How far a state is from satisfying equilibrium, signs, complementarity, cone and "slip only
     * at the strength", and slip not against the force; relative to the largest force and length.
     * The direction of slip is not looked at: along a path on which it turns it is not that of an
     * implicit step.
     */
    double
    residual(const Vector &before, const Vector &factors, const ConeState &state) const;

    /** Largest difference of forces and of dislocations, relative to the largest ones. */
    double
    distance(const ConeState &a, const ConeState &b, const Vector &factors) const;

  private:
    Vector
    reactions(const Vector &factors) const;
    Vector
    forces(const Vector &R, const Vector &y) const;
    Vector
    evaluate(const Vector &R, const Vector &before, const Vector &y, DenseMatrix *jacobian) const;
    bool
    newton(const Vector &R, const Vector &before, Vector &y) const;
    double
    size(const Vector &R, const Vector &p, const Vector &y) const;

    const std::vector<ConeElement> elements;
    const DislocationForm form;
    const Vector stiffness;
    /** g0 in the normal bars. */
    Vector gaps;
    /** Factor of c. */
    mutable double scale = 1.;
  };
} // namespace fuga::judges

#endif
