// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_judges_cone_newton_h
#define fuga_tests_judges_cone_newton_h

#include "judges/dislocation_form.h"
#include "judges/envelope.h"

#include <functional>
#include <limits>

namespace fuga::judges
{
  /** A contact element in space: linear or rigid layer, or one that closes along a curve;
   * Coulomb's circular cone. */
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
    Envelope envelope;
    /** c A. */
    double cohesion = 0.;
    /** Of a curved layer: σ(w) and dσ/dw of a closure w, the first slope of which is
     * 1/normal_compliance, and the closure that no stress reaches. */
    std::function<double(double)> stress, tangent;
    double closure_limit = std::numeric_limits<double>::infinity();

    bool
    is_curved() const
    {
      return stress != nullptr;
    }

    /** The largest shear while closed under a pressing force P ≥ 0, with its bond or without. */
    double
    strength(const double P, const bool bonded = true) const
    {
      return friction * envelope.force(area, P) + (bonded ? cohesion : 0.);
    }
  };

  /** The state at the end of one implicit load increment, by bar: forces p, openings a (less than
   * zero where a curved layer has closed) and slips s. */
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
   *     N - min(0, N + c_n a) = 0,     T - proj_r(T + c_t (s - s_before)) = 0,     r = f P + c A,
   *
   * with the projection onto the disc of radius r, P = -min(0, N + c_n a) the pressing force, and
   * c from the diagonal of W; without c A where the joint is open. Curved layers as in
   * NewtonEquations: N + P = 0, P = A σ(-a), d_n = a - g0 + ρ σ(-a) where a < 0.
   */
  class ConeNewton
  {
  public:
    /** @p S, @p B, @p load_patterns as in ContactSystem. */
    ConeNewton(const DenseMatrix &S,
               const DenseMatrix &B,
               const DenseMatrix &load_patterns,
               std::vector<ConeElement> elements);

    /** The same bodies and layers with gaps and strengths of others. */
    ConeNewton
    with(std::vector<ConeElement> others) const;

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
    /** d of the unknowns y, and its derivative. */
    Vector
    dislocations(const Vector &y, Vector &slope) const;
    Vector
    forces(const Vector &R, const Vector &y) const;
    Vector
    evaluate(const Vector &R, const Vector &before, const Vector &y, DenseMatrix *jacobian) const;
    bool
    newton(const Vector &R, const Vector &before, Vector &y) const;
    /** Gaps included. */
    double
    largest_length(const std::vector<Vector> &lengths) const;
    double
    permitted_part(const Vector &y, const Vector &dy) const;
    double
    size(const Vector &R, const Vector &p, const Vector &y) const;

    std::vector<ConeElement> elements;
    DislocationForm form;
    Vector stiffness;
    /** Factor of c. */
    mutable double scale = 1.;
  };
} // namespace fuga::judges

#endif
