// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_program_refinement_indicator_h
#define fuga_bodies_program_refinement_indicator_h

#include <fuga/bodies/condensed/condensed_system.h>

namespace fuga
{
  /**
   * Return the strain energy of the difference between two solutions, u_fine - u_coarse, in each
   * cell of the coarse system. The mesh of the fine system is the same, refined once more.
   */
  template <int dim>
  Vector
  refinement_indicator(const CondensedSystem<dim> &coarse,
                       const dealii::Vector<double> &u_coarse,
                       const CondensedSystem<dim> &fine,
                       const dealii::Vector<double> &u_fine);

  /**
   * Return the cells with the largest indicators, as many as needed for the fraction @p share of
   * their sum.
   */
  template <int dim>
  std::vector<CellKey>
  mark_cells(const CondensedSystem<dim> &system, const Vector &indicator, const double share);
} // namespace fuga

#endif
