// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/elasticity/boundary_conditions.h>
#include <fuga/bodies/elasticity/elastic_bodies.h>
#include <fuga/bodies/program/carried_loads.h>
#include <fuga/bodies/space/discretization.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace fuga
{
  namespace
  {
    /** Forces and displacements below the first share of the largest are rounding errors, and so
     * are forces below the second share of the products that they are sums of, which are large
     * where bodies have moved far. */
    constexpr double rounding = 1e-12, rounding_of_terms = 4e-15;

    std::vector<bool>
    bodies_built_in(const std::vector<std::string> &body_names,
                    const ModelDefinition &model,
                    const unsigned int stage)
    {
      std::vector<bool> built(body_names.size(), false);
      for (const Material &material : model.materials)
        for (std::size_t body = 0; body < body_names.size(); ++body)
          if (body_names[body] == material.body)
            built[body] = material.built_at == stage;
      return built;
    }

    /** Return the displacements that the patterns prescribe at the held degrees of freedom. */
    Vector
    prescribed(const std::vector<LoadPattern> &patterns, const Vector &factors, const std::size_t n)
    {
      Vector result(n, 0.);
      for (std::size_t j = 0; j < patterns.size(); ++j)
        add_multiple(factors[j], patterns[j].prescribed, result);
      return result;
    }

    /** Return the support displacements beyond those of the loads: those of nodes that were held
     * when they had already moved. Return an empty vector if there are none. */
    Vector
    further_displacements(const Vector &u, const Vector &of_loads, const std::vector<bool> &fixed)
    {
      double largest = 0.;
      for (const double value : u)
        largest = std::max(largest, std::abs(value));
      Vector result(u.size(), 0.);
      bool any = false;
      for (std::size_t dof = 0; dof < u.size(); ++dof)
        if (const double difference = u[dof] - of_loads[dof];
            fixed[dof] && std::abs(difference) > rounding * largest)
          {
            result[dof] = difference;
            any         = true;
          }
      return any ? result : Vector();
    }
  } // namespace


  template <int dim>
  CarriedLoads
  carried_loads(const CondensedSystem<dim> &system,
                const ModelDefinition &model,
                const ConstructionState &state,
                const std::vector<LoadPattern> &patterns,
                const Vector &factors)
  {
    const Discretization<dim> &space = system.discretization();
    const JointedMesh &mesh          = system.jointed_mesh();
    const ElasticBodies<dim> bodies(space, mesh, model);
    // Supports that a dynamic stage releases continue to carry what they have carried.
    const std::vector<bool> supported = find_fixed_dofs(space, mesh, model);
    const Vector u                    = space.by_nodes(state.displacement);

    CarriedLoads result;
    result.carried.forces.assign(space.n_dofs(), 0.);
    for (const StressFreeShape &shape : state.shapes)
      {
        Vector all(state.displacement.size(), 0.);
        for (std::size_t i = 0; i < shape.dofs.size(); ++i)
          all[shape.dofs[i]] = shape.displacements[i];
        const std::vector<bool> built = bodies_built_in(mesh.body_names, model, shape.stage);
        add_multiple(1., bodies.forces(space.by_nodes(all), &built), result.carried.forces);
      }
    result.carried.prescribed =
      further_displacements(u, prescribed(patterns, factors, space.n_dofs()), system.fixed_dofs());

    Vector terms;
    const Vector elastic = bodies.forces(u, u, terms);
    const Vector contact = system.bar_forces(state.forces);
    Vector &released = result.released.forces = elastic;
    add_multiple(-1., result.carried.forces, released);
    add_multiple(1., contact, released);
    for (std::size_t j = 0; j < patterns.size(); ++j)
      add_multiple(-factors[j], patterns[j].forces, released);
    const double noise = std::max(
      rounding * std::max({max_abs(elastic), max_abs(contact), max_abs(result.carried.forces)}),
      rounding_of_terms * max_abs(terms));
    for (std::size_t dof = 0; dof < released.size(); ++dof)
      if (supported[dof] || std::abs(released[dof]) <= noise)
        released[dof] = 0.;
    return result;
  }


  template <int dim>
  void
  put_new_nodes_on_supports(const CondensedSystem<dim> &system,
                            const std::vector<bool> &there,
                            const std::vector<LoadPattern> &patterns,
                            const Vector &factors,
                            Vector &displacement)
  {
    const Discretization<dim> &space = system.discretization();
    const Vector of_loads            = prescribed(patterns, factors, space.n_dofs());
    for (std::size_t node = 0; node < space.n_nodes(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        if (const unsigned int dof = space.dof(node, c);
            !there[dof] && system.fixed_dofs()[node * dim + c])
          displacement[dof] = of_loads[node * dim + c];
  }


  template <int dim>
  StressFreeShape
  shape_of_new_bodies(const CondensedSystem<dim> &system,
                      const ModelDefinition &model,
                      const ConstructionState &state)
  {
    const Discretization<dim> &space = system.discretization();
    const std::vector<bool> built =
      bodies_built_in(system.jointed_mesh().body_names, model, state.stage);
    std::set<std::size_t> dofs;
    for (std::size_t cell = 0; cell < space.n_cells(); ++cell)
      if (built[space.cell_body(cell)])
        for (std::size_t i = 0; i < space.reference_element().n_nodes(); ++i)
          for (unsigned int c = 0; c < dim; ++c)
            if (const unsigned int dof = space.dof(space.cell_nodes(cell)[i], c);
                state.displacement[dof] != 0.)
              dofs.insert(dof);
    StressFreeShape shape;
    shape.stage = state.stage;
    for (const std::size_t dof : dofs)
      {
        shape.dofs.push_back(dof);
        shape.displacements.push_back(state.displacement[dof]);
      }
    return shape;
  }


  template CarriedLoads
  carried_loads(const CondensedSystem<2> &,
                const ModelDefinition &,
                const ConstructionState &,
                const std::vector<LoadPattern> &,
                const Vector &);
  template void
  put_new_nodes_on_supports(const CondensedSystem<2> &,
                            const std::vector<bool> &,
                            const std::vector<LoadPattern> &,
                            const Vector &,
                            Vector &);
  template StressFreeShape
  shape_of_new_bodies(const CondensedSystem<2> &,
                      const ModelDefinition &,
                      const ConstructionState &);
  template CarriedLoads
  carried_loads(const CondensedSystem<3> &,
                const ModelDefinition &,
                const ConstructionState &,
                const std::vector<LoadPattern> &,
                const Vector &);
  template void
  put_new_nodes_on_supports(const CondensedSystem<3> &,
                            const std::vector<bool> &,
                            const std::vector<LoadPattern> &,
                            const Vector &,
                            Vector &);
  template StressFreeShape
  shape_of_new_bodies(const CondensedSystem<3> &,
                      const ModelDefinition &,
                      const ConstructionState &);
} // namespace fuga
