// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/cut_polyhedron.h"

#include "stress/cut_polyhedron_points.h"

#include <algorithm>
#include <cmath>

namespace fuga::stress
{
  CutPolyhedron::CutPolyhedron(const Point &half)
  {
    for (unsigned int v = 0; v < 8; ++v)
      vertices.push_back({{v % 2 == 0 ? -half[0] : half[0],
                           v / 2 % 2 == 0 ? -half[1] : half[1],
                           v / 4 == 0 ? -half[2] : half[2]}});
    parts.resize(1);
    for (const std::vector<std::size_t> &corners : std::vector<std::vector<std::size_t>>{
           {0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}})
      {
        parts[0].faces.push_back(all_faces.size());
        all_faces.push_back({corners, all_faces.size()});
      }
  }

  std::size_t
  CutPolyhedron::n_bodies() const
  {
    return number_of_bodies(parts);
  }

  std::vector<std::vector<std::size_t>>
  CutPolyhedron::parts_at_faces() const
  {
    std::vector<std::vector<std::size_t>> result(all_faces.size());
    for (std::size_t p = 0; p < parts.size(); ++p)
      for (const std::size_t face : parts[p].faces)
        result[face].push_back(p);
    return result;
  }

  CutPolyhedron::Point
  CutPolyhedron::mean(const std::vector<std::size_t> &corners) const
  {
    Point result{{0., 0., 0.}};
    for (const std::size_t corner : corners)
      result = sum(result, 1. / static_cast<double>(corners.size()), vertices[corner]);
    return result;
  }

  CutPolyhedron::Point
  CutPolyhedron::center_of(const Part &part) const
  {
    Point result{{0., 0., 0.}};
    for (const std::size_t face : part.faces)
      result =
        sum(result, 1. / static_cast<double>(part.faces.size()), mean(all_faces[face].corners));
    return result;
  }

  // Its corners may lie in a row: all of them count.
  CutPolyhedron::Point
  CutPolyhedron::normal_of(const Face &face) const
  {
    const Point center = mean(face.corners);
    Point twice{{0., 0., 0.}};
    for (std::size_t i = 0; i < face.corners.size(); ++i)
      twice = sum(twice,
                  1.,
                  cross(sum(vertices[face.corners[i]], -1., center),
                        sum(vertices[face.corners[(i + 1) % face.corners.size()]], -1., center)));
    const double size = length(twice);
    return {{twice[0] / size, twice[1] / size, twice[2] / size}};
  }

  double
  CutPolyhedron::distance(const Point &from, const Face &face) const
  {
    return std::abs(dot(normal_of(face), sum(from, -1., mean(face.corners))));
  }

  // Every face that has the edge gets the new vertex, so that parts fit together.
  void
  CutPolyhedron::divide_edges(const std::vector<bool> &is_cut, std::vector<double> &height)
  {
    std::map<Edge, std::size_t> divided;
    for (std::size_t f = 0; f < all_faces.size(); ++f)
      for (std::size_t i = 0; is_cut[f] && i < all_faces[f].corners.size(); ++i)
        if (const Edge at = edge(all_faces[f].corners, i);
            height[at[0]] * height[at[1]] < 0. && divided.emplace(at, vertices.size()).second)
          {
            const double share = height[at[0]] / (height[at[0]] - height[at[1]]);
            vertices.push_back(
              sum(vertices[at[0]], share, sum(vertices[at[1]], -1., vertices[at[0]])));
          }
    height.resize(vertices.size(), 0.);
    for (Face &face : all_faces)
      {
        std::vector<std::size_t> corners;
        for (std::size_t i = 0; i < face.corners.size(); ++i)
          {
            corners.push_back(face.corners[i]);
            if (const auto vertex = divided.find(edge(face.corners, i)); vertex != divided.end())
              corners.push_back(vertex->second);
          }
        face.corners = corners;
      }
  }

  // Parts on both sides of a face get both pieces of it.
  void
  CutPolyhedron::divide_faces(const std::vector<bool> &is_cut, const std::vector<double> &height)
  {
    const std::size_t n = all_faces.size();
    for (std::size_t f = 0; f < n; ++f)
      {
        Face above = all_faces[f], below = all_faces[f];
        const auto remove = [&height](Face &from, const double sign) {
          from.corners.erase(
            std::remove_if(from.corners.begin(),
                           from.corners.end(),
                           [&](const std::size_t v) { return sign * height[v] > 0.; }),
            from.corners.end());
        };
        remove(above, -1.);
        remove(below, 1.);
        const auto reaches = [&height](const Face &face) {
          return std::any_of(face.corners.begin(), face.corners.end(), [&](const std::size_t v) {
            return height[v] != 0.;
          });
        };
        if (!is_cut[f] || !reaches(above) || !reaches(below))
          continue;
        all_faces[f] = below;
        for (Part &part : parts)
          if (std::count(part.faces.begin(), part.faces.end(), f) > 0)
            part.faces.push_back(all_faces.size());
        all_faces.push_back(above);
      }
  }

