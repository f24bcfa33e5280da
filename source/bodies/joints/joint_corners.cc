// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/numbers.h>

#include <fmt/format.h>
#include <fuga/base/disjoint_sets.h>
#include <fuga/bodies/joints/joint_corners.h>
#include <fuga/bodies/point_text.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Tolerance which ensures that equal angles of a regular polygon are on one side of the limit
     * [degrees]. */
    constexpr double rounding_of_angles = 1e-6;
  } // namespace


  template <int dim>
  bool
  is_corner(const dealii::Tensor<1, dim> &a,
            const dealii::Tensor<1, dim> &b,
            const double corner_angle)
  {
    const double angle =
      2. * std::asin(std::min(1., 0.5 * (a - b).norm())) * 180. / dealii::numbers::PI;
    return angle > corner_angle + rounding_of_angles;
  }


  template <int dim>
  std::vector<unsigned int>
  straight_parts(const std::vector<dealii::Tensor<1, dim>> &normals, const double corner_angle)
  {
    DisjointSets sets(normals.size());
    for (unsigned int i = 0; i < normals.size(); ++i)
      for (unsigned int j = 0; j < i; ++j)
        if (!is_corner(normals[i], normals[j], corner_angle))
          sets.unite(i, j);
    std::vector<unsigned int> parts;
    sets.number(parts);
    return parts;
  }


  template <int dim>
  std::vector<std::string>
  corner_report(const std::vector<NodePair<dim>> &pairs, const JointedMesh &mesh)
  {
    // The second part of a node pair would report a corner twice.
    std::vector<std::vector<dealii::Point<dim>>> places(mesh.joints.size());
    for (const auto &pair : pairs)
      if (pair.part == 1 && pair.masters.empty())
        places[pair.joint].push_back(pair.position);
    std::vector<std::string> lines;
    for (std::size_t j = 0; j < places.size(); ++j)
      {
        if (places[j].empty())
          continue;
        lines.push_back(
          fmt::format("joint '{}': split at {} corner{}, where faces meet at more than "
                      "{:g} degrees, {}: one element with its own normal for every "
                      "straight part",
                      mesh.joints[j].name,
                      places[j].size(),
                      places[j].size() == 1 ? "" : "s",
                      mesh.joints[j].corner_angle,
                      text_of_first(places[j])));
      }
    return lines;
  }


  template bool
  is_corner(const dealii::Tensor<1, 2> &, const dealii::Tensor<1, 2> &, const double);
  template std::vector<unsigned int>
  straight_parts(const std::vector<dealii::Tensor<1, 2>> &, const double);
  template std::vector<std::string>
  corner_report(const std::vector<NodePair<2>> &, const JointedMesh &);
  template bool
  is_corner(const dealii::Tensor<1, 3> &, const dealii::Tensor<1, 3> &, const double);
  template std::vector<unsigned int>
  straight_parts(const std::vector<dealii::Tensor<1, 3>> &, const double);
  template std::vector<std::string>
  corner_report(const std::vector<NodePair<3>> &, const JointedMesh &);
} // namespace fuga
