// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/input_errors.h>
#include <fuga/base/interruption.h>
#include <fuga/base/process_info.h>
#include <fuga/input/stiffness_need.h>
#include <fuga/mesh/gmsh_mesh.h>
#include <fuga/output/results/mechanism_text.h>
#include <fuga/run/model/joint_model.h>
#include <fuga/run/model/model.h>
#include <fuga/run/model/phase_begin.h>

#include <algorithm>
#include <fmt/format.h>

namespace fuga
{
  template <int dim>
  Model<dim>::Model(const Parameters &run_parameters,
                    const ConstructionState &state,
                    const Condensation condensation)
    : Model(run_parameters, state, nullptr, condensation)
  {
  }

  template <int dim>
  Model<dim>::Model(const Parameters &run_parameters,
                    const PhaseEnd &before,
                    std::shared_ptr<CondensedSystem<dim>> same_bodies)
    : Model(run_parameters, before.next, &before, Condensation::with_loads, std::move(same_bodies))
  {
  }

  template <int dim>
  Model<dim>::Model(const Parameters &run_parameters,
                    const ConstructionState &state,
                    const PhaseEnd *before,
                    const Condensation condensation,
                    std::shared_ptr<CondensedSystem<dim>> same_bodies)
    : shared_parameters(std::make_shared<const Parameters>(run_parameters))
    , parameters(*shared_parameters)
    , timer(before ? before->timer : PhaseTimer())
    , shared_mesh(before ? before->mesh : read_mesh())
    , mesh(*shared_mesh)
    , shared_bodies(make_bodies(state.stage, condensation, std::move(same_bodies)))
    , bodies(*shared_bodies)
    , construction(state)
    , monitor_points(find_monitor_points())
    , loads(make_loads(before, condensation))
    , monitors(make_monitors(condensation))
    , joint_names(find_joint_names())
    , stage_names(find_stage_names())
    , frames(find_frames())
    , joints_there(find_joints_there())
  {
    if (before)
      first_state = take_over_joints(
        parameters, bodies, *before, loads.history.factors(construction.begin), construction);
    if (!construction.is_first())
      shared_bodies->set_carried_load(loads.history.n_patterns() - 2, construction.jump_offsets);
    timer.set_apart(bodies.phases());
    timer.finish("elements and loads");
    interruption::check("while the model was set up");
  }

  template <int dim>
  std::shared_ptr<const JointedMesh>
  Model<dim>::read_mesh() const
  {
    // The time is that of the program; later models do not wait for it.
    static const double start = seconds_since_process_start();
    timer.book("start", start);
    auto result = std::make_shared<const JointedMesh>(
      split_joints(read_gmsh_mesh(parameters.mesh_file), joint_definitions()));
    timer.finish("mesh");
    return result;
  }

  // The caller that holds the bodies may use them after the model is gone.
  template <int dim>
  std::shared_ptr<CondensedSystem<dim>>
  Model<dim>::make_bodies(const unsigned int stage,
                          const Condensation condensation,
                          std::shared_ptr<CondensedSystem<dim>> same_bodies) const
  {
    if (same_bodies)
      {
        same_bodies->phases() = PhaseTimer();
        return same_bodies;
      }
    struct WithDefinition
    {
      std::shared_ptr<const Parameters> parameters;
      std::shared_ptr<const JointedMesh> mesh;
      CondensedSystem<dim> bodies;
    };
    const auto all = std::shared_ptr<WithDefinition>(new WithDefinition{
      shared_parameters,
      shared_mesh,
      {mesh, parameters.model, frictionless_joints(parameters.joints), condensation, stage}});
    return {all, &all->bodies};
  }

  template <int dim>
  std::vector<JointDefinition>
  Model<dim>::joint_definitions() const
  {
    std::vector<JointDefinition> definitions;
    for (const JointParameters &joint : parameters.joints)
      definitions.push_back(joint.definition);
    return definitions;
  }

  // All errors in joints and loads are found before the bodies are condensed.
  template <int dim>
  LoadProgram
  Model<dim>::make_loads(const PhaseEnd *before, const Condensation condensation)
  {
    interruption::check("while the model was set up");
    check_joints(parameters.joints);
    check_body_solver();
    LoadProgram program = make_load_program(parameters.model, bodies, construction.stage);
    if (construction.is_first())
      check_later_phases<dim>(parameters, mesh);
    if (!is_last_phase())
      {
        const double end       = construction.until_rest
                                   ? parameters.model.dynamics.end_of_continuation(construction.begin)
                                   : next_stage();
        program.history        = program.history.with_corner(end).until(end);
        program.end_of_loading = end;
      }
    bodies.check_load_patterns(program.patterns);
    if (!construction.is_first())
      begin_phase(parameters.model, before, *shared_bodies, construction, program);
    if (condensation != Condensation::never)
      shared_bodies->set_load_patterns(std::move(program.patterns));
    return program;
  }

  template <int dim>
  std::vector<MonitorPoint<dim>>
  Model<dim>::find_monitor_points() const
  {
    std::vector<MonitorPoint<dim>> points;
    InputErrors errors;
    for (const MonitorDefinition &definition : parameters.model.monitors)
      errors.attempt([&]() { points.emplace_back(bodies.discretization(), mesh, definition); });
    errors.throw_if_any();
    return points;
  }

  template <int dim>
  std::vector<Monitor>
  Model<dim>::make_monitors(const Condensation condensation) const
  {
    std::vector<Monitor> result;
    if (condensation == Condensation::never)
      return result;
    for (std::size_t i = 0; i < monitor_points.size(); ++i)
      result.emplace_back(parameters.model.monitors[i],
                          monitor_points[i],
                          parameters.model,
                          bodies,
                          is_dynamic() ? Monitor::Source::field : Monitor::Source::loads);
    return result;
  }

