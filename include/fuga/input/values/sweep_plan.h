// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_values_sweep_plan_h
#define fuga_input_values_sweep_plan_h

#include <fuga/input/values/parameter_scanner.h>

namespace fuga
{
  /** One line of section Sweep: entries that assume the same values, one after the other. */
  struct SweptLine
  {
    /** The line, e.g. "Sweep", "Joints/base/Cohesion", "0, 10", and its origin. */
    ScannedEntry line;
    /** Entries without values; none if the line varies the order of the stages. */
    std::vector<ScannedEntry> targets;
    std::vector<std::string> values;
    /** The present form of the line, after `set`, if it was written in an older form. */
    std::string today;
  };

  /**
   * The variants requested by section Sweep: each is a scan like that of a file of its own. Nothing
   * but the form of the section is checked here; whether entries and values make sense is found out
   * when a variant is read, with the messages that a file gives.
   */
  class SweepPlan
  {
  public:
    /**
     * Remove the lines that vary something from @p scan and store them.
     * @throws InputError for lines whose form is wrong, or that vary the same entry.
     */
    explicit SweepPlan(ParameterScan scan);

    /**
     * Return the number of combinations of the values, or of values if they are varied together; 0
     * without a sweep.
     */
    std::size_t
    n_variants() const;

    const std::vector<SweptLine> &
    lines() const
    {
      return swept_lines;
    }

    /**
     * Return the number of the value of every line in variant @p i; the first line varies slowest.
     */
    std::vector<std::size_t>
    choice(const std::size_t i) const;

    /** Return the file with the values of variant @p i, which have the origin of their lines. */
    ParameterScan
    variant(const std::size_t i) const;

    /** Return the file without the sweep. */
    const ParameterScan &
    file() const
    {
      return scan;
    }

  private:
    void
    add_line(const ScannedEntry &entry);
    void
    add_older_line(const ScannedEntry &entry);
    void
    add_sequences(const ScannedEntry &entry, const char separator);
    /** Return the entries denoted by "SECTION/NAMES/ENTRY". */
    std::vector<ScannedEntry>
    targets_of(const std::string &name, const ScannedEntry &entry) const;
    std::vector<std::string>
    subsections_of(const std::string &section) const;
    void
    check_together() const;

    ParameterScan scan;
    std::vector<SweptLine> swept_lines;
    bool in_step = false;
  };

  /**
   * Return the values of a line: "a | b" if values contain commas themselves, otherwise "a, b"
   * (commas in brackets do not separate), or a range "first : step : last" of expressions of the
   * constants.
   * @throws InputError
   */
  std::vector<std::string>
  split_swept_values(const ScannedEntry &line, const ParameterScan &file);
} // namespace fuga

#endif
