// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_contact_cycle_record_h
#define fuga_tests_contact_cycle_record_h

#include "contact/toy_system.h"

namespace fuga::tests
{
  /** Stage one from zero to @p begin, then n cycles of two stages that end at @p first, @p second.
   */
  LoadHistory
  cyclic_history(const std::size_t n,
                 const Vector &first,
                 const Vector &second,
                 const Vector &begin);

  /** 1, 2, … n. */
  std::vector<double>
  whole_numbers(const std::size_t n);

  /**
   * What many cycles must keep: of each cycle the loss and its number of events, of the second and
   * the last one the end state, and the worst certificate. Its memory does not grow with the
   * events.
   */
  class CycleRecord : public PathObserver
  {
  public:
    CycleRecord(const ContactSystem &system,
                const std::vector<ContactElement> &elements,
                const LoadHistory &history);

    void
    advanced(const PathPoint &from, const PathPoint &to, const double length) override;
    void
    jumped(const JointState &to) override;
    void
    changed(const std::vector<ContactEvent> &events, const JointState &state) override;
    /** Levels are the ends of the stages: 0 the first loading, then two per cycle. */
    void
    reached(const std::size_t index, const JointState &state) override;

    Certificate worst;
    /** Per cycle. */
    std::vector<double> loss;
    std::vector<std::size_t> n_events;
    /** Memory in use at the end of each cycle [bytes]. */
    std::vector<std::size_t> memory;
    JointState end_of_second, last;

  private:
    Judge judge;
    double loss_before            = 0.;
    std::size_t n_events_in_cycle = 0;
  };

  /**
   * The demands on many cycles of a problem whose cycles are alike from the second on: losses equal
   * to 1e-9 of @p loss_scale, forces and dislocations back (but for @p advance per cycle of the
   * tangential ones), certificate, events, time and memory per cycle constant.
   */
  void
  expect_steady_cycles(const CycleRecord &record,
                       const std::vector<ContactElement> &elements,
                       const double loss_scale,
                       const double advance = 0.);
} // namespace fuga::tests

#endif
