// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_study_trial_run_h
#define fuga_study_trial_run_h

#include <fuga/contact/judge/judge.h>
#include <fuga/output/results/joint_resultant.h>
#include <fuga/run/model/joint_model.h>
#include <fuga/run/model/model.h>

namespace fuga
{
  /** A run of a model that writes nothing and keeps the results at its load levels. */
  template <int dim>
  class TrialRun : private PathObserver
  {
  public:
    struct Level
    {
      double t = 0.;
      std::vector<ElementResult> results;
      std::vector<JointResultant> resultants;
      /** Interface coordinates and load factors. */
      Vector x, a;
    };

    /**
     * Follow the loads to their end, or as far as possible. @throws InputError, NumericalFailure
     */
    explicit TrialRun(const Model<dim> &model);

    const Model<dim> &
    model() const
    {
      return its_model;
    }

    /**
     * Return the levels that were reached, followed by the last state if the run ended between
     * levels.
     */
    const std::vector<Level> &
    levels() const
    {
      return all_levels;
    }

    /** Return whether the run ended between levels. */
    bool
    ended_early() const
    {
      return all_levels.size() > n_reached;
    }

    /** Return the displacement at a level up to rigid motions. */
    dealii::Vector<double>
    deformation(const Level &level) const;

    /** Return the compliance of a bar in the unloaded state [length/force]. */
    double
    compliance(const unsigned int bar) const
    {
      return layered.compliance(bar);
    }

  private:
    void
    advanced(const PathPoint &from, const PathPoint &to, const double length) override;
    void
    jumped(const JointState &to) override;
    void
    changed(const std::vector<ContactEvent> &events, const JointState &state) override;
    void
    reached(const std::size_t index, const JointState &state) override;
    void
    add_level(const JointState &state);

    const Model<dim> &its_model;
    const JointModel joint;
    const LayeredSystem layered;
    const Judge judge;
    JointState last_state;
    std::vector<Level> all_levels;
    std::size_t n_reached = 0;
  };

  /**
   * Return the levels that both runs reached, and their last states if one of them or both ended
   * early.
   */
  template <int dim>
  std::vector<
    std::pair<const typename TrialRun<dim>::Level *, const typename TrialRun<dim>::Level *>>
  common_levels(const TrialRun<dim> &one, const TrialRun<dim> &other);
} // namespace fuga

#endif
