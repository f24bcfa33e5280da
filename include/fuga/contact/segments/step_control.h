// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_segments_step_control_h
#define fuga_contact_segments_step_control_h

#include <algorithm>
#include <cmath>

namespace fuga
{
  /**
   * Determines the length of the next step along a curve from an error, relative to what is
   * allowed, that grows with the fifth power of the length.
   */
  class StepControl
  {
  public:
    explicit StepControl(const double first_length) : length(first_length)
    {
    }

    void
    limit(const double largest)
    {
      length = std::min(length, largest);
    }

    /** Divide a step of length @p part. */
    void
    divide(const double part)
    {
      rejected_error = 0.;
      length         = 0.5 * part;
    }

    /** Note that the step has no end. */
    void
    fail()
    {
      rejected_error = 0.;
      length *= 0.25;
    }

    /** Note a rejected step. If a step from the same point is rejected a second time, the two
     * errors show how the error falls: by less than the order where directions turn into others at
     * once. */
    void
    reject(const double error)
    {
      double order = 5.;
      if (rejected_error > error)
        order = std::clamp(std::log(rejected_error / error) / std::log(rejected_length / length),
                           least_order,
                           order);
      rejected_error  = error;
      rejected_length = length;
      length *= std::max(0.1, 0.9 * std::pow(error, -1. / order));
    }

    /** Note an accepted step. With @p foreseeing, a change of the leading term of the error is
     * extrapolated from step to step: where directions turn faster and faster, as towards the apex
     * of a cone, every second step would be rejected otherwise (Gustafsson, ACM Trans. Math. Softw.
     * 20, 1994). A corner of a law, passed by short steps, tells nothing about what follows. */
    void
    accept(const double error, const bool foreseeing)
    {
      rejected_error        = 0.;
      const double of_error = growth(error), taken = length;
      length *= std::min(largest_growth, of_error);
      if (foreseeing && taken_before > 0.)
        length *= std::clamp(taken / taken_before * of_error / growth_before, least_foreseen, 1.);
      taken_before  = taken;
      growth_before = of_error;
    }

    double
    operator()() const
    {
      return length;
    }

  private:
    static constexpr double largest_growth = 5., least_order = 1., least_foreseen = 0.2;

    static double
    growth(const double error)
    {
      constexpr double least_error = 1e-8;
      return 0.9 * std::pow(std::max(error, least_error), -0.2);
    }

    double length, taken_before = 0., growth_before = 1.;
    double rejected_length = 0., rejected_error = 0.;
  };
} // namespace fuga

#endif
