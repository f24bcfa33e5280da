// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_system_layered_system_h
#define fuga_contact_system_layered_system_h

#include <fuga/contact/contact_element.h>
#include <fuga/contact/contact_system.h>
#include <fuga/contact/system/rigid_basis.h>

#include <limits>
#include <optional>

namespace fuga
{
  /** A state whose forces are as exact as they can be, from which those of states near by differ by
   * little. */
  struct KnownForces
  {
    Vector factors, dislocations, water, forces;
  };

  /**
   * Bodies and layer in series. Every bar's jump is split into an elastic part and a *dislocation*
   * d,
   *
   *     δ = d + D p,    D = ρ/A, ρ the ComplianceLaw::reference_compliance(),
   *
   * and the bodies are eliminated:
   *
   *     p = R a(t) - W d.                                                   (doc/theory.md, eq. 4)
   *
   * W, symmetric positive semidefinite, is the stiffness against an imposed dislocation; R gives
   * the bar forces of the fully closed and sticking joint. W exists for every compliance from zero
   * (W = S) to infinity (W = 0) and for bodies that only their joints hold, so neither a rigid
   * joint nor a floating body is a special case. The dislocation is the opening, the slip, and what
   * a nonlinear layer deforms more or less than D p; a bar that does none of this is
   * never touched.
   */
  class LayeredSystem
  {
  public:
    /** @p system must live as long as this object. */
    LayeredSystem(const ContactSystem &system, const std::vector<ContactElement> &elements);

    std::size_t
    n_bars() const
    {
      return compliances.size();
    }

    /** The bodies, and what acts on them. */
    const ContactSystem &
    contact_system() const
    {
      return bodies;
    }

    /** W [MN/m]. */
    const DenseMatrix &
    stiffness() const
    {
      return W;
    }

    /** Largest diagonal entry of W [MN/m]. */
    double
    largest_stiffness() const
    {
      return largest;
    }

    /**
     * √W_ii, but for what is only rounding [√(MN/m)]. Divided by it forces, multiplied by it jumps
     * of bars as different as can be are of one size, for |W_ij| ≤ √(W_ii W_jj).
     */
    double
    scale(const std::size_t bar) const
    {
      return scales[bar];
    }

    /** Largest jump of any bar times its scale. */
    double
    scaled_size(const Vector &jumps) const;

    /** R, n_bars x n_patterns [MN]. */
    const DenseMatrix &
    reactions() const
    {
      return R;
    }

    /** The bodies have got other load patterns, which cause these forces in the fully closed and
     * sticking joint, but for the imposed jumps. */
    void
    take_loads(DenseMatrix &&reactions);

    /** D of one bar [m/MN]. */
    double
    compliance(const std::size_t bar) const
    {
      return compliances[bar];
    }

    /** Whether the bar has a nonlinear layer: then d and D p may be much larger than the jump. */
    bool
    is_curved(const std::size_t bar) const
    {
      return curved[bar];
    }

    /** ContactSystem::water_in_joints(). */
    const WaterInJoints *
    water_in_joints() const
    {
      return bodies.water_in_joints();
    }

    /**
     * Forces p = R a - W d, and those of the water ω if it is not empty. Where a joint is so much
     * softer than the bodies that the digits of p decide about their deformation, or where p is a
     * small difference, it is refined until it satisfies the equations of the ContactSystem, of
     * which W is but the inverse, or until it differs from what is @p known by what W and R say.
     */
    Vector
    forces(const Vector &factors,
           const Vector &dislocations,
           const Vector &water      = {},
           const KnownForces *known = nullptr) const;

    /** Whether forces() refines @p forces such as these: then rates of forces, which come from W
     * alone, do not add up to them. */
    bool
    refines_forces(const Vector &dislocations, const Vector &forces) const;

    /** p -= W d, for forces and dislocations or the rates of both. */
    void
    subtract_response(const Vector &dislocations, Vector &forces) const;

    /** Adds (I - W D) ω: a force between the lips, so an elastic part D ω of the jump that no bar
     * force p causes. */
    void
    add_water(const Vector &water, Vector &forces) const;

    /** Jumps δ = d + D p. */
    Vector
    jumps(const Vector &dislocations, const Vector &forces) const;

  private:
    void
    eliminate_in_jumps(const ContactSystem &system);
    /** False if it is not the corners alone that have more bars than coordinates, or if a joint is
     * very soft. */
    bool
    eliminate_at_corners(const ContactSystem &system);
    void
    eliminate_with_jump_operator(const ContactSystem &system);
    void
    add_imposed_jumps(const ContactSystem &system);
    /** R a - W d and the forces of the water, in double precision. */
    Vector
    response(const Vector &factors, const Vector &dislocations, const Vector &water) const;
    void
    refine_in_jumps(const Vector &factors,
                    const Vector &dislocations,
                    const Vector &water,
                    Vector &forces) const;
    void
    refine_with_jump_operator(const Vector &factors,
                              const Vector &dislocations,
                              const Vector &water,
                              Vector &forces) const;
    /** The same for the columns of W and R. */
    void
    refine_responses();
    /** Whether a share @p rounding of the jumps costs the forces digits. */
    bool
    has_soft_joint(const double rounding = std::numeric_limits<double>::epsilon()) const;

    Accurate
    loads_on_bodies(const Accurate &factors) const;

    const ContactSystem &bodies;
    /** Whether forces() refines whatever the state; with a jump operator by these factors of the
     * saddle point matrix, scaled. */
    bool delicate = false;
    std::optional<RigidBasis> rigid_motions;
    std::optional<LuFactors> saddle_factors;
    double saddle_scale = 1.;
    Vector compliances;
    std::vector<bool> curved;
    DenseMatrix W;
    DenseMatrix R;
    double largest = 0.;
    Vector scales;
  };

  /** D = ρ/A of a bar with the given law [m/MN]. */
  double
  bar_compliance(const ComplianceLaw &law, const double area);

  /** @throws NumericalFailure */
  [[noreturn]] void
  throw_repeated_bars();
} // namespace fuga

#endif
