// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_cones_cone_program_h
#define fuga_contact_cones_cone_program_h

#include <fuga/base/numerics/dense_matrix.h>

#include <optional>

namespace fuga
{
  /** A block of one to three unknowns, beginning with @p first, that lies in the cone z₀ ≥ f |(z₁,
   * z₂)|; a single unknown is not negative. */
  struct ConeBlock
  {
    std::size_t first, size;
    double friction;
  };

  /**
   * The convex program
   *
   *     min ½ zᵀM z - rᵀz,    z in the cones of the blocks,
   *
   * with M symmetric and positive semidefinite. Its forces λ = M z - r lie in the dual cones, |(λ₁,
   * λ₂)| ≤ f λ₀, and λ·z = 0 in every block. It is solved by a primal-dual interior point method
   * with the scaling of Nesterov and Todd and the corrector of Mehrotra, regardless of whether M
   * resists motions strongly, weakly or not at all.
   */
  class ConeProgram
  {
  public:
    ConeProgram(const DenseMatrix &M, const std::vector<ConeBlock> &blocks);

    /** The side of the complementarity on which a block ends. */
    enum class Place
    {
      /** The force is inside its cone; there is no rate. */
      at_rest,
      /** Force and rate are on the surfaces of their cones. */
      on_surface,
      /** There is no force. */
      unloaded
    };

    struct Solution
    {
      Vector z, forces;
      /** The place of each block. */
      std::vector<Place> places;
      /** False if z grows without bounds; z is then the last iterate of the method. */
      bool is_bounded = true;
    };

    /** Solve the program for the linear term @p r. Return nothing if the method stagnates before it
     * reaches the solution. */
    std::optional<Solution>
    solve(const Vector &r) const;

  private:
    struct Scaling;
    struct Iterate;
    class NewtonStep;

    std::vector<ConeBlock> blocks;
    /** The scaling z = scale y to unknowns y in the cones y₀ ≥ |(y₁, y₂)|. */
    Vector scale;
    /** The matrix M in terms of the unknowns y. */
    DenseMatrix A;
  };
} // namespace fuga

#endif
