// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/interruption.h>
#include <fuga/base/process_info.h>
#include <fuga/contact/certificate.h>
#include <fuga/io/joint_resultant.h>
#include <fuga/io/mechanism_text.h>
#include <fuga/io/version.h>
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
      double first_opening = std::numeric_limits<double>::quiet_NaN();
      double first_slip    = std::numeric_limits<double>::quiet_NaN();
    };
  } // namespace

  template <int dim>
  Sweep<dim>::Sweep(const Model<dim> &shared_model)
    : model(shared_model), log(model.parameters.output.directory + "/log.txt")
  {
  }

  template <int dim>
  bool
  Sweep<dim>::has_stages_of_model(const Variant &variant) const
  {
    return variant.stages.size() == model.parameters.model.stages.size() &&
           std::is_sorted(variant.stages.begin(), variant.stages.end());
  }

  template <int dim>
  ModelDefinition
  Sweep<dim>::definition_of(const Variant &variant) const
  {
    ModelDefinition definition = model.parameters.model;
    definition.stages.clear();
    for (const unsigned int stage : variant.stages)
      definition.stages.push_back(model.parameters.model.stages[stage]);
    return definition;
  }

  // The load patterns are those of the model; another order of stages only changes their factors.
  template <int dim>
  LoadHistory
  Sweep<dim>::history_of(const Variant &variant) const
  {
    return has_stages_of_model(variant) ? model.loads.history
                                        : make_load_history<dim>(definition_of(variant));
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
  SweepRow
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

    SweepRow row;
    for (const auto &setting : variant.settings)
      row.settings.push_back(setting.second);
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
    describe_end(variant, joint, history, row);
    row.resultants.resize(variant.joints.size());
    row.displacements.resize(model.monitors.size());
    row.first_opening = observer.first_opening;
    row.first_slip    = observer.first_slip;
    row.certificate   = observer.worst.worst();
    row.warnings      = observer.tables.template warnings<dim>(model.joint_names,
                                                          model.parameters.output.units.stress());
    count(row, *path);
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return row;
  }

  // Loads that change in time are several patterns; they keep the order of their stages.
  template <int dim>
  void
  Sweep<dim>::describe_end(const Variant &variant,
                           const JointModel &joint,
                           const LoadHistory &history,
                           SweepRow &row) const
  {
    const ModelDefinition definition = definition_of(variant);
    const DrivingQuantities driving(
      definition, has_stages_of_model(variant) ? model.loads.load_factors : history);
    row.drive = driving.at(row.path.t, stage_of(row.path.t, variant.stages.size()).first);
    if (row.path.mechanism != MechanismKind::none)
      row.motion = mechanism_text(joint_motions(model.joint_names.size(),
                                                joint.elements,
                                                model.frames,
                                                row.path.mechanism_jumps,
                                                dim == 3),
                                  model.joint_names);
  }

  template <int dim>
  void
  Sweep<dim>::count(const SweepRow &row, const ContactPath &path)
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
  void
  Sweep<dim>::say(const std::string &text)
  {
    log.append(text + "\n");
    if (model.parameters.output.log != LogDetail::quiet)
      fmt::print("{}\n", text);
  }

  template <int dim>
  void
  Sweep<dim>::say_header()
  {
    say(fmt::format("fuga {}  {}", version, model.parameters.title));
    for (const auto &lines : {model.mesh.report, model.bodies.report(), model.loads.report})
      for (const std::string &line : lines)
        say(line);
  }

  template <int dim>
  void
  Sweep<dim>::say_row(const Variant &variant, const SweepRow &row)
  {
    std::string settings;
    for (const auto &[name, value] : variant.settings)
      settings += fmt::format("{}{} = {}", settings.empty() ? "" : ", ", name, value);
    say(fmt::format("{:>5}  {:<60} {:<15} {:<12} t = {:<12.9g} {}  certificate {:.1e}",
                    row.number,
                    settings,
                    row.verdict,
                    mechanism_name(row.path.mechanism),
                    row.path.t,
                    row.drive.text(),
                    row.certificate));
    if (!row.motion.empty())
      say("       " + row.motion);
    for (const std::string &warning : row.warnings)
      {
        say("       Warning: " + warning);
        summary.warnings.push_back(fmt::format("variant {}: {}", row.number, warning));
      }
    log.publish(false);
  }

  template <int dim>
  ExitCode
  Sweep<dim>::run()
  {
    const Parameters &parameters = model.parameters;
    begin_results(parameters.output.directory,
                  [this]() { write_summary("unfinished", ExitCode::done); });
    Table<SweepRow> table(parameters.output.directory + "/sweep.csv", sweep_columns(model));
    table.publish(true);
    say_header();
    bool any_failed     = false;
    const auto next_row = [&](const std::size_t i) {
      try
        {
          return run_variant(parameters.variants[i]);
        }
      catch (const Interrupted &)
        {
          table.publish(true); // all rows before this one
          throw;
        }
    };
    for (std::size_t i = 0; i < parameters.variants.size(); ++i)
      {
        SweepRow row = next_row(i);
        row.number   = i + 1;
        table.add(row);
        table.publish(false);
        say_row(parameters.variants[i], row);
        any_failed = any_failed || row.failed;
      }
    table.publish(true);
    model.timer.finish("variants");
    const ExitCode code = any_failed ? ExitCode::numerical_failure
                          : summary.worst_certificate <= parameters.solver.certificate_bound
                            ? ExitCode::done
                            : ExitCode::certificate_violated;
    say(
      fmt::format("{} variants on one condensation, worst certificate {:.1e}. Results {}/sweep.csv",
                  parameters.variants.size(),
                  summary.worst_certificate,
                  parameters.output.directory));
    log.publish(true);
    write_summary(any_failed ? "numerical failure" : "done", code);
    return code;
  }

  template class Sweep<2>;
  template class Sweep<3>;
} // namespace fuga
