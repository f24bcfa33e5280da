// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_study_dual_fields_h
#define fuga_study_dual_fields_h

#include <fuga/study/trial_run.h>

namespace fuga
{
  /**
   * Return, for each contact element, whether its pressure counts for the target accuracy. @throws
   * InputError for an expression without value.
   */
  template <int dim>
  std::vector<bool>
  counting_elements(const Model<dim> &model);

  /**
   * Return displacements that show where an error of the mesh matters for the quantity of the
   * target accuracy, with the joints as they are at @p level: by Maxwell's theorem those caused by
   * a force at the monitor; or those caused by a jump of the joint on which its bar forces do the
   * work that is wanted, N, T, M, or, for the pressure, ∫p². There is one displacement per number.
   * (doc/theory.md, section 14)
   * @throws NumericalFailure
   */
  template <int dim>
  std::vector<dealii::Vector<double>>
  dual_fields(const TrialRun<dim> &run, const typename TrialRun<dim>::Level &level);
} // namespace fuga

#endif
