// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_mesh_gmsh_mesh_h
#define fuga_mesh_gmsh_mesh_h

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fuga
{
  /** Shapes of mesh entities that the program understands (first order; Gmsh's own vertex order).
   */
  enum class CellShape
  {
    point,
    line,
    triangle,
    quadrilateral,
    tetrahedron,
    hexahedron
  };

  /** Return the number of vertices of a shape. */
  unsigned int
  n_vertices(const CellShape shape);

  /** Return the dimension of a shape: 0 point, 1 line, 2 triangle ... */
  unsigned int
  dimension(const CellShape shape);

  /** Return the number of faces of a cell of this shape. */
  unsigned int
  n_faces(const CellShape shape);

  /** Return the shape of the faces of a cell of this shape. */
  CellShape
  face_shape(const CellShape shape);

  /** A cell, face or point of the file, counter-clockwise as Gmsh numbers it. */
  struct MeshEntity
  {
    CellShape shape = CellShape::point;
    std::array<unsigned int, 8> vertices{};
    /** Tag of the physical group; 0 = in no group. */
    int physical_tag = 0;
  };

  /**
   * The contents of a Gmsh file without the parts that no computation needs: vertices of no cell,
   * faces and points in no physical group, and entities of other dimensions are left out; vertices
   * are numbered from 0.
   */
  struct GmshMesh
  {
    std::string file_name;
    unsigned int dimension = 0;

    std::vector<std::array<double, 3>> vertices;
    /** Entities of the highest dimension, one dimension less, and points. A face is drawn in the
     *  direction of its physical group: a minus sign in the group reverses it. */
    std::vector<MeshEntity> cells;
    std::vector<MeshEntity> faces;
    std::vector<MeshEntity> points;
    /** Names of the physical groups by (dimension, tag). */
    std::map<std::pair<unsigned int, int>, std::string> physical_names;
  };

  /**
   * Read a Gmsh .msh file, version 2.2 or 4.1, ASCII, with first-order elements.
   * @throws InputError naming file and line, what is wrong and what to do: missing or unreadable
   * file, binary or other versions, second-order elements, unknown element types, vertex numbers
   * that do not exist, coordinates that are not finite, elements in more than one physical group,
   * cells in no physical group, groups without names, truncated sections, degenerate or absurd
   * counts (a count is never trusted for an allocation before the lines are there).
   */
  GmshMesh
  read_gmsh_mesh(const std::string &file_name);

  /** Parse such a file from a text in memory; @p file_name is only used in messages. */
  GmshMesh
  parse_gmsh_mesh(const std::string_view text, const std::string &file_name);
} // namespace fuga

#endif
