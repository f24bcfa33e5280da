// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/refined_run.h"

#include <fuga/input/read/read_parameters.h>
#include <fuga/mesh/gmsh_mesh.h>

namespace fuga::tests
{
  SceneRun
  run_patch(const std::string &file, const Patch &patch)
  {
    if (patch.seed == 0)
      return run_scene(file);
    Parameters parameters = read_parameters(file, {"Output/Fields=never", "Output/Log=quiet"});
    std::vector<JointDefinition> joints;
    for (const JointParameters &joint : parameters.joints)
      joints.push_back(joint.definition);
    refine(patch, split_joints(read_gmsh_mesh(parameters.mesh_file), joints), parameters.model);
    return run_parameters(std::move(parameters));
  }
} // namespace fuga::tests
