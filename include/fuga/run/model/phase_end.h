// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_model_phase_end_h
#define fuga_run_model_phase_end_h

#include <fuga/base/phase_timer.h>
#include <fuga/bodies/condensed/condensed_system.h>
#include <fuga/bodies/construction.h>
#include <fuga/output/restart/checkpoint.h>

#include <memory>

namespace fuga
{
  /** How a phase of construction ended: all that the next one needs to know of it. */
  struct PhaseEnd
  {
    /** What the next one begins with, but for the forces of its bars and what follows from them. */
    ConstructionState next;
    std::shared_ptr<const JointedMesh> mesh;
    PhaseTimer timer;

    /** Which degrees of freedom were there, see Discretization::dof(). */
    std::vector<bool> was_there;

    /** Only geometry and bars are used; the laws do not live any more. */
    std::vector<ContactElement> elements;
    std::vector<ElementIdentity> identities;
    /** The state of the joints and what all records know. */
    Checkpoint checkpoint;
  };

  /** Takes what is known of elements and bars of a phase over into the next one. */
  class PhaseTransfer
  {
  public:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    /** @p elements of the new phase, and where they are. */
    PhaseTransfer(const PhaseEnd &before,
                  const std::vector<ContactElement> &elements,
                  const std::vector<ElementIdentity> &identities);

    /** Values of bars; 0 for new ones. */
    Vector
    of_bars(const Vector &values) const;

    /** Values of elements; 0 for new ones. */
    template <typename Value>
    std::vector<Value>
    of_elements(const std::vector<Value> &values) const;

    /** New numbers of elements; without those that are gone. */
    std::vector<std::size_t>
    numbers(const std::vector<std::size_t> &before) const;

    /**
     * The state in which the phase begins: new elements as at the beginning of a run; @p grouted
     * joints (by number) have no gap where they were open, no force, and all of their strength.
     */
    JointState
    state(const std::vector<ContactElement> &elements, const std::vector<bool> &grouted) const;

  private:
    const PhaseEnd &before;
    const std::vector<ContactElement> &elements;
    /** Old number of every element, or none. */
    std::vector<std::size_t> old_numbers;
  };
} // namespace fuga

#endif
