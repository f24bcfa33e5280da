// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/bodies/field_expression.h>
#include <fuga/io/process_info.h>
#include <fuga/io/summary.h>
#include <fuga/mesh/gmsh_mesh.h>
#include <fuga/simulation.h>

#include <deal.II/lac/vector.h>

#include <fmt/format.h>

namespace fuga
{
  template <int dim>
  Simulation<dim>::Simulation(const Parameters &run_parameters)
    : parameters(run_parameters)
    , mesh((timer.book("start", seconds_since_process_start()),
            split_joints(read_gmsh_mesh(parameters.mesh_file), joint_definitions())))
    , bodies((timer.finish("mesh"), mesh), parameters.model, frictionless_joints())
    , elements(make_elements())
    , loads(make_loads())
    , layered((book_body_phases(), bodies), elements)
    , path(elements, layered, loads.history, path_options())
    , judge(bodies, elements, loads.history)
    , names_of_joints(joint_names())
    , names_of_stages(stage_names())
    , element_normals(normals())
    , context{elements, names_of_joints, names_of_stages, element_normals, parameters.output.units}
    , log(parameters.output.log, context)
    , fields(parameters.output.directory, bodies, parameters.model, mesh.body_names)
  {
    timer.finish("layered system");
  }

  template <int dim>
  Simulation<dim>::~Simulation() = default;

  // The bodies keep their own time.
  template <int dim>
  void
  Simulation<dim>::book_body_phases()
  {
    for (const auto &[name, seconds] : bodies.phase_seconds())
      timer.set_apart(name, seconds);
    timer.finish("elements and loads");
  }

  template <int dim>
  std::vector<JointDefinition>
  Simulation<dim>::joint_definitions() const
  {
    std::vector<JointDefinition> definitions;
    for (const JointParameters &joint : parameters.joints)
      definitions.push_back(joint.definition);
    return definitions;
  }

  template <int dim>
  std::vector<bool>
  Simulation<dim>::frictionless_joints() const
  {
    std::vector<bool> frictionless;
    for (const JointParameters &joint : parameters.joints)
      frictionless.push_back(joint.friction.is_frictionless());
    return frictionless;
  }

  template <int dim>
  PathOptions
  Simulation<dim>::path_options() const
  {
    PathOptions options;
    options.iteration      = parameters.solver.iteration == IterationKind::newton
                               ? PathOptions::Iteration::newton
                               : PathOptions::Iteration::constant_stiffness;
    options.tolerance      = parameters.solver.iteration_tolerance;
    options.max_iterations = parameters.solver.maximum_iterations;
    return options;
  }

  namespace
  {
    std::unique_ptr<ComplianceLaw>
    make_law(const LayerLaw law, const double compliance, const double thickness)
    {
      switch (law)
        {
          case LayerLaw::rigid:
            return make_rigid_law();
          case LayerLaw::linear:
            return make_linear_law(compliance);
          case LayerLaw::cubic_root:
            return make_cubic_root_law(compliance, thickness);
        }
      return nullptr;
    }
  } // namespace

  // The bodies know where the elements are; the parameters know what they are made of.
  template <int dim>
  std::vector<ContactElement>
  Simulation<dim>::make_elements()
  {
    std::vector<ContactElement> result = bodies.elements();
    for (unsigned int j = 0; j < parameters.joints.size(); ++j)
      {
        const JointParameters &joint = parameters.joints[j];
        laws.push_back(make_law(joint.normal_law, joint.normal_compliance, joint.thickness));
        laws.push_back(make_law(joint.shear_law, joint.shear_compliance, joint.thickness));
        const FieldExpression<dim> gap(
          {joint.initial_gap},
          parameters.model.constants,
          fmt::format("{}: initial gap of joint '{}'", joint.origin, joint.definition.name));
        for (ContactElement &element : result)
          {
            if (element.joint != j)
              continue;
            element.normal_law = laws[laws.size() - 2].get();
            element.shear_law  = laws.back().get();
            element.friction   = joint.friction;
            dealii::Point<dim> point;
            for (unsigned int d = 0; d < dim; ++d)
              point[d] = element.position[d];
            element.initial_gap = gap.value(point, 0);
            if (element.initial_gap < 0.)
              throw InputError(fmt::format(
                "{}: the initial gap '{}' of joint '{}' is {:g} at ({}). A gap is not negative: "
                "use max(0, ...) if the formula dips below zero.",
                joint.origin,
                joint.initial_gap,
                joint.definition.name,
                element.initial_gap,
                fmt::join(element.position, ", ")));
          }
      }
    return result;
  }

