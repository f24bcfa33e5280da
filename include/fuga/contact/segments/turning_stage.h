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
    /** f and c, where c contains everything that does not depend on the pressure [MN]. */
    double friction = 0., cohesion = 0.;
    /** Rates of f and c per unit of τ. */
    double friction_rate = 0., cohesion_rate = 0.;
    /** tan ψ: how fast the lips rise as they slide. */
    double rise = 0.;
  };

  /**
   * The forces of the turning elements near a point of the path, three each (N, T1, T2), as all
   * other elements respond to their slips s and the rise ω of their lips:
   *
   *     p = forces + (τ - τ0) rates - against_slip (s - s0) - against_rise (ω - ω0)
   */
  struct TurningResponse
  {
    double tau = 0.;
    Accurate slips;
    Vector dilations;
    Vector forces, rates;
    /** 3n x 2n and 3n x n matrices; the latter is empty where no lips rise. */
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
   * The implicit equations of all turning elements together. They determine slips s = s* + ξ e,
   * with ω = ω* + ξ tan ψ, in the directions e of T. With Demand::cone they are such that T + (f
   * N - c) e = 0: a return mapping. With Demand::rates the slips ξ e are those that flow with the
   * rates at τ while the path goes on by λ: e·q_t + f q_n = λ (ċ - ḟ N), where q is the change of
   * forces by λ and ξ. The unknowns are ξ and the angles of e, so that neither N = 0 nor ξ = 0 is a
   * singular point. They are solved by a quasi-Newton method: factors are kept, for both demands,
   * as long as they are useful, and are updated from its steps.
   */
  class TurningStageSolver
  {
  public:
    enum class Demand
    {
      cone,
      rates
    };

    /** Constructor. @p stiffness is that of the tangential bars of each element while nothing else
     * moves, which gives the size of terms [MN/m]. */
    TurningStageSolver(const Vector &stiffness, IterationCount &count);

    /** Set the response of the forces from now on; set_strengths() sets the strengths of the
     * elements. */
    void
    set_response(TurningResponse &&response);
    void
    set_strengths(const std::vector<TurningElement> &elements);

    /** Return the forces of the turning elements at @p tau with the slips and dilations of
     * @p stage. */
    Vector
    forces_at(const double tau, const TurningStage &stage) const;

    /** Return the rates at which they grow with τ if nothing slips. */
    const Vector &
    load_rates() const
    {
      return response.rates;
    }

    /**
     * Find the stage at @p tau from the slips and dilations of @p base (s*, ω*) and the forces with
     * them; @p advance is λ. The directions of @p stage and the lengths @p xi are the first guess
     * and are overwritten. Return false if there is no solution near by.
     */
    bool
    solve(const Demand demand,
          const double tau,
          const double advance,
          const TurningStage &base,
          Vector &xi,
          TurningStage &stage);

    /** Set the slips and dilations to those of @p base plus the lengths @p xi along the directions
     * of @p stage. */
    void
    set_slips(const TurningStage &base, const Vector &xi, TurningStage &stage) const;

    /** Return the forces that slips and dilations take away. */
    Vector
    resistance(const Vector &slips, const Vector &dilations) const;

    /** Return the rates of slip γ that keep the forces on the cones, e·Ṫ + f Ṅ = ċ - ḟ N; nothing
     * if they are not determined. */
    std::optional<Vector>
    slip_rates(const TurningStage &stage) const;

  private:
    /** Residuals, two per element, and the forces that belong to the flow, q of Demand::rates. */
    struct Residual
    {
      Vector values;
      Vector flow;
      /** Largest residual in units of the error that rounding leaves. */
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
    /** Return the error that rounding leaves in the residuals of the elements. */
    Vector
    noise(const double tau, const TurningStage &base) const;
    Residual
    evaluate(const Demand demand,
             const TurningStage &base,
             const Vector &noise,
             const double advance,
             const Vector &xi,
             TurningStage &stage) const;
    /** Take a step. Return false if it turned directions less than it should. */
    static bool
    take_step(const Vector &step, const Vector &arms, Vector &xi, TurningStage &stage);
    /** Set the factors for @p demand; those of the other demand are sufficient at first. Return
     * whether they are new. */
    bool
    take_factors(const Demand demand,
                 const double advance,
                 const Vector &xi,
                 const TurningStage &stage,
                 const Residual &residual);
    /** Return the forces that are lost as element @p j slips by @p slip while its lips rise by
     * @p rise. */
    Vector
    lost_forces(const std::size_t j, const TangentVector &slip, const double rise) const;

    const Vector diagonal;
    IterationCount &count;
    TurningResponse response;
    /** Sizes of the forces that the turning elements would have without their slips. */
    Vector force_sizes;
    std::vector<TurningElement> turning;
    std::array<Factorisation, 2> factorisations;
    /** True if turns affect the slips of others by more than factors without them could
     * compensate. */
    bool turns_are_coupled = false;
  };
} // namespace fuga

#endif
