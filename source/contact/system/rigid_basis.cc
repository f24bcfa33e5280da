// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/system/rigid_basis.h>

#include <cmath>

namespace fuga
{
  namespace
  {
    /** Remainder of a motion of size one that is a combination of others. */
    constexpr long double dependent = 1e-9L;

    void
    scale(const long double amount, Accurate &x)
    {
      for (long double &value : x)
        value *= amount;
    }
  } // namespace

  // The Gram-Schmidt method is applied twice.
  RigidBasis::RigidBasis(const ContactSystem &system)
  {
    const DenseMatrix &M = system.rigid_coordinates(), &loads = system.rigid_motion_loads();
    for (Eigen::Index k = 0; k < M.cols(); ++k)
      {
        Motion motion;
        motion.coordinates.assign(M.col(k).data(), M.col(k).data() + M.rows());
        for (Eigen::Index j = 0; j < loads.cols(); ++j)
          motion.loads.push_back(loads(k, j));
        const auto normalise = [&motion](const long double smallest) {
          const long double size = std::sqrt(dot(motion.coordinates, motion.coordinates));
          if (size <= smallest)
            return false;
          scale(1.L / size, motion.coordinates);
          scale(1.L / size, motion.loads);
          return true;
        };
        if (!normalise(0.L))
          continue;
        for (int pass = 0; pass < 2; ++pass)
          for (const Motion &other : motions)
            {
              const long double share = dot(other.coordinates, motion.coordinates);
              add_scaled(-share, other.coordinates, motion.coordinates);
              add_scaled(-share, other.loads, motion.loads);
            }
        if (normalise(dependent))
          motions.push_back(std::move(motion));
      }
  }

  void
  RigidBasis::remove(Accurate &x) const
  {
    for (const Motion &motion : motions)
      add_scaled(-dot(motion.coordinates, x), motion.coordinates, x);
  }

  void
  RigidBasis::correct_resultants(const Accurate &a, Accurate &f) const
  {
    for (const Motion &motion : motions)
      add_scaled(dot(motion.loads, a) - dot(motion.coordinates, f), motion.coordinates, f);
  }

  Accurate
  RigidBasis::resistance(const DenseMatrix &S, const Accurate &x) const
  {
    Accurate deformation = x, result(S.rows(), 0.L);
    remove(deformation);
    add_product(1.L, S, deformation, result);
    remove(result);
    return result;
  }
} // namespace fuga
