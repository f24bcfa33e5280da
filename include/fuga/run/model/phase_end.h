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
  /** The end of a phase of construction: everything that the next one needs to know about it. */
  struct PhaseEnd
  {
    /**
     * The state in which the next phase begins, without the forces of its bars and what follows
     * from them.
     */
    ConstructionState next;
    std::shared_ptr<const JointedMesh> mesh;
    PhaseTimer timer;

    /** Tells which degrees of freedom existed, see Discretization::dof(). */
    std::vector<bool> was_there;

    /** The elements, of which only geometry and bars are used; their laws do not exist any more. */
    std::vector<ContactElement> elements;
    std::vector<ElementIdentity> identities;
    /** The state of the joints and the contents of all records. */
    Checkpoint checkpoint;
  };

  /** Transfers values of elements and bars of a phase to the next one. */
  class PhaseTransfer
  {
  public:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    /** @p elements and their @p identities belong to the new phase. */
    PhaseTransfer(const PhaseEnd &before,
                  const std::vector<ContactElement> &elements,
                  const std::vector<ElementIdentity> &identities);

    /** Return the values of bars; 0 for new ones. */
    Vector
    of_bars(const Vector &values) const;

    /** Return the values of elements; 0 for new ones. */
    template <typename Value>
    std::vector<Value>
    of_elements(const std::vector<Value> &values) const;

    /** Return the new numbers of elements, without those that no longer exist. */
    std::vector<std::size_t>
    numbers(const std::vector<std::size_t> &before) const;

    /**
     * Return the state in which the phase begins: new elements are as at the beginning of a run;
     * @p grouted joints (by number) have no gap where they were open, no force, and their full
     * strength.
     */
    JointState
    state(const std::vector<ContactElement> &elements, const std::vector<bool> &grouted) const;

  private:
    const PhaseEnd &before;
    const std::vector<ContactElement> &elements;
    /** Old number of every element, or `none`. */
    std::vector<std::size_t> old_numbers;
  };
} // namespace fuga

#endif
