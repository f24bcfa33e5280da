// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_model_safety_search_h
#define fuga_run_model_safety_search_h

#include <fuga/output/tables/summary.h>
#include <fuga/run/model/joint_model.h>
#include <fuga/run/model/model.h>

namespace fuga
{
  /**
   * The searches for factors of safety requested in section Safety: stages after the loads, each of
   * which begins with the state at their end.
   */
  template <int dim>
  class SafetySearch
  {
  public:
    /**
     * @p joints are those with their strength from which @p joint was made. All arguments must
     * outlive this object.
     */
    SafetySearch(const Model<dim> &model,
                 const std::vector<JointParameters> &joints,
                 const JointModel &joint,
                 const LayeredSystem &layered);

    bool
    is_wanted() const
    {
      return model.loads.end_of_loading < model.loads.history.end();
    }

    /** Return what is known before the searches, or without them. */
    std::vector<SafetyFactor>
    announced() const;

    /**
     * Follow all searches from the cut at the end of the loads. @p begins is called with the state
     * in which a search begins, @p lost when equilibrium was lost. The judge starts from the end of
     * the loads every time, and is reset to it afterwards.
     * @throws NumericalFailure
     */
    std::vector<SafetyFactor>
    run(const PathCut &end_of_loading,
        Judge &judge,
        PathObserver &observer,
        const std::function<void(const JointState &)> &begins,
        const std::function<void()> &lost) const;

  private:
    std::size_t
    first() const
    {
      return static_cast<std::size_t>(model.loads.end_of_loading);
    }

    SafetyFactor
    announced(const StageDefinition &search) const;
    /** Return the loads, and the strength, up to the end of a search. */
    LoadHistory
    history_of(const std::size_t search) const;
    std::vector<std::string>
    moving_joints(const Vector &mechanism_jumps) const;

    const Model<dim> &model;
    const std::vector<JointParameters> &joints;
    const JointModel &joint;
    const LayeredSystem &layered;
  };
} // namespace fuga

#endif
