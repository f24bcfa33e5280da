// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/cut_polyhedron_points.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>

// The tetrahedra of a cut polyhedron.
namespace fuga::stress
{
  void
  CutPolyhedron::make_tetrahedra()
  {
    std::set<std::size_t> used;
    for (Part &part : parts)
      {
        part.center = vertices.size();
        vertices.push_back(center_of(part));
        used.insert(part.faces.begin(), part.faces.end());
      }
    for (const std::size_t face : used)
      {
        all_faces[face].center = vertices.size();
        vertices.push_back(mean(all_faces[face].corners));
      }
  }

  double
  CutPolyhedron::volume(const Tetrahedron &cell) const
  {
    const auto from_first = [&](const std::size_t i) {
      return sum(vertices[cell[i]], -1., vertices[cell[0]]);
    };
    return dot(from_first(1), cross(from_first(2), from_first(3)));
  }

  void
  CutPolyhedron::for_each_cell(
    const std::function<void(const Part &, const Tetrahedron &)> &action) const
  {
    for (const Part &part : parts)
      for (const std::size_t f : part.faces)
        for (std::size_t i = 0; i < all_faces[f].corners.size(); ++i)
          {
            const Edge at    = edge(all_faces[f].corners, i);
            Tetrahedron cell = {{part.center, all_faces[f].center, at[0], at[1]}};
            if (volume(cell) < 0.)
              std::swap(cell[2], cell[3]);
            action(part, cell);
          }
  }

  CutPolyhedron::FaceGroups
  CutPolyhedron::faces() const
  {
    const std::vector<std::vector<std::size_t>> at = parts_at_faces();
    FaceGroups result;
    for (std::size_t f = 0; f < all_faces.size(); ++f)
      {
        const Face &face = all_faces[f];
        if (at[f].empty())
          continue;
        const std::size_t first = parts[at[f].front()].body, last = parts[at[f].back()].body;
        if (first == last && face.side == inside)
          continue;
        auto &group =
          result[face.side == inside ? name_of_joint(first, last)
                                     : fmt::format("{}_s{}", bodies[first].name, face.side)];
        for (std::size_t i = 0; i < face.corners.size(); ++i)
          group.push_back(
            {face.center + 1, edge(face.corners, i)[0] + 1, edge(face.corners, i)[1] + 1});
      }
    return result;
  }

  std::map<std::string, CutPolyhedron::Point>
  CutPolyhedron::outer_groups() const
  {
    std::map<std::string, Point> result;
    for (const Part &part : parts)
      for (const std::size_t f : part.faces)
        if (const Face &face = all_faces[f]; face.side != inside)
          {
            const Point normal  = normal_of(face);
            const Point outward = sum(mean(face.corners), -1., center_of(part));
            result[fmt::format("{}_s{}", bodies[part.body].name, face.side)] =
              sum({{0., 0., 0.}}, dot(normal, outward) < 0. ? -1. : 1., normal);
          }
    return result;
  }

  std::vector<std::size_t>
  CutPolyhedron::used_vertices() const
  {
    std::set<std::size_t> used;
    for (const Part &part : parts)
      for (const std::size_t f : part.faces)
        used.insert(all_faces[f].corners.begin(), all_faces[f].corners.end());
    return {used.begin(), used.end()};
  }

  std::string
  CutPolyhedron::mesh_text() const
  {
    constexpr unsigned int tetrahedron = 4;
    MeshText mesh                      = mesh_of_faces();
    std::set<std::size_t> used;
    for_each_cell([&](const Part &part, const Tetrahedron &cell) {
      mesh.add_element(
        tetrahedron, tag_of_body(part.body), {cell[0] + 1, cell[1] + 1, cell[2] + 1, cell[3] + 1});
      used.insert(cell.begin(), cell.end());
    });
    for (const std::size_t v : used)
      mesh.add_vertex(v + 1, vertices[v][0], vertices[v][1], vertices[v][2]);
    return mesh.text();
  }

  std::vector<double>
  CutPolyhedron::lengths() const
  {
    std::vector<double> result;
    for (const Part &part : parts)
      for (const std::size_t f : part.faces)
        for (std::size_t i = 0; i < all_faces[f].corners.size(); ++i)
          {
            const Edge at = edge(all_faces[f].corners, i);
            result.push_back(length(sum(vertices[at[0]], -1., vertices[at[1]])));
          }
    return result;
  }

  double
  CutPolyhedron::width() const
  {
    double left = vertices[used_vertices().front()][0], right = left;
    for (const std::size_t v : used_vertices())
      {
        left  = std::min(left, vertices[v][0]);
        right = std::max(right, vertices[v][0]);
      }
    return right - left;
  }

  // Longest side over the smallest height.
  double
  CutPolyhedron::largest_aspect() const
  {
    double result = 1.;
    for_each_cell([&](const Part &, const Tetrahedron &cell) {
      double longest = 0., largest_area = 0.;
      for (std::size_t i = 0; i < 4; ++i)
        {
          const Point a = sum(vertices[cell[(i + 1) % 4]], -1., vertices[cell[i]]),
                      b = sum(vertices[cell[(i + 2) % 4]], -1., vertices[cell[i]]);
          longest       = std::max({longest, length(a), length(b)});
          largest_area  = std::max(largest_area, length(cross(a, b)));
        }
      result = std::max(result, longest * largest_area / volume(cell));
    });
    return result;
  }

  double
  CutPolyhedron::offset() const
  {
    const Point &first = vertices[used_vertices().front()];
    return std::max({std::abs(first[0]), std::abs(first[1]), std::abs(first[2])});
  }
} // namespace fuga::stress
