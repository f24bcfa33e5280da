// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/scene_model.h"

#include "judges/from_contact.h"

#include <fuga/input/layer_law.h>
#include <fuga/input/read/read_parameters.h>
#include <fuga/mesh/gmsh_mesh.h>
#include <fuga/mesh/joint_splitter.h>

#include <stdexcept>

namespace fuga::tests
{
  namespace
  {
    Parameters
    read(const std::string &file, const std::vector<std::string> &overrides)
    {
      return read_parameters(parameter_path(file), overrides);
    }

    JointedMesh
    split(const Parameters &parameters)
    {
      std::vector<JointDefinition> definitions;
      for (const JointParameters &joint : parameters.joints)
        definitions.push_back(joint.definition);
      return split_joints(read_gmsh_mesh(parameters.mesh_file), definitions);
    }
  } // namespace

  SceneModel::SceneModel(const std::string &file, const std::vector<std::string> &overrides)
    : parameters(read(file, overrides)), mesh(split(parameters))
  {
    std::vector<bool> frictionless;
    for (const JointParameters &joint : parameters.joints)
      frictionless.push_back(joint.friction.is_frictionless());
    system   = std::make_unique<CondensedSystem<2>>(mesh, parameters.model, frictionless);
    elements = system->elements();
    for (const JointParameters &joint : parameters.joints)
      {
        if (joint.initial_gap != "0")
          throw std::invalid_argument("SceneModel knows no initial gaps");
        for (const LayerDirection direction : {LayerDirection::normal, LayerDirection::shear})
          laws.push_back(make_layer_law(joint, direction, parameters.model.constants));
      }
    for (ContactElement &element : elements)
      {
        element.normal_law = laws[2 * element.joint].get();
        element.shear_law  = laws[2 * element.joint + 1].get();
        element.friction   = parameters.joints[element.joint].friction;
      }
    loads = std::make_unique<LoadProgram>(make_load_program(parameters.model, *system));
    system->set_load_patterns(loads->patterns);
  }

  SceneModel::~SceneModel() = default;

  judges::JudgeProblem
  SceneModel::judge_problem() const
  {
    return judges::judge_problem(*system, elements);
  }

  Vector
  SceneModel::judge_load(const double t) const
  {
    return judges::judge_load(*system, loads->history.factors(t));
  }

  Vector
  SceneModel::bars(const SceneRun &run, const double t, const bool forces) const
  {
    Vector result(2 * elements.size(), 0.);
    for (std::size_t r = 0; r < run.history.rows.size(); ++r)
      if (std::abs(run.history.number(r, "t") - t) < 1e-12)
        {
          const ContactElement &element =
            elements.at(static_cast<std::size_t>(run.history.number(r, "element")));
          if (std::abs(element.position[0] - run.history.number(r, "x")) > 1e-9)
            throw std::logic_error("elements are numbered otherwise");
          result.at(element.normal_bar) = run.history.number(r, forces ? "N" : "jump_n");
          if (element.has_tangential_bar())
            result.at(element.tangential_bar) = run.history.number(r, forces ? "T1" : "jump_t1");
        }
    return result;
  }

  dealii::Vector<double>
  SceneModel::displacement(const Vector &jumps, const double t) const
  {
    if (!system->jump_operator().is_identity())
      throw std::logic_error("jumps are no coordinates where joints cross");
    return system->recover(loads->history.factors(t), jumps);
  }

  std::size_t
  SceneModel::node_at(const std::array<double, 2> &place) const
  {
    const auto &space  = system->discretization();
    std::size_t result = 0;
    const dealii::Point<2> point(place[0], place[1]);
    for (std::size_t node = 1; node < space.n_nodes(); ++node)
      if (space.position(node).distance(point) < space.position(result).distance(point))
        result = node;
    return result;
  }
} // namespace fuga::tests
