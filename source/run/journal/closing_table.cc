// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/process_info.h>
#include <fuga/output/warnings/model_warnings.h>
#include <fuga/output/warnings/motion_warnings.h>
#include <fuga/run/journal/closing_table.h>
#include <fuga/run/journal/verdict_text.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    bool
    lost_equilibrium(const PathResult &result)
    {
      return result.verdict == Verdict::limit_load || result.verdict == Verdict::no_continuation;
    }

    void
    log_proof(RunLog &log, const RunOutcome &outcome)
    {
      const MechanismCertificate &mechanism = outcome.proof.mechanism;
      if (outcome.path.verdict == Verdict::limit_load && mechanism.proves())
        log.line(fmt::format("            shown by a motion: resistance {:.1e}, inadmissible "
                             "part {:.1e}, balance of "
                             "power {:.1e}; the load drives it with {:.3g} of its power",
                             mechanism.resistance,
                             mechanism.inadmissible,
                             mechanism.balance,
                             mechanism.drive));
      if (const BarrierCertificate &barrier = outcome.proof.barrier; barrier.proves())
        log.line(fmt::format("            shown by a virtual motion: equilibrium {:.1e}, "
                             "inadmissible part {:.1e}; the load works on it with {:.3g} of "
                             "its power; margin {:.1e}",
                             barrier.equilibrium,
                             barrier.inadmissible,
                             barrier.drive,
                             barrier.margin()));
      const Jump &jump = outcome.path.jump;
      if (outcome.path.verdict == Verdict::no_continuation && jump.shows_instability())
        log.line(fmt::format("            shown by the jump: with a hundredth of the load added "
                             "before it, it is {:.4g} times as large",
                             jump.size_nearer / jump.size));
    }

    template <int dim>
    void
    log_verdict(RunJournal<dim> &journal, const RunOutcome &outcome)
    {
      const PhaseRun<dim> &phase            = journal.phase;
      const std::vector<std::string> &names = phase.model.stage_names;
      const double t                        = outcome.path.t;
      RunLog &log                           = journal.log;
      switch (outcome.code)
        {
          case ExitCode::numerical_failure:
            log.line(fmt::format("Verdict     numerical failure: {}", outcome.message));
            break;
          case ExitCode::loss_of_equilibrium:
            log.line(fmt::format("Verdict     {} at {}, {}",
                                 outcome.verdict,
                                 place_text(t, names),
                                 reason_text(phase, outcome.path)));
            log.line("            " +
                     journal.context.driving.at(t, stage_of(t, names.size()).first).text());
            if (const std::string text = phase.model.motion(phase.joint.elements, outcome.path);
                !text.empty())
              log.line("            " + text);
            log_proof(log, outcome);
            break;
          default:
            log.line(fmt::format("Verdict     {}, t = {:.12g}", outcome.verdict, t));
        }
    }

    void
    log_safety(RunLog &log, const SafetyFactor &safety)
    {
      const auto listed = [](const std::vector<std::string> &names) {
        return fmt::format("{}", fmt::join(names, ", "));
      };
      std::string text =
        fmt::format("Safety      {} of {}: ", safety.method, listed(safety.acts_on));
      if (safety.verdict == SafetyFactor::not_computed)
        text += "not computed, because the loads are not carried to their end";
      else if (safety.verdict == SafetyFactor::largest_factor_reached)
        text += fmt::format("above {:.12g}, the largest factor asked for", safety.factor);
      else
        text += fmt::format("{:.12g}, {}", safety.factor, safety.verdict);
      if (safety.mechanism != MechanismKind::none)
        text += fmt::format(
          ", mechanism: {} of {}", mechanism_name(safety.mechanism), listed(safety.moving_joints));
      log.line(text);
      if (!safety.motion.empty())
        log.line("            " + safety.motion);
    }

    void
    log_motion(RunLog &log, const RunRecord &record, const Units &units)
    {
      const std::vector<std::size_t> &n_steps = record.motion_steps;
      if (n_steps.empty())
        return;
      std::size_t n_halved = 0;
      for (std::size_t i = 1; i < n_steps.size(); ++i)
        n_halved += n_steps[i];
      const MotionLedger &e = record.motion_energies;
      log.line(
        fmt::format("Motion      {} steps and {} shorter ones; work {:.6g} {}: kinetic {:.6g}, "
                    "bodies {:.6g}, damping {:.6g}, joints {:.6g}, integration in time {:.3g} "
                    "({:.1e} of the largest){}; not accounted for {:.1e} of the largest",
                    n_steps[0],
                    n_halved,
                    e.work,
                    units.energy(),
                    e.kinetic,
                    e.bodies,
                    e.damping,
                    e.joints,
                    e.numerical,
                    e.share(e.numerical),
                    e.share(e.sudden) > 0. ? fmt::format(", sudden {:.3g}", e.sudden) : "",
                    e.share(e.defect())));
      for (const std::string &warning : motion_warnings(e, n_steps))
        log.warning(warning);
    }

    /** Return the forces and moments that joint @p r carries. */
    template <int dim>
    std::string
    resultant_text(const JointResultant &r, const Units &u)
    {
      if (!(r.share_stick + r.share_slip > 0.))
        return "no force";
      std::string text = fmt::format(
        "N {:.6g} {}, T {:.6g} {}", r.N, u.force, dim == 2 ? r.T : std::hypot(r.T, r.T2), u.force);
      if (dim == 2 && std::isfinite(r.M))
        text += fmt::format(", M {:.6g} {}", r.M, u.energy());
      text += fmt::format("; in compression {:.1f} %", 100. * r.share_compression);
      if (std::isfinite(r.sliding_safety))
        text += fmt::format("; sliding safety {:.4g}", r.sliding_safety);
      if (std::isfinite(r.overturning_safety))
        text += fmt::format("; overturning safety {:.4g}", r.overturning_safety);
      return text;
    }

    /** Log the resultants of the last state. */
    template <int dim>
    void
    log_resultants(RunJournal<dim> &journal)
    {
      const JointState &last = journal.record.last_state;
      if (last.states.empty())
        return;
      const PhaseRun<dim> &phase = journal.phase;
      std::string title          = "Resultants";
      const std::vector<JointResultant> resultants =
        phase.model.resultants(phase.results(last), phase.judge.dissipation());
      for (std::size_t j = 0; j < resultants.size(); ++j)
        {
          if (!phase.model.joints_there[j])
            continue;
          journal.log.line(
            fmt::format("{:<11} {}: {}",
                        title,
                        phase.model.joint_names[j],
                        resultant_text<dim>(resultants[j], phase.parameters.output.units)));
          title.clear();
        }
    }

    void
    log_certificate(RunLog &log,
                    const Certificate &certificate,
                    const double bound,
                    const RunOutcome &outcome)
    {
      const auto entries = certificate.entries();
      const auto largest =
        std::max_element(entries.begin(), entries.end(), [](const auto &a, const auto &b) {
          return a.second < b.second;
        });
      const bool is_violated = outcome.code == ExitCode::certificate_violated;
      log.line(fmt::format("Certificate {:.2e} ({}), bound {:.0e}{}",
                           certificate.worst(),
                           largest->first,
                           bound,
                           is_violated ? "   VIOLATED" : ""));
      if (is_violated && !outcome.message.empty())
        log.line("            " + outcome.message);
    }
  } // namespace

  template <int dim>
  void
  log_closing_warnings(RunJournal<dim> &journal, const RunOutcome &outcome)
  {
    const PhaseRun<dim> &phase     = journal.phase;
    const PathResult &path         = outcome.path;
    const SolverSettings &settings = phase.parameters.solver;
    RunLog &log                    = journal.log;
    if (path.n_non_unique > 0 && path.verdict != Verdict::non_unique_continuation)
      log.warning(fmt::format(
        "t = {:.12g}: {}; {} such decisions on the path, the one of '{}' was "
        "followed.",
        path.critical.t,
        critical_friction_text(phase, path),
        path.n_non_unique,
        settings.non_unique == NonUniqueChoice::first ? "first" : "largest dissipation"));
    if (path.n_followed_jumps > 0)
      log.warning(fmt::format(
        "The path is not continuous: {} jump(s){}{}; energies are not known after the first one{}.",
        path.n_followed_jumps,
        path.n_failures > 0 ? fmt::format(", {} where it could not be computed", path.n_failures)
                            : "",
        path.jump.found ? fmt::format(", the last one at t = {:.12g}", path.jump.t) : "",
        jump_text(path.jump, phase.parameters.output.units)));
    if (settings.beyond_limit == LimitLoadChoice::arc_length &&
        path.beyond.end == BeyondLimit::End::none && lost_equilibrium(path))
      log.warning("The path was not followed beyond the limit load: that needs rigid or linear "
                  "layers of straight strength.");
    if (settings.beyond_limit == LimitLoadChoice::dynamic && !phase.motion &&
        lost_equilibrium(path))
      log.warning("The motion beyond the limit load was not followed: displacements, gaps or "
                  "temperatures change there, which have no inertia.");
    for (const std::string &text : range_warnings<dim>(
           journal.record.excesses, phase.model.joint_names, phase.parameters.output.units))
      log.warning(text);
  }

  template <int dim>
  void
  log_closing_table(RunJournal<dim> &journal, const RunOutcome &outcome)
  {
    const PhaseRun<dim> &phase   = journal.phase;
    const Parameters &parameters = phase.parameters;
    const RunRecord &record      = journal.record;
    const Units &units           = parameters.output.units;
    RunLog &log                  = journal.log;
    log.line(std::string(72, '-'));
    log_verdict(journal, outcome);
    for (const SafetyFactor &safety : outcome.safety)
      log_safety(log, safety);
    if (const BeyondLimit &beyond = outcome.path.beyond; beyond.end != BeyondLimit::End::none)
      log.line(
        fmt::format("Beyond      {} steps to t = {:.12g}, largest jump grown by {:.6g} {}, end: {}",
                    beyond.n_steps,
                    beyond.t,
                    beyond.length,
                    units.length,
                    beyond_limit_end_name(beyond.end)));
    std::string kinds;
    for (const auto &[kind, count] : record.events_by_kind)
      kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", count, kind);
    log.line(
      fmt::format("Events      {}{}", record.n_events, kinds.empty() ? "" : " (" + kinds + ")"));
    log_motion(log, record, units);
    for (const MotionBeyondLimit &continued : record.continuations)
      log.line("Continued   " + continuation_text(continued, units));
    log_resultants(journal);
    if (!journal.accuracy.rounds.empty())
      log.line("Accuracy    " + journal.accuracy.conclusion());
    const IterationCount iterations = phase.path->iterations();
    if (iterations.n_solutions > 0)
      log.line(fmt::format("Iterations  {} in {} solutions, at most {} in one",
                           iterations.n_iterations,
                           iterations.n_solutions,
                           iterations.max_in_one));
    log_certificate(log, record.worst, parameters.solver.certificate_bound, outcome);
    phase.model.timer.finish("tables");
    log.line(fmt::format("Time        {:.3f} s, memory {:.0f} MB",
                         phase.model.timer.sum(),
                         peak_memory_in_megabytes()));
    log.line(fmt::format("Results     {}", parameters.output.directory));
  }

  template void
  log_closing_warnings(RunJournal<2> &, const RunOutcome &);
  template void
  log_closing_warnings(RunJournal<3> &, const RunOutcome &);
  template void
  log_closing_table(RunJournal<2> &, const RunOutcome &);
  template void
  log_closing_table(RunJournal<3> &, const RunOutcome &);
} // namespace fuga
