// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_tables_history_columns_h
#define fuga_output_tables_history_columns_h

#include <fuga/bodies/dynamics/response_spectrum.h>
#include <fuga/bodies/program/driving_quantity.h>
#include <fuga/bodies/program/monitor.h>
#include <fuga/contact/dynamics/moving_bodies.h>
#include <fuga/contact/judge/judge_memory.h>
#include <fuga/contact/path/path_observer.h>
#include <fuga/input/units.h>
#include <fuga/output/files/table.h>
#include <fuga/output/results/joint_resultant.h>

namespace fuga
{
  /** The data that the rows of all tables contain about the moment to which they belong. */
  struct Moment
  {
    double t;
    DrivingQuantity drive;
    double certificate;
    /** Growth of the largest jump beyond the limit load. */
    double path_length;
  };

  /** An event of bodies in motion that is not a change of state. */
  struct MotionEvent
  {
    double t;
    /** The element whose lips move farthest. */
    std::size_t element;
    /** The words for the states before and after the event. */
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
    /** Work on all joints if the row is a MotionEvent, otherwise not a number. */
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
    /** Stress in the order xx, yy, zz, xy, xz, yz. */
    std::array<double, 6> stress;
  };

  /** A row at the end of a whole time step. */
  struct AccelerationRow
  {
    const std::string &stage, &monitor;
    /** Time since the stage began [s]. */
    double time;
    /** Absolute acceleration [m/s²]. */
    std::array<double, 3> acceleration;
  };

  struct SpectrumRow
  {
    const std::string &stage, &monitor;
    char axis;
    const SpectralResponse &response;
  };

  /** The end of a time step. */
  struct MotionMoment
  {
    /** Time since the stage began [s]. */
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

  /** Return all columns that describe a joint as a whole, of which each table uses some. */
  Columns<JointResultant>
  resultant_quantities(const Units &units);

  /** Return the columns that describe the energies of a motion. */
  Columns<MotionLedger>
  motion_energies(const Units &units);

  /**
   * Return the columns of the tables of a run, see doc/results.md. @p in_space, @p has_water and
   * @p has_motion add those that only models in space, with water in joints, or with bodies that
   * may move have.
   */
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
