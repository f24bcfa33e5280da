// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_cone_stage_h
#define fuga_contact_cone_stage_h

#include <fuga/base/accurate.h>
#include <fuga/contact/contact_boundary.h>
#include <fuga/contact/curved_segment.h>
#include <fuga/contact/released_system.h>

#include <optional>

namespace fuga
{
  /** An element that slips on its cone. */
  struct SlippingElement
  {
    std::size_t element;
    double friction;
  };

  /** The unknowns of all slipping elements at one parameter τ of a segment. */
  struct ConeStage
  {
    /** Slips, two components per element [m], in extended precision: forces are differences of
     * terms as large as the stiffness where rigid joints cross times the longest slip. */
    Accurate slips;
    /** Unit directions e. */
    std::vector<TangentVector> directions;
    /** Bar forces N, T1, T2 of every slipping element [MN]. */
    Vector forces;
  };

  /**
   * The implicit equations of all slipping elements together: along a segment the forces are
   *
   *     p = p0 + τ p1 - K s
   *
   * with K the stiffness without the released bars, and wanted are slips s = s* + ξ e in the
   * directions e of T. With Demand::cone they are such that T + f N e = 0: a return mapping. With
   * Demand::rates the slips ξ e are what flows with the rates at τ while the load goes on by λ:
   * e·q_t + f q_n = 0, q = λ p1 - K ξ e. Unknowns are ξ and the angles of e, so that neither N = 0
   * nor ξ = 0 is a singular point. Solved by Newton's method; the factors are kept as long as they
   * serve.
   */
  class ConeStageSolver
  {
  public:
    enum class Demand
    {
      cone,
      rates
    };

    /** @p at_start, @p rates: the forces of all bars without the slips of @p slipping and without the
     * dislocations of released bars, at τ = 0 and per unit of τ. */
    ConeStageSolver(const std::vector<ContactElement> &elements,
                    const std::vector<SlippingElement> &slipping,
                    const ReleasedSystem &released,
                    const Vector &at_start,
                    const Vector &rates,
                    IterationCount &count);

    /**
     * Finds the stage at @p tau from the slips @p base_slips (s*); @p advance is λ. The directions of @p stage
     * and the lengths @p xi are the first guess and are overwritten. Returns false if there is no
     * solution near by.
     */
    bool
    solve(const Demand demand,
          const double tau,
          const double advance,
          const Accurate &base_slips,
          Vector &xi,
          ConeStage &stage);

    /** K s, the forces that slips take away. */
    Vector
    resistance(const Vector &slips) const;

    /** Rates of slip γ that keep the forces on the cones, e·Ṫ + f Ṅ = 0; nothing if they are not
     * determined. */
    std::optional<Vector>
    slip_rates(const std::vector<TangentVector> &directions) const;

  private:
    /** Residuals, two per element, and the forces that come with the flow, q of Demand::rates. */
    struct Residual
    {
      Vector values;
      Vector flow;
      /** Largest one in units of what rounding leaves. */
      double worst = 0.;
    };

    /** LU factors of the matrix of one demand, and the lengths that belong to a unit turn of each
     * direction in it. */
    struct Factorisation
    {
      std::optional<LuFactors> factors;
      Vector arms;
    };

    /** The slips s*, the forces with them, and what rounding leaves of residuals. */
    struct Base
    {
      Accurate slips;
      Vector forces;
      /** Of the elements. */
      Vector noise;
    };

    Base
    base(const double tau, const Accurate &slips) const;
    Residual
    evaluate(const Demand demand,
             const Base &from,
             const double advance,
             const Vector &xi,
             ConeStage &stage) const;
    void
    factorise(const Demand demand,
              const Vector &xi,
              const ConeStage &stage,
              const Residual &residual);
    static void
    take_step(const Vector &step, const Vector &arms, Vector &xi, ConeStage &stage);

    const std::vector<SlippingElement> slipping;
    IterationCount &count;
    /** 3n x 2n. */
    DenseMatrix K;
    Vector p0, p1;
    /** Stiffness of a tangential bar of each element without released bars: the size of terms. */
    Vector diagonal;
    /** Whether an element has two tangential bars; where it has one, the rows and columns of the
     * second are zero. */
    std::vector<bool> is_plane;
    std::array<Factorisation, 2> factorisations;
  };
} // namespace fuga

#endif
