// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_journal_run_journal_h
#define fuga_run_journal_run_journal_h

#include <fuga/output/restart/checkpoint.h>
#include <fuga/output/tables/accuracy_report.h>
#include <fuga/output/warnings/model_range.h>
#include <fuga/run/model/phase_run.h>

namespace fuga
{
  /**
   * The output of a run while its path is followed: the record from which its summary is made, its
   * log, its tables and its fields. Nothing is written before begin().
   */
  template <int dim>
  class RunJournal
  {
  public:
    /**
     * @p phase must outlive this object. @p accuracy describes how the mesh of the model was found,
     * if it was adapted.
     */
    RunJournal(PhaseRun<dim> &phase, AccuracyReport accuracy);

    /**
     * Prepare the directory: remove the results of an earlier run and begin the files of this one.
     */
    void
    begin();

    /** Record that the path has reached @p state. */
    void
    advance_to(const JointState &state);

    /** Record @p events on the path, after which it is in @p state. */
    void
    add_events(const std::vector<ContactEvent> &events, const JointState &state);

    /** Write tables and, on request, fields of a level in @p state. */
    void
    write_state(const JointState &state, const bool with_fields);

    /**
     * Write the last state in equilibrium, e.g. that at a limit load, like a level, unless it is
     * one.
     */
    void
    write_last_state();

    /** Write the fields of @p state, in which the bodies are displaced by @p displacement. */
    void
    write_fields(const JointState &state,
                 const std::vector<ElementResult> &results,
                 const dealii::Vector<double> &displacement);

    /** Write a row for every monitor; for @p occasion, see HistoryWriter::add_monitors(). */
    void
    write_monitors(const JointState &state, const std::string &occasion);

    /** Bring log and tables on disk up to date if it is time to, or if @p now is true. */
    void
    publish(const bool now);

    PhaseRun<dim> &phase;
    const AccuracyReport accuracy;
    const HistoryContext context;
    RunRecord record;
    RunLog log;
    HistoryWriter history;
    FieldWriter<dim> fields;

  private:
    ModelRange model_range;
  };
} // namespace fuga

#endif
