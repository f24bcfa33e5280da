// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/space/discretization.h>
#include <fuga/output/files/version.h>
#include <fuga/output/warnings/model_echo.h>
#include <fuga/output/warnings/model_warnings.h>
#include <fuga/run/journal/log_header.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    std::string
    strength_description(const FrictionLaw &law)
    {
      std::string text = fmt::format("friction {:g}, cohesion {:g}", law.coefficient, law.cohesion);
      if (law.envelope.is_curved())
        text += fmt::format(", envelope ((1 + p/{0:g})^{1:g} - 1) {0:g}/{1:g}",
                            law.envelope.pressure,
                            law.envelope.exponent);
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

    std::string
    shear_description(const JointModel &model, const unsigned int j)
    {
      for (const ContactElement &element : model.elements)
        if (element.joint == j && element.coupling != nullptr)
          return element.coupling->description();
      return model.laws[2 * j + 1]->description();
    }

    /** Return the length of a joint [m]; in space, the side of a square of the same area. */
    template <int dim>
    double
    size_of_joint(const CondensedSystem<dim> &bodies, const unsigned int j)
    {
      double size = 0.;
      for (const JointFace &face : bodies.joint_faces())
        if (face.joint == j)
          size += dim == 2 ? std::hypot(face.positions.back()[0] - face.positions.front()[0],
                                        face.positions.back()[1] - face.positions.front()[1])
                           : face.area;
      return dim == 2 ? size : std::sqrt(size);
    }

    // Log the layers: a mistake in units shows in the modulus of the layer, or in its stiffness
    // relative to that of the bodies.
    template <int dim>
    void
    log_layers(RunJournal<dim> &journal)
    {
      const PhaseRun<dim> &phase   = journal.phase;
      const Parameters &parameters = phase.parameters;
      double softest_body          = std::numeric_limits<double>::infinity();
      for (const Material &material : parameters.model.materials)
        softest_body = std::min(softest_body, material.young_modulus);
      for (unsigned int j = 0; j < parameters.joints.size(); ++j)
        {
          const JointParameters &data = parameters.joints[j];
          const double length         = size_of_joint(phase.model.bodies, j);
          std::string text            = fmt::format("joint '{}': normal {}, shear {}, {}",
                                         data.definition.name,
                                         phase.joint.laws[2 * j]->description(),
                                         shear_description(phase.joint, j),
                                         strength_description(data.friction));
          const double compliance     = phase.joint.laws[2 * j]->initial_compliance();
          if (compliance > 0. && length > 0.)
            text += fmt::format("; rho E / B = {:.3g}", compliance * softest_body / length);
          if (data.normal_layer_modulus() > 0.)
            text += fmt::format(", layer modulus {:.4g} {}",
                                data.normal_layer_modulus(),
                                parameters.output.units.stress());
          journal.log.line(text);
        }
    }
  } // namespace

  template <int dim>
  void
  log_header(RunJournal<dim> &journal)
  {
    const PhaseRun<dim> &phase       = journal.phase;
    const Model<dim> &model          = phase.model;
    const Discretization<dim> &space = model.bodies.discretization();
    RunLog &log                      = journal.log;
    for (std::size_t i = 0; i < journal.accuracy.rounds.size(); ++i)
      log.earlier_line(journal.accuracy.description(i));
    log.line(fmt::format("fuga {}  {}", version, phase.parameters.title));
    log.line(fmt::format("{}: {} cells, {} degrees of freedom, {} contact elements, {} bars",
                         phase.parameters.mesh_file,
                         space.n_cells(),
                         space.n_dofs(),
                         phase.joint.elements.size(),
                         phase.layered.n_bars()));
    for (const std::string &line : model.mesh.report)
      log.line(line);
    for (const std::string &line : model.bodies.report())
      log.line(line);
    log_layers(journal);
    for (const std::string &line : phase.joint.report)
      log.line(line);
    for (const std::string &line : model.loads.report)
      log.line(line);
    log_model(journal);
  }

  template <int dim>
  void
  log_model(RunJournal<dim> &journal)
  {
    const Model<dim> &model      = journal.phase.model;
    const Parameters &parameters = journal.phase.parameters;
    const ModelEcho<dim> echo(parameters,
                              model.bodies,
                              model.loads.load_factors,
                              model.construction.stage,
                              model.next_stage());
    for (const std::string &line : echo.in_brief())
      journal.log.line(line);
    for (const std::string &text : model_warnings(parameters,
                                                  model.bodies,
                                                  model.loads.load_factors,
                                                  model.construction.stage,
                                                  model.next_stage()))
      journal.log.warning(text);
  }

  template void
  log_header(RunJournal<2> &);
  template void
  log_header(RunJournal<3> &);
  template void
  log_model(RunJournal<2> &);
  template void
  log_model(RunJournal<3> &);
} // namespace fuga
