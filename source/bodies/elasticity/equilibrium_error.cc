// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/elasticity/equilibrium_error.h>
#include <fuga/bodies/elasticity/rigid_pieces.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  template <int dim>
  EquilibriumError
  equilibrium_error(const Vector &elastic,
                    const Vector &terms,
                    const Vector &contact,
                    const Vector &loads,
                    const Vector &acting,
                    const std::vector<bool> &fixed,
                    const RigidPieces<dim> &pieces)
  {
    EquilibriumError error;
    const double largest =
      std::max({max_abs(acting), max_abs(elastic), max_abs(loads), max_abs(contact)});
    if (largest == 0.)
      return error;
    // The displacements of a body that moves far on a soft joint leave K u uncertain by their last
    // digits; only the part that exceeds this uncertainty is an error. The resultants below do not
    // depend on K.
    const double rounding = 4. * std::numeric_limits<double>::epsilon();
    for (std::size_t i = 0; i < elastic.size(); ++i)
      if (!fixed[i])
        error.residual =
          std::max(error.residual,
                   (std::abs(elastic[i] + contact[i] - loads[i]) - rounding * terms[i]) / largest);

    for (std::size_t k = 0; k < pieces.n_free_motions(); ++k)
      {
        const Vector motion = pieces.free_motion(k);
        double sum = 0., size = largest * max_abs(motion);
        for (std::size_t i = 0; i < acting.size(); ++i)
          size += std::abs(motion[i] * acting[i]);
        for (std::size_t i = 0; i < motion.size(); ++i)
          {
            sum += motion[i] * (contact[i] - loads[i]);
            size += std::abs(motion[i] * contact[i]) + std::abs(motion[i] * loads[i]);
          }
        if (std::abs(sum) / size >= error.resultant)
          {
            error.resultant = std::abs(sum) / size;
            error.body      = pieces.moving_body(k);
          }
      }
    return error;
  }


  template EquilibriumError
  equilibrium_error(const Vector &,
                    const Vector &,
                    const Vector &,
                    const Vector &,
                    const Vector &,
                    const std::vector<bool> &,
                    const RigidPieces<2> &);
  template EquilibriumError
  equilibrium_error(const Vector &,
                    const Vector &,
                    const Vector &,
                    const Vector &,
                    const Vector &,
                    const std::vector<bool> &,
                    const RigidPieces<3> &);
} // namespace fuga
