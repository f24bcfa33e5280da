// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_segments_turning_stage_h
#define fuga_contact_segments_turning_stage_h

#include <fuga/base/numerics/accurate.h>
#include <fuga/base/numerics/secant_factors.h>
#include <fuga/contact/segments/path_options.h>
#include <fuga/contact/tangent_vector.h>

#include <optional>

namespace fuga
{
  /** An element that slips along two tangents, |T| = c - f N, and its strength at one parameter τ.
   */
  struct TurningElement
  {
    std::size_t element = 0;
    /** f, and c: all that does not depend on the pressure [MN]. */
    double friction = 0., cohesion = 0.;
    /** Their rates per unit of τ. */
    double friction_rate = 0., cohesion_rate = 0.;
    /** tan ψ: how fast the lips rise as they slide. */
    double rise = 0.;
  };

  /**
   * The forces of the turning elements near a point of the path, three each (N, T1, T2), as all
   * others answer their slips s and the rise ω of their lips:
   *
   *     p = forces + (τ - τ0) rates - against_slip (s - s0) - against_rise (ω - ω0)
   */
  struct TurningResponse
  {
    double tau = 0.;
    Accurate slips;
    Vector dilations;
    Vector forces, rates;
    /** 3n x 2n, and 3n x n; the latter is empty where no lips rise. */
    DenseMatrix against_slip, against_rise;
  };

  /** The unknowns of all turning elements at one parameter τ of a segment. */
  struct TurningStage
  {
    /** Slips, two components per element [m], in extended precision: forces are differences of
     * terms as large as the stiffness where rigid joints cross times the longest slip. */
    Accurate slips;
    /** Rise of the lips [m]. */
    Vector dilations;
    /** Unit directions e. */
    std::vector<TangentVector> directions;
    /** Bar forces N, T1, T2 of every turning element [MN]. */
    Vector forces;
  };

  /**
   * The implicit equations of all turning elements together. Wanted are slips s = s* + ξ e, with
   * ω = ω* + ξ tan ψ, in the directions e of T. With Demand::cone they are such that
   * T + (f N - c) e = 0: a return mapping. With Demand::rates the slips ξ e are what flows with the
   * rates at τ while the path goes on by λ: e·q_t + f q_n = λ (ċ - ḟ N), with q the change of
   * forces by λ and ξ. Unknowns are ξ and the angles of e, so that neither N = 0 nor ξ = 0 is a
   * singular point. Solved by a quasi-Newton method: factors are kept, for both demands, as long as
   * they serve, and learn from their steps.
   */
  class TurningStageSolver
  {
  public:
    enum class Demand
    {
      cone,
      rates
    };

    /** @p stiffness: of the tangential bars of each element, nothing else moving: the size of terms
     * [MN/m]. */
    TurningStageSolver(const Vector &stiffness, IterationCount &count);

    /** How the forces answer from now on, and the strengths of the elements. */
    void
    set_response(TurningResponse &&response);
    void
    set_strengths(const std::vector<TurningElement> &elements);

    /** The forces of the turning elements at @p tau with the slips and dilations of @p stage. */
    Vector
    forces_at(const double tau, const TurningStage &stage) const;

    /** How fast they grow with τ if nothing slips. */
    const Vector &
    load_rates() const
    {
      return response.rates;
    }

    /**
     * Finds the stage at @p tau from the slips and dilations of @p base (s*, ω*) and the forces with
     * them; @p advance is λ. The directions of @p stage and the lengths @p xi are the first guess
     * and are overwritten. Returns false if there is no solution near by.
     */
    bool
    solve(const Demand demand,
          const double tau,
          const double advance,
          const TurningStage &base,
          Vector &xi,
          TurningStage &stage);

    /** The slips and dilations of @p base and of the lengths @p xi along the directions of
     * @p stage. */
    void
    set_slips(const TurningStage &base, const Vector &xi, TurningStage &stage) const;

    /** The forces that slips and dilations take away. */
    Vector
    resistance(const Vector &slips, const Vector &dilations) const;

    /** Rates of slip γ that keep the forces on the cones, e·Ṫ + f Ṅ = ċ - ḟ N; nothing if they are
     * not determined. */
    std::optional<Vector>
    slip_rates(const TurningStage &stage) const;

  private:
    /** Residuals, two per element, and the forces that come with the flow, q of Demand::rates. */
    struct Residual
    {
      Vector values;
      Vector flow;
      /** Largest one in units of what rounding leaves. */
      double worst = 0.;
    };

    /** Factors of the matrix of one demand, and the lengths that belong to a unit turn of each
     * direction in it. */
    struct Factorisation
    {
      std::optional<SecantFactors> factors;
      Vector arms;
    };

    bool
    iterate(const Demand demand,
            const double tau,
            const double advance,
            const TurningStage &base,
            Vector &xi,
            TurningStage &stage);
    /** What rounding leaves of the residuals of the elements. */
    Vector
    noise(const double tau, const TurningStage &base) const;
    Residual
    evaluate(const Demand demand,
             const TurningStage &base,
             const Vector &noise,
             const double advance,
             const Vector &xi,
             TurningStage &stage) const;
    /** Returns false if it turned directions less than it should. */
    static bool
    take_step(const Vector &step, const Vector &arms, Vector &xi, TurningStage &stage);
    /** Factors for @p demand; those of the other demand serve as well at first. Returns whether they
     * are new. */
    bool
    take_factors(const Demand demand,
                 const double advance,
                 const Vector &xi,
                 const TurningStage &stage,
                 const Residual &residual);
    /** Force number @p row that is lost as element @p j slips by @p slip, its lips rising by
     * @p rise. */
    double
    lost_force(const std::size_t row,
               const std::size_t j,
               const TangentVector &slip,
               const double rise) const;

    const Vector diagonal;
    IterationCount &count;
    TurningResponse response;
    /** Size of the forces that the turning elements would have without their slips. */
    Vector force_sizes;
    std::vector<TurningElement> turning;
    std::array<Factorisation, 2> factorisations;
    /** Turns do more to the slips of others than factors without them could make up for. */
    bool turns_are_coupled = false;
  };
} // namespace fuga

#endif
