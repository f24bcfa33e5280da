// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/bodies/program/carried_loads.h>
#include <fuga/bodies/space/discretization.h>
#include <fuga/run/model/joint_model.h>
#include <fuga/run/model/phase_begin.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    // A body takes the temperature that it has when it is built as its own, so that the stress
    // shown for it would be wrong.
    void
    check_temperatures(const ModelDefinition &definition,
                       const LoadProgram &program,
                       const unsigned int stage)
    {
      const Vector factors = program.load_factors.factors(stage);
      for (std::size_t i = 0; i < factors.size(); ++i)
        for (const Material &material : definition.materials)
          if (const LoadDefinition &load = definition.loads[i];
              load.kind == LoadKind::temperature && factors[i] != 0. &&
              material.built_at == stage &&
              (load.targets.empty() ||
               std::find(load.targets.begin(), load.targets.end(), material.body) !=
                 load.targets.end()))
            throw InputError(fmt::format(
              "{}: the temperature load '{}' acts on body '{}' already when it is built. Give "
              "bodies that are built later a temperature load of their own, whose factor is 0 "
              "then.",
              load.origin,
              load.name,
              material.body));
    }
  } // namespace

  std::vector<bool>
  frictionless_joints(const std::vector<JointParameters> &joints)
  {
    std::vector<bool> frictionless;
    for (const JointParameters &joint : joints)
      frictionless.push_back(joint.friction.is_frictionless());
    return frictionless;
  }

  template <int dim>
  void
  check_later_phases(const Parameters &parameters, const JointedMesh &mesh)
  {
    for (const unsigned int stage : first_stages_of_phases(parameters.model))
      if (stage > 0)
        {
          const CondensedSystem<dim> later(mesh,
                                           parameters.model,
                                           frictionless_joints(parameters.joints),
                                           Condensation::with_loads,
                                           stage);
          check_initial_gaps<dim>(later.elements(), parameters.joints, parameters.model.constants);
          check_temperatures(
            parameters.model, make_load_program(parameters.model, later, stage), stage);
        }
  }

  template <int dim>
  void
  begin_phase(const ModelDefinition &definition,
              const PhaseEnd *before,
              CondensedSystem<dim> &bodies,
              ConstructionState &construction,
              LoadProgram &program)
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
          if (StressFreeShape shape = shape_of_new_bodies(bodies, definition, construction);
              !shape.dofs.empty())
            construction.shapes.push_back(std::move(shape));
      }
    bodies.set_stress_free_shapes(construction.shapes);
    CarriedLoads carried =
      carried_loads(bodies, definition, construction, program.patterns, factors);
    program.patterns.push_back(std::move(carried.carried));
    program.patterns.push_back(std::move(carried.released));
    // After a motion little is out of balance, and this must not disturb what follows.
    const double released = construction.begins_stage()
                              ? construction.stage + 1.
                              : definition.dynamics.end_of_continuation(construction.begin);
    program.history =
      program.history.with_corner(released).with_carried_loads(construction.begin, released);
  }

  template <int dim>
  JointState
  take_over_joints(const Parameters &parameters,
                   const CondensedSystem<dim> &bodies,
                   const PhaseEnd &before,
                   const Vector &factors,
                   ConstructionState &construction)
  {
    const JointModel joint =
      make_joint_model<dim>(bodies, parameters.joints, parameters.model.constants);
    const std::vector<std::string> &filled =
      parameters.model.stages[construction.stage].grouted_joints;
    std::vector<bool> grouted;
    for (const JointParameters &data : parameters.joints)
      grouted.push_back(construction.begins_stage() &&
                        std::find(filled.begin(), filled.end(), data.definition.name) !=
                          filled.end());
    const PhaseTransfer transfer(before, bodies.elements(), bodies.identities());
    JointState first = transfer.state(joint.elements, grouted);

    Vector &offsets = construction.jump_offsets = first.dislocations;
    for (const ContactElement &element : joint.elements)
      {
        const auto add = [&](const unsigned int bar, const ComplianceLaw &law) {
          offsets[bar] += bar_compliance(law, element.area) * first.forces[bar];
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
    if (bodies.imposed_jumps().size() > 0)
      imposed = multiply(bodies.imposed_jumps(), factors);
    for (std::size_t bar = 0; bar < offsets.size(); ++bar)
      offsets[bar] -= of_bodies[bar] + imposed[bar];
    return first;
  }

  template <int dim>
  std::string
  change_of_construction(const ModelDefinition &definition,
                         const CondensedSystem<dim> &bodies,
                         const unsigned int stage)
  {
    std::vector<std::string> built, removed;
    for (const Material &material : definition.materials)
      if (stage > 0 && material.built_at == stage)
        built.push_back(material.body);
      else if (material.removed_at == stage)
        removed.push_back(material.body);
    std::string text = fmt::format("stage '{}':", definition.stages[stage].name);
    const auto add   = [&text](const char *what, const std::vector<std::string> &names) {
      if (!names.empty())
        text += fmt::format(" {} {};", what, fmt::join(names, ", "));
    };
    add("built", built);
    add("removed", removed);
    add("grouted", definition.stages[stage].grouted_joints);
    const Discretization<dim> &space = bodies.discretization();
    return text + fmt::format(" {} cells, {} degrees of freedom, {} contact elements",
                              space.n_cells(),
                              space.n_dofs(),
                              bodies.elements().size());
  }

  template void
  check_later_phases<2>(const Parameters &, const JointedMesh &);
  template void
  begin_phase(const ModelDefinition &,
              const PhaseEnd *,
              CondensedSystem<2> &,
              ConstructionState &,
              LoadProgram &);
  template JointState
  take_over_joints(const Parameters &,
                   const CondensedSystem<2> &,
                   const PhaseEnd &,
                   const Vector &,
                   ConstructionState &);
  template std::string
  change_of_construction(const ModelDefinition &, const CondensedSystem<2> &, const unsigned int);
  template void
  check_later_phases<3>(const Parameters &, const JointedMesh &);
  template void
  begin_phase(const ModelDefinition &,
              const PhaseEnd *,
              CondensedSystem<3> &,
              ConstructionState &,
              LoadProgram &);
  template JointState
  take_over_joints(const Parameters &,
                   const CondensedSystem<3> &,
                   const PhaseEnd &,
                   const Vector &,
                   ConstructionState &);
  template std::string
  change_of_construction(const ModelDefinition &, const CondensedSystem<3> &, const unsigned int);
} // namespace fuga
