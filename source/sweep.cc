// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/process_info.h>
#include <fuga/contact/certificate.h>
#include <fuga/io/joint_resultant.h>
#include <fuga/sweep.h>
#include <fuga/table_range.h>

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <limits>

namespace fuga
{
  namespace
  {
    constexpr double never = std::numeric_limits<double>::quiet_NaN();

    /** Notes what the table needs and has every event judged. */
    class Observer : public PathObserver
    {
    public:
      Observer(Judge &judge_of_variant, const std::vector<ContactElement> &elements)
        : judge(judge_of_variant), tables(elements)
      {
      }

      void
      advanced(const PathPoint &from, const PathPoint &to, const double length) override
      {
        judge.follow(from, to, length);
        tables.watch(to.state);
        last_state = to.state;
      }

      void
      jumped(const JointState &to) override
      {
        judge.lose_track();
        last_state = to;
      }

      void
      changed(const std::vector<ContactEvent> &events, const JointState &state) override
      {
        last_state = state;
        worst.absorb(judge.judge(state));
        for (const ContactEvent &event : events)
          {
            if (event.to == ContactState::open && !(first_opening <= event.t))
              first_opening = event.t;
            if (is_slipping(event.to) && !(first_slip <= event.t))
              first_slip = event.t;
          }
      }

      void
      reached(const std::size_t, const JointState &) override
      {
      }

      Judge &judge;
      TableRange tables;
      JointState last_state;
      Certificate worst;
      double first_opening = never, first_slip = never;
    };
  } // namespace

  template <int dim>
  struct Sweep<dim>::Row
  {
    std::string verdict;
    PathResult path;
    std::vector<JointResultant> resultants;
    std::vector<std::array<double, 3>> displacements;
    double first_opening = never, first_slip = never;
    double certificate = 0.;
    double seconds     = 0.;
    bool failed        = false;
    std::vector<std::string> warnings;
  };

  template <int dim>
  Sweep<dim>::Sweep(const Model<dim> &shared_model) : model(shared_model)
  {
  }

  // The load patterns are those of the model; another order of stages only changes their factors.
  template <int dim>
  LoadHistory
  Sweep<dim>::history_of(const Variant &variant) const
  {
    if (variant.stages.size() == model.parameters.model.stages.size() &&
        std::is_sorted(variant.stages.begin(), variant.stages.end()))
      return model.loads.history;
    ModelDefinition definition = model.parameters.model;
    definition.stages.clear();
    for (const unsigned int stage : variant.stages)
      definition.stages.push_back(model.parameters.model.stages[stage]);
    return make_load_history<dim>(definition);
  }

  // Only the compliances of the bars enter; friction and cohesion do not.
  template <int dim>
  const LayeredSystem &
  Sweep<dim>::layered_system_of(const JointModel &joint)
  {
    bool same = layered != nullptr;
    for (const ContactElement &element : joint.elements)
      {
        same = same && layered->compliance(element.normal_bar) ==
                         bar_compliance(*element.normal_law, element.area);
        if (element.has_tangential_bar())
          same = same && layered->compliance(element.tangential_bar) ==
                           bar_compliance(*element.shear_law, element.area);
      }
    if (!same)
      {
        layered = std::make_unique<LayeredSystem>(model.bodies, joint.elements);
        ++summary.work.n_layered_systems;
      }
    return *layered;
  }

  template <int dim>
  typename Sweep<dim>::Row
  Sweep<dim>::run_variant(const Variant &variant)
  {
    const auto begin = std::chrono::steady_clock::now();
    const JointModel joint =
      make_joint_model<dim>(model.bodies, variant.joints, model.parameters.model.constants);
    const LoadHistory history   = history_of(variant);
    const LayeredSystem &system = layered_system_of(joint);
    Judge judge(model.bodies, joint.elements, history);
    Observer observer(judge, joint.elements);
    const auto path = make_contact_path(joint.elements, system, history, model.path_options());

    Row row;
    try
      {
        row.path    = path->run({}, observer);
        row.verdict = verdict_name(row.path.verdict);
      }
    catch (const NumericalFailure &)
      {
        row.verdict = "numerical failure";
        row.failed  = true;
      }
    if (!observer.last_state.states.empty())
      {
        observer.worst.absorb(judge.judge(observer.last_state));
        const Vector jumps =
          system.jumps(observer.last_state.dislocations, observer.last_state.forces);
        const auto results = element_results(joint.elements, observer.last_state, jumps);
        row.resultants     = model.resultants(results, judge.dissipation());
        const Vector x     = judge.coordinates(jumps, observer.last_state.t),
                     a     = history.factors(observer.last_state.t);
        for (const Monitor &monitor : model.monitors)
          row.displacements.push_back(monitor.displacement(x, a));
      }
    row.resultants.resize(variant.joints.size());
    row.displacements.resize(model.monitors.size());
    row.first_opening = observer.first_opening;
    row.first_slip    = observer.first_slip;
    row.certificate   = observer.worst.worst();
    row.warnings =
      observer.tables.warnings(model.joint_names, model.parameters.output.units.stress());
    count(row, *path);
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return row;
  }

