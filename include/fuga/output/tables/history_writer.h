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
  /** Constant data to which every row refers. */
  struct HistoryContext
  {
    const std::vector<ContactElement> &elements;
    const std::vector<std::string> &joint_names;
    /** Tells for each joint whether there are bodies on both sides. */
    const std::vector<bool> &joints_there;
    const std::vector<std::string> &stage_names;
    const std::vector<Monitor> &monitors;
    Units units;
    /** Whether tables have columns of the water in joints. */
    bool has_water = false;
    /** Whether tables have columns of the third dimension. */
    bool in_space = false;
    /** Whether any stage is dynamic. */
    bool has_motion = false;
    SpectrumSettings spectra;
    DrivingQuantities driving;
  };

  /**
   * Return the stage to which a load time belongs (the end of a stage belongs to that stage), and
   * the fraction of it that is done.
   */
  std::pair<std::size_t, double>
  stage_of(const double t, const std::size_t n_stages);

  /**
   * Return the same for an event: at a whole number it is caused by the loads of the next stage.
   */
  std::pair<std::size_t, double>
  stage_of_event(const double t, const std::size_t n_stages);

  /** The state of the tables in a checkpoint. */
  struct HistoryMemory
  {
    /** The states of all tables of the run, each with the name of its file. */
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
   * monitors.csv (one row per monitor and level, event or time step), if there are dynamic stages,
   * earthquake.csv (one row per joint and time step), and on request accelerations.csv and
   * spectra.csv of the monitors in them. The columns are described in doc/results.md.
   */
  class HistoryWriter
  {
  public:
    /** Create the tables; nothing is published yet. */
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

    /** Add rows at the end of a time step of a dynamic stage. */
    void
    add_motion(const double t,
               const MotionMoment &moment,
               const std::vector<JointResultant> &joint_resultants);

    /**
     * Set the growth of the largest jump beyond the limit load for all following rows; 0 before it.
     */
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

    /**
     * Add displacements and stresses of the monitors; @p occasion is "level", "event" or "step",
     * @p thermal_strains has one entry per monitor.
     */
    void
    add_monitors(const double t,
                 const std::string &occasion,
                 const Vector &coordinates,
                 const Vector &factors,
                 const Vector &thermal_strains);

    /** Add the accelerations of the monitors in a stage, and their response spectra. */
    void
    add_accelerations(const std::size_t stage,
                      const std::vector<std::array<GroundMotion, 3>> &of_monitors);

    /** Bring the files on disk up to date. */
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

    /** Call @p visit with every table that @p writer has. */
    template <typename Writer, typename Visitor>
    static void
    for_each_table(Writer &writer, const Visitor &visit);

    const HistoryContext context;
    Table<EventRow> events;
    Table<ElementRow> history;
    Table<ResultantRow> resultants;
    /** Present only if there are monitors. */
    std::unique_ptr<Table<MonitorRow>> monitors;
    /** Present only if there are dynamic stages. */
    std::unique_ptr<Table<MotionRow>> motion;
    /** Present only on request. */
    std::unique_ptr<Table<AccelerationRow>> accelerations;
    std::unique_ptr<Table<SpectrumRow>> spectra;
    std::size_t n_events = 0;
    double length_beyond = 0.;
  };
} // namespace fuga

#endif