  template <int dim>
  std::vector<std::string>
  Model<dim>::find_joint_names() const
  {
    std::vector<std::string> names;
    for (const JointParameters &joint : parameters.joints)
      names.push_back(joint.definition.name);
    return names;
  }

  template <int dim>
  std::vector<std::string>
  Model<dim>::find_stage_names() const
  {
    std::vector<std::string> names;
    for (const StageDefinition &stage : parameters.model.stages)
      names.push_back(stage.name);
    return names;
  }

  template <int dim>
  std::vector<ElementFrame>
  Model<dim>::find_frames() const
  {
    std::vector<ElementFrame> result;
    for (std::size_t k = 0; k < bodies.elements().size(); ++k)
      result.push_back({bodies.normal(k), bodies.tangents(k)});
    return result;
  }

  template <int dim>
  std::vector<JointResultant>
  Model<dim>::resultants(const std::vector<ElementResult> &results, const Vector &dissipation) const
  {
    if constexpr (dim == 3)
      return joint_resultants_in_space(
        joint_names.size(), bodies.elements(), frames, results, dissipation);
    else
      {
        std::vector<std::array<double, 3>> normals;
        for (const ElementFrame &frame : frames)
          normals.push_back(frame.normal);
        return joint_resultants(joint_names.size(),
                                bodies.elements(),
                                normals,
                                results,
                                dissipation,
                                {parameters.model.thickness,
                                 parameters.model.assumption == PlaneAssumption::axisymmetric});
      }
  }

  template <int dim>
  std::string
  Model<dim>::motion(const std::vector<ContactElement> &elements, const PathResult &result) const
  {
    if (result.mechanism == MechanismKind::none || result.mechanism_jumps.empty())
      return "";
    return mechanism_text(
      joint_motions(joint_names.size(), elements, frames, result.mechanism_jumps, dim == 3),
      joint_names);
  }

  template <int dim>
  void
  Model<dim>::check_joints(const std::vector<JointParameters> &joints) const
  {
    check_initial_gaps<dim>(bodies.elements(), joints, parameters.model.constants);
  }

  template <int dim>
  void
  Model<dim>::check_body_solver() const
  {
    const BodySolver solver = parameters.model.body_solver;
    if (solver != BodySolver::matrix_free)
      return;
    const std::string what = what_needs_stiffness(parameters);
    if (!what.empty())
      throw InputError(fmt::format(
        "{}: Solver/Bodies = iterative matrix-free: {} not available without the stiffness of the "
        "interface. Choose Solver/Bodies = iterative or direct.",
        parameters.parameter_file,
        what));
  }

  template <int dim>
  std::vector<bool>
  Model<dim>::find_joints_there() const
  {
    std::vector<bool> there(parameters.joints.size(), false);
    for (const JointFace &face : bodies.joint_faces())
      there[face.joint] = true;
    return there;
  }

  template <int dim>
  PathOptions
  Model<dim>::path_options() const
  {
    PathOptions options;
    options.iteration = parameters.solver.iteration == IterationKind::newton
                          ? PathOptions::Iteration::newton
                          : PathOptions::Iteration::constant_stiffness;
    options.follow    = parameters.solver.follow_events ? PathOptions::Follow::events
                                                        : PathOptions::Follow::stage_ends;
    switch (parameters.solver.non_unique)
      {
        case NonUniqueChoice::stop:
          options.non_unique = PathOptions::NonUnique::stop;
          break;
        case NonUniqueChoice::first:
          options.non_unique = PathOptions::NonUnique::first;
          break;
        case NonUniqueChoice::largest_dissipation:
          options.non_unique = PathOptions::NonUnique::largest_dissipation;
          break;
      }
    options.follow_jumps   = parameters.solver.follow_jumps;
    options.beyond_limit   = parameters.solver.beyond_limit == LimitLoadChoice::arc_length;
    options.beyond_jump    = parameters.solver.beyond_jump;
    options.tolerance      = parameters.solver.iteration_tolerance;
    options.max_iterations = parameters.solver.maximum_iterations;
    return options;
  }

  // Prescribed quantities without inertia must be constant where bodies move.
  template <int dim>
  bool
  Model<dim>::goes_on_in_motion(const PathResult &result) const
  {
    if (parameters.solver.beyond_limit != LimitLoadChoice::dynamic || is_dynamic() ||
        (result.verdict != Verdict::limit_load && result.verdict != Verdict::no_continuation) ||
        !(result.t < parameters.model.dynamics.end_of_continuation(result.t)))
      return false;
    const Vector rates   = loads.load_factors.rates(result.t),
                 factors = loads.load_factors.factors(result.t);
    for (std::size_t i = 0; i < rates.size(); ++i)
      if (const LoadDefinition &load = parameters.model.loads[i];
          load.is_without_inertia() &&
          (rates[i] != 0. || (factors[i] != 0. && depends_on_time(load))))
        return false;
    return true;
  }

  template <int dim>
  std::vector<std::pair<std::string, std::size_t>>
  Model<dim>::sizes() const
  {
    std::size_t n_bars = 0;
    for (const ContactElement &element : bodies.elements())
      n_bars += element.n_bars();
    return {{"cells", bodies.discretization().n_cells()},
            {"degrees_of_freedom", bodies.discretization().n_dofs()},
            {"load_patterns", bodies.load_patterns().cols()},
            {"interface_coordinates", bodies.n_coordinates()},
            {"contact_elements", bodies.elements().size()},
            {"bars", n_bars}};
  }

  template class Model<2>;
  template class Model<3>;
} // namespace fuga
