// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/elasticity/free_motions.h>
#include <fuga/bodies/elasticity/rigid_pieces.h>

#include <cmath>

namespace fuga
{
  // Gram and Schmidt: motions of one piece are all but orthogonal, and those of others are far.
  template <int dim>
  FreeMotions::FreeMotions(const RigidPieces<dim> &pieces)
  {
    for (std::size_t k = 0; k < pieces.n_free_motions(); ++k)
      {
        Vector whole = pieces.free_motion(k);
        for (const Motion &other : motions)
          remove(other, whole);
        const double size = std::sqrt(dot(whole, whole));
        Motion motion;
        for (std::size_t i = 0; i < whole.size(); ++i)
          if (whole[i] != 0.)
            {
              motion.entries.push_back(i);
              motion.values.push_back(whole[i] / size);
            }
        motions.push_back(std::move(motion));
      }
  }

  void
  FreeMotions::remove(const Motion &motion, Vector &u)
  {
    double amount = 0.;
    for (std::size_t i = 0; i < motion.entries.size(); ++i)
      amount += motion.values[i] * u[motion.entries[i]];
    for (std::size_t i = 0; i < motion.entries.size(); ++i)
      u[motion.entries[i]] -= amount * motion.values[i];
  }

  Vector
  FreeMotions::deformation(Vector u) const
  {
    for (const Motion &motion : motions)
      remove(motion, u);
    return u;
  }

  template FreeMotions::FreeMotions(const RigidPieces<2> &);
  template FreeMotions::FreeMotions(const RigidPieces<3> &);
} // namespace fuga
