// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_elasticity_free_motions_h
#define fuga_bodies_elasticity_free_motions_h

#include <fuga/base/numerics/dense_matrix.h>

#include <vector>

namespace fuga
{
  template <int dim>
  class RigidPieces;

  /**
   * The rigid motions that the supports leave to the bodies, orthonormal by nodes. A body that
   * flies moves by far more than it deforms: K u has resultants that are all rounding then, and
   * inertia would follow them, unless the motion, which K does not feel, is taken out of u before.
   */
  class FreeMotions
  {
  public:
    template <int dim>
    explicit FreeMotions(const RigidPieces<dim> &pieces);

    /** @p u (entry node * dim + component) without its rigid part. */
    Vector
    deformation(Vector u) const;

  private:
    /** Of the nodes that move. */
    struct Motion
    {
      std::vector<std::size_t> entries;
      Vector values;
    };

    static void
    remove(const Motion &motion, Vector &u);

    std::vector<Motion> motions;
  };
} // namespace fuga

#endif
