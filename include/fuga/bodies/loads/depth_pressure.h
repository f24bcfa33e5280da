// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_loads_depth_pressure_h
#define fuga_bodies_loads_depth_pressure_h

#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/bodies/space/discretization.h>

namespace fuga
{
  /**
   * Adds the nodal forces of a depth pressure on the boundaries whose labels are marked in @p
   * loaded, for one level. Faces are cut at the level, and integration is exact on both kinds of
   * terms: along √d instead of d everything is a polynomial. In space a face is swept by lines, and
   * exact if the depth changes along the lines only; else across them √d and what is left of a
   * corner have the error of Gauss' rule.
   */
  template <int dim>
  void
  add_depth_pressure(const Discretization<dim> &discretization,
                     const DepthPressure &pressure,
                     const double level,
                     const std::vector<bool> &loaded,
                     Vector &forces);

  /**
   * The levels at which the nodal forces of water on these faces change otherwise than smoothly
   * with the level, in increasing order: the lowest and the highest place of the faces, every
   * horizontal
   * one, which gets wet at once, and the @p others. Without faces there are none.
   */
  template <int dim>
  std::vector<double>
  levels_of_kinks(const Discretization<dim> &discretization,
                  const std::vector<typename Discretization<dim>::BoundaryFace> &faces,
                  std::vector<double> others = {});
} // namespace fuga

#endif