  template <int dim>
  void
  Sweep<dim>::count(const Row &row, const ContactPath &path)
  {
    ++summary.n_variants;
    ++summary.verdicts[row.verdict];
    summary.n_events += row.path.n_events;
    summary.n_steps += row.path.n_steps;
    summary.n_jumps += row.path.n_jumps;
    summary.n_schemes += row.path.n_schemes;
    summary.n_iterations += path.iterations().n_iterations;
    // Not a number is worse than any number.
    if (!(row.certificate <= summary.worst_certificate))
      summary.worst_certificate = row.certificate;
    SchemeWork &total        = summary.work.scheme;
    const SchemeWork &of_one = path.work();
    total.n_factorisations += of_one.n_factorisations;
    total.n_updates += of_one.n_updates;
    total.n_bars_ever_active = std::max(total.n_bars_ever_active, of_one.n_bars_ever_active);
  }

  template <int dim>
  void
  Sweep<dim>::write_summary(const std::string &verdict, const ExitCode code)
  {
    summary.verdict           = verdict;
    summary.exit_code         = static_cast<int>(code);
    summary.sizes             = model.sizes();
    summary.work.bodies       = model.bodies.work();
    summary.certificate_bound = model.parameters.solver.certificate_bound;
    summary.phases            = model.timer.seconds();
    summary.peaks             = model.timer.peak_megabytes();
    summary.memory_MB         = peak_memory_in_megabytes();
    summary.split_report      = model.mesh.report;
    write_complete_file(model.parameters.output.directory + "/summary.json",
                        summary_json(summary, model.parameters));
  }

  template <int dim>
  std::vector<std::string>
  Sweep<dim>::columns() const
  {
    const Units &u                   = model.parameters.output.units;
    std::vector<std::string> columns = {"variant"};
    for (const auto &setting : model.parameters.variants.front().settings)
      columns.push_back(setting.first);
    columns.insert(columns.end(),
                   {"verdict", "mechanism", "t", "first_opening_t", "first_slip_t", "events"});
    for (const std::string &joint : model.joint_names)
      for (const std::string &quantity : {fmt::format("N[{}]", u.force),
                                          fmt::format("T[{}]", u.force),
                                          fmt::format("M[{}]", u.energy()),
                                          std::string("share_open"),
                                          std::string("share_slip"),
                                          fmt::format("largest_pressure[{}]", u.stress()),
                                          std::string("sliding_safety"),
                                          std::string("overturning_safety"),
                                          fmt::format("cracked_length[{}]", u.length)})
        columns.push_back(joint + " " + quantity);
    for (const Monitor &monitor : model.monitors)
      for (const char *component : {"ux", "uy"})
        columns.push_back(fmt::format("{} {}[{}]", monitor.name(), component, u.length));
    columns.insert(columns.end(), {"certificate", "seconds"});
    return columns;
  }

  template <int dim>
  void
  Sweep<dim>::write(CsvFile &table,
                    const std::size_t number,
                    const Variant &variant,
                    const Row &row) const
  {
    table.add(number);
    for (const auto &setting : variant.settings)
      table.add(setting.second);
    table.add(row.verdict);
    table.add(mechanism_name(row.path.mechanism));
    for (const double value : {row.path.t, row.first_opening, row.first_slip})
      table.add(value);
    table.add(row.path.n_events);
    for (const JointResultant &r : row.resultants)
      for (const double value : {r.N,
                                 r.T,
                                 r.M,
                                 r.share_open,
                                 r.share_slip,
                                 r.largest_pressure,
                                 r.sliding_safety,
                                 r.overturning_safety,
                                 r.cracked_length})
        table.add(value);
    for (const auto &u : row.displacements)
      for (unsigned int c = 0; c < dim; ++c)
        table.add(u[c]);
    table.add(row.certificate);
    table.add(row.seconds);
    table.end_row();
  }

  template <int dim>
  ExitCode
  Sweep<dim>::run()
  {
    const Parameters &parameters = model.parameters;
    begin_results(parameters.output.directory,
                  [this]() { write_summary("unfinished", ExitCode::done); });
    CsvFile table(parameters.output.directory + "/sweep.csv", columns());
    table.publish(true);
    const bool quiet = parameters.output.log == LogDetail::quiet;
    bool any_failed  = false;
    for (std::size_t i = 0; i < parameters.variants.size(); ++i)
      {
        const Variant &variant = parameters.variants[i];
        const Row row          = run_variant(variant);
        write(table, i + 1, variant, row);
        table.publish(false);
        any_failed = any_failed || row.failed;
        if (quiet)
          continue;
        std::string settings;
        for (const auto &[name, value] : variant.settings)
          settings += fmt::format("{}{} = {}", settings.empty() ? "" : ", ", name, value);
        fmt::print("{:>5}  {:<60} {:<15} {:<12} t = {:<12.9g} certificate {:.1e}\n",
                   i + 1,
                   settings,
                   row.verdict,
                   mechanism_name(row.path.mechanism),
                   row.path.t,
                   row.certificate);
        for (const std::string &warning : row.warnings)
          fmt::print("       Warning: {}\n", warning);
      }
    table.publish(true);
    model.timer.finish("variants");
    const ExitCode code = any_failed ? ExitCode::numerical_failure
                          : summary.worst_certificate <= parameters.solver.certificate_bound
                            ? ExitCode::done
                            : ExitCode::certificate_violated;
    write_summary(any_failed ? "numerical failure" : "done", code);
    if (!quiet)
      fmt::print(
        "{} variants on one condensation, worst certificate {:.1e}. Results {}/sweep.csv\n",
        parameters.variants.size(),
        summary.worst_certificate,
        parameters.output.directory);
    return code;
  }

  template class Sweep<2>;
  template class Sweep<3>;
} // namespace fuga
