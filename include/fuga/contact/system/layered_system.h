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
  /** A state whose forces are as exact as possible, used to compute those of states near by, which
   * differ only slightly. */
  struct KnownForces
  {
    Vector factors, dislocations, water, forces;
  };

  /**
   * Bodies and layers in series. The jump of every bar is split into an elastic part and a
   * *dislocation* d,
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
   * joint nor a floating body is a special case. The dislocation consists of the opening, the slip,
   * and the deformation of a nonlinear layer in excess of D p; a bar that does none of this is
   * never touched.
   */
  class LayeredSystem
  {
  public:
    /** Constructor. @p system must live as long as this object. */
    LayeredSystem(const ContactSystem &system, const std::vector<ContactElement> &elements);

    std::size_t
    n_bars() const
    {
      return compliances.size();
    }

    /** Return the bodies and what acts on them. */
    const ContactSystem &
    contact_system() const
    {
      return bodies;
    }

    /** Return W [MN/m]. */
    const DenseMatrix &
    stiffness() const
    {
      return W;
    }

    /** Return the largest diagonal entry of W [MN/m]. */
    double
    largest_stiffness() const
    {
      return largest;
    }

    /**
     * Return √W_ii, except for values that are only rounding [√(MN/m)]. Forces divided by it, and
     * jumps multiplied by it, have the same magnitude for bars as different as can be, since
     * |W_ij| ≤ √(W_ii W_jj).
     */
    double
    scale(const std::size_t bar) const
    {
      return scales[bar];
    }

    /** Return the largest jump of any bar times its scale. */
    double
    scaled_size(const Vector &jumps) const;

    /** Return R, n_bars x n_patterns [MN]. */
    const DenseMatrix &
    reactions() const
    {
      return R;
    }

    /** Set other load patterns of the bodies, which cause these forces in the fully closed and
     * sticking joint, except for the imposed jumps. */
    void
    take_loads(DenseMatrix &&reactions);

    /** Return D of one bar [m/MN]. */
    double
    compliance(const std::size_t bar) const
    {
      return compliances[bar];
    }

    /** Return whether the bar has a nonlinear layer: d and D p may then be much larger than the
     * jump. */
    bool
    is_curved(const std::size_t bar) const
    {
      return curved[bar];
    }

    /** Return ContactSystem::water_in_joints(). */
    const WaterInJoints *
    water_in_joints() const
    {
      return bodies.water_in_joints();
    }

    /**
     * Return the forces p = R a - W d, including those of the water ω if it is not empty. Where a
     * joint is so much softer than the bodies that the digits of p determine their deformation, or
     * where p is a small difference, p is refined until it satisfies the equations of the
     * ContactSystem, of which W is only the inverse, or until it differs from what is @p known by
     * the amount that W and R give.
     */
    Vector
    forces(const Vector &factors,
           const Vector &dislocations,
           const Vector &water      = {},
           const KnownForces *known = nullptr) const;

    /** Return whether forces() refines @p forces such as these: rates of forces, which are computed
     * from W alone, then do not add up to them. */
    bool
    refines_forces(const Vector &dislocations, const Vector &forces) const;

    /** Compute p -= W d, for forces and dislocations or the rates of both. */
    void
    subtract_response(const Vector &dislocations, Vector &forces) const;

    /** Add (I - W D) ω: a force between the lips, i.e. an elastic part D ω of the jump that no bar
     * force p causes. */
    void
    add_water(const Vector &water, Vector &forces) const;

    /** Return the jumps δ = d + D p. */
    Vector
    jumps(const Vector &dislocations, const Vector &forces) const;

  private:
    void
    eliminate_in_jumps(const ContactSystem &system);
    /** Eliminate at the corners. Return false if not only the corners have more bars than
     * coordinates, or if a joint is very soft. */
    bool
    eliminate_at_corners(const ContactSystem &system);
    void
    eliminate_with_jump_operator(const ContactSystem &system);
    void
    add_imposed_jumps(const ContactSystem &system);
    /** Return R a - W d and the forces of the water, in double precision. */
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
    /** Refine the columns of W and R in the same way. */
    void
    refine_responses();
    /** Return whether a share @p rounding of the jumps costs the forces digits. */
    bool
    has_soft_joint(const double rounding = std::numeric_limits<double>::epsilon()) const;

    Accurate
    loads_on_bodies(const Accurate &factors) const;

    const ContactSystem &bodies;
    /** True if forces() refines whatever the state is; with a jump operator it uses these factors
     * of the saddle point matrix, scaled. */
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

  /** Return D = ρ/A of a bar with the given law [m/MN]. */
  double
  bar_compliance(const ComplianceLaw &law, const double area);

  /** @throws NumericalFailure */
  [[noreturn]] void
  throw_repeated_bars();
} // namespace fuga

#endif
