// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_curved_segment_h
#define fuga_contact_curved_segment_h

#include <fuga/contact/path_segment.h>

namespace fuga
{
  /** A slip rate below this share of the largest jump rate is zero. */
  constexpr double slip_rate_tolerance = 1e-10;

  /** How nonlinear layers are iterated. */
  struct PathOptions
  {
    enum class Iteration
    {
      /** Newton with the tangent stiffness of the layer. */
      newton,
      /** The paper's iteration (3), (7), (8) with a constant matrix; diverges where the layer
         hardens too much. */
      constant_stiffness
    };

    enum class Follow
    {
      /** From event to event. */
      events,
      /** From corner to corner of the loads by implicit steps where that is possible. */
      stage_ends
    };

    /** What happens where the joints can go on in several ways. */
    enum class NonUnique
    {
      /** The path ends with Verdict::non_unique_continuation. */
      stop,
      /** The first continuation found is followed. */
      first,
      /** The one that dissipates most. */
      largest_dissipation
    };

    Follow follow        = Follow::events;
    NonUnique non_unique = NonUnique::stop;
    /** Goes on beyond a limit load, the load falling or constant. */
    bool beyond_limit = false;
    /** How far the largest jump grows there [m]; 0: ten times the largest jump at the limit. */
    double beyond_jump  = 0.;
    Iteration iteration = Iteration::newton;
    /** Difference of two successive iterations that ends the iteration, relative to the largest
     * jump. */
    double tolerance            = 1e-13;
    unsigned int max_iterations = 200;
  };

  /** Work done for nonlinear layers. */
  struct IterationCount
  {
    std::size_t n_solutions  = 0;
    std::size_t n_iterations = 0;
    std::size_t max_in_one   = 0;
    /** Largest energy the nonlinear layers stored: the scale of what a step may lose of it. */
    double largest_energy = 0.;
  };

  template <typename Count, typename Visitor, only_for<Count, IterationCount> = 0>
  void
  for_each_field(Count &count, Visitor &&visit)
  {
    auto &[n_solutions, n_iterations, max_in_one, largest_energy] = count;
    visit("n_solutions", n_solutions);
    visit("n_iterations", n_iterations);
    visit("max_in_one", max_in_one);
    visit("largest_energy", largest_energy);
  }

  /**
   * The path of a working scheme with nonlinear layers, or of one whose friction is being reduced:
   * a smooth curve, followed by a tangent predictor and an iterated corrector. The end is located
   * on the curve itself: the event function is interpolated by cubics between solved points, the
   * bracket shrinks until the function vanishes at a solved point, and every other event function
   * is watched at every point, so none is skipped. The loss of slip (re-stick) is one of these
   * events.
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
    std::vector<std::size_t>
    resticking() const override;

  private:
    /** Something that must stay positive: value and derivative along the path. */
    struct EventFunction
    {
      double value        = 0.;
      double rate         = 0.;
      double tolerance    = 0.;
      bool has_rate       = true;
      std::size_t element = 0;
    };

    /** A deformation of the layer and its rate. */
    struct LayerMotion
    {
      double value = 0.;
      double rate  = 0.;
    };

    LayerMotion
    closing(const std::size_t k, const PathPoint &point) const;
    LayerMotion
    shearing(const std::size_t k, const std::size_t a, const PathPoint &point) const;
    std::vector<EventFunction>
    event_functions(const double tau, const PathPoint &point) const;
    double
    first_root(const std::size_t a, const std::size_t b) const;
    double
    locate_end(std::size_t a, std::size_t b);
    std::optional<PathPoint>
    solve(const double tau, const Vector &predicted_dislocations);
    bool
    iterate(const double tau, JointState &state);
    double
    closure_safeguard(const JointState &state, const JointRates &change) const;
    bool
    passes_closure_limit(const JointState &state) const;
    [[noreturn]] void
    give_up() const;
    Vector
    interpolate(const std::size_t a, const double tau) const;
    bool
    is_reduction() const
    {
      return course.share_rate != 0.;
    }
    bool
    is_behind_pole() const;
    double
    step_defect(const PathPoint &from, const PathPoint &to, const double length) const;
    double
    reduction_defect(const PathPoint &from, const PathPoint &to, const double length) const;
    double
    energy_defect(const PathPoint &from, const PathPoint &to, const double length) const;
    std::size_t
    insert(const double tau, PathPoint &&point);
    double
    jump_of(const PathPoint &point) const;
    [[noreturn]] void
    fail_behind(const std::size_t a, const char *what);
    void
    forget_behind(const std::size_t a);

    PathContext context;
    const Course course;
    const PathOptions options;
    IterationCount &count;
    std::vector<double> taus;
    std::vector<PathPoint> points;
    std::vector<std::vector<EventFunction>> functions;
    /** Of any bar at the points so far: the scale of the iteration. All jumps may vanish at once,
     * where all elements lift off or come down together, and would be no scale for themselves. */
    double largest_jump = 0.;
    std::vector<std::size_t> lost_slip;
    /** Of the scheme at the start of a strength reduction. */
    int determinant_sign = 0;
    bool at_limit        = false;
  };
} // namespace fuga

#endif
