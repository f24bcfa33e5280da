// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/interruption.h>
#include <fuga/base/work_counter.h>
#include <fuga/bodies/processes.h>
#include <fuga/contact/judge/limit_proof.h>
#include <fuga/output/tables/summary.h>
#include <fuga/run/simulation/simulation.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  template <int dim>
  Simulation<dim>::Simulation(const Model<dim> &shared_model, AccuracyReport of_mesh)
    : model(shared_model)
    , parameters(model.parameters)
    , accuracy(std::move(of_mesh))
    , phase(model, parameters)
    , joint(phase.joint)
    , layered(phase.layered)
    , safety_search(phase.safety_search)
    , motion(phase.motion)
    , path(phase.path)
    , judge(phase.judge)
    , model_range(joint.elements, model.joint_names.size(), excesses)
    , context{joint.elements,
              model.joint_names,
              model.joints_there,
              model.stage_names,
              model.monitors,
              parameters.output.units,
              !model.bodies.closed_water().empty(),
              dim == 3,
              may_move(parameters),
              parameters.output.spectra,
              DrivingQuantities(parameters.model, model.loads.load_factors)}
    , log(parameters.output.log, context, parameters.output.directory + "/log.txt")
    , fields(parameters.output.directory, model.bodies, parameters.model, model.mesh.body_names)
    , history(parameters.output.directory, context)
  {
    model.timer.finish("layered system");
  }

  template <int dim>
  Simulation<dim>::~Simulation() = default;

  template <int dim>
  ExitCode
  Simulation<dim>::run()
  {
    begin_output();
    log_header();
    from_the_beginning = true;
    return follow([this]() { return path->run(model.loads.levels, *this); });
  }

  template <int dim>
  ExitCode
  Simulation<dim>::follow(const std::function<PathResult()> &path_to_follow)
  {
    Outcome outcome;
    try
      {
        PathResult found = path_to_follow();
        end_motion();
        if (model.construction.until_rest)
          outcome.proof.mechanism = end_continuation(found);
        else if (found.verdict != Verdict::done && found.beyond.end == BeyondLimit::End::none)
          write_last_state();
        goes_on_in_motion = model.goes_on_in_motion(found) || still_move(found);
        if (goes_on_in_motion || (found.verdict == Verdict::done && !model.is_last_phase()))
          {
            if (goes_on_in_motion)
              begin_continuation(found);
            end_of_phase = found;
            return ExitCode::done;
          }
        if (!model.construction.until_rest)
          outcome.proof = prove_limit(judge, joint.elements, layered, last_state, found);
        outcome.path    = found;
        outcome.verdict = verdict_name(found.verdict);
        outcome.code =
          found.verdict == Verdict::done ? ExitCode::done : ExitCode::loss_of_equilibrium;
        find_safety(outcome);
        if (!(worst.worst() <= parameters.solver.certificate_bound))
          {
            outcome.code    = ExitCode::certificate_violated;
            outcome.message = doubt_about_data();
          }
      }
    catch (const NumericalFailure &failure)
      {
        outcome.verdict = "numerical failure";
        outcome.code    = ExitCode::numerical_failure;
        outcome.message = limit_of_law();
        if (outcome.message.empty())
          {
            const std::string doubt = doubt_about_data();
            outcome.message = doubt.empty() ? failure.what() : doubt + ". " + failure.what();
          }
        outcome.path.t = last_state.t;
      }
    catch (const Interrupted &)
      {
        end_early();
      }
    catch (const processes::Separated &)
      {
        if (interruption::signal_number() == 0)
          throw;
        end_early(); // the others noticed the signal before this process did
      }
    finish(outcome);
    return outcome.code;
  }

  template <int dim>
  void
  Simulation<dim>::advanced(const PathPoint &from, const PathPoint &to, const double length)
  {
    judge.follow(from, to, length);
    model_range.watch(to.state);
    last_state = to.state;
    log.progress(to.state.t, static_cast<double>(model.stage_names.size()));
  }

  template <int dim>
  void
  Simulation<dim>::jumped(const JointState &to)
  {
    judge.lose_track();
    model_range.watch(to);
    last_state = to;
  }

  template <int dim>
  void
  Simulation<dim>::changed(const std::vector<ContactEvent> &events, const JointState &state)
  {
    last_state                    = state;
    const Certificate certificate = judge.judge(state);
    worst.absorb(certificate);
    for (const ContactEvent &event : events)
      ++events_by_kind[fmt::format("{} -> {}", event.names()[0], event.names()[1])];
    n_events += events.size();
    history.add_events(events, certificate.worst());
    if (parameters.output.monitors == MonitorOutput::events && !model.monitors.empty() && !motion)
      write_monitors(
        state.t, "event", phase.monitored(state), model.loads.history.factors(state.t));
    log.events(events, certificate.worst());
    publish(false);
    if (!motion)
      checkpoint_at_event();
  }

  // A requested load level: the only place where the full field is recovered, and only if it is
  // written.
  template <int dim>
  void
  Simulation<dim>::reached(const std::size_t index, const JointState &state)
  {
    const bool last    = model.is_last_phase() && state.t >= model.loads.end_of_loading;
    const bool written = parameters.output.fields == FieldOutput::levels ||
                         (parameters.output.fields == FieldOutput::end && last);
    write_state(state, written);
    levels_written = index + 1;
    if (motion)
      level_is_due = true;
    else
      write_checkpoint();
  }

  template <int dim>
  void
  Simulation<dim>::went_beyond(const double length, const JointState &state)
  {
    if (length == 0.)
      {
        last_state = state;
        write_last_state();
        return;
      }
    history.set_path_length(length);
    write_state(state, parameters.output.fields == FieldOutput::levels);
  }

  template <int dim>
  void
  Simulation<dim>::write_state(const JointState &state, const bool with_fields)
  {
    const work::Scope scope(work::Phase::results);
    model.timer.finish("path");
    Certificate certificate = judge.judge(state);
    const Vector jumps      = layered.jumps(state.dislocations, state.forces);
    const Vector x          = judge.coordinates(jumps, state.t);
    const Vector a          = model.loads.history.factors(state.t);
    const auto results      = phase.results(state);
    if (with_fields)
      write_fields(state, results, displacement(state, x, a, certificate));
    worst.absorb(certificate);
    history.add_level(state.t,
                      results,
                      model.resultants(results, judge.dissipation()),
                      phase.energies(),
                      certificate.worst());
    write_monitors(state.t, "level", phase.monitored(state), a);
    log.level(state.t, results, certificate.worst());
    publish(false);
    model.timer.finish("tables");
  }

  template <int dim>
  void
  Simulation<dim>::write_fields(const JointState &state,
                                const std::vector<ElementResult> &results,
                                const dealii::Vector<double> &displacement)
  {
    // Beyond a limit load the load time does not grow, but the times of a film must.
    const double time = state.t + history.path_length();
    dealii::Vector<double> velocity;
    if (motion && parameters.output.field_interval > 0.)
      velocity = model.bodies.by_degrees_of_freedom(motion->steady_velocity());
    fields.write_bodies(
      time,
      displacement,
      velocity,
      model.loads.template temperature<dim>(parameters.model, model.mesh.body_names, state.t));
    fields.write_joints(time, joint.elements, results, judge.dissipation());
    model.timer.finish("fields");
  }

  template <int dim>
  dealii::Vector<double>
  Simulation<dim>::displacement(const JointState &state,
                                const Vector &x,
                                const Vector &a,
                                Certificate &certificate) const
  {
    const auto take = [&certificate](const EquilibriumError &error) {
      certificate.equilibrium      = std::max(certificate.equilibrium, error.residual);
      certificate.body_equilibrium = std::max(certificate.body_equilibrium, error.resultant);
    };
    dealii::Vector<double> u;
    if (motion)
      {
        take(motion->equilibrium_error(state.forces));
        u = model.bodies.by_degrees_of_freedom(phase.displacement_in_motion());
      }
    else
      {
        const auto rigid = model.bodies.rigid_part(x);
        u                = model.bodies.recover(a, rigid.remainder);
        Vector on_lips   = state.forces;
        for (std::size_t i = 0; i < state.water.size(); ++i)
          on_lips[i] -= state.water[i];
        const EquilibriumError error = model.bodies.equilibrium_error(u, on_lips, a, rigid.motion);
        if (!balance_lips(on_lips, a, rigid.motion, error.residual, u, certificate))
          take(error);
        if (rigid.motion.size() > 0)
          u += rigid.motion;
      }
    model.timer.finish("recovery of displacements");
    return u;
  }

  // What the path takes for the stiffness of the bodies differs from theirs by rounding. Either it
  // is the forces that are wrong by this, or the jumps: by which share, the certificate says of
  // both.
  template <int dim>
  bool
  Simulation<dim>::balance_lips(const Vector &on_lips,
                                const Vector &a,
                                const dealii::Vector<double> &motion_of_bodies,
                                const double residual,
                                dealii::Vector<double> &u,
                                Certificate &certificate) const
  {
    constexpr double worth_mending = 1e-10;
    if (residual <= worth_mending)
      return false;
    dealii::Vector<double> balanced = u;
    const double moved =
      share(model.bodies.balance_lips(on_lips, a, balanced), judge.memory().largest_jump);
    const EquilibriumError error =
      model.bodies.equilibrium_error(balanced, on_lips, a, motion_of_bodies);
    if (std::max(error.residual, moved) >= residual)
      return false;
    u                            = balanced;
    certificate.equilibrium      = std::max(certificate.equilibrium, error.residual);
    certificate.body_equilibrium = std::max(certificate.body_equilibrium, error.resultant);
    certificate.penetration      = std::max(certificate.penetration, moved);
    return true;
  }

  template <int dim>
  void
  Simulation<dim>::write_monitors(const double t,
                                  const std::string &occasion,
                                  const Vector &coordinates,
                                  const Vector &factors)
  {
    Vector thermal_strains(model.monitors.size(), 0.);
    if (std::any_of(model.monitors.begin(), model.monitors.end(), [](const Monitor &monitor) {
          return monitor.has_stress();
        }))
      {
        const TemperatureField<dim> temperature =
          model.loads.template temperature<dim>(parameters.model, model.mesh.body_names, t);
        for (std::size_t i = 0; i < model.monitors.size(); ++i)
          thermal_strains[i] =
            temperature.strain(model.monitor_points[i].position(), model.monitors[i].body());
      }
    history.add_monitors(t, occasion, coordinates, factors, thermal_strains);
  }

  // At a limit load the last state in equilibrium is written like a level.
  template <int dim>
  void
  Simulation<dim>::write_last_state()
  {
    if (last_state.states.empty())
      return;
    constexpr double rounding = 1e-14;
    const bool is_level =
      levels_written > 0 && std::abs(model.loads.levels[levels_written - 1] - last_state.t) <=
                              rounding * std::max(1., last_state.t);
    if (!is_level)
      write_state(last_state, parameters.output.fields != FieldOutput::never);
  }

  template class Simulation<2>;
  template class Simulation<3>;
} // namespace fuga
