// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_element_contact_boundary_h
#define fuga_contact_element_contact_boundary_h

#include <fuga/contact/joint_state.h>
#include <fuga/contact/system/layered_system.h>

#include <algorithm>
#include <limits>

namespace fuga
{
  /** The position of the shear of an element relative to its strength. */
  enum class ShearPosition
  {
    /** |T| is below the strength, or there is no tangential bar: the shear cannot change the
     * state. */
    inside,
    /** |T| is at a strength above zero. */
    at_strength,
    /** T = 0 and the strength is zero (N = 0, no cohesion): the apex of Coulomb's cone. With two
     * tangential bars, an element without strength at any pressure has no shear, and is
     * `inside`. */
    at_apex
  };

  /** An element whose state the rates have to decide. */
  struct BoundaryElement
  {
    std::size_t element = 0;
    /** N = 0 and gap = 0: the element may open or stay closed. */
    bool grazing        = false;
    ShearPosition shear = ShearPosition::inside;
    /** Direction of T if at_strength; along one tangential bar its sign and 0. */
    TangentVector direction = {{1., 0.}};
  };

  /** Return the number of states that an element on a boundary can take; along two tangents at the
   * apex each is one of many. */
  inline std::size_t
  n_states(const BoundaryElement &candidate)
  {
    return 1 + (candidate.grazing ? 1 : 0) + static_cast<std::size_t>(candidate.shear);
  }

  /** A quantity that must stay positive, and its rate along the path. */
  struct Reserve
  {
    double value = 0.;
    double rate  = 0.;
    /** Value that counts as zero. */
    double tolerance = 0.;
    /** Rate that counts as zero. */
    double noise = 0.;

    /** Return whether the value is zero and stays zero up to rounding, because the rate problem has
     * treated its rate as zero. */
    bool
    rests() const
    {
      return value <= tolerance && rate >= -std::max(tolerance, noise);
    }

    /** Return how far below zero the value may be at @p tau along a path of which this is the
     * beginning: as far as at the beginning and, where it rests there, in addition as far as
     * rounding leads it. Rates that begin large on a soft layer soon have a smaller
     * @p noise_there. */
    double
    drift(const double tau, const double noise_there) const
    {
      return std::max(0., -value) +
             (rests() ? tau * std::max(tolerance, std::min(noise, noise_there)) : 0.);
    }
  };

  /** Length of a path that does not meet a boundary. */
  constexpr double no_boundary = std::numeric_limits<double>::infinity();

  /**
   * Determines the position of a state relative to the boundaries of Coulomb's contact conditions:
   * which elements are on one, and how far along given rates the next one is reached. With two
   * tangential bars the cone is circular. Tolerances are relative to the rounding errors of the
   * forces and jumps concerned.
   */
  class ContactBoundary
  {
  public:
    ContactBoundary(const std::vector<ContactElement> &elements, const LayeredSystem &system);

    /** Set the scales of forces and jumps from a state; to be called before the other functions. */
    void
    set_scales(const JointState &state, const Vector &factors, const double widening);

    /** Raise the tolerances so that changes along given rates within a length that the load time
     * cannot distinguish from zero count as zero. */
    void
    take_unresolved(const JointRates &rates, const double length);

    /** Let gaps up to @p gap count as closed. Return whether fewer did so before. */
    bool
    take_for_closed(const double gap);

    /** Return all elements on a boundary, slipping ones included. */
    std::vector<BoundaryElement>
    elements_on_boundary(const JointState &state) const;

    /**
     * Return the length τ along the straight line state + τ rates after which the first boundary is
     * reached; for a stuck element with two tangential bars this is the smallest root of |T + τ
     * Ṫ|² = (r + τ ṙ)², where r is its strength. Return infinity if none is reached.
     */
    double
    distance(const JointState &state, const JointRates &rates, const Drive &drive) const;

    /**
     * Return the reserves of all elements at a point: the gap of open elements, the remaining
     * tension and strength of closed ones, the remaining rise of those that slide; always in the
     * same order for the same states.
     */
    std::vector<Reserve>
    reserves(const JointState &state, const JointRates &rates, const Drive &drive) const;

    /** Return the largest residual of an equation of forces that may be nothing but rounding [MN]:
     * a few last digits of its terms. */
    double
    rounding_of_residual() const
    {
      return last_digits;
    }

    /** Return the force below which a bar counts as unloaded [MN]. */
    double
    force_tolerance(const std::size_t bar) const
    {
      return force_tolerances[bar];
    }

    const Vector &
    all_force_tolerances() const
    {
      return force_tolerances;
    }

    /** Return the force below which the shear strength of an element, or the distance of the shear
     * from it, counts as zero [MN]. */
    double
    strength_tolerance(const std::size_t element, const Strength &strength) const;

    /** Return the gap that counts as closed [m]. */
    double
    gap_tolerance() const
    {
      return zero_gap;
    }

    /** Tells which values among given rates count as zero. */
    class RateNoise
    {
    public:
      /** Share of the terms whose difference a rate is: the error that a linear solution leaves. */
      static constexpr double share = 1e-10;

      RateNoise(const LayeredSystem &system, const JointRates &rates, const Drive &drive);

      /** Return the noise of the rate of the force of a bar. */
      double
      force(const std::size_t bar) const;

      /** Return the noise of the rate of any jump. */
      double
      jump() const
      {
        return jump_noise;
      }

    private:
      const LayeredSystem &system;
      const Drive &drive;
      double scaled_dislocation;
      double jump_noise;
      double least_noise;
      /** There is no bound where strengths change but no force drives. */
      double largest_noise = std::numeric_limits<double>::infinity();
    };

  private:
    /** The shear of an element, its strength, the rates of both, and their tolerance [MN]. */
    struct Shear
    {
      TangentVector force, rate;
      double strength, strength_rate, tolerance;
    };

    Shear
    shear(const std::size_t k,
          const JointState &state,
          const JointRates &rates,
          const Drive &drive) const;
    Reserve
    gap_reserve(const std::size_t k,
                const JointState &state,
                const JointRates &rates,
                const RateNoise &noise) const;
    Reserve
    tension_reserve(const std::size_t k,
                    const JointState &state,
                    const JointRates &rates,
                    const Drive &drive,
                    const RateNoise &noise) const;
    Reserve
    dilation_reserve(const std::size_t k,
                     const JointState &state,
                     const JointRates &rates,
                     const RateNoise &noise) const;
    double
    noise_of_shear(const std::size_t k, const JointState &state, const RateNoise &noise) const;
    /** Return whether a compliant layer is closed by more than rounding: its lips do not open, even
     * if its force is too small to determine its shear. */
    bool
    is_visibly_closed(const JointState &state, const std::size_t k) const;
    void
    place_shear(const JointState &state, BoundaryElement &candidate) const;
    void
    append_shear_reserves(const std::size_t k,
                          const JointState &state,
                          const JointRates &rates,
                          const Drive &drive,
                          const RateNoise &noise,
                          std::vector<Reserve> &reserves) const;
    double
    distance_from_cone(const std::size_t k,
                       const JointState &state,
                       const JointRates &rates,
                       const Drive &drive,
                       const RateNoise &noise) const;
    double
    distance_of(const std::size_t k,
                const JointState &state,
                const JointRates &rates,
                const Drive &drive,
                const RateNoise &noise) const;

    const std::vector<ContactElement> &elements;
    const LayeredSystem &system;
    const bool in_space;
    Vector force_tolerances;
    double zero_gap    = 0.;
    double last_digits = 0.;
  };
} // namespace fuga

#endif
