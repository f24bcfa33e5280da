// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_simulation_h
#define fuga_simulation_h

#include <fuga/base/phase_timer.h>
#include <fuga/bodies/load_program.h>
#include <fuga/contact/certificate.h>
#include <fuga/contact/event_path.h>
#include <fuga/io/field_writer.h>
#include <fuga/io/parameters.h>
#include <fuga/io/run_log.h>

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
   * One run, from parameters to results. The members are the parts of the program in the order in
   * which data goes through them: mesh, condensed bodies, contact elements, loads, layered system,
   * path, judge, writers. Construction reads and checks everything and condenses the bodies;
   * nothing is written before run().
   */
  template <int dim>
  class Simulation : private PathObserver
  {
  public:
    /** @throws InputError, NumericalFailure */
    explicit Simulation(const Parameters &parameters);

    ~Simulation() override;

    /** Follows the loads and writes all results. */
    ExitCode
    run();

  private:
    void
    advanced(const PathPoint &from, const PathPoint &to, const double length) override;
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

    std::vector<JointDefinition>
    joint_definitions() const;
    std::vector<bool>
    frictionless_joints() const;
    PathOptions
    path_options() const;
    std::vector<ContactElement>
    make_elements();
    LoadProgram
    make_loads();
    std::vector<std::string>
    joint_names() const;
    std::vector<std::string>
    stage_names() const;
    std::vector<std::array<double, 3>>
    normals() const;

    void
    book_body_phases();
    void
    begin_output();
    void
    log_header();
    void
    log_layers();
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

    const Parameters parameters;
    PhaseTimer timer;
    const JointedMesh mesh;
    CondensedSystem<dim> bodies;
    std::vector<std::unique_ptr<ComplianceLaw>> laws;
    const std::vector<ContactElement> elements;
    const LoadProgram loads;
    const LayeredSystem layered;
    EventPath path;
    Judge judge;
    const std::vector<std::string> names_of_joints, names_of_stages;
    const std::vector<std::array<double, 3>> element_normals;
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
