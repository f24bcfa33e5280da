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
  /** Where the shear of an element stands with respect to its strength. */
  enum class ShearPosition
  {
    /** |T| below the strength, or no tangential bar: the shear cannot change the state. */
    inside,
    /** |T| at a strength above zero. */
    at_strength,
    /** T = 0 and no strength (N = 0, no cohesion): the apex of Coulomb's cone. With two tangential
       bars and no strength whatever the pressure the shear is none, and `inside`. */
    at_apex
  };

  /** An element whose state the rates have to decide. */
  struct BoundaryElement
  {
    std::size_t element = 0;
    /** N = 0 and gap = 0: the element may open, or stay closed. */
    bool grazing        = false;
    ShearPosition shear = ShearPosition::inside;
    /** Sign of T if at_strength; of no meaning with two tangential bars. */
    double sign = 0.;
    /** With two tangential bars, that of T if at_strength. */
    TangentVector direction = {{1., 0.}};
  };

  /** Something that must stay positive, and its rate along the path. */
  struct Reserve
  {
    double value = 0.;
    double rate  = 0.;
    /** Value that counts as zero. */
    double tolerance = 0.;
    /** Rate that counts as none. */
    double noise = 0.;

    /** It is zero, and stays so but for rounding: the rate problem has taken its rate for none. */
    bool
    rests() const
    {
      return value <= tolerance && rate >= -std::max(tolerance, noise);
    }

    /** How far below zero it may be at @p tau along a path of which this is the beginning: as far as
     * there, and where it rests there by what rounding leads it; rates that begin large on a soft
     * layer soon have less @p noise_there. */
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
   * Answers where a state stands with respect to the boundaries of Coulomb's contact conditions:
   * which elements are on one, and how far along given rates the next one is reached. With two
   * tangential bars the cone is circular. Tolerances are relative to the rounding errors of the
   * forces and jumps concerned.
   */
  class ContactBoundary
  {
  public:
    ContactBoundary(const std::vector<ContactElement> &elements, const LayeredSystem &system);

    /** Takes the scales of forces and jumps from a state; to be called before the others. */
    void
    set_scales(const JointState &state, const Vector &factors, const double widening);

    /** What is used up along given rates within a length that the load time cannot tell from none
     * counts as zero. */
    void
    take_unresolved(const JointRates &rates, const double length);

    /** Gaps up to @p gap count as closed. Whether fewer did before. */
    bool
    take_for_closed(const double gap);

    /** All elements on a boundary, slipping ones included. */
    std::vector<BoundaryElement>
    elements_on_boundary(const JointState &state) const;

    /**
     * Length τ along the straight line state + τ rates after which the first boundary is reached,
     * for a stuck element with two tangential bars the smallest root of |T + τ Ṫ|² = (r + τ ṙ)², r
     * its strength; infinity if none is.
     */
    double
    distance(const JointState &state, const JointRates &rates, const Drive &drive) const;

    /**
     * The reserves of all elements at a point: gap of open elements, tension and strength left of
     * closed ones, the rise that is left to those that slide; always in the same order for the same
     * states.
     */
    std::vector<Reserve>
    reserves(const JointState &state, const JointRates &rates, const Drive &drive) const;

    /** Force below which a bar counts as unloaded [MN]. */
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

    /** Force below which the shear strength of an element, or its distance from it, is zero [MN].
     */
    double
    strength_tolerance(const std::size_t element, const Strength &strength) const;

    /** Gap that counts as closed [m]. */
    double
    gap_tolerance() const
    {
      return zero_gap;
    }

    /** What counts as zero among given rates. */
    class RateNoise
    {
    public:
      /** Of the terms a rate is the difference of: what a linear solution leaves. */
      static constexpr double share = 1e-10;

      RateNoise(const LayeredSystem &system, const JointRates &rates, const Drive &drive);

      /** Rate of the force of a bar. */
      double
      force(const std::size_t bar) const;

      /** Rate of any jump. */
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
      /** No bound where no force drives, but strengths that change. */
      double largest_noise = std::numeric_limits<double>::infinity();
    };

  private:
    /** The shear of an element, its strength, their rates, and the tolerance of both [MN]. */
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
    /** Whether a nonlinear layer is closed by more than rounding: its lips do not open, be its
     * force too small to know its shear. */
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
    const bool has_cones;
    Vector force_tolerances;
    double zero_gap = 0.;
  };
} // namespace fuga

#endif
