// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_loads_depth_pressure_h
#define fuga_bodies_loads_depth_pressure_h

#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/bodies/space/discretization.h>

namespace fuga
{
  /**
   * Add the nodal forces of a depth pressure on the boundaries whose labels are marked in
   * @p loaded, for one level. Faces are cut at the level, and integration is exact for both kinds
   * of terms: along √d instead of d everything is a polynomial. In space a face is swept by lines,
   * and the integral is exact if the depth changes only along the lines; otherwise √d across them
   * and the rest of a corner have the error of Gauss' rule.
   */
  template <int dim>
  void
  add_depth_pressure(const Discretization<dim> &discretization,
                     const DepthPressure &pressure,
                     const double level,
                     const std::vector<bool> &loaded,
                     Vector &forces);

  /**
   * Return the levels at which the nodal forces of water on these faces do not change smoothly with
   * the level, in increasing order: the lowest and the highest position of the faces, every
   * horizontal one, which gets wet at once, and the @p others. Without faces there are none.
   */
  template <int dim>
  std::vector<double>
  levels_of_kinks(const Discretization<dim> &discretization,
                  const std::vector<typename Discretization<dim>::BoundaryFace> &faces,
                  std::vector<double> others = {});
} // namespace fuga

#endif
