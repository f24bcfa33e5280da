// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/bodies/program/carried_loads.h>
#include <fuga/bodies/space/discretization.h>
#include <fuga/run/model/joint_model.h>
#include <fuga/run/model/model.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <fmt/format.h>

namespace fuga
{
  // Nothing is computed before the input of all phases has been checked.
  template <int dim>
  void
  Model<dim>::check_later_phases() const
  {
    for (const unsigned int stage : first_stages_of_phases(parameters.model))
      if (stage > 0)
        {
          const CondensedSystem<dim> later(
            mesh, parameters.model, frictionless_joints(), Condensation::with_loads, stage);
          check_initial_gaps<dim>(later.elements(), parameters.joints, parameters.model.constants);
          check_temperatures(make_load_program(parameters.model, later, stage), stage);
        }
  }

  // A body takes the temperature that it has when it is built for its own, so that what is shown as
  // its stress would not be.
  template <int dim>
  void
  Model<dim>::check_temperatures(const LoadProgram &program, const unsigned int stage) const
  {
    const Vector factors = program.load_factors.factors(stage);
    for (std::size_t i = 0; i < factors.size(); ++i)
      for (const Material &material : parameters.model.materials)
        if (const LoadDefinition &load = parameters.model.loads[i];
            load.kind == LoadKind::temperature && factors[i] != 0. && material.built_at == stage &&
            (load.targets.empty() ||
             std::find(load.targets.begin(), load.targets.end(), material.body) !=
               load.targets.end()))
          throw InputError(fmt::format(
            "{}: the temperature load '{}' acts on body '{}' already when it is built. Give bodies "
            "that are built later a temperature load of their own, whose factor is 0 then.",
            load.origin,
            load.name,
            material.body));
  }

  template <int dim>
  void
  Model<dim>::begin_phase(LoadProgram &program, const PhaseEnd *before)
  {
    program.history      = program.history.with_corner(construction.begin);
    const Vector factors = program.history.factors(construction.begin);
    if (before)
      {
        const PhaseTransfer transfer(*before, bodies.elements(), bodies.identities());
        const JointState &last = before->checkpoint.record.last_state;
        construction.forces    = transfer.of_bars(last.forces);
        if (!last.water.empty())
          {
            const Vector water = transfer.of_bars(last.water);
            for (std::size_t bar = 0; bar < water.size(); ++bar)
              construction.forces[bar] -= water[bar];
          }
        put_new_nodes_on_supports(
          bodies, before->was_there, program.patterns, factors, construction.displacement);
        if (construction.begins_stage())
          if (StressFreeShape shape = shape_of_new_bodies(bodies, parameters.model, construction);
              !shape.dofs.empty())
            construction.shapes.push_back(std::move(shape));
      }
    shared_bodies->set_stress_free_shapes(construction.shapes);
    CarriedLoads carried =
      carried_loads(bodies, parameters.model, construction, program.patterns, factors);
    program.patterns.push_back(std::move(carried.carried));
    program.patterns.push_back(std::move(carried.released));
    // Little is out of balance behind a motion, and it is not to disturb what follows.
    const double released = construction.begins_stage()
                              ? construction.stage + 1.
                              : parameters.model.dynamics.end_of_continuation(construction.begin);
    program.history =
      program.history.with_corner(released).with_carried_loads(construction.begin, released);
  }

  // The bars go on feeling what they felt, and new ones begin with nothing, wherever the bodies
  // are.
  template <int dim>
  void
  Model<dim>::take_over_joints(const PhaseEnd &before)
  {
    const JointModel joint =
      make_joint_model<dim>(bodies, parameters.joints, parameters.model.constants);
    const std::vector<std::string> &filled =
      parameters.model.stages[construction.stage].grouted_joints;
    std::vector<bool> grouted;
    for (const std::string &name : joint_names)
      grouted.push_back(construction.begins_stage() &&
                        std::find(filled.begin(), filled.end(), name) != filled.end());
    const PhaseTransfer transfer(before, bodies.elements(), bodies.identities());
    first_state = transfer.state(joint.elements, grouted);

    Vector &offsets = construction.jump_offsets = first_state.dislocations;
    for (const ContactElement &element : joint.elements)
      {
        const auto add = [&](const unsigned int bar, const ComplianceLaw &law) {
          offsets[bar] += bar_compliance(law, element.area) * first_state.forces[bar];
        };
        add(element.normal_bar, *element.normal_law);
        if (element.has_tangential_bar())
          add(element.tangential_bar, *element.shear_law);
        if (element.has_second_tangential_bar())
          add(element.second_tangential_bar, *element.shear_law);
      }
    const dealii::Vector<double> u(construction.displacement.begin(),
                                   construction.displacement.end());
    const Vector of_bodies = bodies.jumps(u);
    Vector imposed(offsets.size(), 0.);
    if (!bodies.imposed_jumps().empty())
      imposed = multiply(bodies.imposed_jumps(), loads.history.factors(construction.begin));
    for (std::size_t bar = 0; bar < offsets.size(); ++bar)
      offsets[bar] -= of_bodies[bar] + imposed[bar];
  }

  // What is prescribed without inertia must stand still where bodies move.
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
  std::string
  Model<dim>::change_of_construction() const
  {
    const unsigned int stage = construction.stage;
    std::vector<std::string> built, removed;
    for (const Material &material : parameters.model.materials)
      if (stage > 0 && material.built_at == stage)
        built.push_back(material.body);
      else if (material.removed_at == stage)
        removed.push_back(material.body);
    std::string text = fmt::format("stage '{}':", stage_names[stage]);
    const auto add   = [&text](const char *what, const std::vector<std::string> &names) {
      if (!names.empty())
        text += fmt::format(" {} {};", what, fmt::join(names, ", "));
    };
    add("built", built);
    add("removed", removed);
    add("grouted", parameters.model.stages[stage].grouted_joints);
    const Discretization<dim> &space = bodies.discretization();
    return text + fmt::format(" {} cells, {} degrees of freedom, {} contact elements",
                              space.n_cells(),
                              space.n_dofs(),
                              bodies.elements().size());
  }

  template class Model<2>;
  template class Model<3>;
} // namespace fuga
