// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/elasticity/rigid_pieces.h>
#include <fuga/bodies/point_text.h>

#include <cmath>
#include <numeric>

namespace fuga
{
  namespace
  {
    /** Return @p x without components that are only rounding relative to @p size; of a direction
     * and its opposite, return the one whose last nonzero component is positive. */
    template <int dim>
    dealii::Tensor<1, dim>
    clean(dealii::Tensor<1, dim> x, const double size, const bool is_direction = false)
    {
      double sign = 1.;
      for (unsigned int c = 0; c < dim; ++c)
        if (std::abs(x[c]) < 1e-9 * size)
          x[c] = 0.;
        else if (is_direction)
          sign = x[c] > 0. ? 1. : -1.;
      return sign * x;
    }
  } // namespace


  template <int dim>
  void
  RigidPieces<dim>::require_held_by(const ContactBars<dim> &bars) const
  {
    const DenseMatrix free = null_space(bars);
    if (free.cols() == 0)
      return;
    unsigned int worst = 0;
    double largest     = -1.;
    for (unsigned int piece = 0; piece < centers.size(); ++piece)
      {
        double sum = 0.;
        for (Eigen::Index j = 0; j < free.cols(); ++j)
          for (unsigned int i = 0; i < n_motions; ++i)
            sum += free(n_motions * piece + i, j) * free(n_motions * piece + i, j);
        if (sum > largest * (1. + 1e-6))
          {
            largest = sum;
            worst   = piece;
          }
      }
    throw InputError(fmt::format(
      "Body '{}' (the piece around {}) is not held even when every joint is closed and "
      "sticks: it is {}. Hold more components of its boundaries, or tie it by a joint with at "
      "least {} to a body that is held.",
      mesh.body_names[body_of_piece[worst]],
      text_of(centers[worst]),
      describe(free, worst),
      dim == 2 ? "two node pairs" : "three node pairs that are not in line"));
  }


  template <int dim>
  std::string
  RigidPieces<dim>::describe(const DenseMatrix &free, const unsigned int piece) const
  {
    // This is an orthonormal basis of the motions of this piece: shifts first, then the others.
    std::vector<Motion> span, found;
    const auto reduce = [](Motion v, const std::vector<Motion> &basis) {
      for (const auto &b : basis)
        {
          const double s = std::inner_product(v.begin(), v.end(), b.begin(), 0.);
          for (unsigned int i = 0; i < n_motions; ++i)
            v[i] -= s * b[i];
        }
      return v;
    };
    const auto norm = [](const Motion &v) {
      return std::sqrt(std::inner_product(v.begin(), v.end(), v.begin(), 0.));
    };
    const auto add = [&](const Motion &v, std::vector<Motion> &basis) {
      auto w = reduce(v, basis);
      if (const double length = norm(w); length > 1e-5)
        {
          for (double &x : w)
            x /= length;
          basis.push_back(w);
        }
    };
    for (Eigen::Index j = 0; j < free.cols(); ++j)
      {
        Motion motion;
        for (unsigned int i = 0; i < n_motions; ++i)
          motion[i] = free(n_motions * piece + i, j);
        add(motion, span);
      }
    for (unsigned int c = 0; c < n_motions; ++c)
      {
        Motion unit{};
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
  RigidPieces<dim>::describe(const Motion &motion, const unsigned int piece) const
  {
    dealii::Tensor<1, dim> shift;
    for (unsigned int c = 0; c < dim; ++c)
      shift[c] = motion[c];
    if constexpr (dim == 2)
      {
        const double rotation = motion[2] / sizes[piece];
        if (std::abs(motion[2]) > 1e-6)
          return fmt::format("free to rotate about ({:.6g}, {:.6g})",
                             centers[piece][0] - motion[1] / rotation,
                             centers[piece][1] + motion[0] / rotation);
      }
    else
      {
        dealii::Tensor<1, dim> rotation;
        for (unsigned int c = 0; c < dim; ++c)
          rotation[c] = motion[dim + c] / sizes[piece];
        if (rotation.norm() * sizes[piece] > 1e-6)
          {
            const auto center =
              centers[piece] + dealii::cross_product_3d(rotation, shift) / rotation.norm_square();
            const bool screw = std::abs(rotation * shift) > 1e-6 * rotation.norm();
            return fmt::format("free to rotate about an axis in the direction {} through {}{}",
                               text_of(clean(rotation / rotation.norm(), 1., true), 4),
                               text_of(clean(center, sizes[piece])),
                               screw ? " and to move along it at the same time" : "");
          }
      }
    for (unsigned int c = 0; c < dim; ++c)
      if (std::abs(std::abs(shift[c]) - shift.norm()) < 1e-6 * shift.norm())
        return fmt::format("free to move in {}", "xyz"[c]);
    return fmt::format("free to move in the direction {}", text_of(shift, 4));
  }


  template void
  RigidPieces<2>::require_held_by(const ContactBars<2> &) const;
  template void
  RigidPieces<3>::require_held_by(const ContactBars<3> &) const;
} // namespace fuga
