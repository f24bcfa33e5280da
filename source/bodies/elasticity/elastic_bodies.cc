// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <fuga/bodies/elasticity/cell_stiffness.h>
#include <fuga/bodies/elasticity/elastic_bodies.h>
#include <fuga/bodies/model_names.h>
#include <fuga/bodies/processes.h>
#include <fuga/bodies/space/node_graph.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fuga
{
  template <int dim>
  ElasticBodies<dim>::ElasticBodies(const Discretization<dim> &space,
                                    const JointedMesh &mesh,
                                    const ModelDefinition &model)
    : discretization(space), materials(mesh.body_names.size())
  {
    for (const Material &material : model.materials)
      materials.at(index_of(mesh.body_names, material.body)) =
        lame_constants(material, model.assumption);
  }


  template <int dim>
  Vector
  ElasticBodies<dim>::node_moduli() const
  {
    Vector result(discretization.n_nodes(), 0.);
    const std::size_t n_nodes = discretization.reference_element().n_nodes();
    for (std::size_t cell = 0; cell < discretization.n_cells(); ++cell)
      {
        const LameConstants &material = materials[discretization.cell_body(cell)];
        const unsigned int *nodes     = discretization.cell_nodes(cell);
        for (std::size_t i = 0; i < n_nodes; ++i)
          result[nodes[i]] = std::max(result[nodes[i]], material.lambda + 2. * material.mu);
      }
    return result;
  }


  template <int dim>
  SymmetricTriplets
  ElasticBodies<dim>::assemble(const InterfaceCoordinates<dim> &coordinates) const
  {
    std::vector<bool> is_plain(discretization.n_nodes());
    for (std::size_t node = 0; node < is_plain.size(); ++node)
      is_plain[node] = coordinates.is_plain(node);
    std::vector<std::size_t> plain, special;
    plain.reserve(discretization.n_own_cells());
    for (std::size_t cell = 0; cell < discretization.n_cells(); ++cell)
      {
        if (!discretization.is_own(cell))
          continue;
        const unsigned int *nodes = discretization.cell_nodes(cell);
        const bool all            = std::all_of(nodes,
                                     nodes + discretization.reference_element().n_nodes(),
                                     [&](const unsigned int node) { return is_plain[node]; });
        (all ? plain : special).push_back(cell);
      }
    SymmetricTriplets matrix;
    matrix.size = static_cast<int>(coordinates.size());
    add_plain_cells(NodeGraph<dim>(discretization, plain, is_plain), plain, coordinates, matrix);
    add_special_cells(special, coordinates, matrix);
    return matrix;
  }


  template <int dim>
  void
  ElasticBodies<dim>::add_plain_cells(const NodeGraph<dim> &graph,
                                      const std::vector<std::size_t> &cells,
                                      const InterfaceCoordinates<dim> &coordinates,
                                      SymmetricTriplets &matrix) const
  {
    matrix.rows.reserve(graph.n_entries() + graph.n_entries() / 8);
    matrix.columns.reserve(graph.n_entries() + graph.n_entries() / 8);
    const auto number = [&](const std::size_t node, const unsigned int c) {
      return static_cast<int>(coordinates.plain_coordinate(node * dim + c)) + 1;
    };
    for (unsigned int node = 0; node < discretization.n_nodes(); ++node)
      if (graph.has_entries(node))
        {
          for (auto neighbour = graph.begin(node); neighbour != graph.end(node); ++neighbour)
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int d = 0; d < dim; ++d)
                {
                  matrix.rows.push_back(number(node, c));
                  matrix.columns.push_back(number(*neighbour, d));
                }
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = 0; d <= c; ++d)
              {
                matrix.rows.push_back(number(node, c));
                matrix.columns.push_back(number(node, d));
              }
        }

    matrix.values.reserve(graph.n_entries() + graph.n_entries() / 8);
    matrix.values.resize(graph.n_entries(), 0.);
    const std::size_t n_local = discretization.reference_element().n_nodes();
    CellStiffness<dim> stiffness(discretization, materials);
    for (const std::size_t cell : cells)
      {
        const unsigned int *nodes = discretization.cell_nodes(cell);
        const double *K           = stiffness.of(cell);
        for (std::size_t a = 0; a < n_local; ++a)
          for (std::size_t b = 0; b < n_local; ++b)
            if (nodes[b] <= nodes[a])
              {
                const bool diagonal = a == b;
                double *value =
                  matrix.values.data() + (diagonal ? graph.diagonal_entry(nodes[a])
                                                   : graph.block_entry(nodes[a], nodes[b]));
                for (unsigned int c = 0; c < dim; ++c)
                  for (unsigned int d = 0; d < (diagonal ? c + 1 : dim); ++d)
                    *value++ += K[(a * dim + c) * n_local * dim + b * dim + d];
              }
      }
  }


  template <int dim>
  void
  ElasticBodies<dim>::add_special_cells(const std::vector<std::size_t> &cells,
                                        const InterfaceCoordinates<dim> &coordinates,
                                        SymmetricTriplets &matrix) const
  {
    using Term                = typename InterfaceCoordinates<dim>::Term;
    const std::size_t n_local = discretization.reference_element().n_nodes() * dim;
    CellStiffness<dim> stiffness(discretization, materials);
    std::vector<Term> terms;
    for (const std::size_t cell : cells)
      {
        // Assemble Cᵀ K C on the coordinates that occur in this cell.
        std::vector<unsigned int> used;
        std::vector<Vector> factors; // of every coordinate, by local degree of freedom
        for (std::size_t i = 0; i < n_local; ++i)
          {
            coordinates.terms_of(discretization.cell_nodes(cell)[i / dim] * dim + i % dim, terms);
            for (const Term &term : terms)
              {
                const auto at = std::find(used.begin(), used.end(), term.coordinate) - used.begin();
                if (static_cast<std::size_t>(at) == used.size())
                  {
                    used.push_back(term.coordinate);
                    factors.emplace_back(n_local, 0.);
                  }
                factors[static_cast<std::size_t>(at)][i] += term.factor;
              }
          }
        const double *K = stiffness.of(cell);
        Vector product(n_local);
        for (std::size_t j = 0; j < used.size(); ++j)
          {
            for (std::size_t i = 0; i < n_local; ++i)
              product[i] =
                std::inner_product(K + i * n_local, K + (i + 1) * n_local, factors[j].begin(), 0.);
            for (std::size_t i = 0; i < used.size(); ++i)
              if (used[i] >= used[j])
                {
                  matrix.rows.push_back(static_cast<int>(used[i]) + 1);
                  matrix.columns.push_back(static_cast<int>(used[j]) + 1);
                  matrix.values.push_back(
                    std::inner_product(product.begin(), product.end(), factors[i].begin(), 0.));
                }
          }
      }
  }


  template <int dim>
  void
  ElasticBodies<dim>::assemble_by_nodes(dealii::SparsityPattern &pattern,
                                        dealii::SparseMatrix<double> &matrix) const
  {
    const auto n_local =
      static_cast<unsigned int>(discretization.reference_element().n_nodes() * dim);
    std::vector<dealii::types::global_dof_index> dofs(n_local);
    const auto take_dofs = [&](const std::size_t cell) {
      for (unsigned int i = 0; i < n_local; ++i)
        dofs[i] = discretization.cell_nodes(cell)[i / dim] * dim + i % dim;
    };
    dealii::DynamicSparsityPattern entries(static_cast<unsigned int>(discretization.n_dofs()));
    for (std::size_t cell = 0; cell < discretization.n_cells(); ++cell)
      if (discretization.is_own(cell))
        {
          take_dofs(cell);
          for (const auto dof : dofs)
            entries.add_entries(dof, dofs.begin(), dofs.end());
        }
    pattern.copy_from(entries);
    matrix.reinit(pattern);
    CellStiffness<dim> stiffness(discretization, materials);
    for (std::size_t cell = 0; cell < discretization.n_cells(); ++cell)
      if (discretization.is_own(cell))
        {
          take_dofs(cell);
          const double *K = stiffness.of(cell);
          for (unsigned int i = 0; i < n_local; ++i)
            matrix.add(dofs[i], n_local, dofs.data(), K + std::size_t{i} * n_local);
        }
  }


  template <int dim>
  template <typename Action>
  void
  ElasticBodies<dim>::for_each_cell_force(const Vector &u,
                                          const Action &action,
                                          const std::vector<bool> *only) const
  {
    const std::size_t n_local = discretization.reference_element().n_nodes() * dim;
    CellStiffness<dim> stiffness(discretization, materials);
    Vector local(n_local), force(n_local);
    for (std::size_t cell = 0; cell < discretization.n_cells(); ++cell)
      {
        if (!discretization.is_own(cell) || (only && !(*only)[discretization.cell_body(cell)]))
          continue;
        const double *K = stiffness.of(cell);
        stiffness.take_deformation(cell, u, local);
        for (std::size_t i = 0; i < n_local; ++i)
          force[i] = std::inner_product(local.begin(), local.end(), K + i * n_local, 0.);
        action(cell, local, force, K);
      }
  }


  template <int dim>
  Vector
  ElasticBodies<dim>::forces(const Vector &u, const std::vector<bool> *only) const
  {
    Vector result(discretization.n_dofs(), 0.);
    if (std::all_of(u.begin(), u.end(), [](const double value) { return value == 0.; }))
      return result; // the first solution with any load
    for_each_cell_force(
      u,
      [&](const std::size_t cell, const Vector &, const Vector &force, const double *) {
        const unsigned int *nodes = discretization.cell_nodes(cell);
        for (std::size_t i = 0; i < force.size(); ++i)
          result[nodes[i / dim] * dim + i % dim] += force[i];
      },
      only);
    processes::sum(result);
    return result;
  }


  template <int dim>
  Vector
  ElasticBodies<dim>::forces(const Vector &u, const Vector &rounded, Vector &terms) const
  {
    Vector result(discretization.n_dofs(), 0.);
    terms.assign(discretization.n_dofs(), 0.);
    for_each_cell_force(
      u, [&](const std::size_t cell, const Vector &, const Vector &force, const double *K) {
        const unsigned int *nodes = discretization.cell_nodes(cell);
        const std::size_t n       = force.size();
        for (std::size_t i = 0; i < n; ++i)
          {
            const std::size_t row = nodes[i / dim] * dim + i % dim;
            result[row] += force[i];
            for (std::size_t j = 0; j < n; ++j)
              terms[row] += std::abs(K[i * n + j] * rounded[nodes[j / dim] * dim + j % dim]);
          }
      });
    processes::sum(result);
    processes::sum(terms);
    return result;
  }


  template <int dim>
  Vector
  ElasticBodies<dim>::cell_energies(const Vector &u) const
  {
    Vector result(discretization.n_cells(), 0.);
    for_each_cell_force(
      u, [&](const std::size_t cell, const Vector &local, const Vector &force, const double *) {
        result[cell] = std::inner_product(local.begin(), local.end(), force.begin(), 0.) / 2.;
      });
    processes::sum(result);
    return result;
  }


  template class ElasticBodies<2>;
  template class ElasticBodies<3>;
} // namespace fuga
