// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_segments_event_location_h
#define fuga_contact_segments_event_location_h

#include <fuga/contact/segments/path_segment.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace fuga
{
  /** Share of the largest rate of dislocation below which a speed of slip counts as zero. */
  constexpr double slip_rate_tolerance = 1e-10;

  /** A quantity that is positive along a curve until an event: a reserve of the contact conditions,
   * or the speed of a slip, whose derivative is not known. */
  struct EventFunction
  {
    double value = 0.;
    /** Derivative along the curve. */
    double rate = 0.;
    /** Value that counts as zero. */
    double tolerance = 0.;
    /** Number of the element whose speed of slip this is. */
    std::optional<std::size_t> slipping = {};
  };
  using EventFunctions = std::vector<EventFunction>;

  /**
   * The reserves of the contact conditions along a curve. The values that count as zero are
   * determined by the forces and jumps at the beginning, or at the point itself: a curve that
   * begins without any load has no scale for what is to come. Reserves that rest at the beginning
   * drift by their noise along the whole curve, and those that are below zero there stay so.
   */
  class ReservesOfCurve
  {
  public:
    ReservesOfCurve(const PathContext &context,
                    const Course &course,
                    const PathPoint &start,
                    const Drive &drive);

    /** Return the reserves at the beginning. */
    EventFunctions
    at_start() const;

    /** Return the reserves at @p tau, where @p drive drives the joints. */
    EventFunctions
    at(const double tau, const PathPoint &point, const Drive &drive) const;

  private:
    PathContext context;
    const Course &course;
    /** The boundary_at() the beginning, and the reserves there. */
    const ContactBoundary first_boundary;
    const std::vector<Reserve> first;
  };

  /** Return the share of the way from @p a to @p b, @p length apart, at which the first function is
   * used up, by cubics and, for speeds of slip, by secants; no_boundary if none is. */
  double
  first_event(const EventFunctions &a, const EventFunctions &b, const double length);

  /** Return whether a function is below zero by more than its tolerance. */
  bool
  is_violated(const EventFunctions &functions);

  /** Return the distance, ahead or back, at which the first reserve is used up, among those that
   * are used up at @p at to within their tolerance and were not @p before, @p length back, or had
   * only begun to grow; no_boundary if none is. */
  double
  way_to_event(const EventFunctions &before, const EventFunctions &at, const double length);

  /** Return whether a function that was not used up @p before, or had only begun to grow, is used
   * up at @p at. */
  bool
  is_met(const EventFunctions &before, const EventFunctions &at, const double length);

  /** Return the elements whose slip is at rest, and was faster @p before. */
  std::vector<std::size_t>
  slips_at_rest(const EventFunctions &before, const EventFunctions &at);

  /** Two stations of a curve between which it meets its first event, unless it does at the lower
   * one. A station has a place `tau` and its `functions`. */
  template <typename Station>
  struct EventBracket
  {
    /** The stations before the event that were found on the way; the last one is the lower end. */
    std::vector<Station> before;
    Station high;
    /** True if nothing is resolved between the ends. */
    bool is_narrow = false;
    /** True if no station was found just beyond the lower end. */
    bool is_open = false;

    /** Return the station that comes before the last one. */
    const Station &
    last_but_one() const
    {
      return before[before.size() > 1 ? before.size() - 2 : 0];
    }
  };

  /**
   * Shrink a bracket, of which only @p high lies beyond an event, until its lower end meets the
   * first event, or until it is no wider than @p narrowest. `solve(bracket, tau)` returns the
   * station at @p tau, or nothing where none is found; the event is then looked for before that
   * place. The return value is empty if there is no event.
   */
  template <typename Station, typename Solve>
  std::optional<EventBracket<Station>>
  locate_event(const Station &low, const Station &high, const double narrowest, Solve &&solve)
  {
    constexpr int max_trials = 200;
    constexpr double least   = 1e-3; // share of the bracket by which it shrinks
    EventBracket<Station> bracket{{low}, high};
    double end = high.tau; // nothing is known beyond
    for (int trial = 0; trial < max_trials; ++trial)
      {
        const Station &last = bracket.before.back();
        const double first = last.tau, width = end - first;
        if (width <= narrowest)
          break;
        const double length = bracket.high.tau - first;
        const double share  = first_event(last.functions, bracket.high.functions, length);
        if (share > 1. && !bracket.is_open)
          return {};
        // The interpolation is trusted as long as it shrinks the bracket; every fourth time it is
        // halved.
        double tau = first + share * length;
        if (trial % 4 == 3 || tau >= end)
          tau = first + 0.5 * width;
        tau                           = std::max(tau, first + least * width);
        std::optional<Station> middle = solve(bracket, tau);
        if (!middle)
          {
            end             = tau;
            bracket.is_open = true;
          }
        else if (is_violated(middle->functions))
          {
            bracket.high    = std::move(*middle);
            bracket.is_open = false;
            end             = tau;
          }
        else
          {
            const bool met = is_met(last.functions, middle->functions, tau - first);
            bracket.before.push_back(std::move(*middle));
            if (met)
              return bracket;
          }
      }
    bracket.is_narrow = true;
    return bracket;
  }

  /**
   * Move @p reached, a station of a step from @p from, to where a reserve is zero that is used up
   * there to within its tolerance and was not at the station @p before. Tolerances are those of the
   * rounding of the largest terms: an element that begins to slip must not begin off its cone by as
   * much, nor one that opens with a force. `solve(tau)` returns a station up to @p last_tau, or
   * nothing; a station there stays, as the next course begins with it. Return whether there is such
   * a reserve.
   */
  template <typename Station, typename Solve>
  bool
  meet_event(const Station &from,
             const Station &before,
             Station &reached,
             const double last_tau,
             Solve &&solve)
  {
    constexpr double near = 0.01; // of the step
    const double way = way_to_event(before.functions, reached.functions, reached.tau - before.tau);
    if (way == no_boundary)
      return false;
    const double tau = reached.tau + way;
    if (tau == reached.tau || reached.tau == last_tau ||
        std::abs(way) > near * (reached.tau - from.tau) || tau > last_tau)
      return true;
    std::optional<Station> nearer = solve(tau);
    if (nearer && !is_violated(nearer->functions))
      reached = std::move(*nearer);
    return true;
  }
} // namespace fuga

#endif
