// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/cut_polygon.h"


#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga::stress
{
  namespace
  {
    using Point = CutPolygon::Point;

    Point
    between(const Point &a, const Point &b, const double share)
    {
      return {{a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])}};
    }

    double
    distance(const Point &a, const Point &b)
    {
      return std::hypot(a[0] - b[0], a[1] - b[1]);
    }
  } // namespace

  CutPolygon::CutPolygon(const std::vector<Point> &outline, const bool convex) : vertices(outline)
  {
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i < n; ++i)
      sides[{{std::min(i, (i + 1) % n), std::max(i, (i + 1) % n)}}] = i;
    if (convex)
      {
        parts.resize(1);
        for (std::size_t i = 0; i < n; ++i)
          parts[0].corners.push_back(i);
        return;
      }
    vertices.push_back({{0., 0.}});
    for (std::size_t i = 0; i < n; ++i)
      parts.push_back({0, {n, i, (i + 1) % n}});
  }

  std::size_t
  CutPolygon::n_bodies() const
  {
    return number_of_bodies(parts);
  }

  // Every part that has the edge gets the new vertex, so that parts fit together.
  std::size_t
  CutPolygon::divide(const Edge &at, const Point &place)
  {
    const std::size_t vertex = vertices.size();
    vertices.push_back(place);
    for (Part &part : parts)
      for (std::size_t i = 0; i < part.corners.size(); ++i)
        if (edge(part.corners, i) == at)
          {
            part.corners.insert(part.corners.begin() + static_cast<std::ptrdiff_t>(i) + 1, vertex);
            break;
          }
    if (const auto side = sides.find(at); side != sides.end())
      {
        const std::size_t number = side->second;
        sides.erase(side);
        sides[{{at[0], vertex}}] = sides[{{at[1], vertex}}] = number;
      }
    return vertex;
  }

  void
  CutPolygon::split(const Point &normal, const double offset, const std::vector<bool> &which)
  {
    std::vector<double> height;
    for (const Point &vertex : vertices)
      height.push_back(normal[0] * vertex[0] + normal[1] * vertex[1] - offset);
    for (std::size_t p = 0; p < parts.size(); ++p)
      for (std::size_t i = 0; which[parts[p].body] && i < parts[p].corners.size(); ++i)
        if (const Edge at = edge(parts[p].corners, i); height[at[0]] * height[at[1]] < 0.)
          {
            divide(at,
                   between(vertices[at[0]],
                           vertices[at[1]],
                           height[at[0]] / (height[at[0]] - height[at[1]])));
            height.push_back(0.);
          }
    const std::size_t n_parts = parts.size(), n = n_bodies();
    for (std::size_t p = 0; p < n_parts; ++p)
      {
        if (!which[parts[p].body])
          continue;
        Part above{parts[p].body + n, {}}, below{parts[p].body, {}};
        for (const std::size_t corner : parts[p].corners)
          {
            if (height[corner] >= 0.)
              above.corners.push_back(corner);
            if (height[corner] <= 0.)
              below.corners.push_back(corner);
          }
        if (above.corners.size() < 3)
          continue;
        if (below.corners.size() < 3)
          parts[p] = above;
        else
          {
            parts[p] = below;
            parts.push_back(above);
          }
      }
  }

  void
  CutPolygon::number_bodies()
  {
    std::map<Edge, std::vector<std::size_t>> parts_at;
    for (std::size_t p = 0; p < parts.size(); ++p)
      for (std::size_t i = 0; i < parts[p].corners.size(); ++i)
        parts_at[edge(parts[p].corners, i)].push_back(p);
    std::vector<std::vector<std::size_t>> beside(parts.size());
    for (std::size_t p = 0; p < parts.size(); ++p)
      for (std::size_t i = 0; i < parts[p].corners.size(); ++i)
        for (const std::size_t q : parts_at[edge(parts[p].corners, i)])
          beside[p].push_back(q);
    stress::number_bodies(parts, beside);
  }

  bool
  CutPolygon::cut(const Point &normal,
                  const double offset,
                  const std::vector<bool> &which,
                  const double smallest)
  {
    const CutPolygon before = *this;
    split(normal, offset, which);
    number_bodies();
    const std::vector<double> all = lengths();
    const double least            = smallest * width();
    if (parts.size() > before.parts.size() && *std::min_element(all.begin(), all.end()) >= least &&
        std::all_of(parts.begin(), parts.end(), [&](const Part &part) {
          return area(part) >= least * least;
        }))
      return true;
    *this = before;
    return false;
  }

  void
  CutPolygon::triangulate(const unsigned int n_refinements)
  {
    std::vector<Part> triangles;
    for (const Part &part : parts)
      {
        Point center{{0., 0.}};
        const double share = 1. / static_cast<double>(part.corners.size());
        for (const std::size_t corner : part.corners)
          for (unsigned int d = 0; d < 2; ++d)
            center[d] += share * vertices[corner][d];
        for (std::size_t i = 0; i < part.corners.size(); ++i)
          triangles.push_back(
            {part.body,
             {vertices.size(), part.corners[i], part.corners[(i + 1) % part.corners.size()]}});
        vertices.push_back(center);
      }
    parts = triangles;
    for (unsigned int r = 0; r < n_refinements; ++r)
      {
        std::map<Edge, std::size_t> middles;
        const auto sides_before = sides;
        triangles.clear();
        for (const Part &part : parts)
          {
            std::array<std::size_t, 3> middle;
            for (std::size_t i = 0; i < 3; ++i)
              {
                const Edge at             = edge(part.corners, i);
                const auto [place, added] = middles.emplace(at, vertices.size());
                if (added)
                  vertices.push_back(between(vertices[at[0]], vertices[at[1]], 0.5));
                middle[i] = place->second;
                if (const auto side = sides_before.find(at); side != sides_before.end())
                  {
                    sides.erase(at);
                    sides[{{at[0], middle[i]}}] = sides[{{at[1], middle[i]}}] = side->second;
                  }
              }
            for (std::size_t i = 0; i < 3; ++i)
              triangles.push_back({part.body, {part.corners[i], middle[i], middle[(i + 2) % 3]}});
            triangles.push_back({part.body, {middle[0], middle[1], middle[2]}});
          }
        parts = triangles;
      }
  }

  CutPolygon::FaceGroups
  CutPolygon::faces() const
  {
    std::map<Edge, std::vector<std::size_t>> bodies_at;
    for (const Part &part : parts)
      for (std::size_t i = 0; i < part.corners.size(); ++i)
        bodies_at[edge(part.corners, i)].push_back(part.body);
    FaceGroups result;
    for (const auto &[at, both] : bodies_at)
      if (both.size() == 1 || both[0] != both[1])
        result[both.size() == 1 ? fmt::format("{}_s{}", bodies[both[0]].name, sides.at(at))
                                : name_of_joint(both[0], both[1])]
          .push_back({at[0] + 1, at[1] + 1});
    return result;
  }

  // Sides are numbered as their first corners are: the polygon lies to their left.
  std::map<std::string, CutPolygon::Point>
  CutPolygon::outer_groups() const
  {
    std::map<std::string, Point> result;
    for (const Part &part : parts)
      for (std::size_t i = 0; i < part.corners.size(); ++i)
        if (const auto side = sides.find(edge(part.corners, i)); side != sides.end())
          {
            const Point &a      = vertices[part.corners[i]],
                        &b      = vertices[part.corners[(i + 1) % part.corners.size()]];
            const double length = distance(a, b);
            result[fmt::format("{}_s{}", bodies[part.body].name, side->second)] = {
              {(b[1] - a[1]) / length, (a[0] - b[0]) / length}};
          }
    return result;
  }

  std::string
  CutPolygon::mesh_text() const
  {
    MeshText mesh = mesh_of_faces();
    for (const Part &part : parts)
      mesh.add_element(
        2, tag_of_body(part.body), {part.corners[0] + 1, part.corners[1] + 1, part.corners[2] + 1});
    for (std::size_t v = 0; v < vertices.size(); ++v)
      mesh.add_vertex(v + 1, vertices[v][0], vertices[v][1], 0.);
    return mesh.text();
  }

  double
  CutPolygon::area(const Part &part) const
  {
    double twice = 0.;
    for (std::size_t i = 0; i < part.corners.size(); ++i)
      {
        const Point &a = vertices[part.corners[i]],
                    &b = vertices[part.corners[(i + 1) % part.corners.size()]];
        twice += a[0] * b[1] - a[1] * b[0];
      }
    return 0.5 * twice;
  }

  std::vector<double>
  CutPolygon::lengths() const
  {
    std::vector<double> result;
    for (const Part &part : parts)
      for (std::size_t i = 0; i < part.corners.size(); ++i)
        {
          const Edge at = edge(part.corners, i);
          result.push_back(distance(vertices[at[0]], vertices[at[1]]));
        }
    return result;
  }

  double
  CutPolygon::width() const
  {
    const auto [left, right] = std::minmax_element(
      vertices.begin(), vertices.end(), [](const Point &a, const Point &b) { return a[0] < b[0]; });
    return (*right)[0] - (*left)[0];
  }

  // Longest side over the height on it.
  double
  CutPolygon::largest_aspect() const
  {
    double result = 1.;
    for (const Part &part : parts)
      for (std::size_t i = 0; i < 3; ++i)
        {
          const Edge at       = edge(part.corners, i);
          const double length = distance(vertices[at[0]], vertices[at[1]]);
          result              = std::max(result, length * length / (2. * area(part)));
        }
    return result;
  }

  double
  CutPolygon::offset() const
  {
    return std::max(std::abs(vertices[0][0]), std::abs(vertices[0][1]));
  }
} // namespace fuga::stress
