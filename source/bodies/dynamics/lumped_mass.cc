// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/disjoint_sets.h>
#include <fuga/bodies/dynamics/lumped_mass.h>
#include <fuga/bodies/joints/contact_bars.h>
#include <fuga/bodies/loads/depth_pressure.h>
#include <fuga/bodies/model_names.h>
#include <fuga/bodies/space/cell_values.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fuga
{
  namespace
  {
    template <int dim>
    std::vector<bool>
    nodes_without_mass(const BodyModel<dim> &model, const std::vector<bool> &massless_joints)
    {
      std::vector<bool> result(model.discretization().n_nodes(), false);
      for (const NodePair<dim> &pair : model.joint_geometry().pairs())
        if (massless_joints[pair.joint])
          for (const unsigned int node : {pair.plus_node, pair.minus_node})
            if (node != Discretization<dim>::no_node)
              result[node] = true;
      return result;
    }

    /** What of the mass of a cell each of its nodes gets; all sum up to 1. */
    template <int dim>
    void
    shares_of_nodes(const CellValues<dim> &values,
                    const unsigned int *nodes,
                    const std::vector<bool> &massless,
                    Vector &shares)
    {
      Vector all(shares.size(), 0.);
      for (std::size_t q = 0; q < values.n_points(); ++q)
        for (std::size_t i = 0; i < all.size(); ++i)
          all[i] += values.volume(q) * values.value(i, q) * values.value(i, q);
      shares = all;
      for (std::size_t i = 0; i < all.size(); ++i)
        if (massless[nodes[i]])
          shares[i] = 0.;
      double sum = std::accumulate(shares.begin(), shares.end(), 0.);
      if (sum == 0.) // a layer of one cell between two joints
        {
          shares = all;
          sum    = std::accumulate(all.begin(), all.end(), 0.);
        }
      for (double &share : shares)
        share /= sum;
    }

    /** Masses of the nodes, without what water adds. */
    template <int dim>
    Vector
    masses_of_nodes(const BodyModel<dim> &model, const std::vector<bool> &massless)
    {
      const Discretization<dim> &space = model.discretization();
      const Vector density             = mass_densities(model.jointed_mesh(), model.definition());
      Vector mass(space.n_nodes(), 0.), shares(space.reference_element().n_nodes());
      CellValues<dim> values(space);
      for (std::size_t cell = 0; cell < space.n_cells(); ++cell)
        {
          if (density[space.cell_body(cell)] == 0.)
            continue;
          values.move_to(cell);
          const unsigned int *nodes = space.cell_nodes(cell);
          double volume             = 0.;
          for (std::size_t q = 0; q < values.n_points(); ++q)
            volume += values.volume(q);
          shares_of_nodes(values, nodes, massless, shares);
          for (std::size_t i = 0; i < shares.size(); ++i)
            mass[nodes[i]] += density[space.cell_body(cell)] * volume * shares[i];
        }
      return mass;
    }

    /** By node the number of the piece that cells with common nodes make of the mesh. */
    template <int dim>
    std::vector<unsigned int>
    pieces_of_nodes(const Discretization<dim> &space)
    {
      DisjointSets pieces(space.n_nodes());
      for (std::size_t cell = 0; cell < space.n_cells(); ++cell)
        for (std::size_t i = 1; i < space.reference_element().n_nodes(); ++i)
          pieces.unite(space.cell_nodes(cell)[0], space.cell_nodes(cell)[i]);
      std::vector<unsigned int> result;
      pieces.number(result);
      return result;
    }

    /** By piece the smallest of its moments of inertia about axes through its centre, if its nodes
     * have @p mass [MN m s²]. */
    template <int dim>
    Vector
    smallest_moments(const Discretization<dim> &space,
                     const std::vector<unsigned int> &pieces,
                     const Vector &mass)
    {
      Vector total(pieces.size(), 0.), moments(pieces.size(), 0.);
      std::vector<dealii::Tensor<1, dim>> centre(pieces.size());
      std::vector<dealii::SymmetricTensor<2, dim>> spread(pieces.size());
      for (std::size_t node = 0; node < pieces.size(); ++node)
        {
          total[pieces[node]] += mass[node];
          centre[pieces[node]] += mass[node] * space.position(node);
        }
      for (std::size_t node = 0; node < pieces.size(); ++node)
        if (mass[node] > 0.)
          {
            const std::size_t piece = pieces[node];
            const dealii::Tensor<1, dim> radius =
              space.position(node) - centre[piece] / total[piece];
            spread[piece] += mass[node] * dealii::symmetrize(dealii::outer_product(radius, radius));
          }
      for (std::size_t piece = 0; piece < pieces.size(); ++piece)
        moments[piece] =
          dealii::trace(spread[piece]) - (dim == 3 ? dealii::eigenvalues(spread[piece])[0] : 0.);
      return moments;
    }

    /** A piece whose nodes with mass lie in one point, or in space on a line, could turn without
     * inertia: its lips keep their mass. */
    template <int dim>
    void
    keep_moments(const BodyModel<dim> &model, std::vector<bool> &massless)
    {
      if (std::find(massless.begin(), massless.end(), true) == massless.end())
        return;
      constexpr double none                  = 1e-3;
      const Discretization<dim> &space       = model.discretization();
      const std::vector<unsigned int> pieces = pieces_of_nodes(space);
      const Vector all                       = smallest_moments(
        space, pieces, masses_of_nodes(model, std::vector<bool>(massless.size(), false)));
      const Vector left = smallest_moments(space, pieces, masses_of_nodes(model, massless));
      for (std::size_t node = 0; node < massless.size(); ++node)
        if (left[pieces[node]] <= none * all[pieces[node]])
          massless[node] = false;
    }

    /** The mass m of water along the normal n at a node: m n_c² along the axis c. */
    template <int dim>
    void
    add_water(const BodyModel<dim> &model, const AddedMass &added, Vector &mass)
    {
      const Discretization<dim> &space = model.discretization();
      DepthPressure pressure;
      pressure.root   = 0.875 * added.unit_weight / model.definition().dynamics.gravity;
      pressure.bottom = added.bottom;
      Vector along_normals(space.n_dofs(), 0.);
      add_depth_pressure(space,
                         pressure,
                         added.level,
                         selection(model.jointed_mesh().label_names, added.boundaries),
                         along_normals);
      for (std::size_t node = 0; node < space.n_nodes(); ++node)
        {
          const double *const m = along_normals.data() + node * dim;
          const double size     = std::sqrt(std::inner_product(m, m + dim, m, 0.));
          for (unsigned int c = 0; c < dim && size > 0.; ++c)
            mass[node * dim + c] += m[c] * m[c] / size;
        }
    }
  } // namespace


  template <int dim>
  Vector
  lumped_mass(const BodyModel<dim> &model, const std::vector<bool> &massless_joints)
  {
    const Discretization<dim> &space = model.discretization();
    std::vector<bool> massless       = nodes_without_mass(model, massless_joints);
    keep_moments(model, massless);
    const Vector of_nodes = masses_of_nodes(model, massless);
    Vector mass(space.n_dofs());
    for (std::size_t dof = 0; dof < mass.size(); ++dof)
      mass[dof] = of_nodes[dof / dim];
    for (const AddedMass &water : model.definition().dynamics.added_masses)
      add_water(model, water, mass);
    space.hanging_nodes().move_to_masters(mass);
    for (std::size_t dof = 0; dof < mass.size(); ++dof)
      if (model.fixed_dofs()[dof])
        mass[dof] = 0.;
    return mass;
  }


  template Vector
  lumped_mass(const BodyModel<2> &, const std::vector<bool> &);
  template Vector
  lumped_mass(const BodyModel<3> &, const std::vector<bool> &);
} // namespace fuga
