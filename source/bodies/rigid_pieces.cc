// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/disjoint_sets.h>
#include <fuga/bodies/rigid_pieces.h>

#include <algorithm>
#include <cmath>
#include <lapacke.h>

namespace fuga
{
  namespace
  {
    /** Squares of singular values below this part of the largest one count as zero. */
    constexpr double null_tolerance = 1e-12;

    void
    add_square(DenseMatrix &gram, const std::vector<std::pair<unsigned int, double>> &row)
    {
      for (const auto &a : row)
        for (const auto &b : row)
          gram(a.first, b.first) += a.second * b.second;
    }

    /** Null vectors of a positive semidefinite matrix, as columns. */
    DenseMatrix
    null_vectors(DenseMatrix gram)
    {
      const int n = static_cast<int>(gram.n_rows());
      Vector values(gram.n_rows());
      if (LAPACKE_dsyev(LAPACK_COL_MAJOR, 'V', 'L', n, gram.data(), n, values.data()) != 0)
        throw NumericalFailure("The check of the supports failed (LAPACK dsyev).");
      std::size_t n_null = 0;
      while (n_null < values.size() && values[n_null] <= null_tolerance * values.back())
        ++n_null;
      DenseMatrix result(gram.n_rows(), n_null);
      std::copy(gram.data(), gram.data() + gram.n_rows() * n_null, result.data());
      return result;
    }
  } // namespace


