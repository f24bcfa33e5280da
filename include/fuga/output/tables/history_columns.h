// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_tables_history_columns_h
#define fuga_output_tables_history_columns_h

#include <fuga/bodies/dynamics/response_spectrum.h>
#include <fuga/bodies/program/driving_quantity.h>
#include <fuga/bodies/program/monitor.h>
#include <fuga/contact/dynamics/moving_bodies.h>
#include <fuga/contact/judge/certificate.h>
#include <fuga/contact/path/path_observer.h>
#include <fuga/input/units.h>
#include <fuga/output/files/table.h>
#include <fuga/output/results/joint_resultant.h>

namespace fuga
{
  /** What the rows of all tables say of the moment that they belong to. */
  struct Moment
  {
    double t;
    DrivingQuantity drive;
    double certificate;
    /** Growth of the largest jump beyond the limit load. */
    double path_length;
  };

  /** What happens to bodies in motion besides changes of state. */
  struct MotionEvent
  {
    double t;
    /** That whose lips move farthest. */
    std::size_t element;
    /** The words before and after it. */
    std::array<std::string_view, 2> names;
    /** Work on all joints [MNm]. */
    double energy;
  };

  struct EventRow
  {
    const Moment &moment;
    std::size_t number;
    std::array<std::string_view, 2> names;
    std::size_t n_branches;
    /** Not a number but of a MotionEvent. */
    double energy;
    const ContactElement &element;
    const std::string &joint, &stage;
    double stage_fraction;
  };

  struct ElementRow
  {
    const Moment &moment;
    const std::string &joint;
    const ContactElement &element;
    const ElementResult &result;
  };

  struct ResultantRow
  {
    const Moment &moment;
    const std::string &joint;
    const JointResultant &resultant;
    const EnergyLedger &energies;
  };

  struct MonitorRow
  {
    const Moment &moment;
    const std::string &occasion;
    const Monitor &monitor;
    std::array<double, 3> displacement;
    /** xx, yy, zz, xy, xz, yz. */
    std::array<double, 6> stress;
  };

  /** At the end of a whole step of time. */
  struct AccelerationRow
  {
    const std::string &stage, &monitor;
    /** Since the stage began [s]. */
    double time;
    /** Absolute [m/s²]. */
    std::array<double, 3> acceleration;
  };

  struct SpectrumRow
  {
    const std::string &stage, &monitor;
    char axis;
    const SpectralResponse &response;
  };

  /** The end of a step of time. */
  struct MotionMoment
  {
    /** Since the stage began [s]. */
    double time = 0.;
    /** Acceleration of the ground [m/s²]. */
    std::array<double, 3> ground = {{0., 0., 0.}};
    const MotionLedger &energies;
  };

  struct MotionRow
  {
    double t;
    const MotionMoment &moment;
    const std::string &joint;
    const JointResultant &resultant;
  };

  /** What tables tell of a joint as a whole, of which each has some. */
  Columns<JointResultant>
  resultant_quantities(const Units &units);

  /** What tables tell of the energies of a motion. */
  Columns<MotionLedger>
  motion_energies(const Units &units);

  /** The columns of the tables of a run: doc/results.md. @p in_space, @p has_water, @p
   * has_motion: with those that only models in space, with water in joints, or with bodies that may
   * move have. */
  Columns<EventRow>
  event_columns(const Units &units, const bool has_motion);
  Columns<ElementRow>
  history_columns(const Units &units, const bool has_water);
  Columns<ResultantRow>
  resultant_columns(const Units &units, const bool has_water, const bool in_space);
  Columns<MonitorRow>
  monitor_columns(const Units &units, const bool in_space);
  Columns<AccelerationRow>
  acceleration_columns(const Units &units, const bool in_space);
  Columns<SpectrumRow>
  spectrum_columns(const Units &units);
  Columns<MotionRow>
  motion_columns(const Units &units, const bool in_space);
} // namespace fuga

#endif
