// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/interruption.h>
#include <fuga/base/numerics/not_a_number.h>
#include <fuga/base/process_info.h>
#include <fuga/output/files/version.h>
#include <fuga/output/warnings/model_warnings.h>
#include <fuga/study/sweep.h>

#include <algorithm>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** Return a description such as "Joints/base/Cohesion = 10, Constants/H = 5". */
    std::string
    description_of(const Parameters &sweep, const Variant &variant)
    {
      std::string text;
      for (std::size_t i = 0; i < variant.settings.size(); ++i)
        text +=
          fmt::format("{}{} = {}", i == 0 ? "" : ", ", sweep.swept[i].name, variant.settings[i]);
      return text;
    }
  } // namespace

  template <int dim>
  std::unique_ptr<const Model<dim>>
  checked_model(const Parameters &sweep, const std::size_t condensation, const Condensation how)
  {
    std::unique_ptr<const Model<dim>> model;
    for (const Variant &variant : sweep.variants)
      if (variant.condensation == condensation)
        try
          {
            if (model == nullptr)
              model = std::make_unique<const Model<dim>>(
                *sweep.condensations[condensation], ConstructionState(), how);
            model->check_joints(variant.joints);
          }
        catch (const InputError &error)
          {
            throw InputError(
              fmt::format("{} (In the variant {}.)", error.what(), description_of(sweep, variant)));
          }
    return model;
  }

  // Nothing is computed before everything has been checked.
  template <int dim>
  Sweep<dim>::Sweep(const Parameters &sweep_parameters)
    : parameters(sweep_parameters), log(parameters.output.directory + "/log.txt")
  {
    const std::size_t n = parameters.condensations.size();
    for (std::size_t c = 0; n > 1 && c < n; ++c)
      checked_model<dim>(parameters, c, Condensation::never);
    timer.finish("checks of the input");
    condense(0);
  }

  // Two factorisations at once would take twice the memory.
  template <int dim>
  void
  Sweep<dim>::condense(const std::size_t number)
  {
    if (model != nullptr)
      count_model();
    layered.reset();
    later_bodies.reset();
    driving.reset();
    model.reset();
    condensation = number;
    model        = checked_model<dim>(parameters, number, Condensation::with_loads);
    driving =
      std::make_unique<const DrivingQuantities>(model->parameters.model, model->loads.load_factors);
  }

  template <int dim>
  void
  Sweep<dim>::count_model()
  {
    model->timer.finish("variants");
    BodiesWork work = model->bodies.work();
    work.add(summary.work.bodies);
    if (later_bodies)
      work.add(later_bodies->work());
    summary.work.bodies = work;
    count_steps();
    for (const auto &[name, seconds] : model->timer.seconds())
      if (name != "start" || condensation == 0)
        timer.book(name, seconds);
  }

  template <int dim>
  void
  Sweep<dim>::count_steps()
  {
    if (steps)
      summary.work.bodies.add(steps->work());
    steps.reset();
  }

  template <int dim>
  void
  Sweep<dim>::count(const PhaseRun<dim> &phase)
  {
    if (phase.shared_layered != layered)
      ++summary.work.n_layered_systems;
    if (&phase.model == model.get())
      layered = phase.shared_layered;
    if (phase.motion && phase.motion->step_solvers() != steps)
      {
        count_steps();
        steps = phase.motion->step_solvers();
      }
    SchemeWork &total        = summary.work.scheme;
    const SchemeWork of_path = phase.path->work();
    total.n_factorisations += of_path.n_factorisations;
    total.n_updates += of_path.n_updates;
    total.n_bars_ever_active = std::max(total.n_bars_ever_active, of_path.n_bars_ever_active);
  }

  template <int dim>
  void
  Sweep<dim>::count(const SweepRow &row)
  {
    ++summary.n_variants;
    ++summary.verdicts[row.verdict];
    summary.n_events += row.path.n_events;
    summary.n_steps += row.path.n_steps;
    summary.n_jumps += row.path.n_jumps;
    summary.n_schemes += row.path.n_schemes;
    summary.n_iterations += row.n_iterations;
    summary.worst_certificate = larger_error(summary.worst_certificate, row.certificate);
  }

  template <int dim>
  void
  Sweep<dim>::write_summary(const std::string &verdict, const ExitCode code)
  {
    summary.verdict           = verdict;
    summary.exit_code         = static_cast<int>(code);
    summary.n_condensations   = parameters.condensations.size();
    summary.sizes             = model->sizes();
    summary.certificate_bound = parameters.solver.certificate_bound;
    summary.phases            = timer.seconds();
    summary.peaks             = timer.peak_megabytes();
    summary.memory_MB         = peak_memory_in_megabytes();
    summary.split_report      = model->mesh.report;
    write_complete_file(parameters.output.directory + "/summary.json",
                        summary_json(summary, parameters));
  }

  template <int dim>
  void
  Sweep<dim>::say(const std::string &text)
  {
    log.append(text + "\n");
    if (parameters.output.log != LogDetail::quiet)
      fmt::print("{}\n", text);
  }

  template <int dim>
  void
  Sweep<dim>::warn(const std::string &indent, const std::string &text)
  {
    say(fmt::format("{}Warning: {}", indent, text));
    summary.warnings.push_back(text);
  }

  template <int dim>
  void
  Sweep<dim>::say_header()
  {
    say(fmt::format("fuga {}  {}", version, parameters.title));
    say(fmt::format("Sweep of {} runs on {} condensation{} of the bodies",
                    parameters.variants.size(),
                    parameters.condensations.size(),
                    parameters.condensations.size() == 1 ? "" : "s"));
    for (const SweptQuantity &quantity : parameters.swept)
      if (!quantity.today.empty())
        say(fmt::format("Sweep/{} is an older form of 'set {}'", quantity.name, quantity.today));
  }

  template <int dim>
  void
  Sweep<dim>::say_model()
  {
    for (const auto &lines : {model->mesh.report, model->bodies.report(), model->loads.report})
      for (const std::string &line : lines)
        if (said.insert(line).second)
          say(line);
    for (const std::string &text : model_warnings(
           model->parameters, model->bodies, model->loads.load_factors, 0, model->next_stage()))
      if (said.insert(text).second)
        warn("", text);
  }

  template <int dim>
  void
  Sweep<dim>::say_row(const SweepRow &row)
  {
    std::string settings;
    for (std::size_t i = 0; i < row.settings.size(); ++i)
      settings +=
        fmt::format("{}{} = {}", i == 0 ? "" : ", ", parameters.swept[i].name, row.settings[i]);
    std::string safety;
    for (const SafetyFactor &factor : row.safety)
      if (factor.verdict != SafetyFactor::not_computed)
        safety += fmt::format(
          "  {} {} {:.9g}", factor.method, factor.found() ? "=" : "above", factor.factor);
    say(fmt::format("{:>5}  {:<60} {:<15} {:<12} t = {:<12.9g} {}{}  certificate {:.1e}",
                    row.number,
                    description_of(parameters, parameters.variants[row.number - 1]),
                    row.verdict,
                    mechanism_name(row.path.mechanism),
                    row.path.t,
                    row.drive.text(),
                    safety,
                    row.certificate));
    if (!row.message.empty())
      say("       " + row.message);
    if (!row.motion.empty())
      say("       " + row.motion);
    for (const SafetyFactor &factor : row.safety)
      if (!factor.motion.empty())
        say(fmt::format("       {}: {}", factor.method, factor.motion));
    for (const std::string &warning : row.warnings)
      warn("       ", fmt::format("variant {}: {}", row.number, warning));
    log.publish(false);
  }

  template <int dim>
  ExitCode
  Sweep<dim>::run()
  {
    begin_results(parameters.output.directory,
                  [this]() { write_summary("unfinished", ExitCode::done); });
    Table<SweepRow> table(parameters.output.directory + "/sweep.csv",
                          sweep_columns(*model, parameters));
    table.publish(true);
    say_header();
    say_model();
    bool any_failed     = false;
    const auto next_row = [&](const Variant &variant) {
      try
        {
          if (variant.condensation != condensation)
            {
              condense(variant.condensation);
              say_model();
            }
          return run_variant(variant);
        }
      catch (const Interrupted &)
        {
          table.publish(true); // all rows before this one
          throw;
        }
    };
    for (std::size_t i = 0; i < parameters.variants.size(); ++i)
      {
        SweepRow row = next_row(parameters.variants[i]);
        row.number   = i + 1;
        table.add(row);
        table.publish(false);
        say_row(row);
        any_failed = any_failed || row.exit_code == ExitCode::numerical_failure;
      }
    table.publish(true);
    count_model();
    const ExitCode code = any_failed ? ExitCode::numerical_failure
                          : summary.worst_certificate <= parameters.solver.certificate_bound
                            ? ExitCode::done
                            : ExitCode::certificate_violated;
    say(fmt::format("{} variants, worst certificate {:.1e}. Results {}/sweep.csv",
                    parameters.variants.size(),
                    summary.worst_certificate,
                    parameters.output.directory));
    log.publish(true);
    write_summary(any_failed ? "numerical failure" : "done", code);
    return code;
  }

  template std::unique_ptr<const Model<2>>
  checked_model(const Parameters &, const std::size_t, const Condensation);
  template std::unique_ptr<const Model<3>>
  checked_model(const Parameters &, const std::size_t, const Condensation);
  template class Sweep<2>;
  template class Sweep<3>;
} // namespace fuga
