// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_path_report_counter_h
#define fuga_contact_path_report_counter_h

#include <fuga/contact/path/path_observer.h>

namespace fuga
{
  /**
   * Hands on the reports of a path and counts them. A path that is followed again from a cut
   * repeats its reports; those that its observer has already received are not repeated. After each
   * report the path can be left in a consistent state, and this is where it ends if the user wishes
   * so.
   */
  class ReportCounter : public PathObserver
  {
  public:
    /** Constructor. The first @p n_reports reports are not handed on; from now on this argument
     * counts the reports. */
    ReportCounter(PathObserver &observer, std::size_t &n_reports);

    /** Restart the count. @throws NumericalFailure if fewer reports were made than had been
     * received before. */
    void
    start();

    bool
    wants_cuts() const override;
    bool
    wants_more() const override;
    void
    advanced(const PathPoint &from, const PathPoint &to, const double length) override;
    void
    jumped(const JointState &to) override;
    void
    jumped_in_motion(const JointState &to, const double work) override;
    void
    changed(const std::vector<ContactEvent> &events, const JointState &state) override;
    void
    reached(const std::size_t index, const JointState &state) override;
    void
    began_motion() override;
    void
    began_step(const ContactSystem &system, const LoadHistory &history) override;
    void
    ended_step(const JointState &state) override;
    void
    went_beyond(const double length, const JointState &state) override;

  private:
    /** True while a time step is being reported, which is not interrupted. */
    bool in_step = false;
    /** Make the report unless it was received before. @throws Interrupted after it. */
    template <typename Report>
    void
    hand_on(const Report &report);

    PathObserver &observer;
    std::size_t n_heard;
    std::size_t &count;
  };
} // namespace fuga

#endif
