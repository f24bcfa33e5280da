// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_cones_cone_program_h
#define fuga_contact_cones_cone_program_h

#include <fuga/base/numerics/dense_matrix.h>

#include <optional>

namespace fuga
{
  /** One to three unknowns from @p first on that lie in the cone z₀ ≥ f |(z₁, z₂)|; a single one is
   * not negative. */
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
   * with M symmetric and positive semidefinite. Its forces λ = M z - r lie in the dual cones,
   * |(λ₁, λ₂)| ≤ f λ₀, and λ·z = 0 in every block. A primal-dual interior point method, with the
   * scaling of Nesterov and Todd and the corrector of Mehrotra, solves it whatever the motions are
   * that M resists, strongly, weakly or not at all.
   */
  class ConeProgram
  {
  public:
    ConeProgram(const DenseMatrix &M, const std::vector<ConeBlock> &blocks);

    /** The side of the complementarity on which a block ends. */
    enum class Place
    {
      /** Its force is inside the cone; it has no rate. */
      at_rest,
      /** Force and rate are on the surfaces of their cones. */
      on_surface,
      /** It has no force. */
      unloaded
    };

    struct Solution
    {
      Vector z, forces;
      /** Of the blocks. */
      std::vector<Place> places;
      /** False if z grows without bounds; it is then what the method reached. */
      bool is_bounded = true;
    };

    /** Returns nothing if the method comes to a standstill before the solution. */
    std::optional<Solution>
    solve(const Vector &r) const;

  private:
    struct Scaling;
    struct Iterate;
    class NewtonStep;

    std::vector<ConeBlock> blocks;
    /** z = scale y, y in the cones y₀ ≥ |(y₁, y₂)|. */
    Vector scale;
    /** M in the unknowns y. */
    DenseMatrix A;
  };
} // namespace fuga

#endif
