// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_restart_checkpoint_h
#define fuga_output_restart_checkpoint_h

#include <fuga/bodies/construction.h>
#include <fuga/contact/dynamics/motion_cut.h>
#include <fuga/contact/judge/certificate.h>
#include <fuga/contact/path/event_path.h>
#include <fuga/input/parameters.h>
#include <fuga/output/fields/field_writer.h>
#include <fuga/output/results/monitored_motion.h>
#include <fuga/output/results/motion_beyond_limit.h>
#include <fuga/output/tables/history_writer.h>
#include <fuga/output/tables/run_log.h>
#include <fuga/output/warnings/model_range.h>

#include <map>

namespace fuga
{
  /** The record of a run, kept for its summary. */
  struct RunRecord
  {
    JointState last_state;
    std::size_t levels_written = 0;
    Certificate worst;
    std::map<std::string, std::size_t> events_by_kind;
    std::size_t n_events = 0;
    /**
     * Energies at the end of the last dynamic stage, and its numbers of steps by number of
     * halvings.
     */
    MotionLedger motion_energies;
    std::vector<std::size_t> motion_steps;
    /** Number of intervals Output/Field interval that have passed in this stage. */
    double n_intervals = 0.;
    /** Motions after the loss of an equilibrium; the last one may still be under way. */
    std::vector<MotionBeyondLimit> continuations;
    ModelRange::Record excesses;
  };

  template <typename Record, typename Visitor, only_for<Record, RunRecord> = 0>
  void
  for_each_field(Record &record, Visitor &&visit)
  {
    auto &[last_state,
           levels_written,
           worst,
           events_by_kind,
           n_events,
           motion_energies,
           motion_steps,
           n_intervals,
           continuations,
           excesses] = record;
    visit("last_state", last_state);
    visit("levels_written", levels_written);
    visit("worst", worst);
    visit("events_by_kind", events_by_kind);
    visit("n_events", n_events);
    visit("motion_energies", motion_energies);
    visit("motion_steps", motion_steps);
    visit("n_intervals", n_intervals);
    visit("continuations", continuations);
    visit("excesses", excesses);
  }

  /**
   * Everything from which a run can be continued so that its results are those of an uninterrupted
   * one, bit for bit: the path up to a cut, judge, tables, fields and log. The problem itself is
   * not stored, only what it was defined by, so that no other problem is continued.
   */
  struct Checkpoint
  {
    /** The result of description_of_problem(), and the identity of the mesh file. */
    std::vector<std::pair<std::string, std::string>> parameters;
    FileIdentity mesh;
    /** Whether the run had come to its end, with this verdict and exit code. */
    bool finished = false;
    std::string verdict;
    int exit_code = 0;

    ConstructionState construction;
    PathCut cut;
    /** For bodies in motion: the data that belong to the cut, and the samples of the monitors. */
    MotionCut motion;
    MotionSamples samples;
    JudgeMemory judge;
    RunRecord record;
    HistoryMemory tables;
    FieldCollections fields;
    LogMemory log;
  };

  template <typename Point, typename Visitor, only_for<Point, Checkpoint> = 0>
  void
  for_each_field(Point &checkpoint, Visitor &&visit)
  {
    auto &[parameters,
           mesh,
           finished,
           verdict,
           exit_code,
           construction,
           cut,
           motion,
           samples,
           judge,
           record,
           tables,
           fields,
           log] = checkpoint;
    visit("parameters", parameters);
    visit("mesh", mesh);
    visit("finished", finished);
    visit("verdict", verdict);
    visit("exit_code", exit_code);
    visit("construction", construction);
    visit("cut", cut);
    visit("motion", motion);
    visit("samples", samples);
    visit("judge", judge);
    visit("record", record);
    visit("tables", tables);
    visit("fields", fields);
    visit("log", log);
  }

  /** Write checkpoint.cbor, which is complete whenever it is visible. @throws WriteFailure */
  void
  write_checkpoint(const std::string &directory, const Checkpoint &checkpoint);

  /**
   * Read checkpoint.cbor and check that the results to which it refers exist.
   * @throws InputError if there is none, if it or a result is damaged, or if it was written by
   * another version of the program.
   */
  Checkpoint
  read_checkpoint(const std::string &directory);

  /**
   * @throws InputError that names every difference unless @p parameters define the same problem,
   * except for entries on which the path does not depend and stages added at the end.
   */
  void
  check_same_problem(const Checkpoint &checkpoint, const Parameters &parameters);

  /**
   * Return what defines the problem: Parameters::echo, and data that identify the motion of the
   * ground. The mesh is identified by its file.
   */
  std::vector<std::pair<std::string, std::string>>
  description_of_problem(const Parameters &parameters);

  /** Return whether nothing is left to compute. */
  bool
  is_complete(const Checkpoint &checkpoint, const Parameters &parameters);
} // namespace fuga

#endif
