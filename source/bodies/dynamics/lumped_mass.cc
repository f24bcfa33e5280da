// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/dynamics/lumped_mass.h>
#include <fuga/bodies/joints/contact_bars.h>
#include <fuga/bodies/loads/depth_pressure.h>
#include <fuga/bodies/model_names.h>
#include <fuga/bodies/space/cell_values.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

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

    /** Compute the share of the mass of a cell that each of its nodes gets; all shares sum up to
     * 1. */
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

    /** Mass of a piece of mesh, and its first and second moments about the first of its nodes. */
    template <int dim>
    struct PieceMass
    {
      std::optional<dealii::Point<dim>> origin;
      double mass = 0.;
      dealii::Tensor<1, dim> first;
      dealii::SymmetricTensor<2, dim> second;

      void
      add(const double share, const dealii::Point<dim> &position)
      {
        if (!origin)
          origin = position;
        const dealii::Tensor<1, dim> radius = position - *origin;
        mass += share;
        first += share * radius;
        second += share * dealii::symmetrize(dealii::outer_product(radius, radius));
      }

      /** Return the smallest of the moments of inertia about axes through the centre [MN m s²]. */
      double
      smallest_moment() const
      {
        if (mass == 0.)
          return 0.;
        const dealii::SymmetricTensor<2, dim> spread =
          second - dealii::symmetrize(dealii::outer_product(first, first)) / mass;
        return dealii::trace(spread) - (dim == 3 ? dealii::eigenvalues(spread)[0] : 0.);
      }
    };

    /** Masses of the nodes, without the added mass of water, and of the pieces of mesh. */
    template <int dim>
    struct NodeMasses
    {
      Vector of_nodes;
      std::vector<PieceMass<dim>> of_pieces;
    };

    template <int dim>
    NodeMasses<dim>
    masses_of_nodes(const BodyModel<dim> &model, const std::vector<bool> &massless)
    {
      const Discretization<dim> &space = model.discretization();
      const Vector density             = mass_densities(model.jointed_mesh(), model.definition());
      NodeMasses<dim> result{Vector(space.n_nodes(), 0.),
                             std::vector<PieceMass<dim>>(space.n_pieces())};
      Vector shares(space.reference_element().n_nodes());
      CellValues<dim> values(space);
      for (std::size_t cell = 0; cell < space.n_cells(); ++cell)
        {
          if (density[space.cell_body(cell)] == 0.)
            continue;
          values.move_to(cell);
          const unsigned int *nodes = space.cell_nodes(cell);
          double mass               = 0.;
          for (std::size_t q = 0; q < values.n_points(); ++q)
            mass += density[space.cell_body(cell)] * values.volume(q);
          shares_of_nodes(values, nodes, massless, shares);
          for (std::size_t i = 0; i < shares.size(); ++i)
            {
              result.of_nodes[nodes[i]] += mass * shares[i];
              result.of_pieces[space.cell_piece(cell)].add(mass * shares[i],
                                                           space.position(nodes[i]));
            }
        }
      return result;
    }

    /** Let lips keep their mass if their piece could otherwise turn without inertia, because its
     * nodes with mass would lie in one point, or in space on a line. Pieces that meet in a hinge
     * turn independently. Return whether there are such lips. */
    template <int dim>
    bool
    keep_moments(const Discretization<dim> &space,
                 const NodeMasses<dim> &all,
                 const NodeMasses<dim> &left,
                 std::vector<bool> &massless)
    {
      constexpr double none = 1e-3;
      std::vector<bool> turns;
      for (unsigned int piece = 0; piece < space.n_pieces(); ++piece)
        {
          const double whole = all.of_pieces[piece].smallest_moment();
          turns.push_back(whole > 0. && left.of_pieces[piece].smallest_moment() <= none * whole);
        }
      bool is_kept = false;
      for (std::size_t cell = 0; cell < space.n_cells(); ++cell)
        if (turns[space.cell_piece(cell)])
          for (std::size_t i = 0; i < space.reference_element().n_nodes(); ++i)
            if (const unsigned int node = space.cell_nodes(cell)[i]; massless[node])
              {
                massless[node] = false;
                is_kept        = true;
              }
      return is_kept;
    }

    /** Add the mass m of water along the normal n at a node: m n_c² along the axis c. */
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
    NodeMasses<dim> masses           = masses_of_nodes(model, massless);
    if (std::find(massless.begin(), massless.end(), true) != massless.end() &&
        keep_moments(space,
                     masses_of_nodes(model, std::vector<bool>(massless.size(), false)),
                     masses,
                     massless))
      masses = masses_of_nodes(model, massless);
    Vector mass(space.n_dofs());
    for (std::size_t dof = 0; dof < mass.size(); ++dof)
      mass[dof] = masses.of_nodes[dof / dim];
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
