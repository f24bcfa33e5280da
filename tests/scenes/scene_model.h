// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_scenes_scene_model_h
#define fuga_tests_scenes_scene_model_h

#include "judges/judge_problem.h"
#include "scenes/scene_run.h"

#include <fuga/bodies/condensed/condensed_system.h>
#include <fuga/bodies/program/load_program.h>
#include <fuga/input/parameters.h>

#include <deal.II/lac/vector.h>

#include <memory>

namespace fuga::tests
{
  /**
   * The condensed bodies, contact elements and loads of a parameter file, without any path: what an
   * independent judge needs to solve the same discrete problem.
   */
  struct SceneModel
  {
    SceneModel(const std::string &file, const std::vector<std::string> &overrides = {});
    ~SceneModel();

    Parameters parameters;
    JointedMesh mesh;
    std::unique_ptr<CondensedSystem<2>> system;
    std::vector<std::unique_ptr<ComplianceLaw>> laws;
    std::vector<ContactElement> elements;
    std::unique_ptr<LoadProgram> loads;

    judges::JudgeProblem
    judge_problem() const;

    /** The load of the judges at load time @p t. */
    Vector
    judge_load(const double t) const;

    /** All bars of a run at load time @p t, ordered as the bars are: forces or, else, jumps. */
    Vector
    bars(const SceneRun &run, const double t, const bool forces) const;

    /** Displacement of all degrees of freedom for the jumps of the bars (no crossing joints). */
    dealii::Vector<double>
    displacement(const Vector &jumps, const double t) const;

    /** The node nearest to @p place. */
    std::size_t
    node_at(const std::array<double, 2> &place) const;
  };
} // namespace fuga::tests

#endif
