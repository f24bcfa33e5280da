// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/elasticity/free_motions.h>
#include <fuga/bodies/elasticity/rigid_pieces.h>

#include <cmath>

namespace fuga
{
  template <int dim>
  FreeMotions::FreeMotions(const RigidPieces<dim> &pieces, const Vector &mass)
    : motions(orthonormal(pieces, Vector(mass.size(), 1.))), momenta(orthonormal(pieces, mass))
  {
  }

  // The Gram-Schmidt method is sufficient: motions of one piece are almost orthogonal, and those of
  // other pieces are far away.
  template <int dim>
  std::vector<FreeMotions::Motion>
  FreeMotions::orthonormal(const RigidPieces<dim> &pieces, const Vector &weights)
  {
    constexpr double no_weight = 1e-12;
    const auto square_of       = [&weights](const Vector &u) {
      double sum = 0.;
      for (std::size_t i = 0; i < u.size(); ++i)
        sum += weights[i] * u[i] * u[i];
      return sum;
    };
    std::vector<Motion> result;
    for (std::size_t k = 0; k < pieces.n_free_motions(); ++k)
      {
        Vector whole     = pieces.free_motion(k);
        const double all = square_of(whole);
        for (const Motion &other : result)
          remove(other, whole);
        const double square = square_of(whole);
        if (square <= no_weight * all)
          continue;
        const double size = std::sqrt(square);
        Motion motion;
        for (std::size_t i = 0; i < whole.size(); ++i)
          if (whole[i] != 0.)
            {
              motion.entries.push_back(i);
              motion.values.push_back(whole[i] / size);
              motion.dual.push_back(weights[i] * whole[i] / size);
            }
        result.push_back(std::move(motion));
      }
    return result;
  }

  template <typename Number>
  void
  FreeMotions::remove(const Motion &motion, std::vector<Number> &u)
  {
    Number amount = 0.;
    for (std::size_t i = 0; i < motion.entries.size(); ++i)
      amount += motion.dual[i] * u[motion.entries[i]];
    for (std::size_t i = 0; i < motion.entries.size(); ++i)
      u[motion.entries[i]] -= amount * motion.values[i];
  }

  Vector
  FreeMotions::project(const std::vector<Motion> &motions,
                       const Vector Motion::*const factors,
                       const Vector Motion::*const shape,
                       const Vector &given)
  {
    Vector result(given.size(), 0.);
    for (const Motion &motion : motions)
      {
        double amount = 0.;
        for (std::size_t i = 0; i < motion.entries.size(); ++i)
          amount += (motion.*factors)[i] * given[motion.entries[i]];
        for (std::size_t i = 0; i < motion.entries.size(); ++i)
          result[motion.entries[i]] += amount * (motion.*shape)[i];
      }
    return result;
  }

  Vector
  FreeMotions::inertia_of_resultants(const Vector &forces) const
  {
    return project(momenta, &Motion::values, &Motion::dual, forces);
  }

  Vector
  FreeMotions::rigid_part(const Vector &u) const
  {
    return project(motions, &Motion::dual, &Motion::values, u);
  }

  Vector
  FreeMotions::deformation(Vector u) const
  {
    for (const Motion &motion : motions)
      remove(motion, u);
    return u;
  }

  // Bodies that are nearer lose up to three digits of their deformation by the removal in double
  // precision, 1e-13 of the elastic forces: less than the imbalance that a step leaves.
  Vector
  FreeMotions::deformation_of_far(const Vector &u) const
  {
    constexpr double is_far = 1e3;
    const Vector near       = deformation(u);
    if (max_abs(u) <= is_far * max_abs(near))
      return near;
    Accurate rest = accurate(u);
    for (const Motion &motion : motions)
      remove(motion, rest);
    return {rest.begin(), rest.end()};
  }

  template FreeMotions::FreeMotions(const RigidPieces<2> &, const Vector &);
  template FreeMotions::FreeMotions(const RigidPieces<3> &, const Vector &);
} // namespace fuga
