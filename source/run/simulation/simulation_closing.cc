// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/process_info.h>
#include <fuga/bodies/point_text.h>
#include <fuga/bodies/space/discretization.h>
#include <fuga/output/tables/summary.h>
#include <fuga/output/warnings/model_warnings.h>
#include <fuga/run/simulation/simulation.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  template <int dim>
  void
  Simulation<dim>::finish(const Outcome &outcome)
  {
    model.timer.finish("path");
    if (outcome.path.n_non_unique > 0 && outcome.path.verdict != Verdict::non_unique_continuation)
      log.warning(fmt::format(
        "t = {:.12g}: {}; {} such decisions on the path, the one of '{}' was "
        "followed.",
        outcome.path.critical.t,
        describe_critical(outcome.path),
        outcome.path.n_non_unique,
        parameters.solver.non_unique == NonUniqueChoice::first ? "first" : "largest dissipation"));
    if (outcome.path.n_followed_jumps > 0)
      log.warning(
        fmt::format("The path is not continuous: {} jump(s), the last one at t = {:.12g}; "
                    "energies are not known behind the first one{}.",
                    outcome.path.n_followed_jumps,
                    outcome.path.jump.t,
                    describe_jump(outcome.path.jump)));
    if (parameters.solver.beyond_limit == LimitLoadChoice::arc_length &&
        outcome.path.beyond.end == BeyondLimit::End::none &&
        (outcome.path.verdict == Verdict::limit_load ||
         outcome.path.verdict == Verdict::no_continuation))
      log.warning("The path was not followed beyond the limit load: that needs rigid or linear "
                  "layers.");
    if (parameters.solver.beyond_limit == LimitLoadChoice::dynamic && !motion &&
        (outcome.path.verdict == Verdict::limit_load ||
         outcome.path.verdict == Verdict::no_continuation))
      log.warning("The motion beyond the limit load was not followed: displacements, gaps or "
                  "temperatures change there, which have no inertia.");
    for (const std::string &text :
         range_warnings<dim>(excesses, model.joint_names, parameters.output.units))
      log.warning(text);
    log_closing_table(outcome);
    log.close();
    publish(true);
    write_summary(outcome);
    write_checkpoint(outcome);
  }

  // Friction beyond its critical value: how many ways to go on, and which elements decide.
  template <int dim>
  std::string
  Simulation<dim>::describe_critical(const PathResult &result) const
  {
    constexpr std::size_t max_named  = 3;
    const CriticalFriction &critical = result.critical;
    std::string where;
    for (std::size_t i = 0; i < std::min(max_named, critical.elements.size()); ++i)
      {
        const ContactElement &element = joint.elements[critical.elements[i]];
        dealii::Point<dim> place;
        for (unsigned int c = 0; c < dim; ++c)
          place[c] = element.position[c];
        where += fmt::format("{}{} {} at {}",
                             i == 0 ? "" : ", ",
                             model.joint_names[element.joint],
                             element.number,
                             text_of(place));
      }
    if (critical.elements.size() > max_named)
      where += fmt::format(" and {} more", critical.elements.size() - max_named);
    const std::string count = critical.n_branches == 0
                                ? "no continuation"
                                : fmt::format("{}{} continuations",
                                              critical.all_counted ? "" : "at least ",
                                              critical.n_branches);
    return fmt::format("friction beyond its critical value: {}, decided by {}", count, where);
  }

  template <int dim>
  std::string
  Simulation<dim>::describe_jump(const Jump &jump) const
  {
    if (!jump.found)
      return "";
    const Units &units = parameters.output.units;
    return fmt::format(
      "; a jump of {:.4g} {} leads to an equilibrium near by and sets free {:.4g} {}, "
      "of which friction takes {:.4g} in a slow motion (Solver/No continuation = "
      "jump goes on from there)",
      jump.size,
      units.length,
      jump.released,
      units.energy(),
      jump.dissipated);
  }

  template <int dim>
  std::string
  Simulation<dim>::reason_of(const PathResult &result) const
  {
    return result.verdict == Verdict::limit_load
             ? "mechanism: " + mechanism_name(result.mechanism)
             : "although nothing moves freely, " + describe_critical(result) +
                 describe_jump(result.jump);
  }

  template <int dim>
  void
  Simulation<dim>::log_closing_table(const Outcome &outcome)
  {
    const auto [stage, fraction] = stage_of(outcome.path.t, model.stage_names.size());
    log.line(std::string(72, '-'));
    switch (outcome.code)
      {
        case ExitCode::numerical_failure:
          log.line(fmt::format("Verdict     numerical failure: {}", outcome.message));
          break;
        case ExitCode::loss_of_equilibrium:
          log.line(fmt::format("Verdict     {} at {:.9g} of stage '{}' (t = {:.12g}), {}",
                               outcome.verdict,
                               fraction,
                               model.stage_names[stage],
                               outcome.path.t,
                               reason_of(outcome.path)));
          log.line("            " + context.driving.at(outcome.path.t, stage).text());
          if (const std::string text = model.motion(joint.elements, outcome.path); !text.empty())
            log.line("            " + text);
          if (outcome.path.verdict == Verdict::limit_load && outcome.proof.mechanism.proves())
            log.line(fmt::format("            shown by a motion: resistance {:.1e}, inadmissible "
                                 "part {:.1e}, balance of "
                                 "power {:.1e}; the load drives it with {:.3g} of its power",
                                 outcome.proof.mechanism.resistance,
                                 outcome.proof.mechanism.inadmissible,
                                 outcome.proof.mechanism.balance,
                                 outcome.proof.mechanism.drive));
          if (const BarrierCertificate &barrier = outcome.proof.barrier; barrier.proves())
            log.line(fmt::format("            shown by a virtual motion: equilibrium {:.1e}, "
                                 "inadmissible part {:.1e}; the load works on it with {:.3g} of "
                                 "its power; margin {:.1e}",
                                 barrier.equilibrium,
                                 barrier.inadmissible,
                                 barrier.drive,
                                 barrier.margin()));
          break;
        default:
          log.line(fmt::format("Verdict     {}, t = {:.12g}", outcome.verdict, outcome.path.t));
      }
    for (const SafetyFactor &safety : outcome.safety)
      log_safety(safety);
    if (const BeyondLimit &beyond = outcome.path.beyond; beyond.end != BeyondLimit::End::none)
      log.line(
        fmt::format("Beyond      {} steps to t = {:.12g}, largest jump grown by {:.6g} {}, end: {}",
                    beyond.n_steps,
                    beyond.t,
                    beyond.length,
                    parameters.output.units.length,
                    beyond_limit_end_name(beyond.end)));
    std::string kinds;
    for (const auto &[kind, count] : events_by_kind)
      kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", count, kind);
    log.line(fmt::format("Events      {}{}", n_events, kinds.empty() ? "" : " (" + kinds + ")"));
    log_motion();
    for (const MotionBeyondLimit &continued : continuations)
      log.line("Continued   " + describe(continued));
    log_resultants();
    if (!accuracy.rounds.empty())
      log.line("Accuracy    " + accuracy.conclusion());
    const IterationCount iterations = path->iterations();
    if (iterations.n_solutions > 0)
      log.line(fmt::format("Iterations  {} in {} solutions, at most {} in one",
                           iterations.n_iterations,
                           iterations.n_solutions,
                           iterations.max_in_one));
    const auto entries = worst.entries();
    const auto largest =
      std::max_element(entries.begin(), entries.end(), [](const auto &a, const auto &b) {
        return a.second < b.second;
      });
    log.line(fmt::format("Certificate {:.2e} ({}), bound {:.0e}{}",
                         worst.worst(),
                         largest->first,
                         parameters.solver.certificate_bound,
                         outcome.code == ExitCode::certificate_violated ? "   VIOLATED" : ""));
    if (outcome.code == ExitCode::certificate_violated && !outcome.message.empty())
      log.line("            " + outcome.message);
    model.timer.finish("tables");
    log.line(fmt::format(
      "Time        {:.3f} s, memory {:.0f} MB", model.timer.sum(), peak_memory_in_megabytes()));
    log.line(fmt::format("Results     {}", parameters.output.directory));
  }

  template <int dim>
  void
  Simulation<dim>::log_resultants()
  {
    if (last_state.states.empty())
      return;
    const Units &u    = parameters.output.units;
    std::string title = "Resultants";
    const std::vector<JointResultant> resultants =
      model.resultants(phase.results(last_state), judge.dissipation());
    for (std::size_t j = 0; j < resultants.size(); ++j)
      {
        if (!model.joints_there[j])
          continue;
        const JointResultant &r = resultants[j];
        std::string text        = "no force";
        if (r.share_stick + r.share_slip > 0.)
          {
            text = fmt::format("N {:.6g} {}, T {:.6g} {}",
                               r.N,
                               u.force,
                               dim == 2 ? r.T : std::hypot(r.T, r.T2),
                               u.force);
            if (dim == 2 && std::isfinite(r.M))
              text += fmt::format(", M {:.6g} {}", r.M, u.energy());
            text += fmt::format("; in compression {:.1f} %", 100. * r.share_compression);
            if (std::isfinite(r.sliding_safety))
              text += fmt::format("; sliding safety {:.4g}", r.sliding_safety);
            if (std::isfinite(r.overturning_safety))
              text += fmt::format("; overturning safety {:.4g}", r.overturning_safety);
          }
        log.line(fmt::format("{:<11} {}: {}", title, model.joint_names[j], text));
        title.clear();
      }
  }

  template <int dim>
  void
  Simulation<dim>::write_summary(const Outcome &outcome)
  {
    Summary summary;
    summary.verdict              = outcome.verdict;
    summary.exit_code            = static_cast<int>(outcome.code);
    summary.message              = outcome.message;
    summary.t                    = outcome.path.t;
    const auto [stage, fraction] = stage_of(summary.t, model.stage_names.size());
    summary.stage                = model.stage_names[stage];
    summary.stage_fraction       = fraction;
    summary.drive                = context.driving.at(summary.t, stage);
    summary.motion               = model.motion(joint.elements, outcome.path);
    summary.proof                = outcome.proof;
    summary.path                 = outcome.path;
    for (const std::size_t k : outcome.path.critical.elements)
      {
        const ContactElement &element = joint.elements[k];
        summary.critical_elements.push_back(
          {model.joint_names[element.joint],
           element.number,
           {element.position.begin(), element.position.begin() + dim}});
      }
    summary.safety       = outcome.safety;
    summary.accuracy     = accuracy;
    summary.load_factors = model.loads.factors_by_name(parameters.model, summary.t);
    summary.sizes        = model.sizes();
    summary.work         = {model.bodies.work(), 1, path->work()};
    if (motion)
      summary.work.bodies.add(motion->step_solvers()->work());
    summary.motion_energies   = motion_energies;
    summary.motion_steps      = motion_steps;
    summary.continuations     = continuations;
    summary.events_by_kind    = events_by_kind;
    summary.n_events          = n_events;
    summary.iterations        = path->iterations();
    summary.certificate       = worst;
    summary.certificate_bound = parameters.solver.certificate_bound;
    summary.phases            = model.timer.seconds();
    summary.peaks             = model.timer.peak_megabytes();
    summary.memory_MB         = peak_memory_in_megabytes();
    summary.split_report      = model.mesh.report;
    summary.warnings          = log.all_warnings();
    write_complete_file(parameters.output.directory + "/summary.json",
                        summary_json(summary, parameters));
  }

  template class Simulation<2>;
  template class Simulation<3>;
} // namespace fuga
