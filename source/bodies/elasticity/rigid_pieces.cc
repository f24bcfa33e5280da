// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/disjoint_sets.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/elasticity/rigid_pieces.h>

#include <algorithm>
#include <cmath>
#include <lapacke.h>
#include <numeric>

namespace fuga
{
  namespace
  {
    /** Squares of singular values below this share of the largest one count as zero. */
    constexpr double null_tolerance = 1e-12;

    void
    add_square(DenseMatrix &gram, const std::vector<std::pair<unsigned int, double>> &row)
    {
      for (const auto &a : row)
        for (const auto &b : row)
          gram(a.first, b.first) += a.second * b.second;
    }

    /** Return the null vectors of a positive semidefinite matrix, as columns. */
    DenseMatrix
    null_vectors(DenseMatrix gram)
    {
      const int n = static_cast<int>(gram.rows());
      Vector values(gram.rows());
      if (LAPACKE_dsyev(LAPACK_COL_MAJOR, 'V', 'U', n, gram.data(), n, values.data()) != 0)
        throw NumericalFailure("The check of the supports failed (LAPACK dsyev).");
      std::size_t n_null = 0;
      while (n_null < values.size() && values[n_null] <= null_tolerance * values.back())
        ++n_null;
      DenseMatrix result(gram.rows(), n_null);
      std::copy(gram.data(), gram.data() + gram.rows() * n_null, result.data());
      return result;
    }
  } // namespace


