// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_random_refinement_h
#define fuga_tests_random_refinement_h

#include <deal.II/grid/tria.h>

#include <fuga/bodies/discretization.h>

#include <random>
#include <vector>

namespace fuga::tests
{
  /** Marks about one cell in six, by chance, in every round. */
  template <int dim>
  void
  refine_at_random(const JointedMesh &mesh,
                   ModelDefinition &model,
                   const unsigned int seed,
                   const unsigned int n_rounds)
  {
    std::mt19937 random(seed);
    for (unsigned int round = 0; round < n_rounds; ++round)
      {
        const Discretization<dim> space(mesh, model);
        std::vector<CellKey> marked;
        for (const auto &cell : space.triangulation().active_cell_iterators())
          if (random() % 6 == 0)
            marked.push_back(cell->id().template to_binary<dim>());
        model.local_refinements.push_back(marked);
      }
  }
} // namespace fuga::tests

#endif
