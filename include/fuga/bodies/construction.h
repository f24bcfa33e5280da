// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_construction_h
#define fuga_bodies_construction_h

#include <fuga/base/fields.h>
#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/bodies/model_definition.h>

namespace fuga
{
  /** Whether a body is there in a stage. */
  bool
  is_there(const Material &material, const unsigned int stage);

  /** The same for bodies by name. */
  std::vector<bool>
  bodies_in_stage(const std::vector<std::string> &body_names,
                  const ModelDefinition &model,
                  const unsigned int stage);

  /** Whether the supports of absorbing boundaries are released in a stage: inertia acts. */
  bool
  releases_supports(const ModelDefinition &model, const unsigned int stage);

  /** Whether a stage has the bodies, joints and supports of the one before. */
  bool
  keeps_structure(const ModelDefinition &model, const unsigned int stage);

  /** Whether bodies are built or removed, or joints grouted, at the beginning of a stage. */
  bool
  changes_construction(const ModelDefinition &model, const unsigned int stage);

  /** Whether that happens in any stage but the first. */
  bool
  changes_construction(const ModelDefinition &model);

  /**
   * The first stages of all phases, in which the same bodies are there, no joint is grouted, and
   * inertia acts throughout or not at all: 0, every stage that begins with a change of
   * construction, every dynamic stage and the one behind it.
   */
  std::vector<unsigned int>
  first_stages_of_phases(const ModelDefinition &model);

  /** The stage behind the phase that begins with stage @p first. */
  unsigned int
  end_of_phase(const ModelDefinition &model, const unsigned int first);

  /** Tells a contact element in all phases of construction: its joint, degrees of freedom of its
   * nodes (Discretization::dof(); the largest number for an obstacle), and the straight part of the
   * joint at a corner (NodePair::part). */
  using ElementIdentity = std::array<std::size_t, 4>;

  /**
   * The displacement in which bodies that were built later are free of stress: on the nodes that
   * they share with older bodies, what these had done by then. Elsewhere it is zero.
   */
  struct StressFreeShape
  {
    /** In which the bodies were built. */
    unsigned int stage = 0;
    /** Degrees of freedom; see Discretization::dof(). */
    std::vector<std::size_t> dofs;
    /** [m] */
    Vector displacements;
  };

  template <typename Shape, typename Visitor, only_for<Shape, StressFreeShape> = 0>
  void
  for_each_field(Shape &shape, Visitor &&visit)
  {
    auto &[stage, dofs, displacements] = shape;
    visit("stage", stage);
    visit("dofs", dofs);
    visit("displacements", displacements);
  }

  /** What a phase of construction takes over from the one before; empty for the first phase. */
  struct ConstructionState
  {
    /** The stage in which the phase begins, and the load time: the number of the stage, or a later
     * time where equilibrium was lost, or found again. */
    unsigned int stage = 0;
    double begin       = 0.;
    /** The phase is a motion that goes on until the bodies rest: equilibrium was lost, or they
     * still moved at the end of a dynamic stage. */
    bool until_rest = false;
    /** At its beginning, of all degrees of freedom (Discretization::dof()) [m]. */
    Vector displacement;
    /** Of the motion behind another one; empty: zero [m/s]. */
    Vector velocity;
    /** Bar forces then, less those of water in open elements [MN]. */
    Vector forces;
    /** What the bars feel besides the jump of the bodies and the imposed gaps [m]. */
    Vector jump_offsets;
    std::vector<StressFreeShape> shapes;

    /** Nothing was before. */
    bool
    is_first() const
    {
      return begin == 0. && !until_rest;
    }

    /** The phase begins with its stage, with all that is built, removed and grouted then. */
    bool
    begins_stage() const
    {
      return begin == stage && !until_rest;
    }
  };

  template <typename State, typename Visitor, only_for<State, ConstructionState> = 0>
  void
  for_each_field(State &state, Visitor &&visit)
  {
    auto &[stage, begin, until_rest, displacement, velocity, forces, jump_offsets, shapes] = state;
    visit("stage", stage);
    visit("begin", begin);
    visit("until_rest", until_rest);
    visit("displacement", displacement);
    visit("velocity", velocity);
    visit("forces", forces);
    visit("jump_offsets", jump_offsets);
    visit("shapes", shapes);
  }
} // namespace fuga

#endif
