// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/grid_model.h"

#include <algorithm>
#include <fmt/format.h>

namespace fuga::stress
{
  namespace
  {
    /** Beyond the tags of faces. */
    constexpr std::size_t first_tag_of_points = 1000;
  } // namespace

  int
  GridModel::body(const std::size_t i, const std::size_t j) const
  {
    // Indices left of and below the grid have wrapped around.
    return i < x.size() - 1 && j < y.size() - 1 ? body_of_cell(i, j) : none;
  }

  GridModel::FaceGroups
  GridModel::faces() const
  {
    FaceGroups result;
    const auto vertex = [&](const std::size_t i, const std::size_t j) {
      return i + x.size() * j + 1;
    };
    const auto add = [&](const int before,
                         const int behind,
                         const char *const side_of_before,
                         const char *const side_of_behind,
                         const std::vector<std::size_t> &face) {
      if (before == behind)
        return;
      if (before == none || behind == none)
        result[bodies[static_cast<std::size_t>(std::max(before, behind))].name + '_' +
               (before == none ? side_of_behind : side_of_before)]
          .push_back(face);
      else
        result[name_of_joint(static_cast<std::size_t>(before), static_cast<std::size_t>(behind))]
          .push_back(face);
    };
    for (std::size_t j = 0; j < y.size(); ++j)
      for (std::size_t i = 0; i < x.size(); ++i)
        {
          if (i + 1 < x.size())
            add(body(i, j - 1), body(i, j), "top", "bottom", {vertex(i, j), vertex(i + 1, j)});
          if (j + 1 < y.size())
            add(body(i - 1, j), body(i, j), "right", "left", {vertex(i, j), vertex(i, j + 1)});
        }
    return result;
  }

  std::string
  GridModel::mesh_text() const
  {
    MeshText mesh   = mesh_of_faces();
    std::size_t tag = first_tag_of_points;
    for (const auto &[name, place] : points)
      {
        mesh.add_name(0, ++tag, name);
        mesh.add_element(15, tag, {place[0] + x.size() * place[1] + 1});
      }
    for (std::size_t j = 0; j + 1 < y.size(); ++j)
      for (std::size_t i = 0; i + 1 < x.size(); ++i)
        if (const int b = body_of_cell(i, j); b != none)
          {
            const std::size_t a = i + x.size() * j + 1, d = a + x.size();
            const std::size_t number = tag_of_body(static_cast<std::size_t>(b));
            if (!triangles)
              mesh.add_element(3, number, {a, a + 1, d + 1, d});
            else
              {
                mesh.add_element(2, number, {a, a + 1, d + 1});
                mesh.add_element(2, number, {a, d + 1, d});
              }
          }
    // Only vertices that a cell uses: others would belong to no body.
    for (std::size_t j = 0; j < y.size(); ++j)
      for (std::size_t i = 0; i < x.size(); ++i)
        if (body(i, j) != none || body(i - 1, j) != none || body(i, j - 1) != none ||
            body(i - 1, j - 1) != none)
          {
            const std::array<double, 2> at = place(i, j);
            mesh.add_vertex(i + x.size() * j + 1, at[0], at[1], 0.);
          }
    return mesh.text();
  }

  double
  GridModel::width() const
  {
    return x.back() - x.front();
  }

  double
  GridModel::largest_aspect() const
  {
    double result = 1.;
    for (std::size_t j = 0; j + 1 < y.size(); ++j)
      for (std::size_t i = 0; i + 1 < x.size(); ++i)
        if (body_of_cell(i, j) != none)
          result = std::max(result, aspect_of({x[i + 1] - x[i], y[j + 1] - y[j]}));
    return result;
  }

  double
  GridModel::size_ratio() const
  {
    return size_ratio_of({x, y});
  }

  double
  GridModel::offset() const
  {
    const std::array<double, 2> at = place(0, 0);
    return std::max(std::abs(at[0]), std::abs(at[1]));
  }

  std::size_t
  GridModel::n_joint_faces() const
  {
    const auto all_faces = faces();
    std::size_t n        = 0;
    for (const Joint &joint : joints)
      n += all_faces.at(joint.line.empty() ? joint.plus : joint.line).size();
    return n;
  }

  std::array<double, 2>
  GridModel::place(const std::size_t i, const std::size_t j) const
  {
    return map ? map(x[i], y[j]) : std::array<double, 2>{{x[i], y[j]}};
  }
} // namespace fuga::stress
