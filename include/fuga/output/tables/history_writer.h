// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_tables_history_writer_h
#define fuga_output_tables_history_writer_h

#include <fuga/contact/path/event_path.h>
#include <fuga/input/parameters.h>
#include <fuga/output/tables/history_columns.h>

#include <memory>

namespace fuga
{
  /** Fixed data that every row refers to. */
  struct HistoryContext
  {
    const std::vector<ContactElement> &elements;
    const std::vector<std::string> &joint_names;
    /** Whether a joint has bodies on both sides. */
    const std::vector<bool> &joints_there;
    const std::vector<std::string> &stage_names;
    const std::vector<Monitor> &monitors;
    Units units;
    /** Tables have columns of the water in joints. */
    bool has_water = false;
    /** Tables have columns of the third dimension. */
    bool in_space = false;
    /** Some stage is dynamic. */
    bool has_motion = false;
    SpectrumSettings spectra;
    DrivingQuantities driving;
  };

  /** Which stage a load time belongs to (the end of a stage to that stage), and the fraction done.
   */
  std::pair<std::size_t, double>
  stage_of(const double t, const std::size_t n_stages);

  /** The same of an event: at a whole number it is the loads of the next stage that cause it. */
  std::pair<std::size_t, double>
  stage_of_event(const double t, const std::size_t n_stages);

  /** What a checkpoint keeps of the tables. */
  struct HistoryMemory
  {
    /** Of all that the run has, each with the name of its file. */
    std::vector<std::pair<std::string, TextMemory>> files;
    std::size_t n_events = 0;
  };

  template <typename Memory, typename Visitor, only_for<Memory, HistoryMemory> = 0>
  void
  for_each_field(Memory &memory, Visitor &&visit)
  {
    auto &[files, n_events] = memory;
    visit("files", files);
    visit("n_events", n_events);
  }

  /**
   * The tables of a run: events.csv (one row per change of state), joint_history.csv (one row per
   * element and level), resultants.csv (one row per joint and level), if there are monitors,
   * monitors.csv (one row per monitor and level, event or step of time), if there are dynamic
   * stages, earthquake.csv (one row per joint and step of time), and on request accelerations.csv
   * and spectra.csv of the monitors in them. Columns: doc/results.md.
   */
  class HistoryWriter
  {
  public:
    /** Nothing is published yet. */
    HistoryWriter(const std::string &directory, const HistoryContext &context);

    HistoryMemory
    memory() const;

    void
    restore(const HistoryMemory &memory);

    void
    add_events(const std::vector<ContactEvent> &events, const double certificate);

    void
    add_event(const MotionEvent &event);

    void
    add_level(const double t,
              const std::vector<ElementResult> &results,
              const std::vector<JointResultant> &joint_resultants,
              const EnergyLedger &energies,
              const double certificate);

    /** A step of time of a dynamic stage has ended. */
    void
    add_motion(const double t,
               const MotionMoment &moment,
               const std::vector<JointResultant> &joint_resultants);

    /** Growth of the largest jump beyond the limit load, for all rows that follow; 0 before it. */
    void
    set_path_length(const double length)
    {
      length_beyond = length;
    }

    double
    path_length() const
    {
      return length_beyond;
    }

    /** Displacements and stresses of the monitors; @p occasion: "level", "event" or "step"; @p
     * thermal_strains: one per monitor. */
    void
    add_monitors(const double t,
                 const std::string &occasion,
                 const Vector &coordinates,
                 const Vector &factors,
                 const Vector &thermal_strains);

    /** What the monitors felt in a stage, and the response spectra of it. */
    void
    add_accelerations(const std::size_t stage,
                      const std::vector<std::array<GroundMotion, 3>> &of_monitors);

    /** Brings the files on disk up to date. */
    void
    publish(const bool now);

  private:
    void
    add_event(const double t,
              const double certificate,
              const std::size_t element,
              const std::array<std::string_view, 2> &names,
              const std::size_t n_branches,
              const double energy);

    Moment
    moment(const double t, const std::size_t stage, const double certificate) const;

    /** Calls @p visit with every table that @p writer has. */
    template <typename Writer, typename Visitor>
    static void
    for_each_table(Writer &writer, const Visitor &visit);

    const HistoryContext context;
    Table<EventRow> events;
    Table<ElementRow> history;
    Table<ResultantRow> resultants;
    /** Only if there are monitors. */
    std::unique_ptr<Table<MonitorRow>> monitors;
    /** Only if there are dynamic stages. */
    std::unique_ptr<Table<MotionRow>> motion;
    /** Only on request. */
    std::unique_ptr<Table<AccelerationRow>> accelerations;
    std::unique_ptr<Table<SpectrumRow>> spectra;
    std::size_t n_events = 0;
    double length_beyond = 0.;
  };
} // namespace fuga

#endif
