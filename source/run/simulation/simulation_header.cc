// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/space/discretization.h>
#include <fuga/output/files/version.h>
#include <fuga/output/tables/boundary_table.h>
#include <fuga/output/tables/summary.h>
#include <fuga/output/warnings/model_echo.h>
#include <fuga/output/warnings/model_warnings.h>
#include <fuga/run/simulation/simulation.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  template <int dim>
  void
  Simulation<dim>::begin_output()
  {
    begin_results(parameters.output.directory, [this]() {
      Outcome unfinished;
      unfinished.verdict = "unfinished";
      write_summary(unfinished);
    });
    write_boundary_table(parameters.output.directory, model.mesh, parameters.output.units);
    if (!accuracy.rounds.empty())
      write_refinement_table(parameters.output.directory, accuracy);
    publish(true);
    if (keeps_checkpoints())
      mesh_identity = identify_file(parameters.mesh_file);
    model.timer.finish("tables");
  }

  template <int dim>
  void
  Simulation<dim>::log_header()
  {
    const Discretization<dim> &space = model.bodies.discretization();
    for (std::size_t i = 0; i < accuracy.rounds.size(); ++i)
      log.earlier_line(accuracy.description(i));
    log.line(fmt::format("fuga {}  {}", version, parameters.title));
    log.line(fmt::format("{}: {} cells, {} degrees of freedom, {} contact elements, {} bars",
                         parameters.mesh_file,
                         space.n_cells(),
                         space.n_dofs(),
                         joint.elements.size(),
                         layered.n_bars()));
    for (const std::string &line : model.mesh.report)
      log.line(line);
    for (const std::string &line : model.bodies.report())
      log.line(line);
    log_layers();
    for (const std::string &line : joint.report)
      log.line(line);
    for (const std::string &line : model.loads.report)
      log.line(line);
    log_model();
  }

  template <int dim>
  void
  Simulation<dim>::log_model()
  {
    const ModelEcho<dim> echo(parameters,
                              model.bodies,
                              model.loads.load_factors,
                              model.construction.stage,
                              model.next_stage());
    for (const std::string &line : echo.in_brief())
      log.line(line);
    for (const std::string &text : model_warnings(parameters,
                                                  model.bodies,
                                                  model.loads.load_factors,
                                                  model.construction.stage,
                                                  model.next_stage()))
      log.warning(text);
  }

  namespace
  {
    std::string
    strength_description(const FrictionLaw &law)
    {
      std::string text = fmt::format("friction {:g}, cohesion {:g}", law.coefficient, law.cohesion);
      if (law.friction_loss > 0.)
        text += fmt::format(", residual friction {:g}", residual_friction(law));
      if (law.tensile_strength > 0.)
        text += fmt::format(", tensile strength {:g}", law.tensile_strength);
      if (law.bond_loss == FrictionLaw::BondLoss::slip)
        text += ", brittle";
      if (law.dilatancy > 0.)
        text += fmt::format(", dilatancy {:g}", law.dilatancy);
      return text;
    }
  } // namespace

  template <int dim>
  std::string
  Simulation<dim>::shear_description(const unsigned int j) const
  {
    for (const ContactElement &element : joint.elements)
      if (element.joint == j && element.coupling != nullptr)
        return element.coupling->description();
    return joint.laws[2 * j + 1]->description();
  }

  // A slip of units shows in the modulus of the layer, or in its stiffness against that of the
  // bodies.
  template <int dim>
  void
  Simulation<dim>::log_layers()
  {
    double softest_body = std::numeric_limits<double>::infinity();
    for (const Material &material : parameters.model.materials)
      softest_body = std::min(softest_body, material.young_modulus);
    for (unsigned int j = 0; j < parameters.joints.size(); ++j)
      {
        const JointParameters &data = parameters.joints[j];
        double length               = 0.; // of an area: the side of a square as large
        for (const JointFace &face : model.bodies.joint_faces())
          if (face.joint == j)
            length += dim == 2 ? std::hypot(face.positions.back()[0] - face.positions.front()[0],
                                            face.positions.back()[1] - face.positions.front()[1])
                               : face.area;
        if (dim == 3)
          length = std::sqrt(length);
        std::string text        = fmt::format("joint '{}': normal {}, shear {}, {}",
                                       data.definition.name,
                                       joint.laws[2 * j]->description(),
                                       shear_description(j),
                                       strength_description(data.friction));
        const double compliance = joint.laws[2 * j]->initial_compliance();
        if (compliance > 0. && length > 0.)
          text += fmt::format("; rho E / B = {:.3g}", compliance * softest_body / length);
        if (data.normal_layer_modulus() > 0.)
          text += fmt::format(", layer modulus {:.4g} {}",
                              data.normal_layer_modulus(),
                              parameters.output.units.stress());
        log.line(text);
      }
  }

  template class Simulation<2>;
  template class Simulation<3>;
} // namespace fuga
