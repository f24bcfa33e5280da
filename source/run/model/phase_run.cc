// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/space/discretization.h>
#include <fuga/contact/element/joint_water.h>
#include <fuga/contact/path/event_path.h>
#include <fuga/contact/path/matrix_free_path.h>
#include <fuga/run/model/phase_run.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace fuga
{
  namespace
  {
    /** Return whether a layered system belongs to these elements. Only the compliances of the bars
     * enter it; friction and cohesion do not. */
    bool
    is_of(const LayeredSystem &system, const std::vector<ContactElement> &elements)
    {
      const auto same =
        [&system](const std::size_t bar, const ComplianceLaw &law, const ContactElement &element) {
          return system.compliance(bar) == bar_compliance(law, element.area);
        };
      return std::all_of(elements.begin(), elements.end(), [&](const ContactElement &element) {
        return same(element.normal_bar, *element.normal_law, element) &&
               (!element.has_tangential_bar() ||
                same(element.tangential_bar, *element.shear_law, element));
      });
    }

    /** Return the joints whose lips have no mass, because one of their layers is rigid; see
     * lumped_mass(). */
    std::vector<bool>
    massless_joints(const std::vector<JointParameters> &joints)
    {
      std::vector<bool> result;
      for (const JointParameters &joint : joints)
        result.push_back(joint.normal_law == LayerLaw::rigid || joint.shear_law == LayerLaw::rigid);
      return result;
    }

    /** Return the result of a path that goes on. */
    PathResult
    without_loss(PathResult result)
    {
      result.verdict   = Verdict::done;
      result.mechanism = MechanismKind::none;
      result.mechanism_jumps.clear();
      if (result.n_non_unique == 0)
        result.critical = {};
      result.tried.clear();
      result.barrier = {};
      return result;
    }
  } // namespace

  template <int dim>
  PhaseRun<dim>::PhaseRun(const Model<dim> &of_phase,
                          const Parameters &of_run,
                          const std::shared_ptr<const LayeredSystem> &similar,
                          const std::shared_ptr<StepSolvers> &steps)
    : model(of_phase)
    , parameters(of_run)
    , joint(make_joint_model<dim>(model.bodies, parameters.joints, parameters.model.constants))
    , shared_layered(make_layered(similar))
    , layered(*shared_layered)
    , safety_search(model, parameters.joints, joint, layered)
    , loading(model.loads.history.until(model.loads.end_of_loading))
    , motion(make_motion(steps))
    , path(make_path())
    , judge(model.bodies, joint.elements, model.loads.history, model.loads.end_of_loading)
  {
    if (!motion)
      return;
    std::set<unsigned int> dofs;
    for (const Monitor &monitor : model.monitors)
      for (const unsigned int dof : monitor.watched_dofs())
        dofs.insert(dof);
    motion->watch({dofs.begin(), dofs.end()});
  }

  template <int dim>
  PhaseRun<dim>::~PhaseRun() = default;

  template <int dim>
  std::shared_ptr<const LayeredSystem>
  PhaseRun<dim>::make_layered(const std::shared_ptr<const LayeredSystem> &similar) const
  {
    return similar && is_of(*similar, joint.elements)
             ? similar
             : std::make_shared<const LayeredSystem>(model.bodies, joint.elements);
  }

  template <int dim>
  std::unique_ptr<BodiesInMotion<dim>>
  PhaseRun<dim>::make_motion(const std::shared_ptr<StepSolvers> &steps) const
  {
    if (!model.is_dynamic())
      return nullptr;
    return std::make_unique<BodiesInMotion<dim>>(
      model.bodies,
      parameters.model.dynamics,
      loading,
      model.construction,
      model.loads.template temperature<dim>(
        parameters.model, model.bodies.jointed_mesh().body_names, model.construction.begin),
      massless_joints(parameters.joints),
      steps);
  }

  template <int dim>
  std::unique_ptr<ContactPath>
  PhaseRun<dim>::make_path() const
  {
    if (motion)
      return std::make_unique<DynamicPath>(
        joint.elements, layered, loading, *motion, motion->time_grid(), model.path_options());
    if (model.bodies.has_stiffness())
      return std::make_unique<EventPath>(joint.elements, layered, loading, model.path_options());
    return std::make_unique<MatrixFreePath>(
      joint.elements, layered, model.bodies, model.bodies, loading);
  }

  template <int dim>
  void
  PhaseRun<dim>::began_step(const ContactSystem &system, const LoadHistory &history_of_step)
  {
    judge.begin_step(system, history_of_step);
  }

  template <int dim>
  void
  PhaseRun<dim>::ended_step(const JointState &state)
  {
    judge.end_step(state);
  }

  template <int dim>
  DynamicPath &
  PhaseRun<dim>::dynamic_path() const
  {
    return static_cast<DynamicPath &>(*path);
  }

  // The energy of moving bodies, as the judge computes it, is the work on the stiffness of the
  // steps. The tables have no columns for kinetic energy, or for damping; they contain the rest of
  // the work.
  template <int dim>
  EnergyLedger
  PhaseRun<dim>::energies() const
  {
    EnergyLedger result = judge.energies();
    if (judge.memory().in_motion)
      {
        const EnergyLedger &at_rest   = judge.memory().at_rest;
        const MotionLedger &of_motion = dynamic_path().energies();
        result.external_work =
          at_rest.external_work + of_motion.work - of_motion.kinetic - of_motion.damping;
        result.bodies = at_rest.bodies + of_motion.bodies;
      }
    return result;
  }

  template <int dim>
  Vector
  PhaseRun<dim>::displacement_in_motion() const
  {
    return since_the_beginning(motion->displacement());
  }

  template <int dim>
  Vector
  PhaseRun<dim>::since_the_beginning(Vector u) const
  {
    if (model.construction.displacement.empty())
      return u;
    const Vector before = model.bodies.discretization().by_nodes(model.construction.displacement);
    for (std::size_t i = 0; i < u.size(); ++i)
      u[i] += before[i];
    return u;
  }

  template <int dim>
  Vector
  PhaseRun<dim>::monitored(const JointState &state) const
  {
    return motion ? since_the_beginning(motion->watched_displacement())
                  : judge.coordinates(layered.jumps(state.dislocations, state.forces), state.t);
  }

  template <int dim>
  std::vector<ElementResult>
  PhaseRun<dim>::results(const JointState &state) const
  {
    const DenseMatrix &water = model.bodies.closed_water();
    return element_results(
      joint.elements,
      state,
      layered.jumps(state.dislocations, state.forces),
      water.size() == 0 ? Vector() : multiply(water, model.loads.history.factors(state.t)));
  }

  template <int dim>
  PhaseEnd
  PhaseRun<dim>::leave(const JointState &last_state,
                       const PathResult &result,
                       const std::size_t next_level,
                       const bool until_rest)
  {
    PhaseEnd end;
    end.next.shapes     = model.construction.shapes;
    end.next.until_rest = until_rest;
    if (until_rest || model.construction.until_rest)
      {
        end.next.stage = static_cast<unsigned int>(std::floor(last_state.t));
        end.next.begin = last_state.t;
      }
    else
      end.next.begin = end.next.stage = model.next_stage();
    end.mesh       = model.shared_mesh;
    end.elements   = joint.elements;
    end.identities = model.bodies.identities();

    const dealii::Vector<double> u =
      motion
        ? model.bodies.by_degrees_of_freedom(displacement_in_motion())
        : model.bodies.recover(model.loads.history.factors(last_state.t), monitored(last_state));
    if (motion)
      {
        judge.end_motion(energies().bodies);
        // Columns of a free field begin at rest, and so does everything between them.
        const ModelDefinition &definition = parameters.model;
        if (until_rest || (definition.stages[end.next.stage].is_dynamic() &&
                           definition.dynamics.free_field.names.empty()))
          {
            const auto v = model.bodies.by_degrees_of_freedom(motion->velocity());
            end.next.velocity.assign(v.begin(), v.end());
          }
      }
    end.next.displacement.assign(u.begin(), u.end());
    end.was_there.assign(u.size(), false);
    const Discretization<dim> &space = model.bodies.discretization();
    for (std::size_t node = 0; node < space.n_nodes(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        end.was_there[space.dof(node, c)] = true;

    end.checkpoint.record.last_state     = last_state;
    end.checkpoint.judge                 = judge.memory();
    end.checkpoint.cut.result            = without_loss(result);
    end.checkpoint.cut.memory.iterations = path->iterations();
    end.checkpoint.cut.next_level        = next_level;
    return end;
  }

  template <int dim>
  Checkpoint
  PhaseRun<dim>::enter(const PhaseEnd &before)
  {
    const PhaseTransfer transfer(before, joint.elements, model.bodies.identities());
    Checkpoint checkpoint = before.checkpoint;
    JointState &state = checkpoint.cut.state = model.first_state;
    // The water in a joint that is grouted is squeezed out.
    const Vector factors = model.loads.history.factors(state.t);
    const Vector no_force(layered.n_bars(), 0.);
    renew_water(joint.elements, layered, factors, no_force, WaterRelief::allowed, state);
    checkpoint.record.last_state = state;
    CriticalFriction &critical   = checkpoint.cut.result.critical;
    critical.elements            = transfer.numbers(critical.elements);

    Vector &dissipation = checkpoint.judge.element_dissipation;
    dissipation         = transfer.of_elements(dissipation);
    judge.begin_phase(checkpoint.judge, model.first_state);
    checkpoint.judge = judge.memory();
    return checkpoint;
  }

  template class PhaseRun<2>;
  template class PhaseRun<3>;
} // namespace fuga
