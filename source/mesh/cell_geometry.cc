// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/input_errors.h>
#include <fuga/mesh/cell_geometry.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace fuga
{
  namespace
  {
    using Point = std::array<double, 3>;

    /** Jacobians below this value times (largest edge at the corner)^dim are zero up to
     * rounding. */
    constexpr double flat = 1e-12;

    Point
    operator-(const Point &a, const Point &b)
    {
      return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
    }

    Point
    cross(const Point &a, const Point &b)
    {
      return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
    }

    double
    dot(const Point &a, const Point &b)
    {
      return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    /** A corner of a cell and its neighbours along the edges, in the order of a right-hand system.
     */
    using Corner = std::array<unsigned int, 4>;

    /** Return the corners to check. One corner is sufficient for simplices, because their Jacobian
     * is constant. */
    std::pair<const Corner *, unsigned int>
    corners(const CellShape shape)
    {
      static constexpr std::array<Corner, 1> triangle{{{{0, 1, 2, 0}}}};
      static constexpr std::array<Corner, 4> quadrilateral{
        {{{0, 1, 3, 0}}, {{1, 2, 0, 0}}, {{2, 3, 1, 0}}, {{3, 0, 2, 0}}}};
      static constexpr std::array<Corner, 1> tetrahedron{{{{0, 1, 2, 3}}}};
      static constexpr std::array<Corner, 8> hexahedron{{{{0, 1, 3, 4}},
                                                         {{1, 2, 0, 5}},
                                                         {{2, 3, 1, 6}},
                                                         {{3, 0, 2, 7}},
                                                         {{4, 7, 5, 0}},
                                                         {{5, 4, 6, 1}},
                                                         {{6, 5, 7, 2}},
                                                         {{7, 6, 4, 3}}}};
      switch (shape)
        {
          case CellShape::triangle:
            return {triangle.data(), 1};
          case CellShape::quadrilateral:
            return {quadrilateral.data(), 4};
          case CellShape::tetrahedron:
            return {tetrahedron.data(), 1};
          default:
            return {hexahedron.data(), 8};
        }
    }

    /** Return the Jacobian at a corner, divided by the lengths of the edges so that it is a pure
     * number. */
    double
    scaled_jacobian(const JointedMesh::Cell &cell,
                    const Corner &corner,
                    const std::vector<Point> &vertices)
    {
      const Point &origin = vertices[cell.vertices[corner[0]]];
      const Point a       = vertices[cell.vertices[corner[1]]] - origin;
      const Point b       = vertices[cell.vertices[corner[2]]] - origin;
      const double length = std::sqrt(std::max(dot(a, a), dot(b, b)));
      if (dimension(cell.shape) == 2)
        return length > 0 ? a[0] / length * (b[1] / length) - a[1] / length * (b[0] / length) : 0.;
      const Point c        = vertices[cell.vertices[corner[3]]] - origin;
      const double longest = std::max(length, std::sqrt(dot(c, c)));
      return longest > 0 ? dot(cross(a, b), c) / longest / longest / longest : 0.;
    }

    void
    reverse(JointedMesh::Cell &cell)
    {
      auto &v = cell.vertices;
      switch (cell.shape)
        {
          case CellShape::triangle:
          case CellShape::tetrahedron:
            std::swap(v[1], v[2]);
            break;
          case CellShape::quadrilateral:
            std::swap(v[1], v[3]);
            break;
          default:
            std::swap_ranges(v.begin(), v.begin() + 4, v.begin() + 4);
        }
    }

    const std::array<unsigned int, 4> *
    face_tables(const CellShape shape)
    {
      using Faces = std::array<unsigned int, 4>;
      static constexpr std::array<Faces, 3> triangle{{{{0, 1}}, {{1, 2}}, {{2, 0}}}};
      static constexpr std::array<Faces, 4> quadrilateral{{{{0, 1}}, {{1, 2}}, {{2, 3}}, {{3, 0}}}};
      static constexpr std::array<Faces, 4> tetrahedron{
        {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{0, 3, 2}}}};
      static constexpr std::array<Faces, 6> hexahedron{{{{0, 3, 2, 1}},
                                                        {{4, 5, 6, 7}},
                                                        {{0, 1, 5, 4}},
                                                        {{1, 2, 6, 5}},
                                                        {{2, 3, 7, 6}},
                                                        {{3, 0, 4, 7}}}};
      switch (shape)
        {
          case CellShape::triangle:
            return triangle.data();
          case CellShape::quadrilateral:
            return quadrilateral.data();
          case CellShape::tetrahedron:
            return tetrahedron.data();
          default:
            return hexahedron.data();
        }
    }
  } // namespace


  std::array<unsigned int, 4>
  face_vertices(const JointedMesh::Cell &cell, const unsigned int face)
  {
    const std::array<unsigned int, 4> &local = face_tables(cell.shape)[face];
    std::array<unsigned int, 4> result{};
    for (unsigned int i = 0; i < n_vertices(face_shape(cell.shape)); ++i)
      result[i] = cell.vertices[local[i]];
    return result;
  }


  double
  face_measure(const CellShape shape,
               const std::array<unsigned int, 4> &face,
               const std::vector<std::array<double, 3>> &vertices)
  {
    const Point &origin = vertices[face[0]];
    const Point a       = vertices[face[1]] - origin;
    if (shape == CellShape::line)
      return std::sqrt(dot(a, a));
    const Point b = vertices[face[2]] - origin;
    if (shape == CellShape::triangle)
      return 0.5 * std::sqrt(dot(cross(a, b), cross(a, b)));
    // half the cross product of the diagonals is exact for a plane face
    const Point d = cross(b, vertices[face[3]] - vertices[face[1]]);
    return 0.5 * std::sqrt(dot(d, d));
  }


  std::string
  print_point(const std::array<double, 3> &point, const unsigned int dim)
  {
    return dim == 2 ? fmt::format("({:g}, {:g})", point[0], point[1])
                    : fmt::format("({:g}, {:g}, {:g})", point[0], point[1], point[2]);
  }


  std::string
  face_centre(const CellShape shape,
              const std::array<unsigned int, 4> &face,
              const std::vector<std::array<double, 3>> &vertices)
  {
    Point centre{};
    const unsigned int n = n_vertices(shape);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        centre[d] += vertices[face[i]][d] / n;
    return print_point(centre, dimension(shape) + 1);
  }


  void
  orient_cells(JointedMesh &mesh, const std::string &file_name)
  {
    InputErrors errors;
    for (JointedMesh::Cell &cell : mesh.cells)
      {
        const auto [corner, n] = corners(cell.shape);
        double sum             = 0;
        for (unsigned int i = 0; i < n; ++i)
          sum += scaled_jacobian(cell, corner[i], mesh.vertices);
        if (sum < 0)
          reverse(cell);
        const auto bad = std::find_if(corner, corner + n, [&](const auto &vertices) {
          return !(scaled_jacobian(cell, vertices, mesh.vertices) > flat);
        });
        if (bad != corner + n)
          errors.add(fmt::format(
            "{}: body '{}': the cell with a vertex at {} is degenerate, folded or not convex "
            "there; all "
            "angles must be between 0 and 180 degrees; remesh the geometry (Coherence Mesh; or "
            "finer)",
            file_name,
            mesh.body_names[cell.body],
            print_point(mesh.vertices[cell.vertices[(*bad)[0]]], mesh.dimension)));
      }
    errors.throw_if_any();
  }
} // namespace fuga
