// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_spatial_patch_h
#define fuga_tests_spatial_patch_h

#include "random_refinement.h"

#include <gtest/gtest.h>

#include <ostream>

namespace fuga::tests
{
  /** A mesh of the two blocks of meshes/patch_3d.geo, as the parameter of a test. */
  struct Patch
  {
    const char *mesh;
    unsigned int degree;
    /** Of cells that are refined by chance; 0: none are. */
    unsigned int seed = 0;
  };

  inline std::ostream &
  operator<<(std::ostream &out, const Patch &patch)
  {
    out << patch.mesh << " degree " << patch.degree;
    return patch.seed > 0 ? out << ", refined here and there" : out;
  }

  inline auto
  all_patches()
  {
    return testing::Values(Patch{"patch_hex.msh", 1},
                           Patch{"patch_hex.msh", 2},
                           Patch{"patch_tet.msh", 1},
                           Patch{"patch_hex.msh", 1, 3},
                           Patch{"patch_hex.msh", 2, 4});
  }

  inline void
  refine(const Patch &patch, const JointedMesh &mesh, ModelDefinition &model)
  {
    if (patch.seed > 0)
      refine_at_random<3>(mesh, model, patch.seed, 2);
  }
} // namespace fuga::tests

#endif
