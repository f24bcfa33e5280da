// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_construction_h
#define fuga_bodies_construction_h

#include <fuga/base/fields.h>
#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/bodies/model_definition.h>

namespace fuga
{
  /** Return whether a body exists in a stage. */
  bool
  is_there(const Material &material, const unsigned int stage);

  /** Return for each of these bodies whether it exists in a stage. */
  std::vector<bool>
  bodies_in_stage(const std::vector<std::string> &body_names,
                  const ModelDefinition &model,
                  const unsigned int stage);

  /**
   * Return whether the supports of absorbing boundaries are released in a stage, i.e. inertia acts.
   */
  bool
  releases_supports(const ModelDefinition &model, const unsigned int stage);

  /** Return whether a stage has the bodies, joints and supports of the previous one. */
  bool
  keeps_structure(const ModelDefinition &model, const unsigned int stage);

  /** Return whether bodies are built or removed, or joints grouted, at the beginning of a stage. */
  bool
  changes_construction(const ModelDefinition &model, const unsigned int stage);

  /** Return whether this happens in any stage except for the first. */
  bool
  changes_construction(const ModelDefinition &model);

  /**
   * Return the first stages of all phases. In a phase the same bodies exist, no joint is grouted,
   * and inertia acts throughout or not at all. First stages are 0, every stage that begins with a
   * change of construction, every dynamic stage and the one after it.
   */
  std::vector<unsigned int>
  first_stages_of_phases(const ModelDefinition &model);

  /** Return the stage after the phase that begins with stage @p first. */
  unsigned int
  end_of_phase(const ModelDefinition &model, const unsigned int first);

  /**
   * Identifies a contact element in all phases of construction: its joint, degrees of freedom of
   * its nodes (Discretization::dof(); the largest number for an obstacle), and the straight part of
   * the joint at a corner (NodePair::part).
   */
  using ElementIdentity = std::array<std::size_t, 4>;

  /**
   * The displacement at which bodies that were built later are free of stress: on the nodes that
   * they share with older bodies, the displacement of these at that time. Elsewhere it is zero.
   */
  struct StressFreeShape
  {
    /** The stage in which the bodies were built. */
    unsigned int stage = 0;
    /** Degrees of freedom, see Discretization::dof(). */
    std::vector<std::size_t> dofs;
    /** Displacements of these degrees of freedom [m]. */
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

  /**
   * The data that a phase of construction takes over from the previous one; empty for the first
   * phase.
   */
  struct ConstructionState
  {
    /**
     * The stage in which the phase begins, and the load time: the number of the stage, or a later
     * time at which equilibrium was lost, or found again.
     */
    unsigned int stage = 0;
    double begin       = 0.;
    /**
     * Whether the phase is a motion that goes on until the bodies rest: equilibrium was lost, or
     * they still moved at the end of a dynamic stage.
     */
    bool until_rest = false;
    /**
     * Displacement of all degrees of freedom (Discretization::dof()) at the beginning of the phase
     * [m].
     */
    Vector displacement;
    /** Velocity of a motion that follows another one [m/s]; empty: zero. */
    Vector velocity;
    /** Bar forces at the beginning, minus those of water in open elements [MN]. */
    Vector forces;
    /** Jumps of the bars in addition to the jump of the bodies and the imposed gaps [m]. */
    Vector jump_offsets;
    std::vector<StressFreeShape> shapes;

    /** Return whether there is no earlier phase. */
    bool
    is_first() const
    {
      return begin == 0. && !until_rest;
    }

    /**
     * Return whether the phase begins with its stage, with everything that is built, removed and
     * grouted then.
     */
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