  template <int dim>
  RigidPieces<dim>::RigidPieces(const Discretization<dim> &space,
                                const JointedMesh &jointed,
                                const std::vector<bool> &fixed)
    : discretization(space), mesh(jointed)
  {
    if (space.is_axisymmetric())
      motions = {1};
    else
      for (unsigned int motion = 0; motion < n_motions; ++motion)
        motions.push_back(motion);
    find_nodes(discretization);
    find_free_motions(fixed);

    supports = DenseMatrix(n_motions * centers.size(), n_motions * centers.size());
    for (unsigned int motion = 0; motion < n_motions; ++motion)
      if (std::find(motions.begin(), motions.end(), motion) == motions.end())
        for (unsigned int piece = 0; piece < centers.size(); ++piece)
          add_square(supports, {{n_motions * piece + motion, 1.}});
    for (unsigned int node = 0; node < discretization.n_nodes(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        if (fixed[node * dim + c])
          {
            dealii::Tensor<1, dim> direction;
            direction[c] = 1.;
            add_square(supports, displacement(node, direction));
          }
    for (const auto &[node, other] : hinges)
      for (unsigned int c = 0; c < dim; ++c)
        {
          dealii::Tensor<1, dim> direction;
          direction[c]      = 1.;
          Row row           = displacement(node, direction);
          const auto arm    = discretization.position(node) - centers[other];
          const Motion work = work_on_motions(direction, arm, sizes[other]);
          for (unsigned int motion = 0; motion < n_motions; ++motion)
            row.emplace_back(n_motions * other + motion, -work[motion]);
          add_square(supports, row);
        }
  }


  template <int dim>
  void
  RigidPieces<dim>::find_nodes(const Discretization<dim> &space)
  {
    constexpr unsigned int none = static_cast<unsigned int>(-1);
    piece_of_node.assign(space.n_nodes(), none);
    body_of_piece.assign(space.n_pieces(), none);
    std::vector<double> count(space.n_pieces(), 0.);
    centers.resize(space.n_pieces());
    sizes.assign(space.n_pieces(), 0.);
    for (std::size_t cell = 0; cell < space.n_cells(); ++cell)
      {
        const unsigned int piece = space.cell_piece(cell);
        if (body_of_piece[piece] == none)
          body_of_piece[piece] = space.cell_body(cell);
        for (std::size_t i = 0; i < space.reference_element().n_nodes(); ++i)
          {
            const unsigned int node = space.cell_nodes(cell)[i];
            if (piece_of_node[node] == none)
              {
                piece_of_node[node] = piece;
                centers[piece] += space.position(node);
                ++count[piece];
              }
            else if (piece_of_node[node] != piece)
              hinges.emplace_back(node, piece);
          }
      }
    std::sort(hinges.begin(), hinges.end());
    hinges.erase(std::unique(hinges.begin(), hinges.end()), hinges.end());
    for (std::size_t piece = 0; piece < centers.size(); ++piece)
      centers[piece] /= count[piece];
    for (std::size_t node = 0; node < piece_of_node.size(); ++node)
      if (piece_of_node[node] != none)
        {
          double &size = sizes[piece_of_node[node]];
          size = std::max(size, space.position(node).distance(centers[piece_of_node[node]]));
        }
  }


  // The free motions form the null space of the held components, in shifts and the rotation times
  // the size of the group; they are the three unit motions if no component is held.
  template <int dim>
  void
  RigidPieces<dim>::find_free_motions(const std::vector<bool> &fixed)
  {
    DisjointSets groups(centers.size());
    for (const auto &[node, other] : hinges)
      groups.unite(piece_of_node[node], other);
    const unsigned int n_groups = groups.number(group_of_piece);

    const auto group_of = [&](const std::size_t node) {
      return group_of_piece[piece_of_node[node]];
    };
    std::vector<dealii::Point<dim>> middle(n_groups);
    std::vector<double> count(n_groups, 0.), extent(n_groups, 0.);
    for (std::size_t node = 0; node < piece_of_node.size(); ++node)
      {
        middle[group_of(node)] += discretization.position(node);
        ++count[group_of(node)];
      }
    for (unsigned int group = 0; group < n_groups; ++group)
      middle[group] /= count[group];
    for (std::size_t node = 0; node < piece_of_node.size(); ++node)
      {
        double &size = extent[group_of(node)];
        size = std::max(size, discretization.position(node).distance(middle[group_of(node)]));
      }

    std::vector<DenseMatrix> held(n_groups, DenseMatrix(n_motions, n_motions));
    for (std::size_t node = 0; node < piece_of_node.size(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        if (fixed[node * dim + c])
          {
            const unsigned int group = group_of(node);
            const auto arm           = discretization.position(node) - middle[group];
            dealii::Tensor<1, dim> direction;
            direction[c]      = 1.;
            const Motion work = work_on_motions(direction, arm, extent[group]);
            Row row;
            for (unsigned int motion = 0; motion < n_motions; ++motion)
              row.emplace_back(motion, work[motion]);
            add_square(held[group], row);
          }
    for (unsigned int group = 0; group < n_groups; ++group)
      {
        for (unsigned int motion = 0; motion < n_motions; ++motion)
          if (std::find(motions.begin(), motions.end(), motion) == motions.end())
            add_square(held[group], {{motion, 1.}});
        const DenseMatrix null = null_vectors(std::move(held[group]));
        for (Eigen::Index k = 0; k < null.cols(); ++k)
          {
            FreeMotion free{group, middle[group], {}};
            for (unsigned int motion = 0; motion < n_motions; ++motion)
              free.motion[motion] = null(motion, k) / (motion < dim ? 1. : extent[group]);
            free_motions.push_back(free);
          }
      }
  }


  template <int dim>
  typename RigidPieces<dim>::Motion
  RigidPieces<dim>::work_on_motions(const dealii::Tensor<1, dim> &direction,
                                    const dealii::Tensor<1, dim> &arm,
                                    const double size)
  {
    Motion work;
    for (unsigned int c = 0; c < dim; ++c)
      work[c] = direction[c];
    if constexpr (dim == 2)
      work[2] = (direction[1] * arm[0] - direction[0] * arm[1]) / size;
    else
      for (unsigned int c = 0; c < 3; ++c)
        work[3 + c] = dealii::cross_product_3d(arm, direction)[c] / size;
    return work;
  }


  template <int dim>
  typename RigidPieces<dim>::Row
  RigidPieces<dim>::displacement(const unsigned int node,
                                 const dealii::Tensor<1, dim> &direction) const
  {
    const unsigned int piece = piece_of_node[node];
    const auto arm           = discretization.position(node) - centers[piece];
    const Motion work        = work_on_motions(direction, arm, sizes[piece]);
    Row row;
    for (unsigned int motion = 0; motion < n_motions; ++motion)
      row.emplace_back(n_motions * piece + motion, work[motion]);
    return row;
  }


  template <int dim>
  DenseMatrix
  RigidPieces<dim>::gram_matrix(const ContactBars<dim> &bars) const
  {
    DenseMatrix gram = supports;
    for (const auto &bar : bars.bars())
      {
        Row row = displacement(bar.plus_node, bar.direction);
        if (bar.minus_node != Discretization<dim>::no_node)
          for (const auto &entry : displacement(bar.minus_node, -bar.direction))
            row.push_back(entry);
        add_square(gram, row);
      }
    return gram;
  }


  template <int dim>
  DenseMatrix
  RigidPieces<dim>::null_space(const ContactBars<dim> &bars) const
  {
    return null_vectors(gram_matrix(bars));
  }


  template <int dim>
  bool
  RigidPieces<dim>::are_held_by(const ContactBars<dim> &bars) const
  {
    return null_space(bars).cols() == 0;
  }


  template <int dim>
  Vector
  RigidPieces<dim>::free_motion(const std::size_t number) const
  {
    const FreeMotion &motion = free_motions[number];
    Vector u(discretization.n_dofs(), 0.);
    for (std::size_t node = 0; node < piece_of_node.size(); ++node)
      if (group_of_piece[piece_of_node[node]] == motion.group)
        {
          const auto arm = discretization.position(node) - motion.center;
          for (unsigned int c = 0; c < dim; ++c)
            {
              dealii::Tensor<1, dim> direction;
              direction[c]      = 1.;
              const Motion work = work_on_motions(direction, arm, 1.);
              u[node * dim + c] =
                std::inner_product(work.begin(), work.end(), motion.motion.begin(), 0.);
            }
        }
    return u;
  }


  template <int dim>
  const std::string &
  RigidPieces<dim>::moving_body(const std::size_t number) const
  {
    const auto piece =
      std::find(group_of_piece.begin(), group_of_piece.end(), free_motions[number].group) -
      group_of_piece.begin();
    return mesh.body_names[body_of_piece[static_cast<std::size_t>(piece)]];
  }


  template class RigidPieces<2>;
  template class RigidPieces<3>;
} // namespace fuga
