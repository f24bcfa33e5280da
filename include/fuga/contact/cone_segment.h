// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_cone_segment_h
#define fuga_contact_cone_segment_h

#include <fuga/contact/cone_stage.h>
#include <fuga/contact/curved_segment.h>
#include <fuga/contact/path_segment.h>

namespace fuga
{
  /** Largest error of one step along a curve, relative to the largest force and jump. */
  constexpr double cone_step_tolerance = 1e-11;

  /** Everything that segments with circular friction cones share, by reference. */
  struct ConeContext
  {
    const std::vector<ContactElement> &elements;
    const LayeredSystem &system;
    const ContactBoundary &boundary;
    const ReleasedSystem &released;
  };

  /**
   * The path in one working scheme with circular friction cones. While no slip direction turns, it
   * is straight, and its end is found in one exact step. Otherwise
   *
   *     T_i + f N_i e_i = 0,   ṡ_i = γ_i e_i      for all slipping elements i
   *
   * is integrated by a singly diagonally implicit Runge-Kutta pair of order 5(4): its stages are
   * return mappings, its results are on the cones exactly, and slips that are long beside f N/k,
   * with forces that follow them at once, do not shorten its steps. Events are located on the steps
   * themselves: a step that passes one is repeated, shorter, until it ends there.
   */
  class ConeSegment : public PathSegment
  {
  public:
    /** @p directions of all elements; those of the slipping ones count. */
    ConeSegment(const ConeContext &context,
                const Course &course,
                const PathPoint &start,
                const std::vector<TangentVector> &directions,
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
    JointRates
    motion_at_limit() override;
    std::vector<std::size_t>
    resticking() const override;

  private:
    /** A point of the curve with all that steps and events need. */
    struct Station
    {
      double tau = 0.;
      PathPoint point;
      ConeStage stage;
      /** Rates of slip along the directions. */
      Vector slip_rates;
      std::vector<Reserve> reserves;
    };

    bool
    is_straight() const;
    double
    error_of_rounding(const double shortest);
    void
    find_end_of_curve();
    bool
    complete(Station &station) const;
    bool
    find_slip_rates(Station &station) const;
    void
    set_dislocations(const ConeStage &stage, Vector &dislocations) const;
    bool
    step(const Station &from, const double length, Station &to, double &error);
    double
    work_defect(const Station &from,
                const Station &to,
                const double length,
                const double work) const;
    double
    first_event(const Station &a, const Station &b) const;
    bool
    grows_beyond_bounds() const;
    bool
    is_passed(const Station &station) const;
    bool
    is_reached(const Station &station) const;
    std::optional<Station>
    locate(const Station &from, const Station &passed);
    bool
    turns_back() const;
    /** Rates of slip grow like (τ* - τ)^(-1/@p exponent), and τ* is no further than @p within. */
    bool
    rates_diverge(const int exponent, const double within) const;
    double
    rate_tolerance(const Station &station) const;

    ConeContext context;
    const Course course;
    const PathPoint start;
    std::vector<SlippingElement> slipping;
    ConeStageSolver solver;
    /** Dislocations of the bars that neither slip nor are released. */
    Vector fixed;
    /** Largest force and jump, what errors are relative to. */
    double force_scale = 0., jump_scale = 0.;
    bool straight = true;
    bool at_limit = false, at_turning_point = false;
    double end = 0.;
    std::vector<Station> curve;
    std::vector<std::size_t> lost_slip;
  };
} // namespace fuga

#endif