  template <int dim>
  RigidPieces<dim>::RigidPieces(const Discretization<dim> &space,
                                const JointedMesh &jointed,
                                const std::vector<bool> &fixed)
    : discretization(space)
    , mesh(jointed)
    , motions(space.is_axisymmetric() ? std::vector<unsigned int>{1}
                                      : std::vector<unsigned int>{0, 1, 2})
  {
    static_assert(dim == 2, "three motions per piece");
    find_nodes(discretization);
    find_free_motions(fixed);

    supports = DenseMatrix(3 * centers.size(), 3 * centers.size());
    for (unsigned int motion = 0; motion < 3; ++motion)
      if (std::find(motions.begin(), motions.end(), motion) == motions.end())
        for (unsigned int piece = 0; piece < centers.size(); ++piece)
          add_square(supports, {{3 * piece + motion, 1.}});
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
          direction[c]   = 1.;
          Row row        = displacement(node, direction);
          const auto arm = discretization.position(node) - centers[other];
          row.emplace_back(3 * other + c, -1.);
          row.emplace_back(3 * other + 2, -(c == 0 ? -arm[1] : arm[0]) / sizes[other]);
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


  // The null space of what is held, in shifts and the rotation times the size of the group: three
  // unit motions where nothing is.
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

    std::vector<DenseMatrix> held(n_groups, DenseMatrix(3, 3));
    for (std::size_t node = 0; node < piece_of_node.size(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        if (fixed[node * dim + c])
          {
            const unsigned int group = group_of(node);
            const auto arm           = discretization.position(node) - middle[group];
            add_square(held[group], {{c, 1.}, {2, (c == 0 ? -arm[1] : arm[0]) / extent[group]}});
          }
    for (unsigned int group = 0; group < n_groups; ++group)
      {
        for (unsigned int motion = 0; motion < 3; ++motion)
          if (std::find(motions.begin(), motions.end(), motion) == motions.end())
            add_square(held[group], {{motion, 1.}});
        const DenseMatrix null = null_vectors(std::move(held[group]));
        for (std::size_t k = 0; k < null.n_columns(); ++k)
          {
            FreeMotion motion{group, middle[group], {}, null(2, k) / extent[group]};
            for (unsigned int c = 0; c < dim; ++c)
              motion.shift[c] = null(c, k);
            free_motions.push_back(motion);
          }
      }
  }


  template <int dim>
  typename RigidPieces<dim>::Row
  RigidPieces<dim>::displacement(const unsigned int node,
                                 const dealii::Tensor<1, dim> &direction) const
  {
    const unsigned int piece = piece_of_node[node];
    const auto arm           = discretization.position(node) - centers[piece];
    return {{3 * piece, direction[0]},
            {3 * piece + 1, direction[1]},
            {3 * piece + 2, (direction[1] * arm[0] - direction[0] * arm[1]) / sizes[piece]}};
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
    return null_space(bars).n_columns() == 0;
  }


  template <int dim>
  void
  RigidPieces<dim>::require_held_by(const ContactBars<dim> &bars) const
  {
    const DenseMatrix free = null_space(bars);
    if (free.n_columns() == 0)
      return;
    unsigned int worst = 0;
    double largest     = -1.;
    for (unsigned int piece = 0; piece < centers.size(); ++piece)
      {
        double sum = 0.;
        for (std::size_t j = 0; j < free.n_columns(); ++j)
          for (unsigned int i = 0; i < 3; ++i)
            sum += free(3 * piece + i, j) * free(3 * piece + i, j);
        if (sum > largest * (1. + 1e-6))
          {
            largest = sum;
            worst   = piece;
          }
      }
    throw InputError(fmt::format(
      "Body '{}' (the piece around ({:g}, {:g})) is not held even when every joint is closed and "
      "sticks: it is {}. Hold more components of its boundaries, or tie it by a joint with at "
      "least "
      "two node pairs to a body that is held.",
      mesh.body_names[body_of_piece[worst]],
      centers[worst][0],
      centers[worst][1],
      describe(free, worst)));
  }


  template <int dim>
  std::string
  RigidPieces<dim>::describe(const DenseMatrix &free, const unsigned int piece) const
  {
    // Orthonormal basis of the motions of this piece: shifts first, then what is left.
    std::vector<std::array<double, 3>> span, found;
    const auto reduce = [](std::array<double, 3> v,
                           const std::vector<std::array<double, 3>> &basis) {
      for (const auto &b : basis)
        {
          const double s = v[0] * b[0] + v[1] * b[1] + v[2] * b[2];
          for (unsigned int i = 0; i < 3; ++i)
            v[i] -= s * b[i];
        }
      return v;
    };
    const auto norm = [](const std::array<double, 3> &v) { return std::hypot(v[0], v[1], v[2]); };
    const auto add  = [&](const std::array<double, 3> &v,
                         std::vector<std::array<double, 3>> &basis) {
      auto w = reduce(v, basis);
      if (const double length = norm(w); length > 1e-5)
        {
          for (double &x : w)
            x /= length;
          basis.push_back(w);
        }
    };
    for (std::size_t j = 0; j < free.n_columns(); ++j)
      add({{free(3 * piece, j), free(3 * piece + 1, j), free(3 * piece + 2, j)}}, span);
    for (unsigned int c = 0; c < 3; ++c)
      {
        std::array<double, 3> unit{};
        unit[c] = 1.;
        if (norm(reduce(unit, span)) < 1e-5)
          add(unit, found);
      }
    for (const auto &v : span)
      add(v, found);

    std::vector<std::string> words;
    for (const auto &motion : found)
      words.push_back(describe(motion, piece));
    return fmt::format("{}", fmt::join(words, " and "));
  }


  template <int dim>
  std::string
  RigidPieces<dim>::describe(const std::array<double, 3> &motion, const unsigned int piece) const
  {
    const double rotation = motion[2] / sizes[piece];
    if (std::abs(motion[2]) > 1e-6)
      return fmt::format("free to rotate about ({:.6g}, {:.6g})",
                         centers[piece][0] - motion[1] / rotation,
                         centers[piece][1] + motion[0] / rotation);
    if (std::abs(motion[1]) < 1e-6)
      return "free to move in x";
    if (std::abs(motion[0]) < 1e-6)
      return "free to move in y";
    return fmt::format("free to move in the direction ({:.4g}, {:.4g})", motion[0], motion[1]);
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
          const auto arm    = discretization.position(node) - motion.center;
          u[node * dim]     = motion.shift[0] - motion.rotation * arm[1];
          u[node * dim + 1] = motion.shift[1] + motion.rotation * arm[0];
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
} // namespace fuga
