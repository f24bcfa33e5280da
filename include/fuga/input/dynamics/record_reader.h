// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_dynamics_record_reader_h
#define fuga_input_dynamics_record_reader_h

#include <fuga/bodies/dynamics_definition.h>

#include <string>

namespace fuga
{
  /** The columns of a text that contain the record; they are counted from 1. */
  struct RecordColumns
  {
    /** Column of the time; 0: there is none, and the step is given [s]. */
    unsigned int time = 1;
    double step       = 0.;

    unsigned int acceleration = 2;
  };

  /**
   * Read samples from lines of numbers separated by blanks, commas or semicolons, with comments
   * starting at #, in the unit of the text. Times increase in equal steps, up to the rounding of
   * their digits.
   * @throws InputError that begins with @p name and the line.
   */
  GroundMotion
  read_record_in_columns(const std::string &name,
                         const std::string &text,
                         const RecordColumns &columns);

  /**
   * Read samples in the format of the PEER data base: lines that end with the number of samples and
   * their step, in one of the two forms "NPTS= 4000, DT= .005 SEC" and "4000 .005 NPTS, DT";
   * followed by samples, any number per line.
   */
  GroundMotion
  read_record_at2(const std::string &name, const std::string &text);
} // namespace fuga

#endif
