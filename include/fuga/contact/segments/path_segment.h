// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_segments_path_segment_h
#define fuga_contact_segments_path_segment_h

#include <fuga/contact/segments/course.h>

#include <array>
#include <optional>
#include <vector>

namespace fuga
{
  /** A state with its derivative along the path. */
  struct PathPoint
  {
    JointState state;
    JointRates rates;
    /** Rate of the load time, where that is a curve. */
    std::optional<double> load_rate = {};
  };

  /**
   * The path in one working scheme, from one event to the next. Straight for rigid and linear
   * layers, a curve for nonlinear ones.
   */
  class PathSegment
  {
  public:
    virtual ~PathSegment() = default;

    /** Follows the scheme until the first boundary is reached; the end of the course at the latest.
     */
    virtual double
    find_end() = 0;

    /** State and rates at 0 ≤ τ ≤ end. */
    virtual PathPoint
    at(const double tau) = 0;

    /** Parameters, from 0 to the end, between which state and energies are smooth and resolved. */
    virtual std::vector<double>
    stations() const = 0;

    /** The end is none of the scheme's boundaries: no equilibrium was found behind it. */
    virtual bool
    ends_at_limit() const
    {
      return false;
    }

    /** The motion without resistance there. */
    virtual JointRates
    motion_at_limit()
    {
      return at(stations().back()).rates;
    }

    /** Whether the load has a maximum at the end of a curve, which turns back there: as long as
     * the load grows, the slips would have to jump. */
    virtual bool
    ends_at_turning_point() const
    {
      return false;
    }

    /** Energy that nonlinear layers store between the stations unseen by the cubics between them
     * [MN m]. */
    virtual double
    energy_lost()
    {
      return 0.;
    }

    /** Slipping elements whose slip comes to rest at the end; the rates alone cannot tell (they
     * vanish). */
    virtual std::vector<std::size_t>
    resticking() const
    {
      return {};
    }
  };

  /** The state of a scheme with linear layers on the straight line through @p start. */
  class StraightSegment : public PathSegment
  {
  public:
    StraightSegment(const PathContext &context, const Course &course, const PathPoint &start);

    double
    find_end() override;
    PathPoint
    at(const double tau) override;
    std::vector<double>
    stations() const override;

  private:
    /** Whether the forces of @p point, at the end, are those that the first rates have promised. */
    bool
    has_foreseen_forces(const PathPoint &point) const;
    double
    distance(const JointRates &rates) const;
    /** The corrected state; @p moved grows by the largest dislocations of the corrections. */
    PathPoint
    point(const double tau, double &moved) const;
    /** Whether the forces of a state whose dislocations are those at @p tau could be had from their
     * rates alone. */
    bool
    advance_forces(const double tau, JointState &state) const;

    PathContext context;
    const Course course;
    const PathPoint start;
    double end;
    /** The point at the end, once it has been found. */
    std::optional<PathPoint> end_point;
  };

  /** Parts of a stage by which a path may end below a limit, or a maximum of the load, where it
   * cannot be followed up to it. */
  constexpr double near_enough = 1e-6;

  /** By how much slopes of 1/g and of 1/g² may differ there: a slip that turns soon looks like a
   * maximum. */
  constexpr double bend_of_limit = 0.2, bend_of_maximum = 0.1;

  /** Station i of a curve, as a place and as a point. */
  struct CurvePoint
  {
    double tau             = 0.;
    const PathPoint *point = nullptr;
  };

  /** Whether the rates of dislocation along @p curve grow like (τ* - τ)^(-1/@p exponent), and τ* is
   * no further from its end than @p within: with 1 the motion grows beyond bounds, with 2 the load
   * has a maximum at τ*. */
  bool
  rates_diverge(const std::vector<CurvePoint> &curve,
                const int exponent,
                const double within,
                const double bend);

  /** Length of the first step along a curve: a little more than the way to the first event along
   * the rates of @p start, from @p least to a tenth of the course. */
  double
  first_step(const PathContext &context,
             const Course &course,
             const PathPoint &start,
             const double least);

  /** @throws NumericalFailure if @p n_steps along one curve are more than any needs, at load time
   * @p t; Interrupted if a signal came. */
  void
  check_number_of_steps(const std::size_t n_steps, const double t);

  /**
   * Corrects the dislocations of a state of a linear scheme until its equations hold to rounding.
   * A residual that is less than @p negligible of the largest force is not worth the correction of
   * that number. Returns the sum of the largest corrections [m].
   */
  double
  polish(const PathContext &context,
         const Course &course,
         const double tau,
         const std::array<double, 4> &negligible,
         JointState &state);
} // namespace fuga

#endif
