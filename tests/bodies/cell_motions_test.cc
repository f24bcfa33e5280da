// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Nodal forces of bodies whose cells turn far beside what they deform.

#include "block_mesh.h"
#include "spatial_meshes.h"

#include <fuga/bodies/elasticity/elastic_bodies.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::test;

namespace
{
  /** A strip 60 long and 0.02 thick, far from the origin. */
  JointedMesh
  strip()
  {
    BlockMesh mesh;
    mesh.add_block(
      "strip", 10, 2, rectangle(1000., 1060., 500., 500.02), {{"base", "free", "free", "free"}});
    return mesh.mesh;
  }

  /** The largest moment of the forces of a strip that bends by 1, beside the sum of its terms. */
  template <int dim>
  double
  moment_of_bending_forces(JointedMesh mesh, const unsigned int degree)
  {
    ModelDefinition model;
    model.dimension         = dim;
    model.polynomial_degree = degree;
    add_material(model, "strip", 100., 0.2);
    const Discretization<dim> space(mesh, model);
    Vector u(space.n_dofs(), 0.);
    for (std::size_t node = 0; node < space.n_nodes(); ++node)
      {
        const double s    = (space.position(node)[0] - 1000.) / 60.;
        u[node * dim + 1] = s * s;
        u[node * dim]     = -2. * s / 60. * (space.position(node)[1] - 500.01);
      }
    const Vector forces = ElasticBodies<dim>(space, mesh, model).forces(u);
    double worst        = 0.;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < c; ++d)
        {
          double moment = 0., terms = 0.;
          for (std::size_t node = 0; node < space.n_nodes(); ++node)
            {
              const auto arm  = space.position(node) - space.position(0);
              const double by = arm[d] * forces[node * dim + c],
                           of = arm[c] * forces[node * dim + d];
              moment += by - of;
              terms += std::abs(by) + std::abs(of);
            }
          worst = std::max(worst, std::abs(moment) / terms);
        }
    return worst;
  }
} // namespace

// The law of moments: internal forces have none. Sums of some hundred terms round to 1e-14 of them;
// products with the stiffness alone, which the cells' rotation leaves to rounding, to 1e-8.
TEST(CellMotions, forces_of_bending_have_no_moment)
{
  for (const unsigned int degree : {1U, 2U})
    {
      EXPECT_LT(moment_of_bending_forces<2>(strip(), degree), 1e-14);
      EXPECT_LT(moment_of_bending_forces<3>(extruded(strip(), 2), degree), 1e-14);
    }
}
