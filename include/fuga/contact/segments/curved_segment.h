// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_segments_curved_segment_h
#define fuga_contact_segments_curved_segment_h

#include <fuga/contact/segments/event_location.h>
#include <fuga/contact/segments/layer_work.h>
#include <fuga/contact/segments/scheme_equilibrium.h>

namespace fuga
{
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
    /** A solved point of the curve. */
    struct Station
    {
      double tau = 0.;
      PathPoint point;
      EventFunctions functions;
      /** Energy lost by the step to this point, where that is known [MN m]. */
      std::optional<double> energy_lost;
    };

    std::optional<Station>
    solve(const double tau, const Vector &predicted_dislocations);
    std::optional<Station>
    solve_between(const Station &a, const Station &b, const double tau);
    EventFunctions
    functions_at(const double tau, const PathPoint &point) const;
    bool
    ends_before(const std::size_t a, const Station &passed);
    void
    meet(const Station &from, const Station &before, Station &reached);
    void
    divide_after(std::size_t a, const double shortest);
    [[noreturn]] void
    give_up() const;
    bool
    slips_back(const JointState &from, const JointState &to) const;
    bool
    slips_back_after(const std::size_t a) const;
    bool
    turns_back() const;
    bool
    is_reduction() const
    {
      return course.share_rate != 0.;
    }
    bool
    has_crossed_pole() const;
    /** Return the defect of the step between two stations; set the energy that it loses. */
    double
    step_defect(const Station &from, Station &to) const;
    /** Return the energy of the step between @p a and @p b. */
    StepEnergy
    energy_between(const Station &a, const Station &b) const;
    double
    reduction_defect(const PathPoint &from, const PathPoint &to, const double length) const;
    double
    jump_of(const PathPoint &point) const;
    std::vector<std::size_t>
    elements_on_boundary(const Station &station) const;

    PathContext context;
    const Course course;
    const PathOptions options;
    IterationCount &count;
    SchemeEquilibrium equilibrium;
    const ReservesOfCurve reserves;
    std::vector<Station> curve;
    /** Forces at the beginning. */
    const KnownForces known;
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
