// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_random_refinement_h
#define fuga_tests_random_refinement_h

#include <deal.II/grid/tria.h>

#include <fuga/bodies/processes.h>
#include <fuga/bodies/space/discretization.h>
#include <fuga/bodies/space/serial_cell_id.h>

#include <random>
#include <vector>

namespace fuga::tests
{
  /** Marks about one cell in six, by chance, in every round; the same on any number of processes.
   */
  template <int dim>
  void
  refine_at_random(const JointedMesh &mesh,
                   ModelDefinition &model,
                   const unsigned int seed,
                   const unsigned int n_rounds)
  {
    for (unsigned int round = 0; round < n_rounds; ++round)
      {
        const Discretization<dim> space(mesh, model);
        std::vector<CellKey> marked;
        for (const auto &cell : space.triangulation().active_cell_iterators())
          if (cell->is_locally_owned())
            {
              const CellKey key = serial_cell_id(cell).template to_binary<dim>();
              std::seed_seq seeds{seed, round, key[0], key[1], key[2], key[3]};
              if (std::mt19937(seeds)() % 6 == 0)
                marked.push_back(key);
            }
        model.local_refinements.push_back(processes::gather(std::move(marked)));
      }
  }
} // namespace fuga::tests

#endif
