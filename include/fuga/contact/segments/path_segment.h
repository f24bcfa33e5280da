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
    /** Rate of the load time, where the load time is a curve. */
    std::optional<double> load_rate = {};
  };

  /**
   * The path in one working scheme, from one event to the next. It is straight for rigid and linear
   * layers, and a curve for nonlinear ones.
   */
  class PathSegment
  {
  public:
    virtual ~PathSegment() = default;

    /** Follow the scheme until the first boundary is reached, at the latest until the end of the
     * course. */
    virtual double
    find_end() = 0;

    /** Return state and rates at 0 ≤ τ ≤ end. */
    virtual PathPoint
    at(const double tau) = 0;

    /** Return the parameters, from 0 to the end, between which state and energies are smooth and
     * resolved. */
    virtual std::vector<double>
    stations() const = 0;

    /** Return whether the end is none of the scheme's boundaries: no equilibrium was found beyond
     * it. */
    virtual bool
    ends_at_limit() const
    {
      return false;
    }

    /** Return the motion without resistance at the limit. */
    virtual JointRates
    motion_at_limit()
    {
      return at(stations().back()).rates;
    }

    /** Return whether the load has a maximum at the end of a curve, which turns back there: if the
     * load grew on, the slips would have to jump. */
    virtual bool
    ends_at_turning_point() const
    {
      return false;
    }

    /** Return the energy that nonlinear layers store between the stations and that the cubics
     * between them miss [MN m]. */
    virtual double
    energy_lost()
    {
      return 0.;
    }

    /** Return the slipping elements whose slip comes to rest at the end; the rates alone cannot
     * tell (they vanish). */
    virtual std::vector<std::size_t>
    resticking() const
    {
      return {};
    }
  };

  /** The segment of a scheme with linear layers, on the straight line through @p start. */
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
    /** Return whether the forces of @p point, at the end, are those that the first rates have
     * predicted. */
    bool
    has_foreseen_forces(const PathPoint &point) const;
    double
    distance(const JointRates &rates) const;
    /** Return the corrected state; @p moved grows by the largest dislocations of the
     * corrections. */
    PathPoint
    point(const double tau, double &moved) const;
    /** Return whether the forces of a state whose dislocations are those at @p tau can be computed
     * from their rates alone. */
    bool
    advance_forces(const double tau, JointState &state) const;

    PathContext context;
    const Course course;
    const PathPoint start;
    double end;
    /** The point at the end, once it has been found. */
    std::optional<PathPoint> end_point;
  };

  /** Part of a stage by which a path may end below a limit, or a maximum of the load, where it
   * cannot be followed up to it. */
  constexpr double near_enough = 1e-6;

  /** Amount by which slopes of 1/g and of 1/g² may differ there: a slip that turns soon looks like
   * a maximum. */
  constexpr double bend_of_limit = 0.2, bend_of_maximum = 0.1;

  /** Station i of a curve, as a place and as a point. */
  struct CurvePoint
  {
    double tau             = 0.;
    const PathPoint *point = nullptr;
  };

  /** Return whether the rates of dislocation along @p curve grow like (τ* - τ)^(-1/@p exponent),
   * where τ* is no further from its end than @p within: with 1 the motion grows beyond bounds, with
   * 2 the load has a maximum at τ*. */
  bool
  rates_diverge(const std::vector<CurvePoint> &curve,
                const int exponent,
                const double within,
                const double bend);

  /** Return the length of the first step along a curve: a little more than the distance to the
   * first event along the rates of @p start, from @p least to a tenth of the course. */
  double
  first_step(const PathContext &context,
             const Course &course,
             const PathPoint &start,
             const double least);

  /** Check the number of steps and interruptions. @throws NumericalFailure if @p n_steps along one
   * curve are more than any needs, at load time @p t; Interrupted if a signal came. */
  void
  check_number_of_steps(const std::size_t n_steps, const double t);

  /**
   * Correct the dislocations of a state of a linear scheme until its equations hold to rounding. A
   * residual that is less than @p negligible of the largest force is not worth the correction of
   * that number. Return the sum of the largest corrections [m].
   */
  double
  polish(const PathContext &context,
         const Course &course,
         const double tau,
         const std::array<double, 4> &negligible,
         JointState &state);
} // namespace fuga

#endif
