// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_simulation_h
#define fuga_simulation_h

#include <fuga/contact/certificate.h>
#include <fuga/contact/event_path.h>
#include <fuga/io/field_writer.h>
#include <fuga/io/run_log.h>
#include <fuga/joint_model.h>
#include <fuga/model.h>
#include <fuga/table_range.h>

namespace fuga
{
  /** Exit codes of the program. */
  enum class ExitCode
  {
    done                 = 0,
    input_error          = 1,
    numerical_failure    = 2,
    loss_of_equilibrium  = 3,
    certificate_violated = 4
  };

  /**
   * One run of a model: joints, layered system, path, judge and writers, in the order in which data
   * goes through them. Nothing is written before run().
   */
  template <int dim>
  class Simulation : private PathObserver
  {
  public:
    /** @throws InputError, NumericalFailure */
    explicit Simulation(const Model<dim> &model);

    ~Simulation() override;

    /** Follows the loads and writes all results. */
    ExitCode
    run();

  private:
    void
    advanced(const PathPoint &from, const PathPoint &to, const double length) override;
    void
    jumped(const JointState &to) override;
    void
    changed(const std::vector<ContactEvent> &events, const JointState &state) override;
    void
    reached(const std::size_t index, const JointState &state) override;

    /** How a run ended. */
    struct Outcome
    {
      PathResult path;
      std::string verdict;
      ExitCode code = ExitCode::done;
      std::string message;
    };

    void
    begin_output();
    void
    log_header();
    void
    log_layers();
    std::string
    shear_description(const unsigned int j) const;
    void
    write_state(const JointState &state, const bool with_fields);
    void
    write_last_state();
    void
    finish(const Outcome &outcome);
    void
    log_closing_table(const Outcome &outcome);
    void
    write_summary(const Outcome &outcome);

    const Model<dim> &model;
    const Parameters &parameters;
    const JointModel joint;
    const LayeredSystem layered;
    EventPath path;
    Judge judge;
    TableRange tables;
    const HistoryContext context;
    RunLog log;
    FieldWriter<dim> fields;
    std::unique_ptr<HistoryWriter> history;

    JointState last_state;
    std::size_t levels_written = 0;
    Certificate worst;
    std::map<std::string, std::size_t> events_by_kind;
    std::size_t n_events = 0;
  };
} // namespace fuga

#endif
