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
   * What a run writes while its path is followed: the record from which its summary is made, its
   * log, its tables and its fields. Nothing is written before
   * begin().
   */
  template <int dim>
  class RunJournal
  {
  public:
    /** @p phase must outlive this object. @p accuracy: how the mesh of the model was found, if it
     * was. */
    RunJournal(PhaseRun<dim> &phase, AccuracyReport accuracy);

    /** Takes the directory: results of an earlier run are removed, the files of this one begin. */
    void
    begin();

    /** The path is in @p state. */
    void
    advance_to(const JointState &state);

    /** The path met @p events, behind which it is in @p state. */
    void
    add_events(const std::vector<ContactEvent> &events, const JointState &state);

    /** Writes tables and, on request, fields of a level in @p state. */
    void
    write_state(const JointState &state, const bool with_fields);

    /** Writes the last state in equilibrium, e.g. that at a limit load, like a level; not if it is
     * one. */
    void
    write_last_state();

    /** Writes the fields of @p state, in which the bodies are displaced by @p displacement. */
    void
    write_fields(const JointState &state,
                 const std::vector<ElementResult> &results,
                 const dealii::Vector<double> &displacement);

    /** Writes a row for every monitor; @p occasion: see HistoryWriter::add_monitors(). */
    void
    write_monitors(const JointState &state, const std::string &occasion);

    /** Brings log and tables on disk up to date, where it is time or @p now. */
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
