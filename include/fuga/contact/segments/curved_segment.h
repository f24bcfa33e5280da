// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_segments_curved_segment_h
#define fuga_contact_segments_curved_segment_h

#include <fuga/contact/segments/layer_work.h>
#include <fuga/contact/segments/scheme_equilibrium.h>

namespace fuga
{
  /** Share of the largest jump rate below which a slip rate counts as zero. */
  constexpr double slip_rate_tolerance = 1e-10;

  /**
   * The path of a working scheme with nonlinear layers, or of one whose friction is being reduced:
   * it is a smooth curve, which is followed by a tangent predictor and an iterated corrector. The
   * end is located on the curve itself: the event function is interpolated by cubics between solved
   * points, the bracket shrinks until the function vanishes at a solved point, and every other
   * event function is monitored at every point, so that none is skipped. The loss of slip
   * (re-stick) is one of these events.
   */
  class CurvedSegment : public PathSegment
  {
  public:
    CurvedSegment(const PathContext &context,
                  const Course &course,
                  const PathPoint &start,
                  const PathOptions &options,
                  IterationCount &count);

    double
    find_end() override;
    PathPoint
    at(const double tau) override;
    std::vector<double>
    stations() const override;
    bool
    ends_at_limit() const override
    {
      return at_limit;
    }
    bool
    ends_at_turning_point() const override
    {
      return at_turning_point;
    }
    std::vector<std::size_t>
    resticking() const override;
    double
    energy_lost() override;

  private:
    /** A quantity that must stay positive: its value and its derivative along the path. */
    struct EventFunction
    {
      double value        = 0.;
      double rate         = 0.;
      double tolerance    = 0.;
      bool has_rate       = true;
      std::size_t element = 0;
    };

    std::vector<EventFunction>
    event_functions(const double tau, const PathPoint &point) const;
    double
    first_root(const std::size_t a, const std::size_t b) const;
    void
    locate_end(std::size_t a, std::size_t b);
    void
    meet_event();
    void
    divide_behind(std::size_t a, const double shortest);
    std::optional<PathPoint>
    solve(const double tau, const Vector &predicted_dislocations);
    [[noreturn]] void
    give_up() const;
    Vector
    interpolate(const std::size_t a, const double tau) const;
    bool
    slips_back(const JointState &from, const JointState &to) const;
    bool
    slips_back_behind(const std::size_t a) const;
    bool
    turns_back() const;
    bool
    is_reduction() const
    {
      return course.share_rate != 0.;
    }
    bool
    is_behind_pole() const;
    /** Return the defect of the step from point @p a to a next one; set @p lost to its energy. */
    double
    step_defect(const std::size_t a, const PathPoint &to, const double length, double &lost) const;
    /** Return the energy of the step between points a and a + 1. */
    StepEnergy
    energy_behind(const std::size_t a) const;
    double
    reduction_defect(const PathPoint &from, const PathPoint &to, const double length) const;
    std::size_t
    insert(const double tau, PathPoint &&point, const std::optional<double> &lost = {});
    double
    jump_of(const PathPoint &point) const;
    std::vector<std::size_t>
    elements_on_boundary(const double tau, const JointState &state) const;
    [[noreturn]] void
    fail_behind(const std::size_t a, const char *what);
    void
    forget_behind(const std::size_t a);

    PathContext context;
    const Course course;
    const PathOptions options;
    IterationCount &count;
    SchemeEquilibrium equilibrium;
    std::vector<double> taus;
    std::vector<PathPoint> points;
    /** Forces, and reserves that rest, at the beginning. */
    const KnownForces known;
    const std::vector<Reserve> first_reserves;
    /** The boundary_at() the beginning. */
    const ContactBoundary first_boundary;
    /** Energy lost by the step to each point, where that is known [MN m]. */
    std::vector<std::optional<double>> losses;
    std::vector<std::vector<EventFunction>> functions;
    /** Largest jump of any bar at the points so far, used as the scale of the iteration. All jumps
     * may vanish at once, where all elements lift off or come down together, and would then be no
     * scale for themselves. */
    double largest_jump = 0.;
    std::vector<std::size_t> lost_slip;
    /** Sign of the determinant of the scheme at the start of a strength reduction. */
    int determinant_sign  = 0;
    bool at_limit         = false;
    bool at_turning_point = false;
  };
} // namespace fuga

#endif