  // The face between two halves of a part: around it go the edges that the faces of the upper half
  // have only once.
  std::size_t
  CutPolyhedron::add_cut(const std::vector<std::size_t> &above)
  {
    std::map<Edge, unsigned int> count;
    for (const std::size_t f : above)
      for (std::size_t i = 0; i < all_faces[f].corners.size(); ++i)
        ++count[edge(all_faces[f].corners, i)];
    std::map<std::size_t, std::vector<std::size_t>> next;
    for (const auto &[at, n] : count)
      if (n == 1)
        {
          next[at[0]].push_back(at[1]);
          next[at[1]].push_back(at[0]);
        }
    Face face;
    std::size_t before = inside, at = next.begin()->first;
    do
      {
        face.corners.push_back(at);
        const std::vector<std::size_t> &both = next.at(at);
        const std::size_t to                 = both[0] == before ? both[1] : both[0];
        before                               = at;
        at                                   = to;
      }
    while (at != face.corners.front());
    all_faces.push_back(face);
    return all_faces.size() - 1;
  }

  void
  CutPolyhedron::split(const Point &normal, const double offset, const std::vector<bool> &which)
  {
    std::vector<double> height;
    for (const Point &vertex : vertices)
      height.push_back(dot(normal, vertex) - offset);
    std::vector<bool> is_cut(all_faces.size(), false);
    for (const Part &part : parts)
      for (const std::size_t face : part.faces)
        is_cut[face] = is_cut[face] || which[part.body];
    divide_edges(is_cut, height);
    divide_faces(is_cut, height);
    const std::size_t n_parts = parts.size(), n = n_bodies();
    for (std::size_t p = 0; p < n_parts; ++p)
      {
        if (!which[parts[p].body])
          continue;
        Part above{parts[p].body + n, {}}, below{parts[p].body, {}};
        for (const std::size_t face : parts[p].faces)
          {
            double sum_of_heights = 0.;
            for (const std::size_t corner : all_faces[face].corners)
              sum_of_heights += height[corner];
            (sum_of_heights > 0. ? above : below).faces.push_back(face);
          }
        if (above.faces.empty())
          continue;
        if (below.faces.empty())
          {
            parts[p] = above;
            continue;
          }
        const std::size_t between = add_cut(above.faces);
        above.faces.push_back(between);
        below.faces.push_back(between);
        parts[p] = below;
        parts.push_back(above);
      }
  }

  void
  CutPolyhedron::number_bodies()
  {
    const std::vector<std::vector<std::size_t>> at = parts_at_faces();
    std::vector<std::vector<std::size_t>> beside(parts.size());
    for (std::size_t p = 0; p < parts.size(); ++p)
      for (const std::size_t face : parts[p].faces)
        beside[p].insert(beside[p].end(), at[face].begin(), at[face].end());
    stress::number_bodies(parts, beside);
  }

  bool
  CutPolyhedron::is_well_shaped(const double smallest) const
  {
    const std::vector<double> all = lengths();
    const double least            = smallest * width();
    return *std::min_element(all.begin(), all.end()) >= least &&
           std::all_of(parts.begin(), parts.end(), [&](const Part &part) {
             return std::all_of(part.faces.begin(), part.faces.end(), [&](const std::size_t face) {
               return distance(center_of(part), all_faces[face]) >= least;
             });
           });
  }

  bool
  CutPolyhedron::cut_off(const Point &normal, const double offset, const double smallest)
  {
    const CutPolyhedron before = *this;
    split(normal, offset, {true});
    if (parts.size() == 2)
      {
        parts.pop_back();
        all_faces[parts[0].faces.back()].side = n_sides++;
        if (is_well_shaped(smallest))
          return true;
      }
    *this = before;
    return false;
  }

  bool
  CutPolyhedron::cut(const Point &normal,
                     const double offset,
                     const std::vector<bool> &which,
                     const double smallest)
  {
    const CutPolyhedron before = *this;
    split(normal, offset, which);
    number_bodies();
    if (parts.size() > before.parts.size() && is_well_shaped(smallest))
      return true;
    *this = before;
    return false;
  }
} // namespace fuga::stress