  template <int dim>
  LoadProgram
  Simulation<dim>::make_loads()
  {
    LoadProgram program = make_load_program(parameters.model, bodies);
    bodies.set_load_patterns(std::move(program.patterns));
    return program;
  }

  template <int dim>
  std::vector<std::string>
  Simulation<dim>::joint_names() const
  {
    std::vector<std::string> names;
    for (const JointParameters &joint : parameters.joints)
      names.push_back(joint.definition.name);
    return names;
  }

  template <int dim>
  std::vector<std::string>
  Simulation<dim>::stage_names() const
  {
    std::vector<std::string> names;
    for (const StageDefinition &stage : parameters.model.stages)
      names.push_back(stage.name);
    return names;
  }

  template <int dim>
  std::vector<std::array<double, 3>>
  Simulation<dim>::normals() const
  {
    std::vector<std::array<double, 3>> result;
    for (std::size_t k = 0; k < elements.size(); ++k)
      result.push_back(bodies.normal(k));
    return result;
  }

  template <int dim>
  ExitCode
  Simulation<dim>::run()
  {
    begin_output();
    log_header();
    Outcome outcome;
    try
      {
        outcome.path    = path.run(loads.levels, *this);
        outcome.verdict = verdict_name(outcome.path.verdict);
        outcome.code =
          outcome.path.verdict == Verdict::done ? ExitCode::done : ExitCode::loss_of_equilibrium;
        if (!(worst.worst() <= parameters.solver.certificate_bound))
          outcome.code = ExitCode::certificate_violated;
        if (outcome.path.verdict != Verdict::done)
          write_last_state();
      }
    catch (const NumericalFailure &failure)
      {
        outcome.verdict = "numerical failure";
        outcome.code    = ExitCode::numerical_failure;
        outcome.message = failure.what();
        outcome.path.t  = last_state.t;
      }
    finish(outcome);
    return outcome.code;
  }

  template <int dim>
  void
  Simulation<dim>::advanced(const PathPoint &from, const PathPoint &to, const double length)
  {
    judge.follow(from, to, length);
    last_state = to.state;
    log.progress(to.state.t, loads.history.end());
  }

  template <int dim>
  void
  Simulation<dim>::changed(const std::vector<ContactEvent> &events, const JointState &state)
  {
    const Certificate certificate = judge.judge(state);
    worst.absorb(certificate);
    for (const ContactEvent &event : events)
      ++events_by_kind[fmt::format("{} -> {}", state_name(event.from), state_name(event.to))];
    n_events += events.size();
    history->add_events(events, certificate.worst());
    history->publish(false);
    log.events(events, certificate.worst());
  }

  // A requested load level: the only place where the full field is recovered, and only if it is
  // written.
  template <int dim>
  void
  Simulation<dim>::reached(const std::size_t index, const JointState &state)
  {
    const bool last    = index + 1 == loads.levels.size();
    const bool written = parameters.output.fields == FieldOutput::levels ||
                         (parameters.output.fields == FieldOutput::end && last);
    write_state(state, written);
    levels_written = index + 1;
  }

  template <int dim>
  void
  Simulation<dim>::write_state(const JointState &state, const bool with_fields)
  {
    timer.finish("path");
    Certificate certificate = judge.judge(state);
    const Vector jumps      = layered.jumps(state.dislocations, state.forces);
    const Vector x          = judge.coordinates(jumps);
    const Vector a          = loads.history.factors(state.t);
    const auto results      = element_results(elements, state, jumps);
    if (with_fields)
      {
        const dealii::Vector<double> u = bodies.recover(a, x);
        const EquilibriumError error   = bodies.equilibrium_error(u, state.forces, a);
        certificate.equilibrium        = std::max(certificate.equilibrium, error.residual);
        certificate.body_equilibrium   = std::max(certificate.body_equilibrium, error.resultant);
        timer.finish("recovery of displacements");
        fields.write_bodies(state.t, u);
        fields.write_joints(state.t, elements, results, judge.dissipation());
        timer.finish("fields");
      }
    worst.absorb(certificate);
    history->add_level(state.t, results, judge.energies(), certificate.worst());
    history->publish(false);
    log.level(state.t, results, certificate.worst());
    timer.finish("tables");
  }

  // At a limit load the last state in equilibrium is written like a level.
  template <int dim>
  void
  Simulation<dim>::write_last_state()
  {
    if (last_state.states.empty())
      return;
    const bool is_level = levels_written > 0 && loads.levels[levels_written - 1] == last_state.t;
    if (!is_level)
      write_state(last_state, parameters.output.fields != FieldOutput::never);
  }

  template class Simulation<2>;
} // namespace fuga
