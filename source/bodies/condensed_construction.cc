// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/condensed_system.h>
#include <fuga/bodies/elastic_bodies.h>

#include <deal.II/lac/vector.h>

#include <algorithm>

namespace fuga
{
  template <int dim>
  void
  CondensedSystem<dim>::set_carried_load(const std::size_t number, const Vector &jumps)
  {
    carried.assign(F.column(number), F.column(number) + F.n_rows());
    if (E.empty())
      E = DenseMatrix(bars->bars().size(), patterns.size());
    std::copy(jumps.begin(), jumps.end(), E.column(number));
  }

  template <int dim>
  double
  CondensedSystem<dim>::stress_free_value(const Vector &force, const unsigned int stage) const
  {
    for (const StressFreeShape &shape : shapes)
      if (shape.stage == stage)
        {
          dealii::Vector<double> u(space->n_dofs_of_all_bodies());
          for (std::size_t i = 0; i < shape.dofs.size(); ++i)
            u[static_cast<unsigned int>(shape.dofs[i])] = shape.displacements[i];
          return dot(force, space->by_nodes(u));
        }
    return 0.;
  }

  template <int dim>
  std::vector<ElementIdentity>
  CondensedSystem<dim>::identities() const
  {
    std::vector<ElementIdentity> result;
    for (std::size_t k = 0; k < elements().size(); ++k)
      {
        const auto &pair = bars->pair_of_element(k);
        result.push_back(
          {{pair.joint,
            space->dof(pair.plus_node, 0),
            pair.minus_node == Discretization<dim>::no_node ? static_cast<std::size_t>(-1)
                                                            : space->dof(pair.minus_node, 0),
            pair.part}});
      }
    return result;
  }

  template <int dim>
  Vector
  CondensedSystem<dim>::bar_forces(const Vector &p) const
  {
    Vector forces(space->n_dofs(), 0.);
    bars->add_forces(1., p, forces);
    return forces;
  }

  template class CondensedSystem<2>;
  template class CondensedSystem<3>;
} // namespace fuga
